#include "ui/viewport/tip_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <imgui.h>

#include "app/commands/command_ids.h"
#include "app/commands/selection.h"
#include "ui/panels/panel_support.h"
#include "ui/render/picking.h"
#include "ui/viewport/viewport_context.h"

namespace stretch::ui {

namespace {

constexpr float lingerSeconds = 2.5F;

double tipOf(const rig::TrailSettings& settings) {
  return settings.pivot == rig::Pivot::start ? settings.endFrame : settings.startFrame;
}

/// Pulled spheres show themselves where they are.
rig::TrailSettings withoutSpheres(rig::TrailSettings settings) {
  settings.spheres.clear();
  return settings;
}

/// Whether what leads to the tip is another than in the frame before.
bool noteChange(TipWatch& watch, const rig::Trail& trail) {
  rig::TrailSettings now = withoutSpheres(trail.settings);
  const bool changed =
      watch.trail == trail.id && (!(watch.settings == now) || watch.applied != trail.applied);
  if (watch.trail != trail.id) {
    watch = {};
  }
  watch.trail = trail.id;
  watch.settings = std::move(now);
  watch.applied = trail.applied;
  return changed;
}

bool isInPicture(const ViewportState& viewport, const Vec3& world) {
  const auto place = projectToPixels(viewport.view, world);
  const Viewport& size = viewport.view.viewport;
  return place && place->pixels.x >= 0.0 && place->pixels.x <= size.widthPixels && place->pixels.y >= 0.0 &&
         place->pixels.y <= size.heightPixels;
}

} // namespace

std::optional<double> tipGhostFrame(ViewportContext& context) {
  app::Session& session = *context.open.character();
  TipWatch& watch = context.viewport.tipWatch;
  const rig::Trail* const trail = app::selectedTrail(session);
  if (trail == nullptr) {
    watch = {};
    return std::nullopt;
  }
  if (noteChange(watch, *trail)) {
    watch.secondsLeft = lingerSeconds;
  } else if (!session.isDragging()) {
    watch.secondsLeft = std::max(0.0F, watch.secondsLeft - ImGui::GetIO().DeltaTime);
  }
  const bool isShown = tipFrame(session, context.tool).has_value() || watch.secondsLeft > 0.0F;
  const double tip = tipOf(trail->settings);
  const bool elsewhere = std::abs(tip - session.view().frame) > 0.5;
  return trail->connected && isShown && elsewhere ? std::optional(tip) : std::nullopt;
}

void tellTipOutOfView(ViewportContext& context) {
  TipWatch& watch = context.viewport.tipWatch;
  const bool changing =
      tipFrame(*context.open.character(), context.tool).has_value() || watch.secondsLeft > 0.0F;
  const ShownTrail* const trail = findShown(context.viewport.shown, watch.trail);
  if (trail == nullptr || !trail->exaggerated || !changing) {
    return;
  }
  const bool inside = isInPicture(context.viewport, pointOnTrail(*trail, tipOf(watch.settings), true));
  if (!inside && !watch.toldOutOfView) {
    const std::string key = keyOf(context, command::viewFrameSelection);
    tell(context.ui, ToastKind::info,
         "The tip is out of the picture" + (key.empty() ? "" : ": " + key + " frames it"));
  }
  watch.toldOutOfView = !inside;
}

} // namespace stretch::ui

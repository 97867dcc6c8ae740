#include "ui/viewport/tip_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <imgui.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "ui/panels/context/panel_support.h"
#include "ui/render/picking/picking.h"
#include "ui/viewport/viewport_context.h"
#include "ui/viewport/viewport_scene.h"

namespace stretch::ui {

namespace {

constexpr float lingerSeconds = 2.5F;

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

/// Whether what lies within the radius of a point is in the picture.
bool isInPicture(const ViewportState& viewport, const Vec3& world, double radius) {
  const auto place = projectToPixels(viewport.view, world);
  const Viewport& size = viewport.view.viewport;
  const double margin = radius / unitsPerPixel(viewport.view, world);
  return place && place->pixels.x >= margin && place->pixels.x <= size.widthPixels - margin &&
         place->pixels.y >= margin && place->pixels.y <= size.heightPixels - margin;
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
  const double tip = rig::tipFrameOf(trail->settings);
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
  const double flesh = fleshRadius(context.open.character()->document(), watch.trail);
  const bool inside =
      isInPicture(context.viewport, pointOnTrail(*trail, rig::tipFrameOf(watch.settings), true), flesh);
  if (!inside && !watch.toldOutOfView) {
    const std::string key = keyOf(context, command::viewFrameSelection);
    tell(context.ui, ToastKind::info,
         "The tip leaves the picture" + (key.empty() ? "" : ": " + key + " frames it"));
  }
  watch.toldOutOfView = !inside;
}

} // namespace stretch::ui

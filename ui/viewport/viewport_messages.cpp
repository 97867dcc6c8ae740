#include "ui/viewport/viewport_messages.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include <imgui_internal.h>

#include "app/commands/table/selection.h"
#include "ui/panels/context/panels.h"
#include "ui/viewport/assemble_picture.h"
#include "ui/viewport/shown/shown_controllers.h"
#include "ui/viewport/tools.h"
#include "ui/viewport/viewport_labels.h"
#include "ui/viewport/viewport_scene.h"

namespace stretch::ui {

namespace {

/// Where the character stands in the picture, window units: its limbs with some flesh around them.
std::optional<Rect> figureIn(const ViewportContext& context) {
  constexpr float fleshShare = 0.06F; // of the figure's height
  app::Session* const session = context.open.character();
  std::optional<Rect> figure;
  const auto add = [&](const Vec3& world) {
    if (const auto place = placeOf(context.viewport, world)) {
      const Rect before = figure.value_or(Rect{*place, *place});
      figure = Rect{{std::min(before.min.x, place->x), std::min(before.min.y, place->y)},
                    {std::max(before.max.x, place->x), std::max(before.max.y, place->y)}};
    }
  };
  if (session != nullptr) {
    for (const BoneSegment& bone :
         limbBones(session->document(), session->shownAt(session->view().frame)).bones) {
      add(bone.fromWorld);
      add(bone.toWorld);
    }
  }
  if (figure) {
    const float flesh = fleshShare * figure->height();
    figure = Rect{{figure->min.x - flesh, figure->min.y - 2.0F * flesh},
                  {figure->max.x + flesh, figure->max.y + flesh}};
  }
  return figure;
}

Rect around(const ImVec2& centre, float radius) {
  return {{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}};
}

/// The selected trail's tip, as large as its sphere.
std::optional<Rect> tipBox(const ViewportContext& context) {
  const rig::Trail* const trail = app::selectedTrail(*context.open.character());
  const ShownTrail* const shown = trail != nullptr ? findShown(context.viewport.shown, trail->id) : nullptr;
  if (shown == nullptr) {
    return std::nullopt;
  }
  const auto tip =
      placeOf(context.viewport, pointOnTrail(*shown, rig::tipFrameOf(trail->settings), shown->exaggerated));
  return tip ? std::optional(around(*tip, context.theme.px(14.0F))) : std::nullopt;
}

/// The arrows and rings of what is selected: a controller, or else a sphere.
std::optional<Rect> handlesBox(const ViewportContext& context) {
  const ViewportState& viewport = context.viewport;
  const app::Session& session = *context.open.character();
  const app::Selection& selection = session.view().selection;
  std::optional<Vec3> origin;
  if (const auto handles = controllerHandles(session, viewport.controllers)) {
    origin = handles->origin;
  } else if (const auto axes = handlesOf(viewport.shown, selection.trail(), selection.spheres())) {
    origin = axes->origin;
  }
  const auto place = origin ? placeOf(viewport, *origin) : std::nullopt;
  const double reach = handleReachPixels(viewport.view) / viewport.pixelsPerUnit;
  return place ? std::optional(around(*place, static_cast<float>(reach))) : std::nullopt;
}

/// The trails that show, a box for each of their points.
std::vector<Rect> trailsIn(const ViewportContext& context) {
  std::vector<Rect> boxes;
  if (context.open.character() == nullptr) {
    return boxes;
  }
  for (const ShownTrail& trail : context.viewport.shown.trails) {
    for (const std::vector<Vec3>* path : {&trail.drawn.original, &trail.drawn.exaggerated}) {
      for (const Vec3& world : *path) {
        if (const auto place = placeOf(context.viewport, world)) {
          boxes.push_back(around(*place, context.theme.px(4.0F)));
        }
      }
    }
  }
  return boxes;
}

/// The legends and the label of the lens.
std::vector<Rect> labelsIn(const ViewportContext& context) {
  std::vector<Rect> labels;
  for (const char* const id :
       {"viewport/lens", "viewport/trail-legend", "viewport/weight-legend", "viewport/stretch-legend"}) {
    if (const Item* const item = context.items.find(id)) {
      labels.push_back({item->min, item->max});
    }
  }
  return labels;
}

/// What no message may cover.
std::vector<Rect> keptFree(const ViewportContext& context) {
  std::vector<Rect> kept;
  if (context.open.character() != nullptr) {
    for (const std::optional<Rect>& box : {tipBox(context), handlesBox(context)}) {
      if (box) {
        kept.push_back(*box);
      }
    }
  }
  if (const ImGuiWindow* const tour = ImGui::FindWindowByName("tour"); tour != nullptr && tour->WasActive) {
    kept.push_back({tour->Rect().Min, tour->Rect().Max});
  }
  for (const Item& item : context.items.items) {
    if (std::string_view(item.id).starts_with("welcome/")) {
      kept.push_back({item.min, item.max});
    }
  }
  return kept;
}

} // namespace

void showMessages(ViewportContext& context) {
  MessageView& messages = context.viewport.messages;
  if (context.ui.toasts.empty()) {
    messages = {figureIn(context), 0, {}};
    return;
  }
  messages.drawn = drawMessages(
      context,
      {context.viewport.box, messages.figure, keptFree(context), trailsIn(context), labelsIn(context)},
      messages.place, *ImGui::GetWindowDrawList());
}

bool pressMessage(ViewportContext& context) {
  if (isRunning(context.tool) || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    return false;
  }
  const auto pressed = std::ranges::find_if(context.viewport.messages.drawn, [](const DrawnToast& toast) {
    return toast.box.contains(ImGui::GetMousePos());
  });
  return pressed != context.viewport.messages.drawn.end() &&
         std::erase_if(context.ui.toasts, [&](const Toast& toast) { return toast.text == pressed->text; }) >
             0;
}

} // namespace stretch::ui

#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ui/panels/trails/trail_sections.h"
#include "ui/widgets/dropdown.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

struct StopSide {
  const char* text;
  Vec3 normal; ///< Points to the side that is forbidden.
};

constexpr std::array<StopSide, 6> stopSides{{{"Right of X", Vec3(1.0, 0.0, 0.0)},
                                             {"Left of X", Vec3(-1.0, 0.0, 0.0)},
                                             {"Above Y", Vec3(0.0, 1.0, 0.0)},
                                             {"Below Y", Vec3(0.0, -1.0, 0.0)},
                                             {"In front of Z", Vec3(0.0, 0.0, 1.0)},
                                             {"Behind Z", Vec3(0.0, 0.0, -1.0)}}};

/// Index into stopSides of the nearest direction.
std::size_t sideOf(const Vec3& normal) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < stopSides.size(); ++i) {
    best = glm::dot(stopSides[i].normal, normal) > glm::dot(stopSides[best].normal, normal) ? i : best;
  }
  return best;
}

void setStop(PanelContext& context, const EditPhase& phase, const std::optional<rig::StopPlane>& plane) {
  editSettings(context, phase, "Change where the limb stops",
               [&](rig::TrailSettings& s) { s.stopAt = plane; });
}

} // namespace

void stopRows(PanelContext& context, const rig::Trail& trail) {
  const WidgetContext widgets = widgetsOf(context);
  const std::optional<rig::StopPlane>& plane = trail.settings.stopAt;
  const Help help{"Stop at a plane",
                  "The limb's end is not carried past it: up to the second ledge, and not past it.",
                  {}};
  labelledRow(widgets, "Stop at", help);
  std::vector<Choice> choices{{"Nowhere"}};
  for (const StopSide& side : stopSides) {
    choices.push_back({side.text});
  }
  const int selected = plane ? static_cast<int>(sideOf(plane->normal)) + 1 : 0;
  if (const int chosen = dropdown(widgets, "trail/stop-side", choices, selected, help); chosen == 0) {
    setStop(context, {true, true}, std::nullopt);
  } else if (chosen > 0) {
    const Vec3 point = plane ? plane->point : Vec3(0.0);
    setStop(context, {true, true},
            rig::StopPlane{point, stopSides[static_cast<std::size_t>(chosen - 1)].normal});
  }
  if (!plane) {
    return;
  }
  labelledRow(widgets, "", help);
  const Vec3 axis = glm::abs(stopSides[sideOf(plane->normal)].normal);
  double at = glm::dot(axis, plane->point);
  const double reach = context.character().document().body.height * 4.0;
  SliderSpec spec{.id = "trail/stop-at",
                  .minimum = -reach,
                  .maximum = reach,
                  .step = 0.001,
                  .suffix = " m",
                  .showsFill = false};
  spec.help = {"Where the plane is", "Drag, or click and type.", {}};
  const EditPhase phase = slider(widgets, spec, at);
  setStop(context, phase,
          rig::StopPlane{plane->point + axis * (at - glm::dot(axis, plane->point)), plane->normal});
}

} // namespace stretch::ui

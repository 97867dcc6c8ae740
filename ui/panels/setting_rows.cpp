#include "ui/panels/setting_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/schema/trail_description.h"
#include "ui/widgets/dropdown.h"

namespace stretch::ui {

namespace {

using rig::TrailSettings;

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
  editSettings(context, phase, "Change where the limb stops", [&](TrailSettings& s) { s.stopAt = plane; });
}

} // namespace

Help settingHelp(const std::string& setting, const std::string& title) {
  const std::vector<app::TrailSetting>& table = app::trailSettings();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const app::TrailSetting& s) { return s.name == setting; });
  return {title, found != table.end() ? found->help : std::string(), {}};
}

void numberRow(PanelContext& context, const NumberRow& row, const TrailSettings& settings,
               double TrailSettings::*member) {
  double value = settings.*member;
  const Help help = settingHelp(row.setting, row.label);
  const EditPhase phase = numberControl(context, "trail/" + row.setting, row, help, value);
  editSettings(context, phase, row.undoLabel, [&](TrailSettings& s) { s.*member = value; });
}

Help dragHelp(Help help) {
  help.text += " Drag (Shift: finer), double click to type, right click for the default.";
  return help;
}

EditPhase numberControl(PanelContext& context, const std::string& id, const NumberRow& row, const Help& help,
                        double& value) {
  const WidgetContext widgets = widgetsOf(context);
  labelledRow(widgets, row.label, help);
  SliderSpec spec{.id = id,
                  .minimum = row.minimum,
                  .maximum = row.maximum,
                  .step = row.step,
                  .decimals = row.decimals,
                  .prefix = row.prefix,
                  .suffix = row.suffix,
                  .displayFactor = row.factor,
                  .defaultValue = row.defaultValue};
  spec.hardMaximum = std::max(row.maximum, row.hardMaximum);
  spec.help = dragHelp(help);
  return slider(widgets, spec, value);
}

void choiceRow(PanelContext& context, const ChoiceRow& row, int selected,
               const std::function<void(TrailSettings&, int)>& set) {
  const WidgetContext widgets = widgetsOf(context);
  const Help help = settingHelp(row.setting, row.label);
  labelledRow(widgets, row.label, help);
  std::vector<Choice> choices;
  for (const std::string& text : row.choices) {
    choices.push_back({text, {row.label + ": " + text, help.text, {}}});
  }
  if (const int chosen = segmented(widgets, "trail/" + row.setting, choices, selected);
      chosen >= 0 && chosen != selected) {
    editSettings(context, {true, true}, row.undoLabel, [&](TrailSettings& s) {
      set(s, chosen);
      if (row.also) {
        row.also(s);
      }
    });
  }
}

void flagRow(PanelContext& context, const FlagRow& row, const TrailSettings& settings,
             bool TrailSettings::*member) {
  const WidgetContext widgets = widgetsOf(context);
  const Help help = settingHelp(row.setting, row.label);
  labelledRow(widgets, row.label, help);
  const bool on = settings.*member;
  if (toggle(widgets, "trail/" + row.setting, on ? "On" : "Off", on, help)) {
    editSettings(context, {true, true}, row.undoLabel, [&](TrailSettings& s) { s.*member = !on; });
  }
}

void easeRow(PanelContext& context, const EaseRow& row, const Vec2& point, const Vec2& values,
             const std::function<void(const Vec2&, TrailSettings&)>& set) {
  const WidgetContext widgets = widgetsOf(context);
  const Help help = settingHelp(row.setting, row.label);
  labelledRow(widgets, row.label, help);
  const float width = columnWidth(2);
  Vec2 edited = point;
  SliderSpec percent{.id = row.id + "/percent",
                     .maximum = 0.98,
                     .decimals = 0,
                     .suffix = " %",
                     .displayFactor = 100.0,
                     .defaultValue = 0.0,
                     .width = width};
  percent.help = {
      row.label + ": part of the path", "0 % is off. Drag, double click to type, right click for 0.", {}};
  const EditPhase first = slider(widgets, percent, edited.x);
  ImGui::SameLine();
  SliderSpec value{.id = row.id + "/value",
                   .minimum = values.x,
                   .maximum = values.y,
                   .width = width,
                   .enabled = point.x > 0.0};
  value.help = {row.label + ": value there", "How much of the exaggeration is reached at that point.", {}};
  const EditPhase second = slider(widgets, value, edited.y);
  editSettings(context, {first.changed || second.changed, first.ended || second.ended},
               "Shape the transition", [&](TrailSettings& s) { set(edited, s); });
}

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
  const double reach = context.open.character()->document().biped.height * 4.0;
  SliderSpec spec{.id = "trail/stop-at",
                  .minimum = -reach,
                  .maximum = reach,
                  .step = 0.001,
                  .suffix = " m",
                  .showsFill = false};
  spec.help = {"Where the plane is", "Drag, or double click to type.", {}};
  const EditPhase phase = slider(widgets, spec, at);
  setStop(context, phase,
          rig::StopPlane{plane->point + axis * (at - glm::dot(axis, plane->point)), plane->normal});
}

} // namespace stretch::ui

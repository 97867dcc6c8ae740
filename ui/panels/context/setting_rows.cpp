#include "ui/panels/context/setting_rows.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "app/schema/trail_schema.h"
#include "core/gltf/json/json.h"
#include "ui/panels/context/typed_control.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/slider.h"

namespace stretch::ui {

namespace {

using gltf::Json;

int decimalsOf(const app::SettingFacts& setting) {
  const bool isWhole =
      setting.row.percent || setting.kind == app::SettingKind::whole || setting.row.step >= 1.0;
  return isWhole ? 0 : setting.row.step >= 0.1 ? 1 : 2;
}

std::optional<double> standardNumber(const Json& standard) {
  return standard.is_number() ? std::optional(standard.get<double>()) : std::nullopt;
}

RowEdit numberControl(PanelContext& context, const std::string& id, const app::SettingFacts& setting,
                      const Json& value, const RowExtras& extras) {
  double number = value.get<double>();
  const EditPhase phase = numberSlider(context, id, setting, settingHelp(setting),
                                       {.minimum = extras.minimum,
                                        .maximum = extras.maximum,
                                        .standard = standardNumber(Json::parse(setting.standard))},
                                       number);
  return {phase, Json(setting.kind == app::SettingKind::whole ? std::round(number) : number)};
}

/// A number, and a switch that leaves it to the program.
RowEdit optionalControl(PanelContext& context, const std::string& id, const app::SettingFacts& setting,
                        const Json& value, const RowExtras& extras) {
  const float autoWidth = context.theme.px(80.0F);
  double number = value.is_null() ? extras.automatic : value.get<double>();
  RowEdit edit{
      numberSlider(context, id, setting, settingHelp(setting),
                   {.maximum = extras.maximum, .width = ImGui::GetContentRegionAvail().x - autoWidth},
                   number),
      Json(number)};
  ImGui::SameLine();
  const Help help{"Automatic", "The program chooses the value.", {}};
  if (toggle(widgetsOf(context), id + "-auto", "Auto", value.is_null(), help)) {
    const bool whole = setting.row.step >= 1.0;
    edit = {{true, true}, value.is_null() ? Json(whole ? std::round(number) : number) : Json()};
  }
  return edit;
}

RowEdit flagControl(PanelContext& context, const std::string& id, const app::SettingFacts& setting,
                    const Json& value) {
  const bool on = value.get<bool>();
  const bool clicked = toggle(widgetsOf(context), id, on ? "On" : "Off", on, settingHelp(setting));
  return {{clicked, clicked}, Json(on != clicked)};
}

RowEdit choiceControl(PanelContext& context, const std::string& id, const app::SettingFacts& setting,
                      const Json& value, const RowExtras& extras) {
  std::vector<Choice> choices;
  int selected = -1;
  for (const app::SettingChoice& choice : setting.choices) {
    const std::size_t index = choices.size();
    const std::string text = capitalised(choice.name);
    const std::string help = choice.help.empty() ? setting.help : choice.help;
    selected = value == Json(choice.name) ? static_cast<int>(index) : selected;
    choices.push_back({text,
                       {app::labelOf(setting) + ": " + text, help, {}},
                       extras.offered.empty() || extras.offered[index]});
  }
  const int chosen = segmented(widgetsOf(context), id, choices, selected);
  const bool changed = chosen >= 0 && chosen != selected;
  return {{changed, changed}, changed ? Json(setting.choices[static_cast<std::size_t>(chosen)].name) : value};
}

RowEdit axesControl(PanelContext& context, const std::string& id, const Json& value) {
  const auto axes = value.get<std::string>();
  std::array<bool, 3> on{};
  for (std::size_t i = 0; i < 3; ++i) {
    on[i] = axes.find("xyz"[i]) != std::string::npos;
  }
  const Help help{.text = "Click turns this axis on or off, Shift+click leaves only this one on."};
  const int axis = axisButtons(widgetsOf(context), id, on, help);
  if (axis < 0) {
    return {{}, value};
  }
  const auto chosen = static_cast<std::size_t>(axis);
  const bool only = ImGui::GetIO().KeyShift;
  std::string changed;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool stays = i == chosen ? only || !on[i] : on[i] && !only;
    changed += stays ? std::string(1, "xyz"[i]) : "";
  }
  return {{true, true}, Json(changed)};
}

/// Percent and value of one point of the remap curve.
RowEdit easeControl(PanelContext& context, const std::string& id, const app::SettingFacts& setting,
                    const Json& value) {
  const WidgetContext widgets = widgetsOf(context);
  const float width = columnWidth(2);
  const std::string label = app::labelOf(setting);
  const bool isLow = Json::parse(setting.standard)[1].get<double>() < 0.5;
  Vec2 point(value[0].get<double>(), value[1].get<double>());
  SliderSpec percent{.id = id + "/percent",
                     .maximum = 0.98,
                     .decimals = 0,
                     .suffix = " %",
                     .displayFactor = 100.0,
                     .defaultValue = 0.0,
                     .width = width};
  percent.help = {
      label + ": part of the path", "0 % is off. Drag, click to type, right click for a menu.", {}};
  SliderSpec there{.id = id + "/value",
                   .minimum = isLow ? 0.0 : 0.5,
                   .maximum = isLow ? 0.5 : 1.0,
                   .width = width,
                   .enabled = point.x > 0.0};
  there.help = {label + ": value there", "How much of the exaggeration is reached at that point.", {}};
  const EditPhase first = slider(widgets, percent, point.x);
  ImGui::SameLine();
  const EditPhase second = slider(widgets, there, point.y);
  return {{first.changed || second.changed, first.ended || second.ended}, Json::array({point.x, point.y})};
}

RowEdit vectorControl(PanelContext& context, const std::string& id, const app::SettingFacts& setting,
                      const Json& value) {
  RowEdit edit{{}, value};
  const Json standard = Json::parse(setting.standard);
  const float width = columnWidth(3);
  Help help = settingHelp(setting);
  help.text += setting.unit.empty() ? "" : " In" + unitSuffix(setting) + ".";
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) {
      ImGui::SameLine();
    }
    double number = value[i].get<double>();
    const EditPhase phase =
        numberSlider(context, id + "/" + std::string(1, "XYZ"[i]), setting, help,
                     {.standard = standardNumber(standard[i]), .width = width, .isPart = true}, number);
    (*edit.value)[i] = number;
    edit.phase = {edit.phase.changed || phase.changed, edit.phase.ended || phase.ended};
  }
  return edit;
}

} // namespace

EditPhase numberSlider(PanelContext& context, const std::string& id, const app::SettingFacts& setting,
                       const Help& help, const NumberExtras& extras, double& value) {
  const std::string suffix = extras.isPart ? std::string() : unitSuffix(setting);
  SliderSpec spec{.id = id,
                  .minimum = extras.minimum.value_or(setting.row.minimum.value_or(setting.minimum)),
                  .maximum = extras.maximum.value_or(setting.row.maximum.value_or(setting.maximum)),
                  .step = setting.kind == app::SettingKind::whole ? 1.0 : setting.row.step,
                  .fineStep = setting.row.fineStep,
                  .decimals = decimalsOf(setting),
                  .prefix = setting.row.prefix.c_str(),
                  .suffix = suffix.c_str(),
                  .displayFactor = setting.row.shownFactor * (setting.row.percent ? 100.0 : 1.0),
                  .defaultValue = extras.standard,
                  .hardMinimum = setting.minimum,
                  .hardMaximum = setting.maximum,
                  .showsFill = !extras.isPart,
                  .width = extras.width,
                  .help = dragHelp(help)};
  const EditPhase phase = slider(widgetsOf(context), spec, value);
  if (phase.cut) {
    tell(context.ui, ToastKind::info,
         help.title + " goes from " + sliderText(spec, setting.minimum) + " to " +
             sliderText(spec, setting.maximum));
  }
  return phase;
}

std::string unitSuffix(const app::SettingFacts& setting) {
  if (setting.row.percent) {
    return " %";
  }
  const std::string& named = setting.row.shownUnit.empty() ? setting.unit : setting.row.shownUnit;
  std::string unit = named.empty() ? "" : " " + named;
  for (const auto& [plain, raised] : {std::pair("^2", "\xC2\xB2"), std::pair("^3", "\xC2\xB3")}) {
    if (const std::size_t at = unit.find(plain); at != std::string::npos) {
      unit.replace(at, 2, raised);
    }
  }
  return unit;
}

Help settingHelp(const app::SettingFacts& setting) {
  return {app::labelOf(setting), setting.help, {}};
}

Help dragHelp(Help help) {
  help.text += " Drag (Shift: finer), click to type, right click for a menu.";
  return help;
}

std::string undoLabel(const app::SettingFacts& setting) {
  std::string label = app::labelOf(setting);
  if (setting.kind == app::SettingKind::flag) {
    return label;
  }
  label.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(label.front())));
  return "Change the " + label;
}

RowEdit settingControl(PanelContext& context, const std::string& id, const app::SettingFacts& setting,
                       const Json& value, const RowExtras& extras) {
  labelledRow(widgetsOf(context), app::labelOf(setting), settingHelp(setting));
  if (setting.row.typed) {
    return typedControl(context, id, setting, value, extras.hint);
  }
  switch (setting.kind) {
  case app::SettingKind::number:
  case app::SettingKind::whole:
    return numberControl(context, id, setting, value, extras);
  case app::SettingKind::optionalNumber:
    return optionalControl(context, id, setting, value, extras);
  case app::SettingKind::flag:
    return flagControl(context, id, setting, value);
  case app::SettingKind::choice:
    return choiceControl(context, id, setting, value, extras);
  case app::SettingKind::axes:
    return axesControl(context, id, value);
  case app::SettingKind::ease:
    return easeControl(context, id, setting, value);
  case app::SettingKind::text: // a name is chosen from a list of its own
    return {{}, value};
  case app::SettingKind::vector:
    break;
  }
  return vectorControl(context, id, setting, value);
}

void trailRow(PanelContext& context, const rig::Trail& trail, const std::string& name,
              const SettingsChange& also, const RowExtras& extras) {
  const auto edit = [&](const EditPhase& phase, const std::string& label, const SettingsChange& change) {
    editSettings(context, phase, label, [&](rig::TrailSettings& settings) {
      change(settings);
      if (also) {
        also(settings);
      }
    });
  };
  settingRow(context, "trail/", *app::findSetting(app::trailSchema(), name), trail.settings, edit, extras);
}

void trailSection(PanelContext& context, const rig::Trail& trail, const std::string& section,
                  const SettingsChange& also, const std::vector<std::string>& except) {
  for (const app::SettingFacts& setting : app::trailSchema()) {
    const bool elsewhere = std::find(except.begin(), except.end(), setting.name) != except.end();
    if (setting.row.section == section && !elsewhere) {
      trailRow(context, trail, setting.name, also);
    }
  }
}

} // namespace stretch::ui

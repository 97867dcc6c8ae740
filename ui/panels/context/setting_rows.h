#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/schema/schema.h"
#include "core/gltf/json/json.h"
#include "ui/panels/context/panel_support.h"

namespace stretch::ui {

// Rows of panels, drawn from the described setting: its label, range, unit, choices and help.

/// Label and help sentence of a setting.
[[nodiscard]] Help settingHelp(const app::SettingFacts& setting);

/// The unit as it is written behind a number: " kg/m³".
[[nodiscard]] std::string unitSuffix(const app::SettingFacts& setting);

/// The help with what the mouse does on a slider.
[[nodiscard]] Help dragHelp(Help help);

/// "Change the scale": what undo calls a change of it.
[[nodiscard]] std::string undoLabel(const app::SettingFacts& setting);

/// Facts about a row that only the moment knows.
struct RowExtras {
  double automatic = 0.0;             ///< Shown while an optional number is left to the program.
  std::optional<double> minimum = {}; ///< Bounds of dragging, instead of the setting's own.
  std::optional<double> maximum = {};
  std::vector<bool> offered = {}; ///< Choices that can be chosen; empty: all.
  std::string hint = {};          ///< In an empty text field; else the default.
};

/// Facts about one number that only the moment knows.
struct NumberExtras {
  std::optional<double> minimum = {}; ///< Bounds of dragging, instead of the setting's own.
  std::optional<double> maximum = {};
  std::optional<double> standard = {}; ///< Value that Reset gives.
  float width = 0.0F;                  ///< 0: the available width.
  bool isPart = false; ///< Part of a vector, in a narrow field: no unit behind it, no filled part.
};

/// A slider of the setting's range, step and unit.
EditPhase numberSlider(PanelContext& context, const std::string& id, const app::SettingFacts& setting,
                       const Help& help, const NumberExtras& extras, double& value);

struct RowEdit {
  EditPhase phase;
  gltf::JsonDocument value;
};

/// Label and control of a setting that has `value` now; answers what the hand makes of it.
[[nodiscard]] RowEdit settingControl(PanelContext& context, const std::string& id,
                                     const app::SettingFacts& setting, const gltf::Json& value,
                                     const RowExtras& extras = {});

/// A row whose edits go through `edit(phase, undo label, change of the settings)`. The widget is `prefix` and
/// the setting's name.
template <typename Settings, typename Edit>
void settingRow(PanelContext& context, const std::string& prefix, const app::Setting<Settings>& setting,
                const Settings& settings, Edit&& edit, const RowExtras& extras = {}) {
  const RowEdit row = settingControl(context, prefix + setting.name, setting, setting.read(settings), extras);
  edit(row.phase, undoLabel(setting), [&](Settings& s) { setting.write(row.value, s); });
}

/// Draws rows of settings that are no document: changed at once, without undo. True when the value was
/// changed.
template <typename Settings>
bool viewRow(PanelContext& context, const std::string& prefix, const app::Setting<Settings>& setting,
             Settings& settings, const RowExtras& extras = {}) {
  const RowEdit row = settingControl(context, prefix + setting.name, setting, setting.read(settings), extras);
  if (row.phase.changed) {
    setting.write(row.value, settings);
  }
  return row.phase.changed;
}

/// One setting of a trail; the edit goes to every trail that commands act on. `also` changes what goes with
/// it.
void trailRow(PanelContext& context, const rig::Trail& trail, const std::string& name,
              const SettingsChange& also = {}, const RowExtras& extras = {});

/// Every setting of a section of the trail's panel but `except`, which stand elsewhere.
void trailSection(PanelContext& context, const rig::Trail& trail, const std::string& section,
                  const SettingsChange& also = {}, const std::vector<std::string>& except = {});

} // namespace stretch::ui

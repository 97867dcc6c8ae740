#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/gltf/json/json_document.h"

namespace stretch::app {

// Settings described once. A schema is the table of all settings of one struct: the options of the command
// line, recipes, saved work, what the window remembers, the checks of values, the rows of panels and the
// tables of the documentation follow from it. Values travel as JSON.

enum class SettingKind { number, whole, optionalNumber, flag, choice, axes, ease, vector, text };

struct SettingChoice {
  std::string name;      ///< In files and on the command line: "straighten".
  std::string help = {}; ///< One sentence; empty: the setting's own says it.
};

/// How a panel draws a setting.
struct SettingRow {
  std::string section = {};           ///< Part of the panel; empty: only the window's own controls show it.
  std::string label = {};             ///< Empty: made from the name.
  std::optional<double> minimum = {}; ///< Least value that dragging offers; typing takes the whole range.
  std::optional<double> maximum = {};
  double step = 0.01;    ///< Dragged values are multiples of it,
  double fineStep = 0.0; ///< or with Shift of this; 0: of the step.
  bool percent = false;  ///< A fraction that is shown in per cent.
  std::string prefix = {};
  std::string shownUnit = {}; ///< Instead of the setting's unit, where that makes unhandy numbers: "kPa".
  double shownFactor = 1.0;   ///< From the setting's unit to the shown one.
  bool typed = false;         ///< A text field without a slider: values over many powers of ten.
};

/// Facts about a setting, whatever it belongs to.
struct SettingFacts {
  std::string name;     ///< Key in files: "ease_in".
  double minimum = 0.0; ///< Least number, inclusive.
  double maximum = 0.0;
  std::string unit = {};                   ///< "frames", "Pa"; empty for plain numbers.
  std::vector<SettingChoice> choices = {}; ///< In the order of the enumeration.
  std::string help = {};                   ///< One sentence.
  SettingRow row = {};

  // Filled in when the setting joins its schema.
  SettingKind kind = SettingKind::number;
  std::string option = {};   ///< "--ease-in"; a flag that is on by default is switched off by "--no-pull".
  std::string standard = {}; ///< The default as JSON text: "1", "[0,0.1]", "\"spline\"", "null".
};

/// One setting of a struct `Settings`.
template <typename Settings>
struct Setting : SettingFacts {
  std::function<gltf::Json(const Settings&)> read;
  std::function<void(const gltf::Json&, Settings&)> write; ///< Writes a value that was checked.
};

template <typename Settings>
using Schema = std::vector<Setting<Settings>>;

/// Whether the setting takes the value; an error names the setting, what it got and what it takes.
[[nodiscard]] Status checkValue(const SettingFacts& setting, const gltf::Json& value);

/// The value that an option's text stands for: "2.5", "xz", "0.6,0.1", "straighten". Checked; errors name the
/// option.
[[nodiscard]] Result<gltf::Json> valueOfText(const SettingFacts& setting, const std::string& text);

/// Says in words what the setting takes: "a number from 0 to 5".
[[nodiscard]] std::string takenValues(const SettingFacts& setting);

/// Help of the option: the sentence, choices or unit, and the default; of a flag that is on by default, that
/// it is switched off.
[[nodiscard]] std::string optionHelp(const SettingFacts& setting);

/// Label of the setting on a panel: "Ease-in".
[[nodiscard]] std::string labelOf(const SettingFacts& setting);

/// Checks and sets one setting; an error leaves `settings` as they are.
template <typename Settings>
[[nodiscard]] Status setSetting(const Setting<Settings>& setting, const gltf::Json& value,
                                Settings& settings) {
  Status valid = checkValue(setting, value);
  if (valid) {
    setting.write(value, settings);
  }
  return valid;
}

/// Null when there is none of that name.
template <typename Settings>
[[nodiscard]] const Setting<Settings>* findSetting(const Schema<Settings>& schema, const std::string& name) {
  const auto found = std::find_if(schema.begin(), schema.end(),
                                  [&](const Setting<Settings>& setting) { return setting.name == name; });
  return found == schema.end() ? nullptr : &*found;
}

/// Whether every setting has a value that it takes: numbers that are none are found here.
template <typename Settings>
[[nodiscard]] Status checkSettings(const Schema<Settings>& schema, const Settings& settings) {
  for (const Setting<Settings>& setting : schema) {
    if (Status valid = checkValue(setting, setting.read(settings)); !valid) {
      return valid;
    }
  }
  return Success{};
}

} // namespace stretch::app

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/weight/weight_settings.h"
#include "core/base/result.h"
#include "core/gltf/source.h"

namespace stretch::app {

enum class WeightSettingKind { number, optionalNumber, vector };

/// One setting of a limb's weight, described once: recipes, saved work, the options of `elastic`, the editor
/// and the tests read this table.
struct WeightSetting {
  std::string name;   ///< Key in recipes and saved work: "young".
  std::string option; ///< Long option of `elastic`: "--young".
  WeightSettingKind kind = WeightSettingKind::number;
  double minimum = 0.0; ///< Of numbers, inclusive.
  double maximum = 0.0;
  std::string unit;
  std::string help; ///< One sentence.
  std::function<gltf::Json(const WeightSettings&)> read;
  std::function<void(const gltf::Json&, WeightSettings&)> write; ///< Of a value that was checked.
};

/// All settings but range and moduli, which have shapes of their own.
[[nodiscard]] const std::vector<WeightSetting>& weightSettings();

/// Checks and sets one setting; an error names the setting, what it got and what it takes.
[[nodiscard]] Status setWeightSetting(const WeightSetting& setting, const gltf::Json& value,
                                      WeightSettings& settings);

/// The value that an option's text stands for: "3e5", "0,-9.81,0".
[[nodiscard]] Result<gltf::Json> parseWeightText(const WeightSetting& setting, const std::string& text);

/// Settings as recipes and saved files hold them: every entry of weightSettings(), "range" where it is not
/// the whole clip, "moduli" where a bone has its own.
[[nodiscard]] gltf::Json weightToJson(const WeightSettings& settings);

/// Reads what weightToJson writes; what is missing keeps its value in `settings`. `allowed` names further
/// keys that the caller reads itself. An unknown key or a wrong value is an error that names it.
[[nodiscard]] Status weightFromJson(const gltf::Json& json, const std::vector<std::string>& allowed,
                                    WeightSettings& settings);

} // namespace stretch::app

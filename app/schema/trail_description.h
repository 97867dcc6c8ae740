#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/gltf/source.h"
#include "rig/trail/trail.h"

namespace stretch::app {

enum class SettingKind { number, optionalNumber, flag, choice, axes, ease };

/// One setting of a trail, described once: recipes, saved work, the options of `exaggerate` and the tests
/// read this table.
struct TrailSetting {
  std::string name;   ///< Key in recipes and saved work: "ease_in".
  std::string option; ///< Long option of `exaggerate`: "--ease-in"; empty for `pull`, which has --no-pull.
  SettingKind kind = SettingKind::number;
  double minimum = 0.0; ///< Of numbers, inclusive.
  double maximum = 0.0;
  std::vector<std::string> choices; ///< Of choices.
  std::string unit;                 ///< "frames", "fraction", empty.
  std::string help;                 ///< One sentence.
  std::function<gltf::Json(const rig::TrailSettings&)> read;
  std::function<void(const gltf::Json&, rig::TrailSettings&)> write; ///< Of a value that was checked.
};

/// All settings but range, spheres and stop plane, which have shapes of their own.
[[nodiscard]] const std::vector<TrailSetting>& trailSettings();

/// Checks and sets one setting; an error names the setting, what it got and what it takes.
[[nodiscard]] Status setTrailSetting(const TrailSetting& setting, const gltf::Json& value,
                                     rig::TrailSettings& settings);

/// The value that an option's text stands for: "2.5", "xz", "0.6,0.1", "straighten".
[[nodiscard]] Result<gltf::Json> parseSettingText(const TrailSetting& setting, const std::string& text);

/// "-2.5e3" as a number; an error when `text` is anything but one finite number.
[[nodiscard]] Result<double> parseNumber(const std::string& text, const std::string& where);

} // namespace stretch::app

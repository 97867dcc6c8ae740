#include "app/schema/schema_json.h"

#include <cmath>

namespace stretch::app {

Result<Vec3> vectorFromJson(const gltf::Json& json, const std::string& where) {
  const bool isVector =
      json.is_array() && json.size() == 3 &&
      std::all_of(json.begin(), json.end(), [](const gltf::Json& number) { return number.is_number(); });
  if (!isVector) {
    return Error{json.dump() + " is not a vector", where, "give three numbers, such as [0, 1, 0]"};
  }
  return Vec3(json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
}

Result<Quat> quaternionFromJson(const gltf::Json& json, const std::string& where) {
  const bool isFour =
      json.is_array() && json.size() == 4 &&
      std::all_of(json.begin(), json.end(), [](const gltf::Json& number) { return number.is_number(); });
  if (!isFour) {
    return Error{json.dump() + " is not a quaternion", where, "give four numbers x, y, z, w"};
  }
  return Quat(json[3].get<double>(), json[0].get<double>(), json[1].get<double>(), json[2].get<double>());
}

std::optional<gltf::Json> nearestValue(const SettingFacts& setting, const gltf::Json& value) {
  gltf::Json nearest = value;
  const bool isNumber = value.is_number() && std::isfinite(value.get<double>());
  if (isNumber && setting.kind == SettingKind::choice) {
    const double last = static_cast<double>(setting.choices.size()) - 1.0;
    nearest = setting.choices[static_cast<std::size_t>(std::clamp(value.get<double>(), 0.0, last))].name;
  } else if (isNumber) {
    const double within = std::clamp(value.get<double>(), setting.minimum, setting.maximum);
    nearest = setting.kind == SettingKind::whole ? std::round(within) : within;
  }
  return checkValue(setting, nearest) ? std::optional(nearest) : std::nullopt;
}

} // namespace stretch::app

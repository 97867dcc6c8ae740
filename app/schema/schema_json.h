#pragma once

#include "app/schema/schema.h"
#include "core/gltf/json/json.h"
#include "core/math/types.h"

namespace stretch::app {

// For the sources that read and write settings as objects of JSON.

/// A zero is written without a sign.
[[nodiscard]] inline gltf::Json vectorToJson(const Vec3& v) {
  return gltf::Json::array({v.x + 0.0, v.y + 0.0, v.z + 0.0});
}

[[nodiscard]] Result<Vec3> vectorFromJson(const gltf::Json& json, const std::string& where);

/// x, y, z, w, as glTF has them; read as they are, of any length.
[[nodiscard]] inline gltf::Json quaternionToJson(const Quat& turn) {
  return gltf::Json::array({turn.x + 0.0, turn.y + 0.0, turn.z + 0.0, turn.w + 0.0});
}

[[nodiscard]] Result<Quat> quaternionFromJson(const gltf::Json& json, const std::string& where);

/// Adds every setting of the schema to an object, under its name.
template <typename Settings>
void writeSettings(const Schema<Settings>& schema, const Settings& settings, gltf::Json& object) {
  for (const Setting<Settings>& setting : schema) {
    object[setting.name] = setting.read(settings);
  }
}

/// Reads the keys of an object; what is missing keeps its value. `other` is asked about a key that is no
/// setting and answers whether it took it. A wrong value and a key that nobody knows are errors that name it.
template <typename Settings, typename Other>
[[nodiscard]] Status readSettings(const gltf::Json& object, const Schema<Settings>& schema,
                                  Settings& settings, Other&& other) {
  for (const auto& [key, value] : object.items()) {
    const Setting<Settings>* const known = findSetting(schema, key);
    Status read = known != nullptr ? setSetting(*known, value, settings) : other(key, value);
    if (!read) {
      return read;
    }
  }
  return Success{};
}

/// The value as near as the setting takes it: numbers are brought into their range, a choice may be given by
/// its index. Null when nothing can be made of it.
[[nodiscard]] std::optional<gltf::Json> nearestValue(const SettingFacts& setting, const gltf::Json& value);

/// Takes from an object what can be made sense of and leaves the rest as it is: a damaged file does no harm.
template <typename Settings>
void takeSettings(const gltf::Json& object, const Schema<Settings>& schema, Settings& settings) {
  for (const Setting<Settings>& setting : schema) {
    if (object.is_object() && object.contains(setting.name)) {
      if (const auto value = nearestValue(setting, object[setting.name])) {
        setting.write(*value, settings);
      }
    }
  }
}

} // namespace stretch::app

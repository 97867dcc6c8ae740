#include "app/schema/entry_schema.h"

namespace stretch::app {

using gltf::Json;

Status readValue(const Json& json, const std::string& key, double /*unit*/, std::string& text) {
  if (!json.is_string()) {
    return Error{json.dump() + " is not a name", key, "give a name in quotes"};
  }
  text = json.get<std::string>();
  return Success{};
}

Status readValue(const Json& json, const std::string& key, double /*unit*/, double& number) {
  if (!json.is_number()) {
    return Error{json.dump() + " is not a number", key, "give a number"};
  }
  number = json.get<double>();
  return Success{};
}

Status readValue(const Json& json, const std::string& key, double /*unit*/, bool& flag) {
  if (!json.is_boolean()) {
    return Error{json.dump() + " is neither true nor false", key, "give true or false"};
  }
  flag = json.get<bool>();
  return Success{};
}

Status readValue(const Json& json, const std::string& key, double /*unit*/, Vec2& pair) {
  if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number()) {
    return Error{json.dump() + " is not a pair of frames", key, "give two numbers, such as [0, 12]"};
  }
  pair = {json[0].get<double>(), json[1].get<double>()};
  return Success{};
}

Status readValue(const Json& json, const std::string& key, double unit, Vec3& vector) {
  const Result<Vec3> read = vectorFromJson(json, key);
  vector = read ? *read * unit : vector;
  return read ? Status(Success{}) : Status(read.error());
}

Status readValue(const Json& json, const std::string& key, double /*unit*/, Quat& turn) {
  const Result<Quat> read = quaternionFromJson(json, key);
  turn = read ? *read : turn;
  return read ? Status(Success{}) : Status(read.error());
}

} // namespace stretch::app

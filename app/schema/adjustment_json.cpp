#include "app/schema/adjustment_json.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "app/schema/schema_json.h"

namespace stretch::app {

namespace {

using gltf::Json;
using rig::KeyInterpolation;
using rig::OffsetKey;

// In the order of the enumeration.
constexpr std::array interpolationNames{"auto", "flat", "linear", "stepped", "free"};

Json offsetKeyToJson(const OffsetKey& key, bool isAttribute, const AdjustmentUnits& units) {
  const bool isFree = key.interpolation == KeyInterpolation::free;
  Json json{{"frame", key.frame},
            {"interpolation", interpolationNames.at(static_cast<std::size_t>(key.interpolation))}};
  if (isAttribute) {
    json["value"] = key.value;
  } else {
    json["move"] = vectorToJson(key.move / units.length);
    json["turn"] = vectorToJson(key.turn / units.angle);
  }
  if (isFree && isAttribute) {
    json["value_slope"] = key.valueSlope;
  } else if (isFree) {
    json["move_slope"] = vectorToJson(key.moveSlope / units.length);
    json["turn_slope"] = vectorToJson(key.turnSlope / units.angle);
  }
  return json;
}

Status readNumber(const Json& json, const std::string& key, double& number) {
  if (!json.is_number()) {
    return Error{json.dump() + " is not a number", key, "give a number"};
  }
  number = json.get<double>();
  return Success{};
}

Status readVector(const Json& json, const std::string& key, double unit, Vec3& vector) {
  const Result<Vec3> read = vectorFromJson(json, key);
  if (!read) {
    return read.error();
  }
  vector = *read * unit;
  return Success{};
}

Status readInterpolation(const Json& json, KeyInterpolation& interpolation) {
  const auto* const found =
      std::ranges::find_if(interpolationNames, [&](const char* name) { return json == name; });
  if (found == interpolationNames.end()) {
    return Error{json.dump() + " is no interpolation", "interpolation",
                 "give auto, flat, linear, stepped or free"};
  }
  interpolation = static_cast<KeyInterpolation>(found - interpolationNames.begin());
  return Success{};
}

Status readMember(const std::string& key, const Json& value, bool isAttribute, const AdjustmentUnits& units,
                  OffsetKey& offset) {
  if (key == "frame") {
    return readNumber(value, key, offset.frame);
  }
  if (key == "interpolation") {
    return readInterpolation(value, offset.interpolation);
  }
  if (isAttribute && (key == "value" || key == "value_slope")) {
    return readNumber(value, key, key == "value" ? offset.value : offset.valueSlope);
  }
  if (!isAttribute && (key == "move" || key == "move_slope")) {
    return readVector(value, key, units.length, key == "move" ? offset.move : offset.moveSlope);
  }
  if (!isAttribute && (key == "turn" || key == "turn_slope")) {
    return readVector(value, key, units.angle, key == "turn" ? offset.turn : offset.turnSlope);
  }
  return Error{isAttribute ? "is not a part of an attribute's key" : "is not a part of a controller's key",
               key,
               isAttribute ? "give frame, value, interpolation" : "give frame, move, turn, interpolation"};
}

Result<OffsetKey> offsetKeyOf(const Json& json, bool isAttribute, const AdjustmentUnits& units) {
  const bool hasValue = json.is_object() && (!isAttribute || json.contains("value"));
  if (!json.is_object() || !json.contains("frame") || !hasValue) {
    return Error{json.dump() + " is not a key", "",
                 isAttribute ? R"(give {"frame": number, "value": number})"
                             : R"(give {"frame": number, "move": [x, y, z], "turn": [x, y, z]})"};
  }
  OffsetKey offset;
  for (const auto& [key, value] : json.items()) {
    if (const Status read = readMember(key, value, isAttribute, units, offset); !read) {
      return read.error();
    }
  }
  return offset;
}

Status readOffsetRange(const Json& json, rig::Adjustment& adjustment) {
  const bool isRange = json.is_array() && json.size() == 2 && json[0].is_number() && json[1].is_number();
  if (!isRange) {
    return Error{json.dump() + " is not a range", "range",
                 "give the first and the last frame, such as [0, 12]"};
  }
  adjustment.rangeFrames = Vec2(json[0].get<double>(), json[1].get<double>());
  return Success{};
}

} // namespace

Result<AdjustedName> adjustedName(const Json& json) {
  const bool hasController =
      json.is_object() && json.contains("controller") && json["controller"].is_string();
  const bool hasAttribute = json.is_object() && json.contains("attribute") && json["attribute"].is_string();
  if (hasController == hasAttribute) {
    return Error{"names no controller and no attribute, or both", "",
                 R"(give "controller", such as "left-hand", or "attribute", such as "left-hand.curl")"};
  }
  return AdjustedName{json[hasController ? "controller" : "attribute"].get<std::string>(), hasAttribute};
}

Json offsetKeysToJson(const std::vector<OffsetKey>& keys, bool isAttribute, const AdjustmentUnits& units) {
  Json list = Json::array();
  for (const OffsetKey& key : keys) {
    list.push_back(offsetKeyToJson(key, isAttribute, units));
  }
  return list;
}

Result<std::vector<OffsetKey>> offsetKeysFromJson(const Json& json, bool isAttribute,
                                                  const AdjustmentUnits& units) {
  if (!json.is_array()) {
    return Error{"is not a list", "keys", "give a list of keys"};
  }
  std::vector<OffsetKey> keys;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const Result<OffsetKey> key = offsetKeyOf(json[i], isAttribute, units);
    if (!key) {
      const std::string inside = key.error().where.empty() ? "" : "." + key.error().where;
      return Error{key.error().what, fmt::format("keys[{}]{}", i, inside), key.error().remedy};
    }
    keys.push_back(*key);
  }
  std::ranges::stable_sort(keys, {}, &OffsetKey::frame);
  return keys;
}

Json adjustmentToJson(const rig::Adjustment& adjustment, bool isAttribute, const AdjustmentUnits& units) {
  Json json{{isAttribute ? "attribute" : "controller", adjustment.controller}};
  if (adjustment.rangeFrames) {
    json["range"] = Json::array({adjustment.rangeFrames->x, adjustment.rangeFrames->y});
  }
  json["keys"] = offsetKeysToJson(adjustment.keys, isAttribute, units);
  return json;
}

Result<rig::Adjustment> adjustmentFromJson(const Json& json, const AdjustmentUnits& units,
                                           const std::vector<std::string>& allowed) {
  const Result<AdjustedName> name = adjustedName(json);
  if (!name) {
    return name.error();
  }
  rig::Adjustment adjustment;
  adjustment.controller = name->id;
  for (const auto& [key, value] : json.items()) {
    Status read = Success{};
    if (key == "keys") {
      Result<std::vector<OffsetKey>> keys = offsetKeysFromJson(value, name->isAttribute, units);
      read = keys ? Status(Success{}) : Status(keys.error());
      adjustment.keys = keys ? std::move(*keys) : std::vector<OffsetKey>{};
    } else if (key == "range") {
      read = readOffsetRange(value, adjustment);
    } else if (key != "controller" && key != "attribute" &&
               std::ranges::find(allowed, key) == allowed.end()) {
      read = Error{"is not a part of an adjustment", key, "remove it, or correct its name"};
    }
    if (!read) {
      return read.error();
    }
  }
  return adjustment;
}

} // namespace stretch::app

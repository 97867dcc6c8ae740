#include "app/schema/adjustment_json.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "app/schema/entry_schema.h"
#include "core/anim/frames.h"

namespace stretch::app {

namespace {

using gltf::Json;
using rig::KeyInterpolation;
using rig::OffsetKey;

// In the order of the enumeration.
constexpr std::array interpolationNames{"auto", "flat", "linear", "stepped", "free"};

EntryMember<OffsetKey> interpolationMember() {
  return {"interpolation",
          [](const OffsetKey& key) {
            return Json(interpolationNames.at(static_cast<std::size_t>(key.interpolation)));
          },
          [](const Json& json, OffsetKey& key) -> Status {
            const auto* const found =
                std::ranges::find_if(interpolationNames, [&](const char* name) { return json == name; });
            if (found == interpolationNames.end()) {
              return Error{json.dump() + " is no interpolation", "interpolation",
                           "give auto, flat, linear, stepped or free"};
            }
            key.interpolation = static_cast<KeyInterpolation>(found - interpolationNames.begin());
            return Success{};
          }};
}

EntrySchema<OffsetKey> offsetKeySchema(bool isAttribute, const AdjustmentUnits& units) {
  const auto ofFree = [](EntryMember<OffsetKey> slope) {
    return writtenWhere([](const OffsetKey& key) { return key.interpolation == KeyInterpolation::free; },
                        std::move(slope));
  };
  if (isAttribute) {
    return {entryMember("frame", 1.0, &OffsetKey::frame), interpolationMember(),
            entryMember("value", 1.0, &OffsetKey::value),
            ofFree(entryMember("value_slope", 1.0, &OffsetKey::valueSlope))};
  }
  return {entryMember("frame", 1.0, &OffsetKey::frame),
          interpolationMember(),
          entryMember("move", units.length, &OffsetKey::move),
          entryMember("turn", units.angle, &OffsetKey::turn),
          ofFree(entryMember("move_slope", units.length, &OffsetKey::moveSlope)),
          ofFree(entryMember("turn_slope", units.angle, &OffsetKey::turnSlope))};
}

Result<OffsetKey> offsetKeyOf(const Json& json, bool isAttribute, const EntrySchema<OffsetKey>& schema) {
  const bool hasValue = json.is_object() && (!isAttribute || json.contains("value"));
  if (!json.is_object() || !json.contains("frame") || !hasValue) {
    return Error{json.dump() + " is not a key", "",
                 isAttribute ? R"(give {"frame": number, "value": number})"
                             : R"(give {"frame": number, "move": [x, y, z], "turn": [x, y, z]})"};
  }
  const auto unknown = [&](const std::string& key) -> Status {
    return Error{isAttribute ? "is not a part of an attribute's key" : "is not a part of a controller's key",
                 key,
                 isAttribute ? "give frame, value, interpolation" : "give frame, move, turn, interpolation"};
  };
  OffsetKey offset;
  const Status read = readEntry(json, schema, unknown, offset);
  return read ? Result<OffsetKey>(offset) : Result<OffsetKey>(read.error());
}

EntrySchema<rig::Adjustment> adjustmentSchema(bool isAttribute, const AdjustmentUnits& units) {
  return {entryMember(isAttribute ? "attribute" : "controller", 1.0, &rig::Adjustment::controller),
          {"range",
           [](const rig::Adjustment& adjustment) { return entryValue(*adjustment.rangeFrames, 1.0); },
           [](const Json& json, rig::Adjustment& adjustment) -> Status {
             Vec2 range;
             if (!readValue(json, "range", 1.0, range)) {
               return Error{json.dump() + " is not a range", "range",
                            "give the first and the last frame, such as [0, 12]"};
             }
             adjustment.rangeFrames = range;
             return Success{};
           },
           false, [](const rig::Adjustment& adjustment) { return adjustment.rangeFrames.has_value(); }},
          {"keys",
           [=](const rig::Adjustment& adjustment) {
             return offsetKeysToJson(adjustment.keys, isAttribute, units);
           },
           [=](const Json& json, rig::Adjustment& adjustment) {
             Result<std::vector<OffsetKey>> keys = offsetKeysFromJson(json, isAttribute, units);
             adjustment.keys = keys ? std::move(*keys) : std::vector<OffsetKey>{};
             return keys ? Status(Success{}) : Status(keys.error());
           }}};
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
  const EntrySchema<OffsetKey> schema = offsetKeySchema(isAttribute, units);
  Json list = Json::array();
  for (const OffsetKey& key : keys) {
    list.push_back(writeEntry(schema, key));
  }
  return list;
}

Result<std::vector<OffsetKey>> offsetKeysFromJson(const Json& json, bool isAttribute,
                                                  const AdjustmentUnits& units) {
  if (!json.is_array()) {
    return Error{"is not a list", "keys", "give a list of keys"};
  }
  const EntrySchema<OffsetKey> schema = offsetKeySchema(isAttribute, units);
  std::vector<OffsetKey> keys;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const Result<OffsetKey> key = offsetKeyOf(json[i], isAttribute, schema);
    if (!key) {
      const std::string inside = key.error().where.empty() ? "" : "." + key.error().where;
      return Error{key.error().what, fmt::format("keys[{}]{}", i, inside), key.error().remedy};
    }
    keys.push_back(*key);
  }
  std::ranges::stable_sort(keys, {}, &OffsetKey::frame);
  if (const auto twice = std::ranges::adjacent_find(keys, sameFrame, &OffsetKey::frame);
      twice != keys.end()) {
    return Error{fmt::format("two keys stand at frame {:g}", twice->frame), "keys", "leave one of them out"};
  }
  return keys;
}

Json adjustmentToJson(const rig::Adjustment& adjustment, bool isAttribute, const AdjustmentUnits& units) {
  return writeEntry(adjustmentSchema(isAttribute, units), adjustment);
}

Result<rig::Adjustment> adjustmentFromJson(const Json& json, const AdjustmentUnits& units,
                                           const std::vector<std::string>& allowed) {
  const Result<AdjustedName> name = adjustedName(json);
  if (!name) {
    return name.error();
  }
  const auto unknown = [&](const std::string& key) {
    const bool isKnown =
        key == "controller" || key == "attribute" || std::ranges::find(allowed, key) != allowed.end();
    return isKnown ? Status(Success{})
                   : Status(Error{"is not a part of an adjustment", key, "remove it, or correct its name"});
  };
  rig::Adjustment adjustment;
  const Status read = readEntry(json, adjustmentSchema(name->isAttribute, units), unknown, adjustment);
  return read ? Result<rig::Adjustment>(std::move(adjustment)) : Result<rig::Adjustment>(read.error());
}

} // namespace stretch::app

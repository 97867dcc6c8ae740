#include "app/schema/hold_json.h"

#include <algorithm>
#include <utility>

#include "app/schema/entry_schema.h"

namespace stretch::app {

namespace {

using gltf::Json;

// What may be missing in a hold is there while it is read.
struct PinEntry {
  rig::Pin pin;
  rig::HeldPlace place;
};

struct PropEntry {
  rig::Prop prop;
  rig::HoldTime time;
};

template <typename T, typename Access>
EntryMember<T> relationMember(const std::string& key, Access access) {
  return {key,
          [access](const T& entry) {
            const std::optional<double>& frame = std::invoke(access, entry);
            return frame ? Json(*frame) : Json("source");
          },
          [access, key](const Json& json, T& entry) -> Status {
            if (json != "source" && !json.is_number()) {
              return Error{json.dump() + " is no relation", key,
                           R"(give "source", as the clip has it at each frame, or one frame)"};
            }
            std::invoke(access, entry) = json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
            return Success{};
          }};
}

Json handsToJson(const std::vector<rig::PropHand>& hands, const AdjustmentUnits& units) {
  Json json = Json::object();
  for (const rig::PropHand& hand : hands) {
    json[hand.limb] = offsetKeysToJson(hand.keys, true, units);
  }
  return json;
}

Status readHands(const Json& json, std::vector<rig::PropHand>& hands) {
  if (!json.is_object()) {
    return Error{"is not an object", "hands", R"(give {"right-arm": [{"frame": 0, "value": 1}]})"};
  }
  for (const auto& [limb, keys] : json.items()) {
    Result<std::vector<rig::OffsetKey>> read = offsetKeysFromJson(keys, true, {});
    if (!read) {
      return Error{read.error().what, "hands." + limb + "." + read.error().where, read.error().remedy};
    }
    hands.push_back({limb, std::move(*read)});
  }
  return Success{};
}

EntrySchema<PinEntry> pinSchema(const AdjustmentUnits& units) {
  const auto isPlaced = [](const PinEntry& entry) { return entry.pin.place.has_value(); };
  return {
      needed(entryMember("limb", 1.0, &PinEntry::pin, &rig::Pin::limb)),
      needed(entryMember("range", 1.0, &PinEntry::pin, &rig::Pin::time, &rig::HoldTime::rangeFrames)),
      entryMember("blend", 1.0, &PinEntry::pin, &rig::Pin::time, &rig::HoldTime::blendFrames),
      entryMember("at", 1.0, &PinEntry::pin, &rig::Pin::atFrame),
      entryMember("turn", 1.0, &PinEntry::pin, &rig::Pin::turns),
      entryMember("stretch", 1.0, &PinEntry::pin, &rig::Pin::stretch),
      writtenWhere(isPlaced, entryMember("place", units.length, &PinEntry::place, &rig::HeldPlace::position)),
      writtenWhere(isPlaced, entryMember("orientation", 1.0, &PinEntry::place, &rig::HeldPlace::orientation)),
  };
}

EntrySchema<rig::Grip> gripSchema() {
  return {needed(entryMember("leader", 1.0, &rig::Grip::leader)),
          needed(entryMember("follower", 1.0, &rig::Grip::follower)),
          needed(entryMember("range", 1.0, &rig::Grip::time, &rig::HoldTime::rangeFrames)),
          entryMember("blend", 1.0, &rig::Grip::time, &rig::HoldTime::blendFrames),
          relationMember<rig::Grip>("relation", &rig::Grip::relationFrame),
          entryMember("stretch", 1.0, &rig::Grip::stretch)};
}

EntrySchema<PropEntry> propSchema(const AdjustmentUnits& units) {
  const auto isTimed = [](const PropEntry& entry) { return entry.prop.time.has_value(); };
  return {
      needed(entryMember("node", 1.0, &PropEntry::prop, &rig::Prop::node)),
      relationMember<PropEntry>(
          "bound_at", [](auto& entry) -> auto& { return entry.prop.boundFrame; }),
      writtenWhere(isTimed, entryMember("range", 1.0, &PropEntry::time, &rig::HoldTime::rangeFrames)),
      writtenWhere(isTimed, entryMember("blend", 1.0, &PropEntry::time, &rig::HoldTime::blendFrames)),
      entryMember("move", units.length, &PropEntry::prop, &rig::Prop::move),
      entryMember("turn", units.angle, &PropEntry::prop, &rig::Prop::turn),
      entryMember("stretch", 1.0, &PropEntry::prop, &rig::Prop::stretch),
      {"hands", [units](const PropEntry& entry) { return handsToJson(entry.prop.hands, units); },
       [](const Json& json, PropEntry& entry) { return readHands(json, entry.prop.hands); }, true},
  };
}

template <typename T>
Status readHold(const Json& json, const EntrySchema<T>& schema, const std::vector<std::string>& allowed,
                T& entry) {
  return readEntry(
      json, schema,
      [&](const std::string& key) {
        const bool isCallers = std::ranges::find(allowed, key) != allowed.end();
        return isCallers ? Status(Success{}) : Status(Error{"is not a part of it", key, keysOf(schema)});
      },
      entry);
}

} // namespace

Json pinToJson(const rig::Pin& pin, const AdjustmentUnits& units) {
  return writeEntry(pinSchema(units), PinEntry{pin, pin.place.value_or(rig::HeldPlace{})});
}

Result<rig::Pin> pinFromJson(const Json& json, const AdjustmentUnits& units,
                             const std::vector<std::string>& allowed) {
  PinEntry entry;
  if (const Status read = readHold(json, pinSchema(units), allowed, entry); !read) {
    return read.error();
  }
  rig::Pin& pin = entry.pin;
  if (!json.contains("at")) {
    pin.atFrame = pin.time.rangeFrames.x;
  }
  if (json.contains("place")) {
    pin.place = entry.place;
    pin.turns = pin.turns && json.contains("orientation");
  }
  return std::move(pin);
}

Json gripToJson(const rig::Grip& grip) {
  return writeEntry(gripSchema(), grip);
}

Result<rig::Grip> gripFromJson(const Json& json, const std::vector<std::string>& allowed) {
  rig::Grip grip;
  const Status read = readHold(json, gripSchema(), allowed, grip);
  return read ? Result<rig::Grip>(std::move(grip)) : Result<rig::Grip>(read.error());
}

Json propToJson(const rig::Prop& prop, const AdjustmentUnits& units) {
  return writeEntry(propSchema(units), PropEntry{prop, prop.time.value_or(rig::HoldTime{})});
}

Result<rig::Prop> propFromJson(const Json& json, const AdjustmentUnits& units,
                               const std::vector<std::string>& allowed) {
  PropEntry entry;
  if (const Status read = readHold(json, propSchema(units), allowed, entry); !read) {
    return read.error();
  }
  if (json.contains("range")) {
    entry.prop.time = entry.time;
  } else if (json.contains("blend")) {
    return Error{"comes with no range", "blend", R"(give "range", or leave it out)"};
  }
  return std::move(entry.prop);
}

} // namespace stretch::app

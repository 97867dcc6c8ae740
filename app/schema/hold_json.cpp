#include "app/schema/hold_json.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <glm/geometric.hpp>

#include "app/schema/schema_json.h"

namespace stretch::app {

namespace {

using gltf::Json;

/// A key of an entry, with what reads its value.
struct HoldMember {
  std::string key;
  std::function<Status(const Json&)> read;
  bool isNeeded = false;
};

std::string memberNames(const std::vector<HoldMember>& members) {
  std::string names;
  for (const HoldMember& member : members) {
    names += (names.empty() ? "" : ", ") + member.key;
  }
  return names;
}

Status readMembers(const Json& json, const std::vector<HoldMember>& members,
                   const std::vector<std::string>& allowed) {
  if (!json.is_object()) {
    return Error{json.dump() + " is not an object", "", "give an object with " + memberNames(members)};
  }
  for (const HoldMember& member : members) {
    if (member.isNeeded && !json.contains(member.key)) {
      return Error{"is missing", member.key, "give an object with " + memberNames(members)};
    }
  }
  for (const auto& [key, value] : json.items()) {
    const auto known = std::ranges::find(members, key, &HoldMember::key);
    if (known == members.end()) {
      if (std::ranges::find(allowed, key) == allowed.end()) {
        return Error{"is not a part of it", key, "give an object with " + memberNames(members)};
      }
      continue;
    }
    if (Status read = known->read(value); !read) {
      return read;
    }
  }
  return Success{};
}

HoldMember textMember(const std::string& key, std::string& text) {
  return {key,
          [key, &text](const Json& json) -> Status {
            if (!json.is_string()) {
              return Error{json.dump() + " is not a name", key, "give a name in quotes"};
            }
            text = json.get<std::string>();
            return Success{};
          },
          true};
}

HoldMember numberMember(const std::string& key, double& number) {
  return {key, [key, &number](const Json& json) -> Status {
            if (!json.is_number()) {
              return Error{json.dump() + " is not a number", key, "give a number"};
            }
            number = json.get<double>();
            return Success{};
          }};
}

HoldMember pairMember(const std::string& key, Vec2& pair) {
  return {
      key, [key, &pair](const Json& json) -> Status {
        if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number()) {
          return Error{json.dump() + " is not a pair of frames", key, "give two numbers, such as [0, 12]"};
        }
        pair = {json[0].get<double>(), json[1].get<double>()};
        return Success{};
      }};
}

HoldMember vectorMember(const std::string& key, double unit, Vec3& vector) {
  return {key, [key, unit, &vector](const Json& json) -> Status {
            const Result<Vec3> read = vectorFromJson(json, key);
            vector = read ? *read * unit : vector;
            return read ? Status(Success{}) : Status(read.error());
          }};
}

HoldMember quaternionMember(const std::string& key, Quat& quaternion) {
  return {key, [key, &quaternion](const Json& json) -> Status {
            const Result<Quat> read = quaternionFromJson(json, key);
            quaternion = read ? *read : quaternion;
            return read ? Status(Success{}) : Status(read.error());
          }};
}

HoldMember flagMember(const std::string& key, bool& flag) {
  return {key, [key, &flag](const Json& json) -> Status {
            if (!json.is_boolean()) {
              return Error{json.dump() + " is neither true nor false", key, "give true or false"};
            }
            flag = json.get<bool>();
            return Success{};
          }};
}

HoldMember needed(HoldMember member) {
  member.isNeeded = true;
  return member;
}

Json pairToJson(const Vec2& pair) {
  return Json::array({pair.x, pair.y});
}

void addTime(const rig::HoldTime& time, Json& json) {
  json["range"] = pairToJson(time.rangeFrames);
  json["blend"] = pairToJson(time.blendFrames);
}

Json relationToJson(const std::optional<double>& frame) {
  return frame ? Json(*frame) : Json("source");
}

HoldMember relationMember(const std::string& key, std::optional<double>& frame) {
  return {key, [key, &frame](const Json& json) -> Status {
            if (json != "source" && !json.is_number()) {
              return Error{json.dump() + " is no relation", key,
                           R"(give "source", as the clip has it at each frame, or one frame)"};
            }
            frame = json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
            return Success{};
          }};
}

HoldMember handsMember(std::vector<rig::PropHand>& hands) {
  return {
      "hands",
      [&hands](const Json& json) -> Status {
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
      },
      true};
}

} // namespace

Json pinToJson(const rig::Pin& pin, const AdjustmentUnits& units) {
  Json json{{"limb", pin.limb}};
  addTime(pin.time, json);
  json["at"] = pin.atFrame;
  json["turn"] = pin.turns;
  json["stretch"] = pin.stretch;
  if (pin.place) {
    json["place"] = vectorToJson(pin.place->position / units.length);
    json["orientation"] = quaternionToJson(pin.place->orientation);
  }
  return json;
}

Result<rig::Pin> pinFromJson(const Json& json, const AdjustmentUnits& units,
                             const std::vector<std::string>& allowed) {
  rig::Pin pin;
  rig::HeldPlace place;
  const Status read =
      readMembers(json,
                  {textMember("limb", pin.limb), needed(pairMember("range", pin.time.rangeFrames)),
                   pairMember("blend", pin.time.blendFrames), numberMember("at", pin.atFrame),
                   flagMember("turn", pin.turns), numberMember("stretch", pin.stretch),
                   vectorMember("place", units.length, place.position),
                   quaternionMember("orientation", place.orientation)},
                  allowed);
  if (!read) {
    return read.error();
  }
  if (!json.contains("at")) {
    pin.atFrame = pin.time.rangeFrames.x;
  }
  if (json.contains("place")) {
    pin.place = place;
    pin.turns = pin.turns && json.contains("orientation");
  }
  return pin;
}

Json gripToJson(const rig::Grip& grip) {
  Json json{{"leader", grip.leader}, {"follower", grip.follower}};
  addTime(grip.time, json);
  json["relation"] = relationToJson(grip.relationFrame);
  json["stretch"] = grip.stretch;
  return json;
}

Result<rig::Grip> gripFromJson(const Json& json, const std::vector<std::string>& allowed) {
  rig::Grip grip;
  const Status read = readMembers(
      json,
      {textMember("leader", grip.leader), textMember("follower", grip.follower),
       needed(pairMember("range", grip.time.rangeFrames)), pairMember("blend", grip.time.blendFrames),
       relationMember("relation", grip.relationFrame), numberMember("stretch", grip.stretch)},
      allowed);
  return read ? Result<rig::Grip>(std::move(grip)) : Result<rig::Grip>(read.error());
}

Json propToJson(const rig::Prop& prop, const AdjustmentUnits& units) {
  Json json{{"node", prop.node}, {"bound_at", relationToJson(prop.boundFrame)}};
  if (prop.time) {
    addTime(*prop.time, json);
  }
  json["move"] = vectorToJson(prop.move / units.length);
  json["turn"] = vectorToJson(prop.turn / units.angle);
  json["stretch"] = prop.stretch;
  json["hands"] = Json::object();
  for (const rig::PropHand& hand : prop.hands) {
    json["hands"][hand.limb] = offsetKeysToJson(hand.keys, true, units);
  }
  return json;
}

Result<rig::Prop> propFromJson(const Json& json, const AdjustmentUnits& units,
                               const std::vector<std::string>& allowed) {
  rig::Prop prop;
  rig::HoldTime time;
  const Status read = readMembers(
      json,
      {textMember("node", prop.node), relationMember("bound_at", prop.boundFrame),
       pairMember("range", time.rangeFrames), pairMember("blend", time.blendFrames),
       vectorMember("move", units.length, prop.move), vectorMember("turn", units.angle, prop.turn),
       numberMember("stretch", prop.stretch), handsMember(prop.hands)},
      allowed);
  if (!read) {
    return read.error();
  }
  if (json.contains("range")) {
    prop.time = time;
  } else if (json.contains("blend")) {
    return Error{"comes with no range", "blend", R"(give "range", or leave it out)"};
  }
  return prop;
}

} // namespace stretch::app

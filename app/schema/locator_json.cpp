#include "app/schema/locator_json.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/ranges.h>
#include <glm/geometric.hpp>

#include "app/schema/entry_schema.h"
#include "core/base/file.h"
#include "core/gltf/source/json_text.h"
#include "core/math/finite.h"

namespace stretch::app {

namespace {

using gltf::Json;

constexpr double farthestPlace = 1e9; ///< Single precision, which files hold, still tells bones apart there.

Result<std::string> locatorName(const Json& json, const rig::LocatorPlan& plan, const std::string& where) {
  if (!json.is_object() || !json.contains("name") || !json["name"].is_string()) {
    return Error{"names no joint", where, R"(give "name", such as "leftUpperArm")"};
  }
  const auto name = json["name"].get<std::string>();
  if (rig::findJoint(plan, name) == nullptr) {
    const std::size_t middle = plan.joints.size() / 2;
    return Error{"'" + name + "' is not a joint of the plan " + plan.id, where,
                 fmt::format("give one of its names, such as {}, {}, {}", plan.joints[middle - 1].name,
                             plan.joints[middle].name, plan.joints[middle + 1].name)};
  }
  return name;
}

Status readPosition(const Json& json, Vec3& position) {
  if (Status read = readValue(json, "position", 1.0, position); !read) {
    return read;
  }
  const bool canBeHeld = isFinite(position) && glm::length(position) <= farthestPlace;
  return canBeHeld ? Status(Success{})
                   : Status(Error{"has a coordinate that no file can hold", "position",
                                  "give finite numbers up to 1e9"});
}

Status readTurn(const Json& json, Quat& turn) {
  if (Status read = readValue(json, "orientation", 1.0, turn); !read) {
    return read;
  }
  const double length = glm::length(turn);
  constexpr double shortest = 1e-6;
  if (!std::isfinite(length) || length < shortest) {
    return Error{"the four numbers are no turn", "orientation",
                 "give a unit quaternion x, y, z, w, or leave it out"};
  }
  constexpr double asWritten = 1e-9; // what is written reads back the same, to the last digit
  turn = std::abs(length - 1.0) < asWritten ? turn : turn / length;
  return Success{};
}

Status readConfidence(const Json& json, double& confidence) {
  if (!readValue(json, "confidence", 1.0, confidence) || !(confidence >= 0.0 && confidence <= 1.0)) {
    return Error{json.dump() + " is not a confidence", "confidence", "give a number from 0 to 1"};
  }
  return Success{};
}

EntrySchema<rig::Locator> locatorSchema() {
  EntrySchema<rig::Locator> schema{entryMember("name", 1.0, &rig::Locator::name),
                                   entryMember("position", 1.0, &rig::Locator::position),
                                   entryMember("orientation", 1.0, &rig::Locator::orientation),
                                   entryMember("confidence", 1.0, &rig::Locator::confidence)};
  schema[1].read = [](const Json& json, rig::Locator& one) { return readPosition(json, one.position); };
  schema[2].read = [](const Json& json, rig::Locator& one) { return readTurn(json, one.orientation); };
  schema[3].read = [](const Json& json, rig::Locator& one) { return readConfidence(json, one.confidence); };
  return schema;
}

// `place`: the entry's in its list, for one without a name.
Result<rig::Locator> locatorFromJson(const Json& json, const rig::LocatorPlan& plan,
                                     const std::string& place) {
  const Result<std::string> name = locatorName(json, plan, place);
  if (!name) {
    return name.error();
  }
  const auto unknown = [](const std::string& key) -> Status {
    return Error{"'" + key + "' is not a part of a locator", "",
                 "give name, position, orientation, confidence"};
  };
  rig::Locator locator;
  Json entry = json;
  entry["position"] = json.value("position", Json()); // one without is no vector
  if (const Status read = readEntry(entry, locatorSchema(), unknown, locator); !read) {
    const Error& error = read.error();
    return Error{error.what, *name + (error.where.empty() ? "" : "." + error.where), error.remedy};
  }
  return locator;
}

Result<const rig::LocatorPlan*> planOf(const Json& json) {
  if (!json.is_object() || !json.contains("locators") || !json["locators"].is_array()) {
    return Error{"holds no locators", "", R"(give {"plan": "biped", "locators": [...]})"};
  }
  for (const auto& [key, value] : json.items()) {
    if (key != "plan" && key != "locators") {
      return Error{"is not a part of a file of locators", key, "give plan and locators"};
    }
  }
  const Json id = json.value("plan", Json("biped"));
  const rig::LocatorPlan* const plan = id.is_string() ? rig::locatorPlan(id.get<std::string>()) : nullptr;
  if (plan == nullptr) {
    return Error{id.dump() + " has no locators", "plan",
                 fmt::format("give one of: {}", fmt::join(rig::locatorPlanIds(), ", "))};
  }
  return plan;
}

// What bones cannot be built from.
Status checkWhole(const rig::Locators& locators) {
  if (const std::vector<std::string> missing = rig::missingLocators(locators); !missing.empty()) {
    return Error{fmt::format("has no locator for {}", fmt::join(missing, ", ")), "locators",
                 "add them; rig --locators-only writes a whole set"};
  }
  for (const rig::Locator& locator : locators.list) {
    const rig::Locator* const parent = rig::findLocator(locators, rig::parentLocator(locators, locator.name));
    if (parent != nullptr && parent->position == locator.position) {
      return Error{"stands where " + parent->name + " stands", locator.name, "move one of the two"};
    }
  }
  return Success{};
}

} // namespace

Json locatorsToJson(const rig::Locators& locators) {
  Json json{{"plan", locators.plan}, {"locators", Json::array()}};
  for (const rig::Locator& locator : locators.list) {
    json["locators"].push_back(writeEntry(locatorSchema(), locator));
  }
  return json;
}

Result<rig::Locators> locatorsFromJson(const Json& json) {
  const Result<const rig::LocatorPlan*> plan = planOf(json);
  if (!plan) {
    return plan.error();
  }
  rig::Locators locators{(*plan)->id, {}};
  bool hasTurns = false;
  for (const Json& entry : json["locators"]) {
    Result<rig::Locator> locator =
        locatorFromJson(entry, **plan, "locators[" + std::to_string(locators.list.size()) + "]");
    if (!locator) {
      return locator.error();
    }
    if (rig::findLocator(locators, locator->name) != nullptr) {
      return Error{"comes twice", locator->name, "remove one of the two"};
    }
    hasTurns = hasTurns || entry.contains("orientation");
    locators.list.push_back(std::move(*locator));
  }
  if (Status whole = checkWhole(locators); !whole) {
    return whole.error();
  }
  locators = rig::inOrder(std::move(locators));
  return hasTurns ? locators : rig::alongBones(std::move(locators));
}

Result<rig::Locators> loadLocators(const std::filesystem::path& path) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return text.error();
  }
  const Result<Json> json =
      gltf::parseHandwrittenJson(*text, "check the file for a missing comma or bracket");
  Result<rig::Locators> locators = json ? locatorsFromJson(*json) : Result<rig::Locators>(json.error());
  if (!locators) {
    const Error& error = locators.error();
    return inFile(path.string(), error);
  }
  return locators;
}

} // namespace stretch::app

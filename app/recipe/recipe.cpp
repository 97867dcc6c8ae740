#include "app/recipe/recipe.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "app/edits/keys/rate_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/starting_settings.h"
#include "app/evaluate/clip_moments.h"
#include "app/named.h"
#include "app/recipe/recipe_parts.h"
#include "app/reference/reference_edits.h"
#include "app/schema/adjustment_json.h"
#include "app/schema/trail_schema.h"
#include "app/schema/weight_schema.h"
#include "app/things/time_map.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/json_text.h"
#include "rig/body/reading/planned_body.h"
#include "rig/controllers/controller.h"

namespace stretch::app {

namespace {

using gltf::Json;

constexpr int recipeVersion = 1;
constexpr int mostGroups = 1000000;

Status checkKeys(const Json& json) {
  const std::vector<std::string> known{"version", "clip",    "units",       "frames_per_second",
                                       "trails",  "elastic", "adjustments", "pins",
                                       "grips",   "props",   "references",  "loops"};
  for (const auto& [key, value] : json.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      return Error{"is not a key of a recipe", key, "remove it, or correct its name"};
    }
    const bool isList = key == "pins" || key == "grips" || key == "props" || key == "adjustments";
    if (isList && !value.is_array()) {
      return Error{"is not a list", key, "give a list, as docs/recipes.md tells"};
    }
  }
  if (!json.contains("version") || json["version"] != recipeVersion) {
    return Error{"this program does not know this version of recipes", "version",
                 fmt::format("give {}", recipeVersion)};
  }
  const bool isWithoutTrails =
      !json.contains("trails") &&
      std::ranges::any_of(std::array{"elastic", "adjustments", "pins", "grips", "props", "references"},
                          [&](const char* key) { return json.contains(key); });
  if (!isWithoutTrails && (!json.contains("trails") || !json["trails"].is_array())) {
    return Error{"there is no list of trails", "trails", "give a list, empty or not"};
  }
  if (json.contains("frames_per_second") &&
      !(json["frames_per_second"].is_number() && json["frames_per_second"].get<double>() > 0.0)) {
    return Error{"is not a rate", "frames_per_second", "give a number above 0, or leave it out"};
  }
  if (json.contains("loops") && !json["loops"].is_boolean()) {
    return Error{json["loops"].dump() + " is neither true nor false", "loops", "give one, or leave it out"};
  }
  if (json.contains("clip") && !json["clip"].is_string()) {
    return Error{json["clip"].dump() + " is not the name of a clip", "clip",
                 R"(give its name or its place as text, such as "Walk" or "#1", or leave it out)"};
  }
  if (json.contains("elastic") && !json["elastic"].is_array()) {
    return Error{"is not a list", "elastic", "give a list of {\"limb\": ..., settings}"};
  }
  return Success{};
}

using LimbNames = std::set<std::string>;

void addName(const Json& entry, const char* key, LimbNames& names) {
  if (entry.is_object() && entry.contains(key) && entry[key].is_string()) {
    names.insert(entry[key].get<std::string>());
  }
}

void addNamesOfList(const Json& json, const char* list, std::initializer_list<const char*> keys,
                    LimbNames& names) {
  for (const Json& entry : json.value(list, Json::array())) {
    for (const char* const key : keys) {
      addName(entry, key, names);
    }
  }
}

// Limbs that the lists of a recipe name, whatever else stands in them.
LimbNames limbsNamed(const Json& json) {
  LimbNames limbs;
  for (const char* const list : {"trails", "elastic", "pins"}) {
    addNamesOfList(json, list, {"limb"}, limbs);
  }
  addNamesOfList(json, "grips", {"leader", "follower"}, limbs);
  for (const Json& prop : json.value("props", Json::array())) {
    const Json hands = prop.is_object() ? prop.value("hands", Json::object()) : Json::object();
    for (const auto& [limb, keys] : hands.items()) {
      limbs.insert(hands.is_object() ? limb : std::string());
    }
  }
  limbs.erase(std::string());
  return limbs;
}

// Of any plan: "left-hand" and "left-arm.stretch" are left-arm's.
std::string limbOfPlannedController(const std::string& id) {
  const std::string name = id.substr(0, id.find('.'));
  if (name.empty()) {
    return {};
  }
  if (name.starts_with("spine-")) {
    return "spine";
  }
  for (const rig::BodyPlan& plan : rig::bodyPlans()) {
    for (const rig::PlannedLimb& planned : plan.limbs) {
      rig::Limb limb;
      static_cast<rig::LimbPlace&>(limb) = planned.place;
      limb.id = planned.id;
      if (name == limb.id || name == rig::endController(limb) || name == rig::poleController(limb)) {
        return limb.id;
      }
    }
  }
  return {};
}

// Limbs whose controllers or attributes a recipe adjusts and this character lacks.
LimbNames limbsOfLackingControllers(const Json& json, const Document& document) {
  LimbNames ids;
  addNamesOfList(json, "adjustments", {"controller", "attribute"}, ids);
  const rig::ControllerList list = controllersOf(document);
  LimbNames limbs;
  for (const std::string& id : ids) {
    if (list.attribute(id) == nullptr && !findController(document, list, id)) {
      limbs.insert(limbOfPlannedController(id));
    }
  }
  limbs.erase(std::string());
  return limbs;
}

// All limbs that a recipe for another body names, in one line.
Status checkLimbs(const Json& json, const Document& document) {
  if (document.body.plan == "biped") {
    return Success{};
  }
  LimbNames lacking = limbsNamed(json);
  lacking.merge(limbsOfLackingControllers(json, document));
  std::erase_if(lacking, [&](const std::string& limb) {
    return limb.find("..") != std::string::npos || findLimb(document, limb) != nullptr;
  });
  if (lacking.empty()) {
    return Success{};
  }
  std::string names;
  for (const std::string& limb : lacking) {
    names += (names.empty() ? "" : ", ") + limb;
  }
  return Error{"the character is " + planOf(document.body).title + " and lacks " + names, "limb",
               "name limbs that it has; info lists them"};
}

// The limb that an entry names; a chain joins the document.
Result<rig::Limb> limbOf(const Json& json, Document& document) {
  if (!json.is_object() || !json.contains("limb") || !json["limb"].is_string()) {
    return Error{"names no limb", "", R"(give "limb", such as "left-arm")"};
  }
  return findOrAddLimb(document, json["limb"].get<std::string>(), "limb");
}

Status readColour(const Json& json, rig::Trail& trail) {
  if (!json.is_number_integer() || json.get<int>() < 0) {
    return Error{json.dump() + " is not a colour", "colour", "give the number of a trail colour, from 0"};
  }
  trail.colour = json.get<int>();
  return Success{};
}

Status readGroup(const Json& json, rig::Trail& trail) {
  if (!json.is_number_integer() || json.get<int>() < 0 || json.get<int>() > mostGroups) {
    return Error{json.dump() + " is not a group", "group",
                 "give the same number, above 0, to trails of one group"};
  }
  trail.group = json.get<int>();
  return Success{};
}

Status readControlFrames(const Json& json, rig::Trail& trail) {
  const auto isNumber = [](const Json& entry) { return entry.is_number(); };
  if (!json.is_array() || !std::ranges::all_of(json, isNumber)) {
    return Error{"is not a list of frames", "control_frames", "give numbers, such as [24, 27.5, 30]"};
  }
  trail.controlFrames = json.get<std::vector<double>>();
  std::ranges::sort(trail.controlFrames);
  return Success{};
}

Status readTrailRange(const Json& json, const rig::Limb& limb, Document& document, rig::Trail& trail) {
  if (!json.contains("range")) {
    const Vec2 range = defaultRange(document, trail.clip, limb);
    trail.settings.startFrame = range.x;
    trail.settings.endFrame = range.y;
  }
  return Success{};
}

Result<rig::Trail> trailOf(const Json& json, int clip, bool inMetres, Document& document) {
  const Result<rig::Limb> limb = limbOf(json, document);
  if (!limb) {
    return limb.error();
  }
  rig::Trail trail;
  trail.limb = limb->id;
  trail.clip = clip;
  trail.settings = usualTrail(document, *limb);
  const double lengthUnit = inMetres ? 1.0 : limb->restLength;
  Status read =
      trailFromJson(json, lengthUnit, {"limb", "colour", "group", "control_frames"}, trail.settings);
  if (read && json.contains("colour")) {
    read = readColour(json["colour"], trail);
  }
  if (read && json.contains("group")) {
    read = readGroup(json["group"], trail);
  }
  if (read && json.contains("control_frames")) {
    read = readControlFrames(json["control_frames"], trail);
  }
  if (read) {
    read = readTrailRange(json, *limb, document, trail);
  }
  return read ? Result<rig::Trail>(std::move(trail)) : Result<rig::Trail>(read.error());
}

Result<WeightedLimb> weightOf(const Json& json, const Recipe& recipe, Document& document) {
  const Result<rig::Limb> limb = limbOf(json, document);
  if (!limb) {
    return limb.error();
  }
  WeightedLimb entry{limb->id, recipe.clip, true, usualWeight(document, limb->id)};
  if (std::ranges::any_of(recipe.weights, [&](const WeightedLimb& other) { return meets(other, entry); })) {
    return Error{"the limb " + limb->id + " is named twice", "limb", "name it once"};
  }
  const Status read = weightFromJson(json, {"limb"}, entry.settings);
  return read ? Result<WeightedLimb>(std::move(entry)) : Result<WeightedLimb>(read.error());
}

Result<rig::Adjustment> adjustmentOf(const Json& json, int clip, bool inMetres, const Document& document,
                                     const rig::ControllerList& list) {
  const Result<AdjustedName> name = adjustedName(json);
  if (!name) {
    return name.error();
  }
  if (name->isAttribute && list.attribute(name->id) == nullptr) {
    return Error{"the character has no attribute '" + name->id + "'", "attribute",
                 "'info --json' lists those that it has"};
  }
  const Result<rig::Controller> controller = name->isAttribute ? Result<rig::Controller>(rig::Controller{})
                                                               : findController(document, list, name->id);
  if (!controller) {
    return controller.error();
  }
  Result<rig::Adjustment> adjustment = adjustmentFromJson(json, unitsOf(controller->length, inMetres), {});
  if (adjustment) {
    adjustment->clip = clip;
  }
  return adjustment;
}

Json adjustmentsToJson(const Document& document, int clip) {
  const rig::ControllerList list = controllersOf(document);
  Json entries = Json::array();
  for (const rig::Adjustment& adjustment : document.adjustments) {
    const bool isAttribute = list.attribute(adjustment.controller) != nullptr;
    const Result<rig::Controller> controller = isAttribute
                                                   ? Result<rig::Controller>(rig::Controller{})
                                                   : findController(document, list, adjustment.controller);
    if (adjustment.clip == clip && controller) {
      entries.push_back(adjustmentToJson(adjustment, isAttribute, unitsOf(controller->length, false)));
    }
  }
  return entries;
}

/// `framesOfFrame`: frames of the clip for each one of the recipe.
Status readReference(const Json& json, const std::filesystem::path& folder, double framesOfFrame,
                     Recipe& recipe) {
  recipe.reference.clip = recipe.clip;
  if (!json.contains("references")) {
    return Success{};
  }
  const Result<Reference> read = referenceFromJson(json["references"], recipe.clip, folder.string());
  if (!read) {
    const Error& error = read.error();
    return Error{error.what, error.where.empty() ? "references" : "references." + error.where, error.remedy};
  }
  recipe.reference = mapped(*read, TimeMap{.factor = framesOfFrame});
  return Success{};
}

} // namespace

AdjustmentUnits unitsOf(double limbLength, bool inMetres) {
  constexpr double degree = pi / 180.0;
  return {inMetres ? 1.0 : limbLength, degree};
}

Result<Recipe> recipeFromJson(const Json& json, Document& document, std::optional<int> wantedClip,
                              const std::filesystem::path& folder) {
  if (!json.is_object()) {
    return Error{"is not a JSON object", "recipe", R"(give {"version": 1, "trails": [...]})"};
  }
  if (const Status keys = checkKeys(json); !keys) {
    return keys.error();
  }
  const Result<int> clip =
      wantedClip ? Result<int>(*wantedClip) : findClip(document, json.value("clip", std::string()), "clip");
  if (!clip) {
    return clip.error();
  }
  if (const Status limbs = checkLimbs(json, document); !limbs) {
    return limbs.error();
  }
  const Json units = json.value("units", Json("limb_lengths"));
  if (units != "metres" && units != "limb_lengths") {
    return Error{units.dump() + " is not a unit of a recipe", "units", R"(give "metres" or "limb_lengths")"};
  }
  Recipe recipe;
  recipe.clip = *clip;
  recipe.loops = json.value("loops", false);
  // The recipe's frames are read as those of a clip that is worked on at its rate, and then counted in the
  // clip's.
  const double rate = clipOf(document, *clip).framesPerSecond;
  const double recipeRate = json.value("frames_per_second", rate);
  Document asInRecipe = workAtRate(document, *clip, recipeRate);
  const double lastFrame = clipOf(asInRecipe, *clip).endSeconds * recipeRate;
  const RecipeGround ground{document, *clip, units == "metres", lastFrame};
  Status read = readList(json, "trails", ground, recipe.trails, [&](const Json& entry) {
    return trailOf(entry, *clip, ground.inMetres, asInRecipe);
  });
  if (read) {
    read = readList(json, "elastic", ground, recipe.weights,
                    [&](const Json& entry) { return weightOf(entry, recipe, asInRecipe); });
  }
  if (read) {
    const rig::ControllerList list = controllersOf(document);
    read = readList(json, "adjustments", ground, recipe.adjustments, [&](const Json& entry) {
      return adjustmentOf(entry, *clip, ground.inMetres, document, list);
    });
  }
  if (read) {
    Result<rig::Holds> holds = holdsFromRecipe(json, ground);
    read = holds ? Status(Success{}) : Status(holds.error());
    recipe.holds = holds ? std::move(*holds) : rig::Holds{};
  }
  document.chains = std::move(asInRecipe.chains);
  eachList(recipe, [&](auto& list) {
    for (auto& thing : list) {
      thing = mapped(std::move(thing), TimeMap{.factor = rate / recipeRate});
    }
  });
  read = read ? readReference(json, folder, rate / recipeRate, recipe) : read;
  read = read ? addPropFiles(json, ground.inMetres, folder, recipe, document) : read;
  return read ? Result<Recipe>(std::move(recipe)) : Result<Recipe>(read.error());
}

Result<Recipe> loadRecipe(const std::filesystem::path& path, Document& document, std::optional<int> clip) {
  if (const Result<int> any = findClip(document, "", ""); !any) {
    return any.error(); // the character's fault, not the recipe's: no place in the recipe is named
  }
  const Result<std::string> text = readText(path);
  if (!text) {
    return text.error();
  }
  const Result<Json> json = gltf::parseHandwrittenJson(*text, "give a recipe, as the editor saves it");
  Result<Recipe> recipe =
      json ? recipeFromJson(*json, document, clip, path.parent_path()) : Result<Recipe>(json.error());
  if (!recipe) {
    const Error& error = recipe.error();
    return inFile(path.string(), error);
  }
  return recipe;
}

Json recipeToJson(const Document& document, int clip) {
  Json json;
  json["version"] = recipeVersion;
  json["clip"] = clipOf(document, clip).name;
  if (ownRate(document, clip) != clipOf(document, clip).framesPerSecond) {
    json["frames_per_second"] = clipOf(document, clip).framesPerSecond;
  }
  if (isLooping(document, clip)) {
    json["loops"] = true;
  }
  json["trails"] = Json::array();
  for (const rig::Trail& trail : document.trails) {
    const rig::Limb* const limb = findLimb(document, trail.limb);
    const bool isAside = trail.exaggerated && !trail.connected; // like weight that is off
    if (trail.clip == clip && limb != nullptr && !isAside) {
      Json entry = trailToJson(trail.settings, limb->restLength);
      entry["limb"] = trail.limb;
      entry["colour"] = trail.colour;
      if (!trail.controlFrames.empty()) {
        entry["control_frames"] = trail.controlFrames;
      }
      if (!groupMembers(document, trail.id).empty()) {
        entry["group"] = trail.group;
      }
      json["trails"].push_back(std::move(entry));
    }
  }
  if (Json adjustments = adjustmentsToJson(document, clip); !adjustments.empty()) {
    json["adjustments"] = std::move(adjustments);
  }
  addHoldsToRecipe(document, clip, json);
  for (const WeightedLimb& limb : document.weights) {
    if (limb.clip == clip && limb.on) {
      Json entry = weightToJson(limb.settings);
      entry["limb"] = limb.limb;
      json["elastic"].push_back(std::move(entry));
    }
  }
  if (Json reference = referenceToJson(referenceOf(document, clip)); !reference.empty()) {
    json["references"] = std::move(reference);
  }
  return json;
}

} // namespace stretch::app

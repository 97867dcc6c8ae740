#include "app/recipe/recipe.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/batch/options.h"
#include "app/schema/trail_json.h"
#include "app/schema/weight_description.h"
#include "core/base/file.h"
#include "core/gltf/json.h"
#include "rig/motion/motion.h"

namespace stretch::app {

namespace {

using gltf::Json;

constexpr int recipeVersion = 1;

Error unknownKey(const std::string& key) {
  return {"is no key of a recipe", key, "remove it, or correct its name"};
}

Status checkKeys(const Json& json) {
  const std::vector<std::string> known{"version", "clip", "units", "trails", "props", "elastic"};
  for (const auto& [key, value] : json.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      return unknownKey(key);
    }
    if (key == "props" && !(value.is_array() && value.empty())) {
      return Error{"is not played by this version", key, "leave it out or give an empty list"};
    }
  }
  if (!json.contains("version") || json["version"] != recipeVersion) {
    return Error{"the recipe is of a version that this program does not know", "version",
                 fmt::format("give {}", recipeVersion)};
  }
  if (!json.contains("trails") || !json["trails"].is_array()) {
    return Error{"there is no list of trails", "trails", "give a list, empty or not"};
  }
  if (json.contains("elastic") && !json["elastic"].is_array()) {
    return Error{"is no list", "elastic", "give a list of {\"limb\": ..., settings}"};
  }
  return Success{};
}

Status readFractions(const Json& json, const Clip& clip, rig::TrailSettings& settings) {
  const bool wellFormed = json.is_array() && json.size() == 2 && json[0].is_number() && json[1].is_number() &&
                          json[0].get<double>() >= 0.0 && json[0].get<double>() <= json[1].get<double>() &&
                          json[1].get<double>() <= 1.0;
  if (!wellFormed) {
    return Error{json.dump() + " is no part of a clip", "range_of_clip",
                 "give two fractions in order, such as [0.2, 0.5]"};
  }
  const double last = clip.endSeconds * clip.framesPerSecond;
  settings.startFrame = json[0].get<double>() * last;
  settings.endFrame = json[1].get<double>() * last;
  return Success{};
}

Result<rig::Trail> trailOf(const Json& json, int clip, bool inMetres, Document& document) {
  if (!json.is_object() || !json.contains("limb") || !json["limb"].is_string()) {
    return Error{"a trail names no limb", "trails", "give \"limb\", such as \"left-arm\""};
  }
  const Result<rig::Limb> limb = findOrAddLimb(document, json["limb"].get<std::string>());
  if (!limb) {
    return limb.error();
  }
  rig::Trail trail;
  trail.limb = limb->id;
  trail.clip = clip;
  const double lengthUnit = inMetres ? 1.0 : limb->restLength;
  const Status read = settingsFromJson(json, lengthUnit, {"limb", "range_of_clip", "colour"}, trail.settings);
  if (!read) {
    return read.error();
  }
  if (json.contains("colour")) {
    if (!json["colour"].is_number_integer()) {
      return Error{json["colour"].dump() + " is no colour", "colour",
                   "give the number of a trail colour, from 0"};
    }
    trail.colour = json["colour"].get<int>();
  }
  if (json.contains("range_of_clip")) {
    if (const Status part = readFractions(json["range_of_clip"], clipOf(document, clip), trail.settings);
        !part) {
      return part.error();
    }
  } else if (!json.contains("range")) {
    const Vec2 range = rig::defaultRange(*document.scene, clipOf(document, clip), *limb);
    trail.settings.startFrame = range.x;
    trail.settings.endFrame = range.y;
  }
  return trail;
}

Result<WeightedLimb> weightsOf(const Json& json, int clip, Document& document) {
  if (!json.is_object() || !json.contains("limb") || !json["limb"].is_string()) {
    return Error{"an entry names no limb", "elastic", "give \"limb\", such as \"left-arm\""};
  }
  const Result<rig::Limb> limb = findOrAddLimb(document, json["limb"].get<std::string>());
  if (!limb) {
    return limb.error();
  }
  WeightedLimb entry{limb->id, clip, true, {}};
  const Status read = weightFromJson(json, {"limb"}, entry.settings);
  return read ? Result<WeightedLimb>(std::move(entry)) : Result<WeightedLimb>(read.error());
}

} // namespace

Result<Recipe> recipeFromJson(const Json& json, Document& document) {
  if (!json.is_object()) {
    return Error{"is no JSON object", "recipe", "see the documentation of recipes"};
  }
  if (const Status keys = checkKeys(json); !keys) {
    return keys.error();
  }
  const bool namesClip = json.contains("clip") && json["clip"].is_string();
  const Result<int> clip = findClip(document, namesClip ? json["clip"].get<std::string>() : std::string());
  if (!clip) {
    return clip.error();
  }
  const Json units = json.value("units", Json("limb_lengths"));
  if (units != "metres" && units != "limb_lengths") {
    return Error{units.dump() + " is no unit of a recipe", "units", "give \"metres\" or \"limb_lengths\""};
  }
  Recipe recipe;
  recipe.clip = *clip;
  for (const Json& entry : json["trails"]) {
    Result<rig::Trail> trail = trailOf(entry, *clip, units == "metres", document);
    if (!trail) {
      return trail.error();
    }
    recipe.trails.push_back(std::move(*trail));
  }
  for (const Json& entry : json.value("elastic", Json::array())) {
    Result<WeightedLimb> limb = weightsOf(entry, *clip, document);
    if (!limb) {
      return limb.error();
    }
    recipe.weights.push_back(std::move(*limb));
  }
  return recipe;
}

Result<Recipe> loadRecipe(const std::filesystem::path& path, Document& document) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return text.error();
  }
  const Json json = Json::parse(*text, nullptr, false);
  if (json.is_discarded()) {
    return Error{"is not JSON", path.string(), "correct it"};
  }
  return recipeFromJson(json, document);
}

Json recipeToJson(const Document& document, int clip) {
  Json json;
  json["version"] = recipeVersion;
  json["clip"] = clipOf(document, clip).name;
  json["trails"] = Json::array();
  for (const rig::Trail& trail : document.trails) {
    const rig::Limb* const limb = findLimb(document, trail.limb);
    if (trail.clip == clip && limb != nullptr) {
      Json entry = settingsToJson(trail.settings, limb->restLength);
      entry["limb"] = trail.limb;
      entry["colour"] = trail.colour;
      json["trails"].push_back(std::move(entry));
    }
  }
  for (const WeightedLimb& limb : document.weights) {
    if (limb.clip == clip && limb.on) {
      Json entry = weightToJson(limb.settings);
      entry["limb"] = limb.limb;
      json["elastic"].push_back(std::move(entry));
    }
  }
  return json;
}

} // namespace stretch::app

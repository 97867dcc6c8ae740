#include "app/files/saved_work.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "app/edits/keys/rate_edits.h"
#include "app/edits/keys/track_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/pose/prop_file_edits.h"
#include "app/edits/trail/place_trails.h"
#include "app/files/kept_tracks.h"
#include "app/schema/adjustment_json.h"
#include "app/schema/hold_json.h"
#include "app/schema/locator_json.h"
#include "app/schema/schema_json.h"
#include "app/schema/selection_set_json.h"
#include "app/schema/trail_schema.h"
#include "app/schema/weight_schema.h"
#include "core/gltf/json/json.h"
#include "core/gltf/json/json_integers.h"
#include "rig/body/reading/planned_body.h"
#include "rig/ik/limb_shape.h"

namespace stretch::app {

namespace {

using gltf::Json;

constexpr int workVersion = 1;
constexpr double metres = 1.0;
constexpr double fastestRate = 1e6; ///< Frames per second.

const std::vector<std::string>& keysBesideSettings() {
  static const std::vector<std::string> keys{
      "id",      "limb",   "clip",           "exaggerated", "connected", "applied",    "colour",
      "visible", "pinned", "control_frames", "follow",      "group",     "group_name", "name"};
  return keys;
}

Json savedTrail(const rig::Trail& trail) {
  Json json = trailToJson(trail.settings, metres);
  json["id"] = trail.id;
  json["limb"] = trail.limb;
  json["clip"] = trail.clip;
  json["exaggerated"] = trail.exaggerated;
  json["connected"] = trail.connected;
  json["applied"] = trail.applied;
  json["colour"] = trail.colour;
  json["visible"] = trail.visible;
  json["pinned"] = trail.pinned;
  json["control_frames"] = trail.controlFrames;
  json["follow"] = trail.follow;
  addNames(trail, json);
  return json;
}

std::vector<int> numbersOf(const std::vector<NodeIndex>& nodes) {
  std::vector<int> numbers;
  std::transform(nodes.begin(), nodes.end(), std::back_inserter(numbers),
                 [](NodeIndex node) { return node.value; });
  return numbers;
}

std::vector<NodeIndex> nodesOf(const std::vector<int>& numbers) {
  std::vector<NodeIndex> nodes;
  std::transform(numbers.begin(), numbers.end(), std::back_inserter(nodes),
                 [](int number) { return NodeIndex(number); });
  return nodes;
}

// A biped's limbs and chains are numbers, as earlier versions know them.
constexpr std::array<rig::LimbPlace, 7> numberedPlaces{
    rig::biped::leftArm, rig::biped::rightArm, rig::biped::leftLeg, rig::biped::rightLeg,
    rig::biped::spine,   rig::biped::neck,     rig::LimbPlace{}};

Json placeToJson(const rig::LimbPlace& place) {
  const auto* const numbered = std::ranges::find(numberedPlaces, place);
  if (numbered != numberedPlaces.end()) {
    return numbered - numberedPlaces.begin();
  }
  return {{"kind", kindName(place.kind)}, {"side", static_cast<int>(place.side)}, {"row", place.row}};
}

std::optional<rig::LimbPlace> placeFromJson(const Json& json) {
  if (json.is_number_integer()) {
    const auto number = json.get<std::size_t>();
    return number < numberedPlaces.size() ? std::optional(numberedPlaces[number]) : std::nullopt;
  }
  const std::optional<rig::LimbKind> kind = rig::kindNamed(json.at("kind").get<std::string>());
  const int side = gltf::integerOf(json.at("side"));
  const int row = gltf::integerOf(json.at("row"));
  if (!kind || side < 0 || side > static_cast<int>(rig::LimbSide::middle) || row < 0) {
    return std::nullopt;
  }
  return rig::LimbPlace{*kind, static_cast<rig::LimbSide>(side), row};
}

Json limbToJson(const rig::Limb& limb) {
  Json json{{"limb", limb.id},
            {"kind", placeToJson(limb)},
            {"joints", numbersOf(limb.joints)},
            {"end", limb.endNode.value},
            {"end_offset", vectorToJson(limb.endOffset)},
            {"rest_length", limb.restLength},
            {"confidence", limb.confidence}};
  if (limb.ledByFirst) {
    json["led_by_first"] = true;
  }
  return json;
}

Json limbsToJson(const std::vector<rig::Limb>& limbs) {
  Json list = Json::array();
  for (const rig::Limb& limb : limbs) {
    list.push_back(limbToJson(limb));
  }
  return list;
}

Error malformed(const std::string& where) {
  return {"is not what this program writes", where, "open the file and set it up again"};
}

// Earlier versions kept the settings that the clip was keyed with in the place of the flag, and an applied
// trail acted whether it was connected or not.
Status readApplied(const Json& json, rig::Trail& trail) {
  if (!json.is_object()) {
    trail.applied = !json.is_null() && json.get<bool>() && trail.connected;
    return Success{};
  }
  rig::TrailSettings keyed = trail.settings;
  Status read = trailFromJson(json, metres, {}, keyed);
  trail.connected = true;
  trail.applied = keyed == trail.settings;
  return read;
}

// Earlier versions kept scales that no limb reached.
Json withinReach(Json json) {
  if (json.is_object() && json.contains("scale") && json["scale"].is_number()) {
    json["scale"] = std::min(json["scale"].get<double>(), rig::largestStretch);
  }
  return json;
}

Result<rig::Trail> trailOfWork(const Json& json, const Document& document) {
  rig::Trail trail;
  const Status settings = trailFromJson(withinReach(json), metres, keysBesideSettings(), trail.settings);
  if (!settings) {
    return settings.error();
  }
  trail.id = gltf::integerOf(json.at("id"));
  trail.limb = json.at("limb").get<std::string>();
  trail.clip = gltf::integerOf(json.at("clip"));
  trail.exaggerated = json.at("exaggerated").get<bool>();
  trail.connected = json.at("connected").get<bool>();
  trail.colour = gltf::integerOf(json.at("colour"));
  trail.visible = json.at("visible").get<bool>();
  trail.pinned = json.at("pinned").get<bool>();
  trail.controlFrames = json.at("control_frames").get<std::vector<double>>();
  trail.follow = json.at("follow").get<bool>();
  trail.name = json.value("name", std::string());
  trail.group = std::clamp(json.contains("group") ? gltf::integerOf(json["group"]) : 0, 0, 1000000);
  trail.groupName = json.value("group_name", std::string());
  if (const Status read = readApplied(json.at("applied"), trail); !read) {
    return read.error();
  }
  const bool clipExists = trail.clip >= 0 && static_cast<std::size_t>(trail.clip) < document.clips->size();
  if (!clipExists || trail.id <= 0 || trail.colour < 0 || findTrail(document, trail.id) != nullptr) {
    return malformed("trails");
  }
  std::sort(trail.controlFrames.begin(), trail.controlFrames.end());
  return trail;
}

bool hasRepeats(std::vector<NodeIndex> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end();
}

Result<rig::Limb> limbFromJson(const Json& json, const Document& document) {
  rig::Limb limb;
  const NodeIndex past(document.scene->nodes.size());
  const auto exists = [&](NodeIndex node) { return node.exists() && node < past; };
  limb.id = json.at("limb").get<std::string>();
  const std::optional<rig::LimbPlace> place = placeFromJson(json.at("kind"));
  limb.joints = nodesOf(gltf::integersOf(json.at("joints")));
  limb.endNode = NodeIndex(gltf::integerOf(json.at("end")));
  limb.restLength = json.at("rest_length").get<double>();
  limb.confidence = json.at("confidence").get<double>();
  limb.ledByFirst = json.value("led_by_first", false);
  const Result<Vec3> offset = vectorFromJson(json.at("end_offset"), "limbs.end_offset");
  const bool hasNodes = !limb.joints.empty() && std::ranges::all_of(limb.joints, exists) &&
                        !hasRepeats(limb.joints) && (limb.endNode == NodeIndex::none || exists(limb.endNode));
  if (!offset || !hasNodes || !place || !(limb.restLength > 0.0)) {
    return malformed("limbs");
  }
  static_cast<rig::LimbPlace&>(limb) = *place;
  limb.endOffset = *offset;
  limb.reasons = {"kept in the file"};
  return limb;
}

Json weightedLimbToJson(const WeightedLimb& entry) {
  Json json = weightToJson(entry.settings);
  json["limb"] = entry.limb;
  json["clip"] = entry.clip;
  json["on"] = entry.on;
  return json;
}

Result<WeightedLimb> weightedLimbFromJson(const Json& json, const Document& document) {
  WeightedLimb entry;
  if (const Status read = weightFromJson(json, {"limb", "clip", "on"}, entry.settings); !read) {
    return read.error();
  }
  entry.limb = json.at("limb").get<std::string>();
  entry.clip = gltf::integerOf(json.at("clip"));
  entry.on = json.at("on").get<bool>();
  const bool clipExists = entry.clip >= 0 && static_cast<std::size_t>(entry.clip) < document.clips->size();
  const bool isRepeated = std::ranges::any_of(document.weights, [&](const WeightedLimb& other) {
    return other.limb == entry.limb && other.clip == entry.clip;
  });
  if (!clipExists || isRepeated) {
    return malformed("elastic");
  }
  return entry;
}

Json savedAdjustment(const rig::Adjustment& adjustment, const rig::ControllerList& list) {
  Json json = adjustmentToJson(adjustment, list.attribute(adjustment.controller) != nullptr, {});
  json["clip"] = adjustment.clip;
  return json;
}

Status restoreAdjustments(const Json& entries, Document& document) {
  for (const Json& json : entries) {
    Result<rig::Adjustment> adjustment = adjustmentFromJson(json, {}, {"clip"});
    if (!adjustment) {
      return adjustment.error();
    }
    adjustment->clip = gltf::integerOf(json.at("clip"));
    Result<Document> placed = placeAdjustments(document, {&*adjustment, 1}, Entry::file);
    if (placed) {
      document = std::move(*placed);
    } else {
      document.warnings.push_back("an adjustment kept in the file is left out: " + placed.error().line());
    }
  }
  return Success{};
}

Status restoreHold(const rig::Holds& hold, Document& document) {
  Result<Document> placed = placeHolds(document, hold, Entry::file);
  if (placed) {
    document = std::move(*placed);
  } else {
    document.warnings.push_back("a hold kept in the file is left out: " + placed.error().line());
  }
  return Success{};
}

// One list of holds; `read` answers one of its entries, `put` its list in rig::Holds.
template <typename Read, typename Put>
Status restoreHoldList(const Json& entries, const Read& read, const Put& put, Document& document) {
  for (const Json& json : entries) {
    auto hold = read(json);
    if (!hold) {
      return hold.error();
    }
    hold->clip = gltf::integerOf(json.at("clip"));
    rig::Holds one;
    put(one).push_back(std::move(*hold));
    if (Status restored = restoreHold(one, document); !restored) {
      return restored;
    }
  }
  return Success{};
}

Status restoreHolds(const Json& work, Document& document) {
  const auto listOf = [&](const char* key) { return work.value(key, Json::array()); };
  Status pins = restoreHoldList(
      listOf("pins"), [](const Json& json) { return pinFromJson(json, {}, {"clip"}); },
      [](rig::Holds & holds) -> auto& { return holds.pins; }, document);
  Status grips = restoreHoldList(
      listOf("grips"), [](const Json& json) { return gripFromJson(json, {"clip"}); },
      [](rig::Holds & holds) -> auto& { return holds.grips; }, document);
  Status props = restoreHoldList(
      listOf("props"), [](const Json& json) { return propFromJson(json, {}, {"clip"}); },
      [](rig::Holds & holds) -> auto& { return holds.props; }, document);
  return !pins ? pins : !grips ? grips : props;
}

void saveHolds(const rig::Holds& holds, Json& work) {
  const auto add = [&](const char* key, Json json, int clip) {
    json["clip"] = clip;
    work[key].push_back(std::move(json));
  };
  for (const rig::Pin& pin : holds.pins) {
    add("pins", pinToJson(pin, {}), pin.clip);
  }
  for (const rig::Grip& grip : holds.grips) {
    add("grips", gripToJson(grip), grip.clip);
  }
  for (const rig::Prop& prop : holds.props) {
    add("props", propToJson(prop, {}), prop.clip);
  }
}

Status restoreRates(const Json& rates, Document& document) {
  for (const Json& json : rates) {
    const ClipRate rate{gltf::integerOf(json.at("clip")), json.at("frames_per_second").get<double>(), 0.0};
    const bool known = rate.clip >= 0 && static_cast<std::size_t>(rate.clip) < document.clips->size();
    const bool repeated =
        std::ranges::any_of(document.rates, [&](const ClipRate& other) { return other.clip == rate.clip; });
    if (!known || repeated || !(rate.framesPerSecond > 0.0 && rate.framesPerSecond <= fastestRate)) {
      return malformed("rates");
    }
    document.rates.push_back(rate);
  }
  countInChosenRates(document);
  return Success{};
}

// Limbs of a plan that the character is not read as by itself were chosen by hand, or kept by a version that
// knew bipeds only.
void restorePlan(const Json& work, Document& document) {
  const std::string kept = work.value("plan", std::string("biped"));
  const rig::BodyPlan* const plan = rig::planNamed(kept);
  if (work.contains("limbs") && plan != nullptr && kept != document.body.plan) {
    document.body = bodyOfSource(document, *plan);
  }
}

// One limb has one id, and what is kept twice is read once.
Status restoreLimbs(const Json& work, Document& document) {
  for (const auto& [key, limbs] :
       {std::pair{"limbs", &document.body.limbs}, std::pair{"chains", &document.chains}}) {
    if (!work.contains(key)) {
      continue;
    }
    limbs->clear();
    for (const Json& json : work.at(key)) {
      Result<rig::Limb> limb = limbFromJson(json, document);
      if (!limb) {
        return limb.error();
      }
      if (findLimb(document, limb->id) != nullptr) {
        document.warnings.push_back("the limb " + limb->id +
                                    " is kept twice in the file: the second is left out");
        continue;
      }
      limbs->push_back(std::move(*limb));
    }
  }
  return Success{};
}

Status restoreParts(const Json& work, Document& document) {
  restorePlan(work, document);
  if (Status rates = restoreRates(work.value("rates", Json::array()), document); !rates) {
    return rates;
  }
  if (Status keys = restoreKeptTracks(work.value("clip_keys", Json::array()), document); !keys) {
    return keys;
  }
  if (Status autos = restoreFollowingKeys(work.value("auto_keys", Json::array()), document); !autos) {
    return autos;
  }
  if (Status limbs = restoreLimbs(work, document); !limbs) {
    return limbs;
  }
  for (const Json& json : work.at("trails")) {
    const Result<rig::Trail> trail = trailOfWork(json, document);
    if (!trail) {
      return trail.error();
    }
    document.nextTrailId = std::max(document.nextTrailId, trail->id + 1);
    Result<PlacedTrails> placed = placeTrails(document, {&*trail, 1}, Entry::file);
    if (placed) {
      document = std::move(placed->document);
    } else {
      document.warnings.push_back("a trail kept in the file is left out: " + placed.error().line());
    }
  }
  for (const Json& json : work.value("elastic", Json::array())) {
    Result<WeightedLimb> entry = weightedLimbFromJson(json, document);
    if (!entry) {
      return entry.error();
    }
    document.weights.push_back(std::move(*entry));
  }
  if (work.contains("locators")) {
    Result<rig::Locators> locators = locatorsFromJson(work["locators"]);
    if (!locators) {
      return locators.error();
    }
    document.locators = std::move(*locators);
  }
  if (work.contains("selection_sets")) {
    Result<std::vector<SelectionSet>> sets = selectionSetsFromJson(work["selection_sets"]);
    if (!sets) {
      return sets.error();
    }
    document.selectionSets = std::move(*sets);
  }
  document.loopingClips = gltf::integersOf(work.at("loops"));
  Status adjusted = restoreAdjustments(work.value("adjustments", Json::array()), document);
  return adjusted ? restoreHolds(work, document) : adjusted;
}

} // namespace

Json workOf(const Document& document) {
  if (document.trails.empty() && document.adjustments.empty() && document.holds.empty() &&
      document.weights.empty() && document.chains.empty() && document.loopingClips.empty() &&
      document.rates.empty() && !document.limbsCorrected && document.locators.empty() &&
      !hasEditedKeys(document) && document.followingKeys.empty() && document.addedFiles.empty() &&
      document.selectionSets.empty()) {
    return nullptr;
  }
  Json work;
  work["version"] = workVersion;
  // Limbs are kept even when they were found: a later version of the detection must not move the trails'
  // limbs.
  work["limbs"] = limbsToJson(document.body.limbs);
  work["limbs_corrected"] = document.limbsCorrected;
  if (document.limbsCorrected || document.body.plan != "biped") {
    work["plan"] = document.body.plan;
  }
  work["chains"] = limbsToJson(document.chains);
  if (!document.locators.empty()) {
    work["locators"] = locatorsToJson(document.locators);
  }
  if (!document.selectionSets.empty()) {
    work["selection_sets"] = selectionSetsToJson(document.selectionSets);
  }
  work["trails"] = Json::array();
  for (const rig::Trail& trail : document.trails) {
    work["trails"].push_back(savedTrail(trail));
  }
  for (const WeightedLimb& entry : document.weights) {
    work["elastic"].push_back(weightedLimbToJson(entry));
  }
  const rig::ControllerList list = controllersOf(document);
  for (const rig::Adjustment& adjustment : document.adjustments) {
    work["adjustments"].push_back(savedAdjustment(adjustment, list));
  }
  if (hasEditedKeys(document)) {
    work["clip_keys"] = keptTracks(document);
  }
  if (!document.followingKeys.empty()) {
    work["auto_keys"] = keptFollowingKeys(document);
  }
  saveHolds(document.holds, work);
  work["loops"] = document.loopingClips;
  for (const ClipRate& rate : document.rates) {
    work["rates"].push_back({{"clip", rate.clip}, {"frames_per_second", rate.framesPerSecond}});
  }
  return work;
}

namespace {

// The files that were added stay.
Document withoutEdits(Document document) {
  document = restoreAllTracks(document);
  document.trails.clear();
  document.adjustments.clear();
  document.holds = {};
  document.weights.clear();
  document.chains.clear();
  document.locators = {};
  document.selectionSets.clear();
  document.loopingClips.clear();
  for (ClipRate& rate : document.rates) {
    rate.framesPerSecond = rate.own;
  }
  countInChosenRates(document);
  document.rates.clear();
  if (document.limbsCorrected) {
    document.body = bodyOfSource(document);
    document.limbsCorrected = false;
  }
  return document;
}

} // namespace

Document withoutWork(Document document) {
  document = withoutEdits(std::move(document));
  Result<Document> without = withAddedFiles(document, {});
  return without ? std::move(*without) : document;
}

Status restoreWork(const Json& work, Document& document) {
  try {
    if (!work.is_object() || !work.contains("version") || gltf::integerOf(work["version"]) != workVersion) {
      return Error{"this program does not know this version of the work", "extras.stretch_engine",
                   "open it with the program that wrote it"};
    }
    Document restored = withoutEdits(document);
    restored.limbsCorrected = work.value("limbs_corrected", false);
    if (Status parts = restoreParts(work, restored); !parts) {
      return parts;
    }
    document = std::move(restored);
    return Success{};
  } catch (const Json::exception&) {
    return malformed("extras.stretch_engine");
  }
}

} // namespace stretch::app

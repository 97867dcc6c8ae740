#include <algorithm>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/edits/pose/adjustment_edits.h"
#include "app/evaluate/hand_place.h"
#include "app/recipe/recipe_parts.h"
#include "app/schema/schema_json.h"
#include "core/gltf/json/json.h"

namespace stretch::app {

namespace {

using gltf::Json;

PropFile propFileOf(const rig::Prop& prop, std::filesystem::path path) {
  PropFile file{std::move(path), {}, prop.clip, prop.boundFrame.value_or(0.0), {}};
  for (const rig::PropHand& hand : prop.hands) {
    file.hands.push_back(hand.limb);
  }
  return file;
}

bool isSameThing(const gltf::AddedFile& a, const gltf::AddedFile& b) {
  return a.thing == b.thing || (a.thing->json == b.thing->json && a.thing->buffers == b.thing->buffers);
}

// The file of an earlier replay, put where the new one is, in the place of it. Nothing where there is none.
std::optional<Document> withEarlier(const Document& before, const Document& after,
                                    const std::vector<std::string>& taken) {
  const gltf::AddedFile& added = after.addedFiles.back();
  std::vector<gltf::AddedFile> files = before.addedFiles;
  const auto earlier = std::ranges::find_if(files, [&](const gltf::AddedFile& file) {
    return std::ranges::find(taken, file.name) == taken.end() && isSameThing(file, added);
  });
  if (earlier == files.end()) {
    return std::nullopt;
  }
  earlier->place = added.place;
  std::rotate(earlier, earlier + 1, files.end()); // last, as the new one
  Result<Document> again = withAddedFiles(before, std::move(files));
  return again ? std::optional(std::move(*again)) : std::nullopt;
}

// Where the adjustments of the recipe have the hands.
Result<Vec3> placeAsAdjusted(const PropFile& file, const Recipe& recipe, const Document& document) {
  const Result<Document> adjusted = placeAdjustments(document, recipe.adjustments);
  return adjusted ? placeInHands(*adjusted, file) : Result<Vec3>(adjusted.error());
}

// Answers the name of the node.
Result<std::string> addPropFile(const PropFile& placed, const std::vector<std::string>& taken,
                                Document& document) {
  Result<AddedProp> added = withPropFile(document, placed);
  if (!added) {
    return added.error();
  }
  std::optional<Document> earlier = withEarlier(document, added->document, taken);
  document = earlier ? std::move(*earlier) : std::move(added->document);
  return document.addedFiles.back().name;
}

} // namespace

Status addPropFiles(const Json& json, bool inMetres, const std::filesystem::path& folder, Recipe& recipe,
                    Document& document) {
  const Json entries = json.value("props", Json::array());
  std::vector<std::string> taken;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!entries[i].contains("file")) {
      continue;
    }
    rig::Prop& prop = recipe.holds.props[i];
    PropFile file = propFileOf(prop, folder / entries[i]["file"].get<std::string>());
    const double unit = inMetres ? 1.0 : lengthOfBody(document);
    const Result<Vec3> place = entries[i].contains("place") ? vectorFromJson(entries[i]["place"], "place")
                                                            : placeAsAdjusted(file, recipe, document);
    if (!place) {
      return Error{place.error().line(), fmt::format("props[{}]", i), ""};
    }
    file.place = *place * (entries[i].contains("place") ? unit : 1.0);
    Result<std::string> node = addPropFile(file, taken, document);
    if (!node) {
      return Error{node.error().line(), fmt::format("props[{}]", i), ""};
    }
    prop.node = *node;
    taken.push_back(std::move(*node));
  }
  return Success{};
}

Json withFileOfProp(const Document& document, const rig::Prop& prop, Json entry) {
  constexpr double sameShare = 1e-9; // of the height
  const auto added = std::ranges::find(document.addedFiles, prop.node, &gltf::AddedFile::name);
  if (added == document.addedFiles.end()) {
    return entry;
  }
  const Vec3 place = added->place.translation;
  const Result<Vec3> inHands = placeInHands(document, propFileOf(prop, added->file));
  if (!inHands || glm::distance(*inHands, place) > sameShare * document.body.height) {
    entry["place"] = vectorToJson(place / lengthOfBody(document));
  }
  Json named{{"file", added->file}};
  entry.erase("node");
  named.update(entry);
  return named;
}

} // namespace stretch::app

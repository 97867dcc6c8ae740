#include "app/reference/reference_edits.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/edits/keys/rate_edits.h"
#include "app/schema/reference_schema.h"
#include "app/schema/schema_json.h"
#include "app/things/time_map.h"

namespace stretch::app {

namespace {

using gltf::Json;

/// "images" or "sound": an object of settings.
template <typename Settings>
Status readPart(const Json& json, const char* key, const Schema<Settings>& schema, const std::string& folder,
                Settings& part) {
  if (!json.contains(key)) {
    return Success{};
  }
  const auto unknown = [](const std::string& name, const Json&) -> Status {
    return Error{"is not a setting of a reference", name, "remove it, or correct its name"};
  };
  Status read = json[key].is_object() ? readSettings(json[key], schema, part, unknown)
                                      : Status(Error{"is not an object", key, "give an object of settings"});
  if (read && part.file.empty()) {
    read = Error{"names no file", key, "give \"" + schema.front().name + "\""};
  }
  if (!read) {
    const Error& error = read.error();
    return Error{error.what, error.where == key ? error.where : std::string(key) + "." + error.where,
                 error.remedy};
  }
  part.file = (std::filesystem::path(folder) / part.file).string();
  return Success{};
}

template <typename Settings>
void writePart(const Settings& part, const char* key, const Schema<Settings>& schema, Json& json) {
  if (!part.file.empty()) {
    json[key] = Json::object();
    writeSettings(schema, part, json[key]);
  }
}

/// The clip of its number where that has the name, else the only one of that name.
std::optional<int> clipOfEntry(const Json& entry, const Document& document) {
  if (!entry.is_object() || !entry.contains("name") || !entry["name"].is_string()) {
    return std::nullopt;
  }
  const auto name = entry["name"].get<std::string>();
  std::vector<int> named;
  for (std::size_t clip = 0; clip < document.clips->size(); ++clip) {
    if ((*document.clips)[clip].name == name) {
      named.push_back(static_cast<int>(clip));
    }
  }
  const int number =
      entry.contains("clip") && entry["clip"].is_number_integer() ? entry["clip"].get<int>() : -1;
  if (std::ranges::find(named, number) != named.end()) {
    return number;
  }
  return named.size() == 1 ? std::optional(named.front()) : std::nullopt;
}

} // namespace

Reference referenceOf(const Document& document, int clip) {
  const auto found = std::ranges::find(document.references, clip, &Reference::clip);
  return found == document.references.end() ? Reference{.clip = clip} : *found;
}

Document withReference(Document document, const Reference& reference) {
  std::erase_if(document.references, [&](const Reference& old) { return old.clip == reference.clip; });
  if (!reference.images.file.empty() || !reference.sound.file.empty()) {
    document.references.push_back(reference);
    std::ranges::sort(document.references, {}, &Reference::clip);
  }
  return document;
}

Json referenceToJson(const Reference& reference) {
  Json json = Json::object();
  writePart(reference.images, "images", referenceImagesSchema(), json);
  writePart(reference.sound, "sound", referenceSoundSchema(), json);
  return json;
}

Result<Reference> referenceFromJson(const Json& json, int clip, const std::string& folder) {
  if (!json.is_object()) {
    return Error{"is not an object", "", R"(give an object with "images" or "sound")"};
  }
  for (const auto& [key, value] : json.items()) {
    if (key != "images" && key != "sound") {
      return Error{"is not a part of a reference", key, R"(give "images" or "sound")"};
    }
  }
  Reference reference{.clip = clip};
  Status read = readPart(json, "images", referenceImagesSchema(), folder, reference.images);
  if (read) {
    read = readPart(json, "sound", referenceSoundSchema(), folder, reference.sound);
  }
  return read ? Result<Reference>(std::move(reference)) : Result<Reference>(read.error());
}

Json referencesToJson(const Document& document) {
  Json json = Json::array();
  for (const Reference& reference : document.references) {
    const Clip& clip = clipOf(document, reference.clip);
    const double ownFrames = ownRate(document, reference.clip) / clip.framesPerSecond;
    json.push_back({{"clip", reference.clip},
                    {"name", clip.name},
                    {"refers_to", referenceToJson(mapped(reference, TimeMap{.factor = ownFrames}))}});
  }
  return json;
}

std::vector<Reference> referencesFromJson(const Json& json, const Document& document) {
  std::vector<Reference> references;
  for (const Json& entry : json.is_array() ? json : Json::array()) {
    const std::optional<int> clip = clipOfEntry(entry, document);
    const Result<Reference> read = clip && entry.contains("refers_to")
                                       ? referenceFromJson(entry["refers_to"], *clip, {})
                                       : Result<Reference>(Error{});
    const bool isKnown = clip && std::ranges::find(references, *clip, &Reference::clip) != references.end();
    if (read && !isKnown && *read != Reference{.clip = *clip}) {
      const double frames = clipOf(document, *clip).framesPerSecond / ownRate(document, *clip);
      references.push_back(mapped(*read, TimeMap{.factor = frames}));
    }
  }
  std::ranges::sort(references, {}, &Reference::clip);
  return references;
}

} // namespace stretch::app

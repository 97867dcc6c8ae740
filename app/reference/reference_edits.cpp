#include "app/reference/reference_edits.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/schema/reference_schema.h"
#include "app/schema/schema_json.h"

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
  Json json = Json::object();
  for (const Reference& reference : document.references) {
    json[clipOf(document, reference.clip).name] = referenceToJson(reference);
  }
  return json;
}

std::vector<Reference> referencesFromJson(const Json& json, const Document& document) {
  std::vector<Reference> references;
  for (std::size_t clip = 0; json.is_object() && clip < document.clips->size(); ++clip) {
    const auto found = json.find((*document.clips)[clip].name);
    const Result<Reference> read = found == json.end()
                                       ? Result<Reference>(Error{})
                                       : referenceFromJson(*found, static_cast<int>(clip), {});
    if (read && *read != Reference{.clip = static_cast<int>(clip)}) {
      references.push_back(*read);
    }
  }
  return references;
}

} // namespace stretch::app

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/added_parts.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/added_file.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/uri.h"

namespace stretch::gltf {

namespace {

using Pointer = Json::json_pointer;

const std::string dataUriHead = "data:application/octet-stream;base64,";

/// Where the entries of a thing's lists come to stand behind those of the file.
class Shifts {
public:
  explicit Shifts(const Json& file) {
    for (const char* list : lists) {
      first_[list] = sizeOf(file, list);
    }
  }

  void shift(Json& object, const char* key, const char* list) const {
    if (const int index = indexOr(object, key); index >= 0) {
      object[key] = first_.at(list) + static_cast<std::size_t>(index);
    }
  }

  void shiftAll(Json& members, const char* list) const {
    for (const auto& [key, index] : members.items()) {
      index = first_.at(list) + index.get<std::size_t>();
    }
  }

  static constexpr std::array<const char*, 8> lists{"bufferViews", "accessors", "images", "samplers",
                                                    "textures",    "materials", "meshes", "nodes"};

private:
  std::map<std::string, std::size_t> first_;
};

void shiftTextures(Json& json, const Shifts& shifts) {
  for (const auto& [key, value] : json.items()) {
    if (key.ends_with("Texture") && indexOr(value, "index") >= 0) {
      shifts.shift(value, "index", "textures");
    } else if (value.is_structured()) {
      shiftTextures(value, shifts);
    }
  }
}

void shiftMesh(Json& mesh, const Shifts& shifts) {
  for (Json& primitive : mesh["primitives"]) {
    shifts.shift(primitive, "indices", "accessors");
    shifts.shift(primitive, "material", "materials");
    shifts.shiftAll(primitive["attributes"], "accessors");
    if (primitive.contains("targets")) {
      for (Json& target : primitive["targets"]) {
        shifts.shiftAll(target, "accessors");
      }
    }
  }
}

void shiftAccessor(Json& accessor, const Shifts& shifts) {
  shifts.shift(accessor, "bufferView", "bufferViews");
  if (accessor.contains("sparse")) {
    shifts.shift(accessor["sparse"]["indices"], "bufferView", "bufferViews");
    shifts.shift(accessor["sparse"]["values"], "bufferView", "bufferViews");
  }
}

void shiftTexture(Json& texture, const Shifts& shifts) {
  shifts.shift(texture, "sampler", "samplers");
  shifts.shift(texture, "source", "images");
  if (texture.contains("extensions")) {
    for (const auto& [name, extension] : texture["extensions"].items()) {
      shifts.shift(extension, "source", "images");
    }
  }
}

void shiftEntry(const std::string& list, const Shifts& shifts, Json& entry) {
  if (list == "accessors") {
    shiftAccessor(entry, shifts);
  } else if (list == "images") {
    shifts.shift(entry, "bufferView", "bufferViews");
  } else if (list == "textures") {
    shiftTexture(entry, shifts);
  } else if (list == "materials") {
    shiftTextures(entry, shifts);
  } else if (list == "meshes") {
    shiftMesh(entry, shifts);
  } else if (list == "nodes") {
    shifts.shift(entry, "mesh", "meshes");
    if (entry.contains("children")) {
      shifts.shiftAll(entry["children"], "nodes");
    }
  }
}

void addExtensions(const Json& thing, const char* list, Journal& journal) {
  for (std::size_t i = 0; i < sizeOf(thing, list); ++i) {
    const Json& name = element(thing, list, i);
    if (name.is_string() && !listsText(journal.json(), list, name.get_ref<const std::string&>())) {
      journal.append(Pointer() / std::string(list), name);
    }
  }
}

Json carrierOf(const AddedFile& file, Json children) {
  const Vec3& t = file.place.translation;
  const Quat& q = file.place.rotation;
  const Vec3& s = file.place.scale;
  return {{"name", file.name},
          {"translation", {t.x, t.y, t.z}},
          {"rotation", {q.x, q.y, q.z, q.w}},
          {"scale", {s.x, s.y, s.z}},
          {"children", std::move(children)}};
}

void addFile(const AddedFile& file, std::size_t buffer, std::size_t start, Journal& journal) {
  const Json& thing = file.thing->json;
  const Shifts shifts(journal.json());
  for (const char* list : Shifts::lists) {
    for (std::size_t i = 0; i < sizeOf(thing, list); ++i) {
      Json entry = element(thing, list, i);
      shiftEntry(list, shifts, entry);
      if (std::string(list) == "bufferViews") {
        entry["buffer"] = buffer;
        entry["byteOffset"] = start + wholeOr(entry, "byteOffset", 0);
      }
      journal.append(Pointer() / std::string(list), std::move(entry));
    }
  }
  const Json* const listed = find(element(thing, "scenes", 0), "nodes");
  Json roots = listed != nullptr ? *listed : Json::array();
  shifts.shiftAll(roots, "nodes");
  const std::size_t carrier = journal.append(Pointer("/nodes"), carrierOf(file, std::move(roots)));
  if (sizeOf(journal.json(), "scenes") > 0) {
    const auto scene = static_cast<std::size_t>(indexOr(journal.json(), "scene", 0));
    journal.append(Pointer("/scenes") / scene / "nodes", carrier);
  }
  addExtensions(thing, "extensionsUsed", journal);
  addExtensions(thing, "extensionsRequired", journal);
}

std::size_t wholeWords(std::size_t bytes) {
  return (bytes + 3) / 4 * 4;
}

// Nothing for an entry that is not as addedRecord writes it.
std::optional<AddedFile> fromRecord(const Source& saved, const Json& entry) {
  const std::vector<double> t = numbersOf(entry, "translation");
  const std::vector<double> q = numbersOf(entry, "rotation");
  const std::vector<double> s = numbersOf(entry, "scale");
  const Json* const json = find(entry, "json");
  const std::uint64_t buffer = wholeOr(entry, "buffer", 0);
  const std::uint64_t offset = wholeOr(entry, "byteOffset", 0);
  const std::uint64_t length = wholeOr(entry, "byteLength", 0);
  const bool isThere = buffer < saved.buffers.size() && offset <= saved.buffers[buffer].size() &&
                       length <= saved.buffers[buffer].size() - offset;
  if (t.size() != 3 || q.size() != 4 || s.size() != 3 || json == nullptr || !isThere) {
    return std::nullopt;
  }
  Source thing;
  thing.json = Json(*json);
  const auto first = saved.buffers[buffer].begin() + static_cast<std::ptrdiff_t>(offset);
  thing.buffers = {Bytes(first, first + static_cast<std::ptrdiff_t>(length))};
  thing.hasBinaryChunk = true;
  if (!isThing(thing)) {
    return std::nullopt;
  }
  return AddedFile{textOr(entry, "file"),
                   textOr(entry, "name"),
                   {{t[0], t[1], t[2]}, Quat(q[3], q[0], q[1], q[2]), {s[0], s[1], s[2]}},
                   std::make_shared<const Source>(std::move(thing))};
}

} // namespace

Bytes addFiles(const std::vector<AddedFile>& files, std::size_t buffer, std::size_t start, Journal& journal) {
  Bytes bytes;
  for (const AddedFile& file : files) {
    addFile(file, buffer, start + bytes.size(), journal);
    const Bytes& own = file.thing->buffers[0];
    bytes.insert(bytes.end(), own.begin(), own.end());
    bytes.resize(wholeWords(bytes.size()));
  }
  return bytes;
}

Json addedRecord(const std::vector<AddedFile>& files, std::size_t buffer, std::size_t start) {
  Json record;
  std::size_t offset = start;
  for (const AddedFile& file : files) {
    Json entry = carrierOf(file, nullptr);
    entry.erase("children");
    entry["file"] = file.file;
    entry["json"] = *file.thing->json;
    entry["buffer"] = buffer;
    entry["byteOffset"] = offset;
    entry["byteLength"] = file.thing->buffers[0].size();
    record.push_back(std::move(entry));
    offset += wholeWords(file.thing->buffers[0].size());
  }
  return record;
}

std::vector<AddedFile> addedFromRecord(const Source& saved, const Json& record, Problems& problems) {
  std::vector<AddedFile> files;
  for (const Json& entry : record.is_array() ? record : Json::array()) {
    if (std::optional<AddedFile> file = fromRecord(saved, entry)) {
      files.push_back(std::move(*file));
    } else {
      problems.warning("extras", "a thing that was added from another file is damaged, and left out");
    }
  }
  return files;
}

Result<Source> withAddedFiles(const Source& source, const std::vector<AddedFile>& files) {
  Edits edits;
  edits.addedFiles = files;
  return patched(source, edits);
}

Json addedToJson(const std::vector<AddedFile>& files) {
  Bytes bytes;
  for (const AddedFile& file : files) {
    bytes.insert(bytes.end(), file.thing->buffers[0].begin(), file.thing->buffers[0].end());
    bytes.resize(wholeWords(bytes.size()));
  }
  return {{"files", addedRecord(files, 0, 0)}, {"bytes", dataUriHead + encodeBase64(bytes)}};
}

std::vector<AddedFile> addedFromJson(const Json& json) {
  const Json* const record = find(json, "files");
  std::optional<DataUri> data = decodeDataUri(textOr(json, "bytes"));
  if (record == nullptr || !data) {
    return {};
  }
  Source all;
  all.buffers = {std::move(data->bytes)};
  Problems problems;
  return addedFromRecord(all, *record, problems);
}

std::size_t addedNodeCount(const AddedFile& file) {
  return sizeOf(file.thing->json, "nodes") + 1;
}

} // namespace stretch::gltf

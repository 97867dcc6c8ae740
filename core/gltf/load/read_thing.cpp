#include <algorithm>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/read/read.h"
#include "core/gltf/read/structure.h"
#include "core/gltf/source/added_file.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/pictures.h"
#include "core/gltf/source/plain_parts.h"
#include "core/gltf/source/plain_source.h"

namespace stretch::gltf {

namespace {

constexpr std::size_t alignment = 4;

/// Copies what the nodes of a scene need into a source of its own. Every list entry is copied once, when it
/// is first asked for. The source has to be plain and validated.
class ThingCopy {
public:
  explicit ThingCopy(const Source& from) : from_(from) { to_.json = Json{{"asset", {{"version", "2.0"}}}}; }

  Source ofScene() {
    const auto scene = static_cast<std::size_t>(indexOr(from_.json, "scene", 0));
    Json roots = Json::array();
    for (const int node : indicesOf(element(from_.json, "scenes", scene), "nodes")) {
      roots.push_back(take("nodes", node));
    }
    Json& json = *to_.json;
    json["scene"] = 0;
    json["scenes"] = Json::array({Json{{"nodes", std::move(roots)}}});
    for (auto& [list, entries] : lists_) {
      json[list] = std::move(entries);
    }
    json["buffers"] = Json::array({Json{{"byteLength", bytes_.size()}}});
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
      keepExtensions(list);
    }
    to_.buffers = {std::move(bytes_)};
    to_.hasBinaryChunk = true;
    return std::move(to_);
  }

  /// What of the things in the file is not there or cannot be read.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

private:
  int take(const std::string& list, int index) {
    const auto [place, isNew] = taken_.try_emplace({list, index}, 0);
    if (!isNew) {
      return place->second;
    }
    Json copy = copied(list, element(from_.json, list, static_cast<std::size_t>(index)));
    Json& entries = lists_[list];
    entries.push_back(std::move(copy));
    const int added = static_cast<int>(entries.size()) - 1;
    taken_[{list, index}] = added;
    return added;
  }

  Json copied(const std::string& list, Json entry) {
    if (list == "nodes") {
      return node(entry);
    }
    if (list == "meshes") {
      return mesh(std::move(entry));
    }
    if (list == "materials") {
      retakeTextures(entry);
    } else if (list == "textures") {
      retakeTexture(entry);
    } else if (list == "images") {
      return image(entry);
    } else if (list == "accessors") {
      retakeAccessor(entry);
    } else if (list == "bufferViews") {
      return view(entry);
    }
    return entry;
  }

  Json node(const Json& entry) {
    Json copy = Json::object();
    for (const char* key : {"name", "matrix", "translation", "rotation", "scale", "weights", "extras"}) {
      if (const Json* value = find(entry, key)) {
        copy[key] = *value;
      }
    }
    if (const int mesh = indexOr(entry, "mesh"); mesh >= 0) {
      copy["mesh"] = take("meshes", mesh);
    }
    if (const Json* const extensions = find(entry, "extensions")) {
      for (const auto& [name, value] : extensions->items()) {
        tell(
            fmt::format("what its nodes have by '{}' is left out, its copies where those are instances; make "
                        "it nodes and meshes",
                        name.substr(0, 200)));
      }
    }
    for (const int child : indicesOf(entry, "children")) {
      const int taken = take("nodes", child);
      copy["children"].push_back(taken);
    }
    return copy;
  }

  Json mesh(Json entry) {
    entry.erase("extensions");
    for (Json& primitive : entry["primitives"]) {
      primitive.erase("extensions");
      retake(primitive, "indices", "accessors");
      retake(primitive, "material", "materials");
      retakeAll(primitive["attributes"]);
      if (primitive.contains("targets")) {
        for (Json& target : primitive["targets"]) {
          retakeAll(target);
        }
      }
    }
    return entry;
  }

  void retake(Json& object, const char* key, const char* list) {
    if (const int index = indexOr(object, key); index >= 0) {
      object[key] = take(list, index);
    }
  }

  void retakeAll(Json& attributes) {
    for (const auto& [name, accessor] : attributes.items()) {
      accessor = take("accessors", accessor.get<int>());
    }
  }

  // Wherever a material names a texture: its own properties, and those of its extensions.
  void retakeTextures(Json& json) {
    std::vector<std::string> lost;
    for (const auto& [key, value] : json.items()) {
      const bool isTexture = key.ends_with("Texture") && indexOr(value, "index") >= 0;
      if (isTexture && !hasPictures(indexOr(value, "index"))) {
        lost.push_back(key);
      } else if (isTexture) {
        retake(value, "index", "textures");
      } else if (value.is_structured()) {
        retakeTextures(value);
      }
    }
    for (const std::string& key : lost) {
      json.erase(key);
    }
  }

  // What extensions name need not be there.
  Json named(const char* list, int index) {
    return at(index) < sizeOf(from_.json, list) ? element(from_.json, list, at(index)) : Json();
  }

  // Whether the texture has a picture, and each that it names can be read.
  bool hasPictures(int index) {
    const Json texture = named("textures", index);
    if (texture.is_null()) {
      tell(fmt::format("its texture {} is not there and is left out", index));
    }
    std::vector<int> images{indexOr(texture, "source")};
    if (const Json* const extensions = find(texture, "extensions")) {
      for (const Json& extension : *extensions) {
        images.push_back(indexOr(extension, "source"));
      }
    }
    std::erase(images, -1);
    return !images.empty() && std::ranges::all_of(images, [&](int image) { return isReadable(image); });
  }

  bool isReadable(int image) {
    const auto [known, isNew] = readable_.try_emplace(image, false);
    if (isNew) {
      const Json entry = named("images", image);
      known->second = encodedImage(from_, entry).has_value();
      if (!known->second) {
        tell(fmt::format("its picture '{}' cannot be read and is left out",
                         textOr(entry, "uri").substr(0, 200)));
      }
    }
    return known->second;
  }

  void tell(std::string warning) {
    if (std::ranges::find(warnings_, warning) == warnings_.end()) {
      warnings_.push_back(std::move(warning));
    }
  }

  void retakeTexture(Json& texture) {
    retake(texture, "sampler", "samplers");
    retake(texture, "source", "images");
    if (texture.contains("extensions")) {
      for (const auto& [name, extension] : texture["extensions"].items()) {
        retake(extension, "source", "images");
      }
    }
  }

  Json image(const Json& entry) {
    Json copy = Json::object();
    if (const Json* name = find(entry, "name")) {
      copy["name"] = *name;
    }
    const Bytes bytes = encodedImage(from_, entry).value_or(Bytes()); // is readable
    copy["mimeType"] = mediaTypeOf(entry, bytes);
    copy["bufferView"] = addView(Json::object(), bytes);
    return copy;
  }

  // Values in a buffer without bytes are zeros, as those of an accessor that names no view.
  void retakeAccessor(Json& accessor) {
    const Json* const sparse = find(accessor, "sparse");
    const bool isSparseLost =
        sparse != nullptr && (!hasBytes((*sparse)["indices"]) || !hasBytes((*sparse)["values"]));
    const bool isLost = accessor.contains("bufferView") && !hasBytes(accessor);
    if (isLost || isSparseLost) {
      tell("values of its meshes are not in the file and are taken as zeros");
    }
    if (isLost) {
      accessor.erase("bufferView");
      accessor.erase("byteOffset");
    }
    retake(accessor, "bufferView", "bufferViews");
    if (isSparseLost) {
      accessor.erase("sparse");
    } else if (sparse != nullptr) {
      retake(accessor["sparse"]["indices"], "bufferView", "bufferViews");
      retake(accessor["sparse"]["values"], "bufferView", "bufferViews");
    }
  }

  // Whether the file holds the bytes of the view that a part of an accessor names.
  bool hasBytes(const Json& part) {
    return namedBytes(from_, named("bufferViews", indexOr(part, "bufferView"))).has_value();
  }

  Json view(const Json& entry) {
    const std::span<const std::uint8_t> bytes = namedBytes(from_, entry).value();
    Json copy = Json::object();
    for (const char* key : {"byteStride", "target", "name"}) {
      if (const Json* value = find(entry, key)) {
        copy[key] = *value;
      }
    }
    return placed(std::move(copy), {bytes.begin(), bytes.end()});
  }

  Json placed(Json view, const Bytes& bytes) {
    bytes_.resize((bytes_.size() + alignment - 1) / alignment * alignment);
    Json placed{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
    placed.update(view);
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return placed;
  }

  int addView(Json view, const Bytes& bytes) {
    Json& views = lists_["bufferViews"];
    views.push_back(placed(std::move(view), bytes));
    return static_cast<int>(views.size()) - 1;
  }

  static bool uses(const Json& json, const std::string& extension) {
    if (!json.is_structured()) {
      return false;
    }
    const Json* const extensions = find(json, "extensions");
    if (extensions != nullptr && extensions->contains(extension)) {
      return true;
    }
    for (const Json& value : json) {
      if (uses(value, extension)) {
        return true;
      }
    }
    return false;
  }

  // Quantised attributes are told by the list alone.
  void keepExtensions(const char* list) {
    Json kept = Json::array();
    for (const Json& name : find(from_.json, list) != nullptr ? *find(from_.json, list) : Json::array()) {
      if (name == "KHR_mesh_quantization" || uses(to_.json, name.get<std::string>())) {
        kept.push_back(name);
      }
    }
    if (!kept.empty()) {
      (*to_.json)[list] = std::move(kept);
    }
  }

  static std::string mediaTypeOf(const Json& image, const Bytes& bytes) {
    const bool isJpeg = bytes.size() > 2 && bytes[0] == 0xFF && bytes[1] == 0xD8;
    const bool isWebp = bytes.size() > 12 && bytes[8] == 'W' && bytes[9] == 'E';
    return image.contains("mimeType") ? textOr(image, "mimeType")
           : isJpeg                   ? "image/jpeg"
           : isWebp                   ? "image/webp"
                                      : "image/png";
  }

  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  const Source& from_;
  Source to_;
  std::map<std::pair<std::string, int>, int> taken_;
  std::map<std::string, Json> lists_;
  Bytes bytes_;
  std::map<int, bool> readable_; // images
  std::vector<std::string> warnings_;
};

bool isShownMesh(const Source& thing) {
  return sizeOf(thing.json, "meshes") > 0;
}

bool hasSkinnedNode(const Json& json) {
  for (std::size_t i = 0; i < sizeOf(json, "nodes"); ++i) {
    if (indexOr(element(json, "nodes", i), "skin") >= 0) {
      return true;
    }
  }
  return false;
}

} // namespace

Result<Thing> readThing(const std::filesystem::path& path) {
  const Result<Loaded> loaded = load(path, Tolerance::refuse, Pictures::headers);
  if (!loaded) {
    return inFile(path.string(), loaded.error());
  }
  if (hasSkinnedNode(loaded->source->json)) {
    return Error{"holds a skinned mesh, which its joints move and not a hand", path.string(),
                 "give a file with a thing that a hand can hold"};
  }
  Problems known; // of a file that was read
  const std::optional<PlainSource> plain = plainSource(*loaded->source, known);
  const Source& from = plain ? plain->source : *loaded->source;
  if (sizeOf(from.json, "scenes") == 0) {
    return Error{"has no scene", path.string(), "export it again, with its scene"};
  }
  ThingCopy copy(from);
  auto thing = std::make_shared<const Source>(copy.ofScene());
  if (!isShownMesh(*thing)) {
    return Error{"holds no mesh", path.string(), "give a file with a thing that a hand can hold"};
  }
  Thing read{std::move(thing), {}};
  for (const std::string& warning : copy.warnings()) {
    read.warnings.push_back(path.filename().string() + ": " + warning);
  }
  return read;
}

bool looksLikeThing(const std::filesystem::path& path) {
  Problems problems;
  const std::optional<Source> source = readSource(path, problems);
  if (!source) {
    return false;
  }
  validateStructure(source->json, problems);
  return !problems.hasErrors() && isShownMesh(*source) && !hasSkinnedNode(source->json);
}

bool isThing(const Source& thing) {
  Problems problems;
  validateStructure(thing.json, problems);
  const bool isOneBuffer =
      !problems.hasErrors() && sizeOf(thing.json, "buffers") == 1 && thing.buffers.size() == 1 &&
      sizeOf(thing.json, "scenes") == 1 &&
      wholeOr(element(thing.json, "buffers", 0), "byteLength", 0) <= thing.buffers[0].size();
  return isOneBuffer && isShownMesh(thing) && !hasSkinnedNode(thing.json);
}

} // namespace stretch::gltf

#include "core/gltf/import/material_library.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/problems.h"

namespace stretch::gltf {

namespace {

/// Calls `visit(holder, key)` for every reference to a texture below a material: "...Texture": {"index": n}.
template <typename Visit>
void eachTextureUse(Json& json, const Visit& visit) {
  std::vector<std::string> uses;
  for (const auto& [key, value] : json.items()) {
    const bool isUse = value.is_object() && key.ends_with("Texture") && indexOr(value, "index") >= 0;
    if (isUse) {
      uses.push_back(key);
    } else if (value.is_structured()) {
      eachTextureUse(value, visit);
    }
  }
  for (const std::string& key : uses) {
    visit(json, key);
  }
}

void collectExtensions(const Json& json, std::set<std::string>& names) {
  for (const auto& [key, value] : json.items()) {
    if (key == "extensions" && value.is_object()) {
      for (const auto& extension : value.items()) {
        names.insert(extension.key());
      }
    }
    if (value.is_structured()) {
      collectExtensions(value, names);
    }
  }
}

std::size_t appendView(Source& materials, const Bytes& bytes) {
  Bytes& buffer = materials.buffers.front();
  buffer.resize((buffer.size() + 3) / 4 * 4);
  Json& views = (*materials.json)["bufferViews"];
  views.push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
  buffer.insert(buffer.end(), bytes.begin(), bytes.end());
  (*materials.json)["buffers"][0]["byteLength"] = buffer.size();
  return views.size() - 1;
}

Source emptyLibrary() {
  Source library;
  library.json = Json{{"asset", {{"version", "2.0"}}}, {"buffers", Json::array({{{"byteLength", 0}}})}};
  library.buffers.emplace_back();
  library.hasBinaryChunk = true;
  return library;
}

/// Takes textures over one by one, each once, with what they name.
class LibraryMaker {
public:
  LibraryMaker(const Source& source, std::vector<std::string>& warnings)
      : source_(source), warnings_(warnings), made_(emptyLibrary()) {}

  Source make() {
    const Json* materials = find(source_.json, "materials");
    if (materials == nullptr || !materials->is_array()) {
      return std::move(made_);
    }
    Json copies = *materials;
    eachTextureUse(copies, [&](Json& holder, const std::string& key) { takeUse(holder, key); });
    (*made_.json)["materials"] = std::move(copies);
    takeExtensions();
    return std::move(made_);
  }

private:
  void takeUse(Json& holder, const std::string& key) {
    if (const std::optional<std::size_t> texture = textureFor(indexOr(holder[key], "index"))) {
      holder[key]["index"] = *texture;
    } else {
      holder.erase(key);
    }
  }

  std::optional<std::size_t> textureFor(int index) {
    if (const auto known = textures_.find(index); known != textures_.end()) {
      return known->second;
    }
    return textures_[index] = takeTexture(index);
  }

  std::optional<std::size_t> takeTexture(int index) {
    if (static_cast<std::size_t>(index) >= sizeOf(source_.json, "textures")) {
      return std::nullopt;
    }
    Json texture = element(source_.json, "textures", static_cast<std::size_t>(index));
    bool shown = takeImage(texture);
    if (Json* const extensions = texture.contains("extensions") ? &texture["extensions"] : nullptr;
        extensions != nullptr && extensions->is_object()) {
      for (const auto& [name, extension] : extensions->items()) {
        shown = takeImage(extension) || shown;
      }
    }
    if (!shown) {
      return std::nullopt;
    }
    if (const int sampler = indexOr(texture, "sampler"); sampler >= 0) {
      texture["sampler"] = takeSampler(sampler);
    }
    Json& textures = (*made_.json)["textures"];
    textures.push_back(std::move(texture));
    return textures.size() - 1;
  }

  /// Points the "source" of a texture, or of one of its extensions, to the image in the library.
  bool takeImage(Json& holder) {
    const int index = indexOr(holder, "source");
    if (index < 0 || static_cast<std::size_t>(index) >= sizeOf(source_.json, "images")) {
      return false;
    }
    const auto known = images_.find(index);
    const std::optional<std::size_t> image =
        known != images_.end() ? known->second : images_[index] = copyImage(static_cast<std::size_t>(index));
    if (image) {
      holder["source"] = *image;
    } else {
      holder.erase("source");
    }
    return image.has_value();
  }

  std::optional<std::size_t> copyImage(std::size_t index) {
    Json image = element(source_.json, "images", index);
    const std::optional<Bytes> bytes = encodedImage(source_, image);
    if (!bytes || bytes->empty()) {
      warnings_.push_back(fmt::format("{}: the image cannot be read and is left out", at("images", index)));
      return std::nullopt;
    }
    if (!image.contains("mimeType")) {
      image["mimeType"] = mediaTypeOf(*bytes).value_or("image/png");
    }
    image.erase("uri");
    image["bufferView"] = appendView(made_, *bytes);
    Json& images = (*made_.json)["images"];
    images.push_back(std::move(image));
    return images.size() - 1;
  }

  std::size_t takeSampler(int index) {
    const auto [known, isNew] = samplers_.try_emplace(index, samplers_.size());
    if (isNew) {
      (*made_.json)["samplers"].push_back(element(source_.json, "samplers", static_cast<std::size_t>(index)));
    }
    return known->second;
  }

  void takeExtensions() {
    std::set<std::string> names;
    for (const char* const list : {"materials", "textures", "samplers", "images"}) {
      if (const Json* found = find(made_.json, list)) {
        collectExtensions(*found, names);
      }
    }
    for (const std::string& name : names) {
      (*made_.json)["extensionsUsed"].push_back(name);
      if (listsText(source_.json, "extensionsRequired", name)) {
        (*made_.json)["extensionsRequired"].push_back(name);
      }
    }
  }

  const Source& source_;
  std::vector<std::string>& warnings_;
  Source made_;
  std::map<int, std::optional<std::size_t>> textures_;
  std::map<int, std::optional<std::size_t>> images_;
  std::map<int, std::size_t> samplers_;
};

} // namespace

Source materialsOf(const Source& source, std::vector<std::string>& warnings) {
  return LibraryMaker(source, warnings).make();
}

std::optional<std::string> mediaTypeOf(std::span<const std::uint8_t> image) {
  const std::string_view start(reinterpret_cast<const char*>(image.data()),
                               std::min<std::size_t>(image.size(), 12));
  if (start.starts_with("RIFF") && start.substr(8) == "WEBP") {
    return "image/webp";
  }
  if (start.starts_with("\xFF\xD8\xFF")) {
    return "image/jpeg";
  }
  return start.starts_with("\x89PNG") ? std::optional<std::string>("image/png") : std::nullopt;
}

ShownMaterials shownMaterials(const Source& materials) {
  Problems told; // what cannot be shown was told when the file was read
  const std::vector<Material> drawn = importMaterials(materials, told);
  ShownMaterials shown;
  shown.images = importImages(materials, drawn, told);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const int index = static_cast<int>(i);
    const int baseColorSet = std::max(baseColorTexCoord(materials, index).value_or(0), 0);
    const int emissiveSet = std::max(emissiveTexCoord(materials, index).value_or(baseColorSet), 0);
    shown.materials.push_back(
        {drawn[i], static_cast<std::size_t>(baseColorSet), static_cast<std::size_t>(emissiveSet)});
  }
  return shown;
}

} // namespace stretch::gltf

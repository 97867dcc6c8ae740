#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>

#include <assimp/scene.h>
#include <fmt/core.h>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include "core/gltf/json/json.h"
#include "core/gltf/source/uri.h"
#include "core/interchange/figure_meshes.h"

namespace stretch::interchange {

namespace {

using gltf::Json;
namespace fs = std::filesystem;

constexpr std::size_t mostPixels = std::size_t{1} << 26U;

std::string mimeOf(const Bytes& bytes) {
  const std::string_view head(reinterpret_cast<const char*>(bytes.data()),
                              std::min<std::size_t>(bytes.size(), 4));
  return head.starts_with("\x89PNG") ? "image/png" : head.starts_with("\xFF\xD8\xFF") ? "image/jpeg" : "";
}

void appendBytes(void* to, void* from, int count) {
  const auto* const bytes = static_cast<const std::uint8_t*>(from);
  static_cast<Bytes*>(to)->insert(static_cast<Bytes*>(to)->end(), bytes, bytes + count);
}

Bytes pngOf(int width, int height, const std::uint8_t* rgba) {
  Bytes png;
  return stbi_write_png_to_func(appendBytes, &png, width, height, 4, rgba, 4 * width) != 0 ? png : Bytes();
}

// TGA, BMP, PSD and so on as PNG; empty for what is none, or too large.
Bytes asPng(const Bytes& bytes) {
  int width = 0;
  int height = 0;
  int channels = 0;
  const auto length = static_cast<int>(std::min<std::size_t>(bytes.size(), 1U << 30U));
  if (stbi_info_from_memory(bytes.data(), length, &width, &height, &channels) == 0 ||
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > mostPixels) {
    return {};
  }
  std::uint8_t* const rgba = stbi_load_from_memory(bytes.data(), length, &width, &height, &channels, 4);
  Bytes png = rgba == nullptr ? Bytes() : pngOf(width, height, rgba);
  stbi_image_free(rgba);
  return png;
}

// A picture inside the file: packed, or one pixel after the other.
Bytes embeddedPicture(const aiTexture& texture) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(texture.pcData);
  if (data == nullptr) {
    return {};
  }
  if (texture.mHeight == 0) {
    return {data, data + texture.mWidth};
  }
  const std::size_t pixels = std::size_t{texture.mWidth} * texture.mHeight;
  Bytes rgba;
  for (std::size_t i = 0; i < pixels && pixels <= mostPixels; ++i) {
    const aiTexel& texel = texture.pcData[i];
    rgba.insert(rgba.end(), {texel.r, texel.g, texel.b, texel.a});
  }
  return rgba.empty()
             ? Bytes()
             : pngOf(static_cast<int>(texture.mWidth), static_cast<int>(texture.mHeight), rgba.data());
}

// Names in files are paths of the machine that wrote them: what lies beside the file, or in the folders that
// programs make for it, is meant.
std::optional<Bytes> pictureBeside(const fs::path& file, std::string name) {
  std::ranges::replace(name, '\\', '/');
  const fs::path relative = fs::path(name).lexically_normal();
  const fs::path own = relative.filename();
  const fs::path folder = file.parent_path();
  std::vector<fs::path> places{folder / own, folder / "textures" / own, folder / "Textures" / own,
                               folder / (file.stem().string() + ".fbm") / own};
  if (!relative.is_absolute() && !gltf::escapesFolder(relative)) {
    places.insert(places.begin(), folder / relative);
  }
  for (const fs::path& place : places) {
    std::error_code ignored;
    if (!own.empty() && fs::is_regular_file(place, ignored)) {
      Result<Bytes> bytes = readFile(place);
      return bytes ? std::optional(std::move(bytes).value()) : std::nullopt;
    }
  }
  return std::nullopt;
}

class MaterialAdder {
public:
  MaterialAdder(const aiScene& scene, const fs::path& file, GlbParts& parts,
                std::vector<std::string>& warnings)
      : scene_(scene), file_(file), parts_(parts), warnings_(warnings) {}

  int add(const aiMaterial& material) {
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    Json made{{"name", name.C_Str()}, {"doubleSided", true}, {"pbrMetallicRoughness", surfaceOf(material)}};
    if (const int normals = textureOf(material, aiTextureType_NORMALS); normals >= 0) {
      made["normalTexture"] = {{"index", normals}};
    }
    if (const int glow = textureOf(material, aiTextureType_EMISSIVE); glow >= 0) {
      made["emissiveTexture"] = {{"index", glow}};
      made["emissiveFactor"] = {1, 1, 1};
    }
    if (made["pbrMetallicRoughness"]["baseColorFactor"][3].get<float>() < 1.0F) {
      made["alphaMode"] = "BLEND";
    }
    return static_cast<int>(parts_.add("materials", made));
  }

private:
  // A picture stands in place of the colour, as in the programs that write such files.
  Json surfaceOf(const aiMaterial& material) {
    aiColor3D colour;
    float opacity = 1.0F;
    float shininess = 0.0F;
    if (material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS) {
      colour = {0.8F, 0.8F, 0.8F};
    }
    material.Get(AI_MATKEY_OPACITY, opacity);
    material.Get(AI_MATKEY_SHININESS, shininess);
    int picture = textureOf(material, aiTextureType_DIFFUSE);
    picture = picture < 0 ? textureOf(material, aiTextureType_BASE_COLOR) : picture;
    const auto share = [](float value) {
      return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 1.0F;
    };
    // Blender's own way from a shininess to a roughness.
    const float roughness =
        std::clamp(1.0F - std::sqrt(std::max(0.0F, share(shininess / 100.0F))), 0.3F, 1.0F);
    Json surface{{"metallicFactor", 0}, {"roughnessFactor", roughness}};
    // A file that says wholly transparent mostly means the opposite: exporters disagree on which way it
    // counts.
    const float alpha = share(opacity) > 0.0F ? share(opacity) : 1.0F;
    surface["baseColorFactor"] =
        picture >= 0 ? Json{1, 1, 1, alpha} : Json{share(colour.r), share(colour.g), share(colour.b), alpha};
    if (picture >= 0) {
      surface["baseColorTexture"] = {{"index", picture}};
    }
    return surface;
  }

  int textureOf(const aiMaterial& material, aiTextureType type) {
    aiString path;
    if (material.GetTextureCount(type) == 0 || material.GetTexture(type, 0, &path) != aiReturn_SUCCESS ||
        path.length == 0) {
      return -1;
    }
    const std::string name = path.C_Str();
    const auto known = textures_.find(name);
    return known != textures_.end() ? known->second : textures_[name] = addTexture(name);
  }

  int addTexture(const std::string& name) {
    const aiTexture* const embedded = scene_.GetEmbeddedTexture(name.c_str());
    const std::optional<Bytes> found =
        embedded != nullptr ? std::optional(embeddedPicture(*embedded)) : pictureBeside(file_, name);
    const std::string shown = fs::path(name.substr(name.find_last_of("/\\") + 1)).string();
    if (!found) {
      warnings_.push_back(fmt::format("the texture '{}' is not beside the file, and is left out", shown));
      return -1;
    }
    const Bytes bytes = mimeOf(*found).empty() ? asPng(*found) : *found;
    if (bytes.empty()) {
      warnings_.push_back(
          fmt::format("the texture '{}' is of a kind that is not read, and is left out", shown));
      return -1;
    }
    const std::size_t image = parts_.add(
        "images", {{"name", shown}, {"mimeType", mimeOf(bytes)}, {"bufferView", parts_.addBytes(bytes)}});
    return static_cast<int>(parts_.add("textures", {{"source", image}}));
  }

  const aiScene& scene_;
  const fs::path& file_;
  GlbParts& parts_;
  std::vector<std::string>& warnings_;
  std::map<std::string, int> textures_;
};

} // namespace

std::vector<int> addMaterials(const aiScene& scene, const fs::path& file, GlbParts& parts,
                              std::vector<std::string>& warnings) {
  MaterialAdder adder(scene, file, parts, warnings);
  std::vector<int> materials;
  for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
    materials.push_back(adder.add(*scene.mMaterials[m]));
  }
  return materials;
}

} // namespace stretch::interchange

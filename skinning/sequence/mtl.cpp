#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "core/base/file.h"
#include "core/base/number.h"
#include "core/gltf/import/material_library.h"
#include "core/gltf/write/new_file.h"
#include "skinning/sequence/obj_surface.h"
#include "skinning/sequence/text.h"

namespace stretch::skinning {
namespace {

/// What an MTL file says of a material.
struct MtlMaterial {
  std::optional<glm::vec3> diffuse;
  glm::vec3 emissive{0.0F};
  double opacity = 1.0;
  std::optional<double> specularExponent;
  std::optional<double> roughness;
  double metallic = 0.0;
  std::map<std::string, std::string> images; ///< "map_Kd", "map_Ke", "norm" to the file that is named.
  std::filesystem::path folder;
};

constexpr std::array<std::string_view, 3> imageKeywords{"map_Kd", "map_Ke", "norm"};

std::optional<glm::vec3> colourOf(std::string_view words) {
  glm::vec3 colour(0.0F);
  for (glm::length_t i = 0; i < 3; ++i) {
    const auto number = parseNumber(nextWord(words));
    if (!number) {
      // "Kd 0.5" stands for a grey.
      return i == 0 ? std::nullopt : std::optional(glm::vec3(colour[0]));
    }
    colour[i] = static_cast<float>(std::clamp(*number, 0.0, 1.0));
  }
  return colour;
}

/// The file of "map_Kd -s 1 1 1 folder/my picture.png": options and their values are stepped over.
std::string imageName(std::string_view words) {
  std::string_view rest = words;
  std::string_view word = nextWord(rest);
  while (!word.empty() && word.front() == '-') {
    // The values of an option are numbers or switches.
    do {
      words = rest;
      word = nextWord(rest);
    } while (parseNumber(word).has_value() || word == "on" || word == "off");
  }
  std::string name(trimmed(words));
  std::ranges::replace(name, '\\', '/');
  return name;
}

void readValue(std::string_view keyword, std::string_view words, MtlMaterial& material) {
  const auto number = [&] {
    std::string_view rest = words;
    return parseNumber(nextWord(rest));
  };
  if (keyword == "Kd") {
    material.diffuse = colourOf(words);
  } else if (keyword == "Ke") {
    material.emissive = colourOf(words).value_or(glm::vec3(0.0F));
  } else if (keyword == "d") {
    material.opacity = std::clamp(number().value_or(1.0), 0.0, 1.0);
  } else if (keyword == "Tr") {
    material.opacity = 1.0 - std::clamp(number().value_or(0.0), 0.0, 1.0);
  } else if (keyword == "Ns") {
    material.specularExponent = number();
  } else if (keyword == "Pr") {
    material.roughness = number();
  } else if (keyword == "Pm") {
    material.metallic = std::clamp(number().value_or(0.0), 0.0, 1.0);
  } else if (std::ranges::find(imageKeywords, keyword) != imageKeywords.end()) {
    material.images[std::string(keyword)] = imageName(words);
  }
}

using MtlMaterials = std::map<std::string, MtlMaterial>;

void readLibrary(const std::filesystem::path& file, MtlMaterials& materials,
                 std::vector<std::string>& warnings) {
  const Result<std::string> text = readText(file);
  if (!text) {
    warnings.push_back(file.filename().string() + " cannot be read: its materials are grey");
    return;
  }
  std::string_view rest = *text;
  std::string_view line;
  MtlMaterial* current = nullptr;
  while (nextLine(rest, line)) {
    const std::string_view keyword = nextWord(line);
    if (keyword == "newmtl") {
      current = &materials[std::string(trimmed(line))];
      current->folder = file.parent_path();
    } else if (current != nullptr) {
      readValue(keyword, line, *current);
    }
  }
}

/// The image beside the MTL file or below it; a name that leads elsewhere is looked for by its last part.
std::optional<Bytes> imageBytes(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path named(name);
  const bool inside = named.is_relative() && std::ranges::find(named, "..") == named.end();
  for (const std::filesystem::path& candidate : {inside ? named : named.filename(), named.filename()}) {
    Result<Bytes> bytes = readFile(folder / candidate);
    if (bytes) {
      return std::move(bytes).value();
    }
  }
  return std::nullopt;
}

/// Makes the materials; an image that several of them name is taken once.
class MaterialMaker {
public:
  explicit MaterialMaker(std::vector<std::string>& warnings) : warnings_(warnings) {}

  void add(const std::string& name, const MtlMaterial& material) {
    gltf::NewMaterial made;
    made.name = name;
    made.baseColorTexture = textureOf(material, "map_Kd");
    const bool isTextured = made.baseColorTexture.has_value();
    const glm::vec3 plain = material.diffuse.value_or(glm::vec3(isTextured ? 1.0F : 0.8F));
    // Under a texture exporters leave black, and mean the texture as it is.
    const glm::vec3 colour = isTextured && plain == glm::vec3(0.0F) ? glm::vec3(1.0F) : plain;
    made.baseColor = {colour.x, colour.y, colour.z, material.opacity};
    made.metallic = material.metallic;
    made.roughness = roughnessOf(material);
    made.normalTexture = textureOf(material, "norm");
    made.emissiveTexture = textureOf(material, "map_Ke");
    const bool shinesWhite = made.emissiveTexture && material.emissive == glm::vec3(0.0F);
    made.emissive = shinesWhite ? Vec3(1.0) : Vec3(material.emissive);
    made.isBlended = material.opacity < 1.0;
    made.isDoubleSided = true; // OBJ knows no back faces.
    library_.addMaterial(made);
  }

  gltf::Source make() { return library_.finish(); }

private:
  /// As Blender's exporter writes it: Ns = 1000 (1 - roughness)^2.
  static double roughnessOf(const MtlMaterial& material) {
    if (material.roughness) {
      return std::clamp(*material.roughness, 0.0, 1.0);
    }
    return material.specularExponent
               ? 1.0 - std::sqrt(std::clamp(*material.specularExponent, 0.0, 1000.0) / 1000.0)
               : 0.8;
  }

  std::optional<std::size_t> textureOf(const MtlMaterial& material, const char* keyword) {
    const auto named = material.images.find(keyword);
    if (named == material.images.end() || named->second.empty()) {
      return std::nullopt;
    }
    const std::string place = (material.folder / named->second).string();
    if (const auto known = textures_.find(place); known != textures_.end()) {
      return known->second;
    }
    return textures_[place] = takeImage(material.folder, named->second);
  }

  std::optional<std::size_t> takeImage(const std::filesystem::path& folder, const std::string& name) {
    const std::optional<Bytes> bytes = imageBytes(folder, name);
    if (!bytes) {
      warnings_.push_back("the image " + name + " is not beside its material file: its texture is left out");
      return std::nullopt;
    }
    if (!gltf::mediaTypeOf(*bytes)) {
      warnings_.push_back("the image " + name + " is no PNG, JPEG or WebP: its texture is left out");
      return std::nullopt;
    }
    return library_.addTexture(*bytes, std::filesystem::path(name).filename().string());
  }

  std::vector<std::string>& warnings_;
  gltf::NewFile library_;
  std::map<std::string, std::optional<std::size_t>> textures_;
};

} // namespace

gltf::Source materialsOfMtl(const std::vector<std::filesystem::path>& files,
                            const std::vector<std::string>& names, std::vector<std::string>& warnings) {
  MtlMaterials described;
  for (const std::filesystem::path& file : files) {
    readLibrary(file, described, warnings);
  }
  MaterialMaker maker(warnings);
  for (const std::string& name : names) {
    const auto found = described.find(name);
    maker.add(name, found == described.end() ? MtlMaterial{} : found->second);
  }
  return maker.make();
}

} // namespace stretch::skinning

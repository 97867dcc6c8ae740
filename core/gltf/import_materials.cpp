#include <cmath>

#include <fmt/core.h>

#include "core/gltf/fields.h"
#include "core/gltf/import.h"
#include "core/gltf/json.h"

namespace stretch::gltf {

namespace {

// The base colour texture of either material model.
const Json* baseColorInfo(const Json& material) {
  const Json* info = findPath(material, {"pbrMetallicRoughness", "baseColorTexture"});
  return info != nullptr
             ? info
             : findPath(material, {"extensions", "KHR_materials_pbrSpecularGlossiness", "diffuseTexture"});
}

glm::vec4 baseColorFactor(const Json& material) {
  const Json* metallic = find(material, "pbrMetallicRoughness");
  const Json* glossy = findPath(material, {"extensions", "KHR_materials_pbrSpecularGlossiness"});
  std::vector<double> factor;
  if (metallic != nullptr) {
    factor = numbersOf(*metallic, "baseColorFactor");
  } else if (glossy != nullptr) {
    factor = numbersOf(*glossy, "diffuseFactor");
  }
  return factor.size() == 4 ? glm::vec4(factor[0], factor[1], factor[2], factor[3]) : glm::vec4(1.0F);
}

// KHR_texture_transform; false when it turns the texture, which uvTransform cannot say.
bool readTextureTransform(const Json& info, Material& material) {
  const Json* transform = findPath(info, {"extensions", "KHR_texture_transform"});
  if (transform == nullptr) {
    return true;
  }
  if (const std::vector<double> scale = numbersOf(*transform, "scale"); scale.size() == 2) {
    material.uvTransform[0] = static_cast<float>(scale[0]);
    material.uvTransform[1] = static_cast<float>(scale[1]);
  }
  if (const std::vector<double> offset = numbersOf(*transform, "offset"); offset.size() == 2) {
    material.uvTransform[2] = static_cast<float>(offset[0]);
    material.uvTransform[3] = static_cast<float>(offset[1]);
  }
  return std::abs(numberOr(*transform, "rotation", 0.0)) < 1e-6;
}

// Readers of EXT_texture_webp prefer its picture; the other one is for those that are none.
int imageOf(const Json& json, const Json& texture) {
  const Json* webp = findPath(texture, {"extensions", "EXT_texture_webp"});
  const int image = webp == nullptr ? -1 : indexOr(*webp, "source");
  return image >= 0 && static_cast<std::size_t>(image) < sizeOf(json, "images") ? image
                                                                                : indexOr(texture, "source");
}

std::string complaintAboutTexture(const Json& texture) {
  return findPath(texture, {"extensions", "KHR_texture_basisu"}) != nullptr
             ? "has a KTX2 image, which is not shown; its material keeps its plain colour"
             : "has no PNG, JPEG or WebP image; it is not shown";
}

void readBaseColorTexture(const Json& json, const Json& info, const std::string& where, Material& material,
                          Problems& problems) {
  constexpr int nearest = 9728;
  const int texture = indexOr(info, "index");
  if (texture < 0 || static_cast<std::size_t>(texture) >= sizeOf(json, "textures")) {
    return;
  }
  const Json& textureJson = element(json, "textures", static_cast<std::size_t>(texture));
  material.baseColorImage = imageOf(json, textureJson);
  if (material.baseColorImage < 0) {
    problems.warning(at("textures", static_cast<std::size_t>(texture)), complaintAboutTexture(textureJson));
  }
  if (const int sampler = indexOr(textureJson, "sampler"); sampler >= 0) {
    const Json& samplerJson = element(json, "samplers", static_cast<std::size_t>(sampler));
    material.nearestFilter = indexOr(samplerJson, "magFilter") == nearest;
  }
  if (!readTextureTransform(info, material)) {
    problems.warning(where, "turns its texture, which the viewport does not show");
  }
}

AlphaMode alphaModeOf(const std::string& name) {
  if (name == "MASK") {
    return AlphaMode::mask;
  }
  return name == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

Material importMaterial(const Json& root, std::size_t index, Problems& problems) {
  const Json& json = element(root, "materials", index);
  Material material;
  material.name = textOr(json, "name");
  material.baseColor = baseColorFactor(json);
  if (const std::vector<double> emissive = numbersOf(json, "emissiveFactor"); emissive.size() == 3) {
    material.emissive = {emissive[0], emissive[1], emissive[2]};
  }
  material.alphaMode = alphaModeOf(textOr(json, "alphaMode"));
  material.alphaCutoff = static_cast<float>(numberOr(json, "alphaCutoff", 0.5));
  material.doubleSided = flagOr(json, "doubleSided", false);
  material.unlit = findPath(json, {"extensions", "KHR_materials_unlit"}) != nullptr;
  if (const Json* info = baseColorInfo(json)) {
    readBaseColorTexture(root, *info, at("materials", index), material, problems);
  }
  return material;
}

} // namespace

std::vector<Material> importMaterials(const Source& source, Problems& problems) {
  std::vector<Material> materials(sizeOf(source.json, "materials"));
  for (std::size_t i = 0; i < materials.size(); ++i) {
    materials[i] = importMaterial(source.json, i, problems);
  }
  return materials;
}

bool usesBaseColorTexture(const Source& source, int material) {
  return material >= 0 &&
         baseColorInfo(element(source.json, "materials", static_cast<std::size_t>(material))) != nullptr;
}

int baseColorTexCoord(const Source& source, int material) {
  if (material < 0) {
    return 0;
  }
  const Json* info = baseColorInfo(element(source.json, "materials", static_cast<std::size_t>(material)));
  if (info == nullptr) {
    return 0;
  }
  const int own = indexOr(*info, "texCoord", 0);
  const Json* transform = findPath(*info, {"extensions", "KHR_texture_transform"});
  return transform == nullptr ? own : indexOr(*transform, "texCoord", own);
}

} // namespace stretch::gltf

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"

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

// KHR_texture_transform: scaled, turned, moved, in this order.
glm::mat3x2 uvTransformOf(const Json& info) {
  glm::mat3x2 made{1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F};
  const Json* transform = findPath(info, {"extensions", "KHR_texture_transform"});
  if (transform == nullptr) {
    return made;
  }
  const double angle = numberOr(*transform, "rotation", 0.0);
  const glm::vec2 alongU(std::cos(angle), -std::sin(angle));
  made[0] = alongU;
  made[1] = {-alongU.y, alongU.x};
  if (const std::vector<double> scale = numbersOf(*transform, "scale"); scale.size() == 2) {
    made[0] *= static_cast<float>(scale[0]);
    made[1] *= static_cast<float>(scale[1]);
  }
  if (const std::vector<double> offset = numbersOf(*transform, "offset"); offset.size() == 2) {
    made[2] = glm::vec2(offset[0], offset[1]);
  }
  return made;
}

TextureWrap wrapOf(const Json& sampler, std::string_view key) {
  constexpr int clamp = 33071;
  constexpr int mirror = 33648;
  const int wrap = indexOr(sampler, key);
  if (wrap == clamp) {
    return TextureWrap::clamp;
  }
  return wrap == mirror ? TextureWrap::mirror : TextureWrap::repeat;
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

TextureUse textureUse(const Json& json, const Json& info, Problems& problems) {
  constexpr int nearest = 9728;
  TextureUse use;
  const int texture = indexOr(info, "index");
  if (texture < 0 || static_cast<std::size_t>(texture) >= sizeOf(json, "textures")) {
    return use;
  }
  const Json& textureJson = element(json, "textures", static_cast<std::size_t>(texture));
  use.image = imageOf(json, textureJson);
  if (use.image < 0) {
    problems.warning(at("textures", static_cast<std::size_t>(texture)), complaintAboutTexture(textureJson));
  }
  if (const int sampler = indexOr(textureJson, "sampler"); sampler >= 0) {
    const Json& samplerJson = element(json, "samplers", static_cast<std::size_t>(sampler));
    use.nearestFilter = indexOr(samplerJson, "magFilter") == nearest;
    use.wrapU = wrapOf(samplerJson, "wrapS");
    use.wrapV = wrapOf(samplerJson, "wrapT");
  }
  use.uvTransform = uvTransformOf(info);
  return use;
}

// Factor, strength and texture; what has a texture that cannot be shown does not glow all over.
void readEmission(const Json& root, const Json& json, Material& material, Problems& problems) {
  if (const std::vector<double> emissive = numbersOf(json, "emissiveFactor"); emissive.size() == 3) {
    material.emissive = {emissive[0], emissive[1], emissive[2]};
  }
  if (const Json* strong = findPath(json, {"extensions", "KHR_materials_emissive_strength"})) {
    material.emissive *= static_cast<float>(std::max(numberOr(*strong, "emissiveStrength", 1.0), 0.0));
  }
  const Json* info = find(json, "emissiveTexture");
  if (info == nullptr || material.emissive == glm::vec3(0.0F)) {
    return;
  }
  material.emissiveTexture = textureUse(root, *info, problems);
  if (material.emissiveTexture.image < 0) {
    material.emissive = glm::vec3(0.0F);
  }
}

AlphaMode alphaModeOf(const std::string& name) {
  if (name == "MASK") {
    return AlphaMode::mask;
  }
  return name == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
}

// The transform may name another set than the texture does.
std::optional<int> texCoordOf(const Json* info) {
  if (info == nullptr) {
    return std::nullopt;
  }
  const int own = indexOr(*info, "texCoord", 0);
  const Json* transform = findPath(*info, {"extensions", "KHR_texture_transform"});
  return transform == nullptr ? own : indexOr(*transform, "texCoord", own);
}

Material importMaterial(const Json& root, std::size_t index, Problems& problems) {
  const Json& json = element(root, "materials", index);
  Material material;
  material.name = shownName(json);
  material.baseColor = baseColorFactor(json);
  readEmission(root, json, material, problems);
  material.alphaMode = alphaModeOf(textOr(json, "alphaMode"));
  material.alphaCutoff = static_cast<float>(numberOr(json, "alphaCutoff", 0.5));
  material.doubleSided = flagOr(json, "doubleSided", false);
  material.unlit = findPath(json, {"extensions", "KHR_materials_unlit"}) != nullptr;
  if (const Json* info = baseColorInfo(json)) {
    material.baseColorTexture = textureUse(root, *info, problems);
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

std::optional<int> baseColorTexCoord(const Source& source, int material) {
  return material < 0 ? std::nullopt
                      : texCoordOf(baseColorInfo(
                            element(source.json, "materials", static_cast<std::size_t>(material))));
}

std::optional<int> emissiveTexCoord(const Source& source, int material) {
  return material < 0 ? std::nullopt
                      : texCoordOf(find(element(source.json, "materials", static_cast<std::size_t>(material)),
                                        "emissiveTexture"));
}

} // namespace stretch::gltf

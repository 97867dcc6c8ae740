#include "core/gltf/read/schema.h"

#include <array>

#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

using enum PropertyKind;

constexpr bool required = true;
constexpr bool optional = false;
constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double mostElements = 4294967295.0;

constexpr Property rangeOf(std::string_view owner, std::string_view name, PropertyKind kind, bool isRequired,
                           double minimum, double maximum) {
  return {owner, name, kind, {}, isRequired, minimum, maximum, 0};
}

constexpr Property numbersOf(std::string_view owner, std::string_view name, int count) {
  return {owner, name, numbers, {}, optional, -unlimited, unlimited, count};
}

constexpr Property textOf(std::string_view owner, std::string_view name, bool isRequired = optional) {
  return {owner, name, text, {}, isRequired};
}

constexpr auto properties = std::to_array<Property>({
    {"root", "asset", object, "asset", required},
    {"root", "extensionsUsed", texts},
    {"root", "extensionsRequired", texts},
    {"root", "extensions", object, "any"},
    {"root", "scene", index, "scenes"},
    {"root", "scenes", objects, "scene"},
    {"root", "nodes", objects, "node"},
    {"root", "meshes", objects, "mesh"},
    {"root", "skins", objects, "skin"},
    {"root", "animations", objects, "animation"},
    {"root", "accessors", objects, "accessor"},
    {"root", "bufferViews", objects, "bufferView"},
    {"root", "buffers", objects, "buffer"},
    {"root", "materials", objects, "material"},
    {"root", "textures", objects, "texture"},
    {"root", "images", objects, "image"},
    {"root", "samplers", objects, "any"},
    {"root", "cameras", objects, "any"},
    textOf("asset", "version", required),
    textOf("asset", "minVersion"),
    textOf("scene", "name"),
    {"scene", "nodes", indices, "nodes"},
    textOf("node", "name"),
    {"node", "children", indices, "nodes"},
    {"node", "mesh", index, "meshes"},
    {"node", "skin", index, "skins"},
    {"node", "camera", index, "cameras"},
    numbersOf("node", "matrix", 16),
    numbersOf("node", "translation", 3),
    numbersOf("node", "rotation", 4),
    numbersOf("node", "scale", 3),
    numbersOf("node", "weights", 0),
    textOf("mesh", "name"),
    {"mesh", "primitives", objects, "primitive", required},
    numbersOf("mesh", "weights", 0),
    {"primitive", "attributes", indexMap, "accessors", required},
    {"primitive", "indices", index, "accessors"},
    {"primitive", "material", index, "materials"},
    rangeOf("primitive", "mode", whole, optional, 0, 6),
    {"primitive", "targets", indexMaps, "accessors"},
    {"primitive", "extensions", object, "any"},
    textOf("skin", "name"),
    {"skin", "joints", indices, "nodes", required},
    {"skin", "inverseBindMatrices", index, "accessors"},
    {"skin", "skeleton", index, "nodes"},
    textOf("animation", "name"),
    {"animation", "channels", objects, "channel", required},
    {"animation", "samplers", objects, "animationSampler", required},
    {"channel", "sampler", localIndex, {}, required},
    {"channel", "target", object, "channelTarget", required},
    {"channelTarget", "node", index, "nodes"},
    textOf("channelTarget", "path", required),
    {"animationSampler", "input", index, "accessors", required},
    {"animationSampler", "output", index, "accessors", required},
    textOf("animationSampler", "interpolation"),
    {"accessor", "bufferView", index, "bufferViews"},
    rangeOf("accessor", "byteOffset", whole, optional, 0, largestWhole),
    rangeOf("accessor", "componentType", whole, required, 0, mostElements),
    {"accessor", "normalized", flag},
    rangeOf("accessor", "count", whole, required, 1, mostElements),
    textOf("accessor", "type", required),
    numbersOf("accessor", "min", 0),
    numbersOf("accessor", "max", 0),
    {"accessor", "sparse", object, "sparse"},
    rangeOf("sparse", "count", whole, required, 1, mostElements),
    {"sparse", "indices", object, "sparseIndices", required},
    {"sparse", "values", object, "sparseValues", required},
    {"sparseIndices", "bufferView", index, "bufferViews", required},
    rangeOf("sparseIndices", "byteOffset", whole, optional, 0, largestWhole),
    rangeOf("sparseIndices", "componentType", whole, required, 0, mostElements),
    {"sparseValues", "bufferView", index, "bufferViews", required},
    rangeOf("sparseValues", "byteOffset", whole, optional, 0, largestWhole),
    {"bufferView", "buffer", index, "buffers", required},
    rangeOf("bufferView", "byteOffset", whole, optional, 0, largestWhole),
    rangeOf("bufferView", "byteLength", whole, required, 1, largestWhole),
    rangeOf("bufferView", "byteStride", whole, optional, 4, 252),
    rangeOf("bufferView", "target", whole, optional, 0, mostElements),
    textOf("buffer", "uri"),
    rangeOf("buffer", "byteLength", whole, required, 1, largestWhole),
    textOf("material", "name"),
    {"material", "pbrMetallicRoughness", object, "metallicRoughness"},
    {"material", "normalTexture", object, "textureInfo"},
    {"material", "occlusionTexture", object, "textureInfo"},
    {"material", "emissiveTexture", object, "textureInfo"},
    numbersOf("material", "emissiveFactor", 3),
    textOf("material", "alphaMode"),
    rangeOf("material", "alphaCutoff", number, optional, 0, unlimited),
    {"material", "doubleSided", flag},
    {"material", "extensions", object, "any"},
    numbersOf("metallicRoughness", "baseColorFactor", 4),
    {"metallicRoughness", "baseColorTexture", object, "textureInfo"},
    rangeOf("metallicRoughness", "metallicFactor", number, optional, 0, 1),
    rangeOf("metallicRoughness", "roughnessFactor", number, optional, 0, 1),
    {"metallicRoughness", "metallicRoughnessTexture", object, "textureInfo"},
    {"textureInfo", "index", index, "textures", required},
    rangeOf("textureInfo", "texCoord", whole, optional, 0, mostElements),
    {"textureInfo", "extensions", object, "any"},
    {"texture", "source", index, "images"},
    {"texture", "sampler", index, "samplers"},
    {"texture", "extensions", object, "any"},
    textOf("image", "uri"),
    textOf("image", "mimeType"),
    {"image", "bufferView", index, "bufferViews"},
});

} // namespace

std::span<const Property> schema() {
  return properties;
}

} // namespace stretch::gltf

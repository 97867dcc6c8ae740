#include "core/gltf/write/new_file.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <sstream>
#include <type_traits>
#include <utility>

#include <tiny_gltf.h>

#include "core/anim/track_names.h"
#include "core/base/check.h"
#include "core/gltf/import/material_library.h"
#include "core/gltf/json/json.h"
#include "core/gltf/json/utf8.h"
#include "core/gltf/source/fields.h"
#include "core/gltf/source/json_text.h"

namespace stretch::gltf {

namespace {

constexpr std::size_t alignment = 4; // of everything that a view begins with

template <typename Number>
constexpr int componentType() {
  if constexpr (std::is_same_v<Number, float>) {
    return TINYGLTF_COMPONENT_TYPE_FLOAT;
  } else if constexpr (sizeof(Number) == 1) {
    return std::is_signed_v<Number> ? TINYGLTF_COMPONENT_TYPE_BYTE : TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
  } else if constexpr (sizeof(Number) == 2) {
    return std::is_signed_v<Number> ? TINYGLTF_COMPONENT_TYPE_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
  } else {
    static_assert(std::is_same_v<Number, std::uint32_t>, "glTF knows no such number");
    return TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  }
}

int typeOf(std::size_t width) {
  switch (width) {
  case 1:
    return TINYGLTF_TYPE_SCALAR;
  case 2:
    return TINYGLTF_TYPE_VEC2;
  case 3:
    return TINYGLTF_TYPE_VEC3;
  case 4:
    return TINYGLTF_TYPE_VEC4;
  default:
    check(width == 16, "elements have 1 to 4 numbers, or 16");
    return TINYGLTF_TYPE_MAT4;
  }
}

/// tinygltf counts in int.
int narrow(std::size_t index) {
  check(index <= static_cast<std::size_t>(std::numeric_limits<int>::max()), "an index of glTF fits an int");
  return static_cast<int>(index);
}

int orNone(const std::optional<std::size_t>& index) {
  return index ? narrow(*index) : -1;
}

tinygltf::Value objectOf(const char* key, tinygltf::Value value) {
  tinygltf::Value::Object object;
  object.emplace(key, std::move(value));
  return tinygltf::Value(std::move(object));
}

template <typename Part>
std::size_t add(std::vector<Part>& parts, Part part) {
  parts.push_back(std::move(part));
  return parts.size() - 1;
}

void addOnce(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) {
    names.push_back(name);
  }
}

template <typename Number>
void setBounds(tinygltf::Accessor& accessor, const std::vector<Number>& values, std::size_t width,
               std::size_t stored) {
  for (std::size_t i = 0; i < std::min(width, values.size()); ++i) {
    Number low = values[i];
    Number high = values[i];
    for (std::size_t at = i; at < values.size(); at += stored) {
      low = std::min(low, values[at]);
      high = std::max(high, values[at]);
    }
    accessor.minValues.push_back(static_cast<double>(low));
    accessor.maxValues.push_back(static_cast<double>(high));
  }
}

} // namespace

NewFile::NewFile(const NewFileLabels& labels) : model_(std::make_unique<tinygltf::Model>()) {
  model_->asset.generator = labels.generator;
  model_->asset.copyright = labels.copyright;
  model_->scenes.emplace_back();
  model_->scenes.front().name = labels.scene;
  model_->defaultScene = 0;
}

NewFile::~NewFile() = default;

std::size_t NewFile::addView(const void* data, std::size_t size, ViewTarget target, std::size_t stride) {
  bytes_.resize((bytes_.size() + alignment - 1) / alignment * alignment);
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes_.size();
  view.byteLength = size;
  view.byteStride = stride;
  view.target = static_cast<int>(target);
  bytes_.resize(view.byteOffset + size);
  if (size > 0) {
    std::memcpy(bytes_.data() + view.byteOffset, data, size);
  }
  return add(model_->bufferViews, std::move(view));
}

std::size_t NewFile::addView(std::span<const std::uint8_t> bytes) {
  return addView(bytes.data(), bytes.size(), ViewTarget::none, 0);
}

template <typename Number>
std::size_t NewFile::addAccessor(const std::vector<Number>& values, const AccessorForm& form) {
  const std::size_t stored = std::max(form.width, form.stored);
  tinygltf::Accessor accessor;
  accessor.bufferView = narrow(addView(values.data(), values.size() * sizeof(Number), form.target,
                                       stored > form.width ? stored * sizeof(Number) : 0));
  accessor.componentType = componentType<Number>();
  accessor.type = typeOf(form.width);
  accessor.count = values.size() / stored;
  accessor.normalized = form.normalised;
  if (form.bounds) {
    setBounds(accessor, values, form.width, stored);
  }
  return add(model_->accessors, std::move(accessor));
}

template std::size_t NewFile::addAccessor(const std::vector<float>&, const AccessorForm&);
template std::size_t NewFile::addAccessor(const std::vector<std::int8_t>&, const AccessorForm&);
template std::size_t NewFile::addAccessor(const std::vector<std::uint8_t>&, const AccessorForm&);
template std::size_t NewFile::addAccessor(const std::vector<std::int16_t>&, const AccessorForm&);
template std::size_t NewFile::addAccessor(const std::vector<std::uint16_t>&, const AccessorForm&);
template std::size_t NewFile::addAccessor(const std::vector<std::uint32_t>&, const AccessorForm&);

std::size_t NewFile::addTexture(std::span<const std::uint8_t> image, const std::string& name) {
  tinygltf::Image added;
  added.name = asUtf8(name);
  added.mimeType = mediaTypeOf(image).value_or("image/png");
  added.bufferView = narrow(addView(image));
  const bool isWebp = added.mimeType == "image/webp";
  const int source = narrow(add(model_->images, std::move(added)));
  tinygltf::Texture texture;
  if (isWebp) {
    const char* const extension = "EXT_texture_webp";
    texture.extensions[extension] = objectOf("source", tinygltf::Value(source));
    addOnce(model_->extensionsUsed, extension);
  } else {
    texture.source = source;
  }
  return add(model_->textures, std::move(texture));
}

std::size_t NewFile::addMaterial(const NewMaterial& material) {
  tinygltf::Material added;
  added.name = asUtf8(material.name);
  tinygltf::PbrMetallicRoughness& surface = added.pbrMetallicRoughness;
  const Vec4& color = material.baseColor;
  surface.baseColorFactor = {color.x, color.y, color.z, color.w};
  surface.baseColorTexture.index = orNone(material.baseColorTexture);
  surface.metallicFactor = material.metallic;
  surface.roughnessFactor = material.roughness;
  added.normalTexture.index = orNone(material.normalTexture);
  added.emissiveFactor = {material.emissive.x, material.emissive.y, material.emissive.z};
  added.emissiveTexture.index = orNone(material.emissiveTexture);
  added.alphaMode = material.isBlended ? "BLEND" : "OPAQUE";
  added.doubleSided = material.isDoubleSided;
  return add(model_->materials, std::move(added));
}

void NewFile::takeMaterials(const Source& materials) {
  // tinygltf drops properties that it does not know: these lists come into the file as they are.
  Json& taken = taken_;
  for (const char* const list : {"materials", "textures", "samplers", "images"}) {
    if (const Json* found = find(materials.json, list)) {
      taken[list] = *found;
    }
  }
  for (std::size_t i = 0; i < sizeOf(taken, "images"); ++i) {
    Json& image = taken["images"][i];
    const Json& view = element(materials.json, "bufferViews", wholeOr(image, "bufferView", 0));
    const std::span<const std::uint8_t> bytes(materials.buffers.front());
    image["bufferView"] =
        addView(bytes.subspan(wholeOr(view, "byteOffset", 0), wholeOr(view, "byteLength", 0)));
  }
  for (const auto& [list, names] : {std::pair("extensionsUsed", &model_->extensionsUsed),
                                    std::pair("extensionsRequired", &model_->extensionsRequired)}) {
    for (std::size_t i = 0; i < sizeOf(materials.json, list); ++i) {
      addOnce(*names, element(materials.json, list, i).get<std::string>());
    }
  }
}

std::size_t NewFile::addMesh(const std::string& name) {
  tinygltf::Mesh mesh;
  mesh.name = asUtf8(name);
  return add(model_->meshes, std::move(mesh));
}

void NewFile::addPrimitive(std::size_t mesh, const NewPrimitive& primitive) {
  tinygltf::Primitive added;
  for (const auto& [name, accessor] : primitive.attributes) {
    added.attributes[name] = narrow(accessor);
  }
  added.indices = narrow(primitive.indices);
  added.material = orNone(primitive.material);
  added.mode = TINYGLTF_MODE_TRIANGLES;
  model_->meshes.at(mesh).primitives.push_back(std::move(added));
}

std::size_t NewFile::addNode(const std::string& name, std::optional<std::size_t> parent) {
  tinygltf::Node node;
  node.name = asUtf8(name);
  const std::size_t index = add(model_->nodes, std::move(node));
  (parent ? model_->nodes.at(*parent).children : model_->scenes.front().nodes).push_back(narrow(index));
  return index;
}

void NewFile::setNode(std::size_t node, Channel channel, std::vector<double> values) {
  check(values.size() == (channel == Channel::rotation ? 4 : 3) && channel != Channel::weights,
        "a node is set by 3 numbers, or by 4 that turn it");
  tinygltf::Node& set = model_->nodes.at(node);
  std::vector<double>& place = channel == Channel::rotation ? set.rotation
                               : channel == Channel::scale  ? set.scale
                                                            : set.translation;
  place = std::move(values);
}

void NewFile::setMesh(std::size_t node, std::size_t mesh, std::optional<std::size_t> skin) {
  model_->nodes.at(node).mesh = narrow(mesh);
  model_->nodes.at(node).skin = orNone(skin);
}

std::size_t NewFile::addSkin(const std::string& name, std::size_t inverseBind, std::size_t skeleton,
                             const std::vector<std::size_t>& joints) {
  tinygltf::Skin skin;
  skin.name = asUtf8(name);
  skin.inverseBindMatrices = narrow(inverseBind);
  skin.skeleton = narrow(skeleton);
  std::ranges::transform(joints, std::back_inserter(skin.joints), narrow);
  return add(model_->skins, std::move(skin));
}

std::size_t NewFile::addClip(const std::string& name) {
  tinygltf::Animation clip;
  clip.name = asUtf8(name);
  return add(model_->animations, std::move(clip));
}

void NewFile::setRate(std::size_t clip, double framesPerSecond) {
  model_->animations.at(clip).extras =
      objectOf("stretch_engine", objectOf("frames_per_second", tinygltf::Value(framesPerSecond)));
}

std::size_t NewFile::addSampler(std::size_t clip, std::size_t times, std::size_t values,
                                Interpolation interpolation) {
  tinygltf::AnimationSampler sampler;
  sampler.input = narrow(times);
  sampler.output = narrow(values);
  sampler.interpolation = nameOf(interpolation);
  return add(model_->animations.at(clip).samplers, std::move(sampler));
}

void NewFile::addChannel(std::size_t clip, std::size_t sampler, std::size_t node, Channel channel) {
  tinygltf::AnimationChannel added;
  added.sampler = narrow(sampler);
  added.target_node = narrow(node);
  added.target_path = nameOf(channel);
  model_->animations.at(clip).channels.push_back(std::move(added));
}

void NewFile::requireExtension(const std::string& name) {
  addOnce(model_->extensionsUsed, name);
  addOnce(model_->extensionsRequired, name);
}

Source NewFile::finish() {
  std::erase_if(model_->animations, [](const tinygltf::Animation& clip) { return clip.channels.empty(); });
  if (model_->nodes.empty()) { // A library of materials has no scene.
    model_->scenes.clear();
    model_->defaultScene = -1;
  }
  std::ostringstream text;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(model_.get(), text, false, false);
  Source source;
  Json& json = source.json;
  json = parseAnyJson(text.view());
  for (const auto& [list, taken] : (*taken_).items()) {
    json[list] = taken;
  }
  if (json.contains("meshes")) {
    for (Json& mesh : json["meshes"]) {
      for (Json& primitive : mesh["primitives"]) {
        primitive.erase("mode"); // triangles, which is what glTF takes without a word
      }
    }
  }
  if (!bytes_.empty()) {
    // Written beside the JSON and not through the library's stream, which holds a buffer three times over.
    bytes_.resize((bytes_.size() + alignment - 1) / alignment * alignment);
    json["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
    source.buffers.push_back(std::exchange(bytes_, {}));
    source.hasBinaryChunk = true;
  }
  *model_ = {};
  return source;
}

} // namespace stretch::gltf

#include "core/gltf/import/primitive_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

bool allFinite(const std::vector<glm::vec3>& vectors) {
  return std::ranges::all_of(vectors, [](const glm::vec3& one) {
    return std::isfinite(one.x) && std::isfinite(one.y) && std::isfinite(one.z);
  });
}

// An accessor without bytes stands for zeros.
bool hasData(const Source& source, int accessor) {
  const Json& json = element(source.json, "accessors", static_cast<std::size_t>(accessor));
  const int view = indexOr(json, "bufferView");
  if (view < 0) {
    return find(json, "sparse") != nullptr;
  }
  const int buffer = indexOr(element(source.json, "bufferViews", static_cast<std::size_t>(view)), "buffer");
  return !source.buffers[static_cast<std::size_t>(buffer)].empty();
}

bool isInteger(const AccessorShape& shape) {
  return shape.component != ComponentType::float32;
}

bool isByteOrShort(const AccessorShape& shape) {
  return isInteger(shape) && shape.component != ComponentType::uint32;
}

bool isUnsignedByteOrShort(const AccessorShape& shape) {
  return shape.component == ComponentType::uint8 || shape.component == ComponentType::uint16;
}

bool repeatsJoint(const VertexInfluences& vertex) {
  for (std::size_t i = 1; i < vertex.joints.size(); ++i) {
    for (std::size_t k = 0; k < i && vertex.weights[i] > 0.0F; ++k) {
      if (vertex.weights[k] > 0.0F && vertex.joints[i] == vertex.joints[k]) {
        return true;
      }
    }
  }
  return false;
}

std::size_t largestIndexOf(ComponentType type) {
  switch (type) {
  case ComponentType::uint8:
    return std::numeric_limits<std::uint8_t>::max();
  case ComponentType::uint16:
    return std::numeric_limits<std::uint16_t>::max();
  default:
    return std::numeric_limits<std::uint32_t>::max();
  }
}

} // namespace

PrimitiveParts::PrimitiveParts(const Source& source, const Json& json, std::string where,
                               DecodeBudget& budget, Problems& problems)
    : source_(source), json_(json), where_(std::move(where)), budget_(budget), problems_(problems) {}

void PrimitiveParts::fail(std::string_view place, std::string what) {
  problems_.error(fmt::format("{}.{}", where_, place), std::move(what));
  failed_ = true;
}

// glTF 2.0 specification 3.7.2.1 and KHR_mesh_quantization.
bool PrimitiveParts::isAllowedComponent(std::string_view name, const AccessorShape& shape) const {
  const bool isQuantized =
      listsText(source_.json, "extensionsUsed", "KHR_mesh_quantization") && isByteOrShort(shape);
  if (name.starts_with("JOINTS")) {
    return isUnsignedByteOrShort(shape);
  }
  if (name.starts_with("WEIGHTS") || name.starts_with("COLOR")) {
    return !isInteger(shape) || (isUnsignedByteOrShort(shape) && shape.isNormalized);
  }
  if (name.starts_with("TEXCOORD")) {
    return !isInteger(shape) || (isUnsignedByteOrShort(shape) && shape.isNormalized) || isQuantized;
  }
  return !isInteger(shape) || isQuantized;
}

std::optional<PrimitiveParts::Attribute> PrimitiveParts::attribute(const Json& attributes,
                                                                   std::string_view name,
                                                                   std::string_view types,
                                                                   std::string_view place) {
  const int accessor = indexOr(attributes, name);
  if (accessor < 0) {
    return std::nullopt;
  }
  const std::optional<AccessorShape> shape = shapeOf(source_, accessor);
  const std::string where = fmt::format("{}.{}", place, name);
  if (!shape || types.find(shape->type) == std::string_view::npos || !isAllowedComponent(name, *shape)) {
    fail(where, fmt::format("its accessor has a type that {} cannot have", name));
    return std::nullopt;
  }
  if (vertexCount_ != 0 && shape->count != vertexCount_) {
    fail(where, fmt::format("has {} elements, but there are {} vertices", shape->count, vertexCount_));
    return std::nullopt;
  }
  if (!budget_.take(shape->count * static_cast<std::size_t>(shape->width))) {
    fail(where, "the meshes decode to more data than the program takes into memory");
    return std::nullopt;
  }
  return Attribute{accessor, *shape};
}

std::vector<glm::vec3> PrimitiveParts::vectors(const Attribute& attribute) const {
  const std::vector<float> numbers = readFloats(source_, attribute.accessor);
  std::vector<glm::vec3> vectors(attribute.shape.count);
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    vectors[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  }
  return vectors;
}

void PrimitiveParts::readVertices(int texCoordSet, int emissiveSet, Primitive& made) {
  const Json& attributes = *find(json_, "attributes");
  const std::optional<Attribute> position = attribute(attributes, "POSITION", "VEC3", "attributes");
  if (!position) {
    return;
  }
  vertexCount_ = position->shape.count;
  made.positions = vectors(*position);
  if (!allFinite(made.positions)) {
    fail("attributes.POSITION", "holds values that are no finite numbers");
  }
  if (numbersOf(element(source_.json, "accessors", static_cast<std::size_t>(position->accessor)), "min")
          .empty()) {
    problems_.violation(where_ + ".attributes.POSITION", "its accessor has no min and max");
  }
  const std::optional<Attribute> normal = attribute(attributes, "NORMAL", "VEC3", "attributes");
  if (normal && hasData(source_, normal->accessor)) {
    made.normals = vectors(*normal);
  }
  made.texCoords = readTexCoords(texCoordSet);
  if (emissiveSet != texCoordSet) {
    made.emissiveTexCoords = readTexCoords(emissiveSet);
  }
  readColors(made);
  checkOtherAttributes();
}

std::vector<glm::vec2> PrimitiveParts::readTexCoords(int set) {
  const std::string name = fmt::format("TEXCOORD_{}", set);
  const std::optional<Attribute> texCoord = attribute(*find(json_, "attributes"), name, "VEC2", "attributes");
  std::vector<glm::vec2> texCoords;
  if (!texCoord) {
    return texCoords;
  }
  const std::vector<float> numbers = readFloats(source_, texCoord->accessor);
  texCoords.reserve(vertexCount_);
  for (std::size_t i = 0; i < vertexCount_; ++i) {
    texCoords.emplace_back(numbers[2 * i], numbers[2 * i + 1]);
  }
  return texCoords;
}

void PrimitiveParts::readColors(Primitive& made) {
  const std::optional<Attribute> color =
      attribute(*find(json_, "attributes"), "COLOR_0", "VEC3 VEC4", "attributes");
  if (!color) {
    return;
  }
  const std::vector<float> numbers = readFloats(source_, color->accessor);
  const auto width = static_cast<std::size_t>(color->shape.width);
  bool isClamped = false;
  for (std::size_t i = 0; i < vertexCount_; ++i) {
    const float* one = numbers.data() + i * width;
    const glm::vec4 value(one[0], one[1], one[2], width == 4 ? one[3] : 1.0F);
    made.colors.push_back(glm::clamp(value, 0.0F, 1.0F));
    isClamped = isClamped || made.colors.back() != value;
  }
  if (isClamped) {
    problems_.violation(where_ + ".attributes.COLOR_0", "holds colours beyond 0 to 1", "they are clamped");
  }
}

// What the import does not read: kept in the file, and named where it breaks the rules.
void PrimitiveParts::checkOtherAttributes() {
  constexpr std::array<std::string_view, 7> standardNames{"POSITION", "NORMAL",  "TANGENT", "TEXCOORD_",
                                                          "COLOR_",   "JOINTS_", "WEIGHTS_"};
  for (const auto& attribute : find(json_, "attributes")->items()) {
    const std::string& name = attribute.key();
    const std::string place = fmt::format("{}.attributes.{}", where_, name.substr(0, 100));
    const std::optional<AccessorShape> shape =
        shapeOf(source_, static_cast<int>(*wholeNumber(attribute.value())));
    const bool isStandard = std::ranges::any_of(
        standardNames, [&](std::string_view standard) { return name.starts_with(standard); });
    if (!isStandard && !name.starts_with('_')) {
      problems_.violation(place, "is not an attribute that glTF knows");
    } else if (!shape || shape->component == ComponentType::uint32 || shape->count != vertexCount_) {
      problems_.violation(place,
                          "its accessor has a type or number of elements that an attribute cannot have");
    }
  }
}

void PrimitiveParts::addInfluenceSet(int set, std::size_t jointCount, Primitive& made) {
  const Json& attributes = *find(json_, "attributes");
  const std::string jointsName = fmt::format("JOINTS_{}", set);
  const std::optional<Attribute> joints = attribute(attributes, jointsName, "VEC4", "attributes");
  const std::optional<Attribute> weights =
      attribute(attributes, fmt::format("WEIGHTS_{}", set), "VEC4", "attributes");
  if (!joints || !weights) {
    return;
  }
  made.influences.resize(vertexCount_);
  const std::vector<std::uint32_t> indices = readIntegers(source_, joints->accessor);
  const std::vector<float> numbers = readFloats(source_, weights->accessor);
  bool isTolerated = false;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::size_t slot = static_cast<std::size_t>(set) * 4 + i % 4;
    VertexInfluences& influence = made.influences[i / 4];
    const float weight = std::isfinite(numbers[i]) ? std::max(numbers[i], 0.0F) : 0.0F;
    const auto vertex = static_cast<std::uint32_t>(i / 4);
    if (!std::isfinite(numbers[i]) && (unweighted_.empty() || unweighted_.back() != vertex)) {
      unweighted_.push_back(vertex);
    }
    const bool isThere = indices[i] < jointCount;
    if (!isThere && weight > 0.0F) {
      fail("attributes." + jointsName,
           fmt::format("vertex {} follows joint {}, but the skin has {}", i / 4, indices[i], jointCount));
      return;
    }
    isTolerated = isTolerated || !isThere;
    influence.joints[slot] = isThere ? static_cast<std::uint16_t>(indices[i]) : std::uint16_t{0};
    influence.weights[slot] = weight;
  }
  if (isTolerated) {
    problems_.warning(where_ + ".attributes." + jointsName,
                      "holds joints that the skin does not have, with weight 0");
  }
}

void PrimitiveParts::readInfluences(std::optional<std::size_t> jointCount, Primitive& made) {
  const Json& attributes = *find(json_, "attributes");
  if (failed_ || find(attributes, "JOINTS_0") == nullptr) {
    return;
  }
  if (!jointCount) {
    problems_.warning(where_, "has joints and weights, but no node gives it a skin");
    return;
  }
  addInfluenceSet(0, *jointCount, made);
  if (!failed_) {
    addInfluenceSet(1, *jointCount, made);
  }
  if (find(attributes, "JOINTS_2") != nullptr) {
    problems_.warning(where_, "has vertices that follow more than 8 joints; the others are left out");
  }
  if (failed_) {
    return;
  }
  if (normalizeWeights(made.influences)) {
    problems_.warning(where_ + ".attributes.WEIGHTS_0", "weights do not sum to 1; they are normalised");
  }
  if (std::ranges::any_of(made.influences, repeatsJoint)) {
    problems_.warning(where_ + ".attributes.JOINTS_0", "a vertex names the same joint twice");
  }
}

std::vector<std::uint32_t> PrimitiveParts::readIndices() {
  const int accessor = indexOr(json_, "indices");
  const std::optional<AccessorShape> shape = shapeOf(source_, accessor);
  const bool isIndexType = shape && shape->type == "SCALAR" && !shape->isNormalized &&
                           (isUnsignedByteOrShort(*shape) || shape->component == ComponentType::uint32);
  if (!isIndexType) {
    fail("indices", "its accessor holds no unsigned integers");
    return {};
  }
  if (!budget_.take(shape->count * 3)) {
    fail("indices", "the meshes decode to more data than the program takes into memory");
    return {};
  }
  std::vector<std::uint32_t> corners = readIntegers(source_, accessor);
  const std::uint32_t largest = *std::max_element(corners.begin(), corners.end());
  if (largest >= vertexCount_) {
    fail("indices", fmt::format("refers to vertex {}, but there are {}", largest, vertexCount_));
  } else if (largest == largestIndexOf(shape->component)) {
    fail("indices", fmt::format("holds {}, which restarts primitives and is no index", largest));
  }
  return corners;
}

void PrimitiveParts::readTriangles(Primitive& made) {
  if (failed_) {
    return;
  }
  std::vector<std::uint32_t> corners;
  if (find(json_, "indices") != nullptr) {
    corners = readIndices();
  } else {
    corners.resize(vertexCount_);
    std::iota(corners.begin(), corners.end(), 0U);
  }
  if (!failed_) {
    made.indices = unrolledTriangles(corners, indexOr(json_, "mode", 4));
  }
}

MorphTarget PrimitiveParts::readMorphTarget(const Json& json, const std::string& place) {
  MorphTarget target;
  if (const std::optional<Attribute> position = attribute(json, "POSITION", "VEC3", place)) {
    target.positions = vectors(*position);
    if (!allFinite(target.positions)) {
      fail(place, "holds values that are no finite numbers");
    }
  }
  if (const std::optional<Attribute> normal = attribute(json, "NORMAL", "VEC3", place)) {
    target.normals = vectors(*normal);
  }
  for (const auto& [name, accessor] : json.items()) {
    if (find(*find(json_, "attributes"), name) == nullptr) {
      problems_.violation(fmt::format("{}.{}.{}", where_, place, name),
                          "moves an attribute that the primitive does not have");
    }
  }
  return target;
}

void PrimitiveParts::readMorphTargets(Primitive& made) {
  for (std::size_t i = 0; i < sizeOf(json_, "targets") && !failed_; ++i) {
    made.morphTargets.push_back(readMorphTarget(element(json_, "targets", i), at("targets", i)));
  }
}

} // namespace stretch::gltf

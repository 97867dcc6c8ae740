#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "core/gltf/import/accessor_layout.h"
#include "core/gltf/import/import.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

void validateBufferView(const Source& source, std::size_t index, Problems& problems) {
  const Json& view = element(source.json, "bufferViews", index);
  const Json& buffer = element(source.json, "buffers", static_cast<std::size_t>(indexOr(view, "buffer")));
  const std::uint64_t end = wholeOr(view, "byteOffset", 0) + wholeOr(view, "byteLength", 0);
  if (end > wholeOr(buffer, "byteLength", 0)) {
    problems.error(at("bufferViews", index), "reaches past the end of its buffer");
  }
  constexpr int indexTarget = 34963;
  if (wholeOr(view, "byteStride", 4) % 4 != 0) {
    problems.error(at("bufferViews", index) + ".byteStride", "is not a multiple of 4");
  } else if (find(view, "byteStride") != nullptr && indexOr(view, "target") == indexTarget) {
    problems.violation(at("bufferViews", index) + ".byteStride", "is not allowed for indices");
  }
}

// One accessor; answers its shape where its values can be compared with what it says of them.
class AccessorCheck {
public:
  AccessorCheck(const Source& source, std::size_t index, bool isUsed, Problems& problems)
      : source_(source), json_(element(source.json, "accessors", index)), index_(index), problems_(problems),
        isUsed_(isUsed) {}

  std::optional<AccessorShape> run() {
    std::optional<AccessorShape> shape = shapeOf(source_, static_cast<int>(index_));
    if (!shape) {
      problems_.warning(where(), "has an unknown type or component type and is not used");
      return std::nullopt;
    }
    if (find(json_, "bufferView") != nullptr) {
      part(json_, where(), *shape, shape->count, true);
    }
    if ((find(json_, "bufferView") == nullptr || !isReadable_) && shape->count > mostZeroElements) {
      problems_.error(where(), fmt::format("has {} elements, but no data", shape->count));
    }
    if (const Json* sparse = find(json_, "sparse")) {
      sparsePart(*sparse, *shape);
    }
    return !hasErrors_ && isReadable_ && hasData() ? std::move(shape) : std::nullopt;
  }

private:
  [[nodiscard]] std::string where() const { return at("accessors", index_); }

  [[nodiscard]] bool hasData() const {
    return find(json_, "bufferView") != nullptr || find(json_, "sparse") != nullptr;
  }

  void error(std::string place, std::string what, std::string remedy = {}) {
    problems_.error(std::move(place), std::move(what), std::move(remedy));
    hasErrors_ = true;
  }

  // Bytes that no file gives are zeros (glTF leaves them to extensions); bytes of a file that is missing are
  // an error where the model uses them.
  void needBytes(const Json& view) {
    const auto buffer = static_cast<std::size_t>(indexOr(view, "buffer"));
    const Json* uri = find(element(source_.json, "buffers", buffer), "uri");
    if (!source_.buffers[buffer].empty()) {
      return;
    }
    isReadable_ = false;
    if (uri != nullptr && isUsed_) {
      const auto name = uri->get_ref<const std::string&>().substr(0, 200);
      error(at("buffers", buffer),
            fmt::format("its data ('{}') cannot be read, but the model needs it", name),
            "put the file beside it");
    }
  }

  void part(const Json& json, const std::string& place, const AccessorShape& shape, std::size_t count,
            bool mayBeStrided) {
    const Json& view =
        element(source_.json, "bufferViews", static_cast<std::size_t>(indexOr(json, "bufferView")));
    const std::size_t size = elementSize(shape);
    const std::uint64_t stride = mayBeStrided ? wholeOr(view, "byteStride", size) : size;
    const std::uint64_t start = wholeOr(json, "byteOffset", 0);
    const std::uint64_t end = start + stride * (count - 1) + lastElementSize(shape); // count is below 2^32,
                                                                                     // stride below 2^8: no
                                                                                     // overflow
    if (stride < size) {
      error(place, "has elements longer than their stride");
    } else if (end > wholeOr(view, "byteLength", 0)) {
      error(place, "reads past the end of its buffer view");
    } else if ((start + wholeOr(view, "byteOffset", 0)) % componentSize(shape.component) != 0) {
      problems_.violation(place, "is not aligned to the size of its components");
    }
    needBytes(view);
  }

  void sparsePart(const Json& sparse, const AccessorShape& shape) {
    const Json& indices = *find(sparse, "indices");
    const auto count = static_cast<std::size_t>(wholeOr(sparse, "count", 0));
    AccessorShape indexShape;
    indexShape.type = "SCALAR";
    indexShape.component = static_cast<ComponentType>(indexOr(indices, "componentType"));
    const bool isUnsigned = indexShape.component == ComponentType::uint8 ||
                            indexShape.component == ComponentType::uint16 ||
                            indexShape.component == ComponentType::uint32;
    if (!isUnsigned || count > shape.count) {
      error(where() + ".sparse", isUnsigned ? "replaces more elements than there are"
                                            : "has indices that are no unsigned integers");
      return;
    }
    part(indices, where() + ".sparse.indices", indexShape, count, false);
    part(*find(sparse, "values"), where() + ".sparse.values", shape, count, false);
    if (!hasErrors_ && isReadable_) {
      sparseOrder(shape);
    }
  }

  void sparseOrder(const AccessorShape& shape) {
    const std::vector<std::uint32_t> targets =
        sparseTargets(*sparseRuns(source_, static_cast<int>(index_), shape));
    const bool isIncreasing =
        std::adjacent_find(targets.begin(), targets.end(), std::greater_equal<>()) == targets.end();
    if (!isIncreasing || targets.back() >= shape.count) {
      error(where() + ".sparse.indices", "are not increasing or point past the last element");
    }
  }

  const Source& source_;
  const Json& json_;
  std::size_t index_;
  Problems& problems_;
  bool isUsed_;
  bool hasErrors_ = false;
  bool isReadable_ = true;
};

void addAttributes(const Json& map, std::set<int>& attributes) {
  for (const auto& [name, accessor] : map.items()) {
    attributes.insert(static_cast<int>(*wholeNumber(accessor)));
  }
}

std::set<int> vertexAttributes(const Json& json) {
  std::set<int> attributes;
  for (std::size_t i = 0; i < sizeOf(json, "meshes"); ++i) {
    const Json& mesh = element(json, "meshes", i);
    for (std::size_t k = 0; k < sizeOf(mesh, "primitives"); ++k) {
      const Json& primitive = element(mesh, "primitives", k);
      addAttributes(*find(primitive, "attributes"), attributes);
      for (std::size_t t = 0; t < sizeOf(primitive, "targets"); ++t) {
        addAttributes(element(primitive, "targets", t), attributes);
      }
    }
  }
  return attributes;
}

void markIndex(const Json& object, std::string_view key, std::vector<bool>& used) {
  if (const int accessor = indexOr(object, key); accessor >= 0) {
    used[static_cast<std::size_t>(accessor)] = true;
  }
}

// glTF 2.0 specification 3.6.2.1: a view that several attributes share says how far apart their elements are.
void validateSharedViews(const Json& json, Problems& problems) {
  std::map<int, int> users;
  for (const int accessor : vertexAttributes(json)) {
    const int view = indexOr(element(json, "accessors", static_cast<std::size_t>(accessor)), "bufferView");
    const bool isUnsaid = view >= 0 && find(element(json, "bufferViews", static_cast<std::size_t>(view)),
                                            "byteStride") == nullptr;
    if (isUnsaid && ++users[view] == 2) {
      problems.violation(at("bufferViews", static_cast<std::size_t>(view)),
                         "holds several vertex attributes, but has no byteStride");
    }
  }
}

struct Bounds {
  std::vector<float> least;
  std::vector<float> most;
};

// Of each component; nothing where a value is no finite number. Component by component: opening a file asks
// this for all that it holds.
std::optional<Bounds> boundsOf(const std::vector<float>& values, std::size_t width) {
  Bounds bounds;
  for (std::size_t i = 0; i < width; ++i) {
    float least = values[i];
    float most = values[i];
    bool areFinite = true;
    for (std::size_t k = i; k < values.size(); k += width) {
      areFinite = areFinite && std::isfinite(values[k]);
      least = std::min(least, values[k]);
      most = std::max(most, values[k]);
    }
    if (!areFinite) {
      return std::nullopt;
    }
    bounds.least.push_back(least);
    bounds.most.push_back(most);
  }
  return bounds;
}

// Exporters round what they write as text: a ten thousandth of the extent is no mistake.
bool agrees(const std::vector<double>& said, const std::vector<float>& found, const Bounds& bounds) {
  if (said.size() != found.size()) {
    return said.empty();
  }
  for (std::size_t i = 0; i < said.size(); ++i) {
    const double size = std::max(std::abs(static_cast<double>(bounds.least[i])),
                                 std::abs(static_cast<double>(bounds.most[i])));
    if (std::abs(said[i] - static_cast<double>(found[i])) > 1e-4 * size + 1e-6) {
      return false;
    }
  }
  return true;
}

// What an accessor is used for changes what its values may be.
struct AccessorUse {
  bool isRounded = false; // by compression: min and max are those of before
  bool holdsWeights = false;
};

// `values`: of that accessor.
void validateValues(const Source& source, std::size_t index, const std::vector<float>& values,
                    const AccessorShape& shape, const AccessorUse& use, Problems& problems) {
  const Json& json = element(source.json, "accessors", index);
  const std::optional<Bounds> bounds = boundsOf(values, static_cast<std::size_t>(shape.width));
  if (!bounds) {
    if (use.holdsWeights) {
      return;
    }
    problems.violation(at("accessors", index), "holds values that are no finite numbers");
    return;
  }
  // What min and max mean for normalised integers is read both ways in the wild.
  const bool isComparable = !shape.isNormalized && !use.isRounded;
  if (isComparable && (!agrees(numbersOf(json, "min"), bounds->least, *bounds) ||
                       !agrees(numbersOf(json, "max"), bounds->most, *bounds))) {
    problems.violation(at("accessors", index), "has a min or max that its values do not have");
  }
}

} // namespace

std::set<int> weightAccessors(const Json& json) {
  std::set<int> accessors;
  for (std::size_t i = 0; i < sizeOf(json, "meshes"); ++i) {
    const Json& mesh = element(json, "meshes", i);
    for (std::size_t k = 0; k < sizeOf(mesh, "primitives"); ++k) {
      const Json* const attributes = find(element(mesh, "primitives", k), "attributes");
      for (int set = 0; attributes != nullptr && set < 2; ++set) {
        accessors.insert(indexOr(*attributes, fmt::format("WEIGHTS_{}", set)));
      }
    }
  }
  accessors.erase(-1);
  return accessors;
}

std::vector<bool> usedAccessors(const Json& json) {
  std::vector<bool> used(sizeOf(json, "accessors"), false);
  for (const int accessor : vertexAttributes(json)) {
    used[static_cast<std::size_t>(accessor)] = true;
  }
  for (std::size_t i = 0; i < sizeOf(json, "meshes"); ++i) {
    const Json& mesh = element(json, "meshes", i);
    for (std::size_t k = 0; k < sizeOf(mesh, "primitives"); ++k) {
      markIndex(element(mesh, "primitives", k), "indices", used);
    }
  }
  for (std::size_t i = 0; i < sizeOf(json, "skins"); ++i) {
    markIndex(element(json, "skins", i), "inverseBindMatrices", used);
  }
  for (std::size_t i = 0; i < sizeOf(json, "animations"); ++i) {
    const Json& animation = element(json, "animations", i);
    for (std::size_t k = 0; k < sizeOf(animation, "samplers"); ++k) {
      markIndex(element(animation, "samplers", k), "input", used);
      markIndex(element(animation, "samplers", k), "output", used);
    }
  }
  return used;
}

void validateAccessors(const Source& source, const std::set<std::size_t>& rounded, Problems& problems) {
  for (std::size_t i = 0; i < sizeOf(source.json, "bufferViews"); ++i) {
    validateBufferView(source, i, problems);
  }
  if (problems.hasErrors()) {
    return;
  }
  validateSharedViews(source.json, problems);
  const std::vector<bool> used = usedAccessors(source.json);
  // Weights that are no numbers are told where the mesh is read, which can do without.
  const std::set<int> weights = weightAccessors(source.json);
  DecodeBudget compared(source);
  std::vector<float> values; // of one accessor after the other, in the same memory
  for (std::size_t i = 0; i < sizeOf(source.json, "accessors"); ++i) {
    const std::optional<AccessorShape> shape = AccessorCheck(source, i, used[i], problems).run();
    if (shape && compared.take(shape->count * static_cast<std::size_t>(shape->width))) {
      readFloats(source, static_cast<int>(i), values);
      validateValues(source, i, values, *shape, {rounded.contains(i), weights.contains(static_cast<int>(i))},
                     problems);
    }
  }
}

} // namespace stretch::gltf

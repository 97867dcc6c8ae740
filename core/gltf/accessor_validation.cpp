#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/gltf/accessor_layout.h"
#include "core/gltf/fields.h"

namespace stretch::gltf {

namespace {

// Values looked at to compare them with what the accessors say of them; broken files can name the same bytes
// many times.
constexpr std::size_t mostValuesCompared = std::size_t{1} << 28U;

void validateBufferView(const Source& source, std::size_t index, Problems& problems) {
  const Json& view = element(source.json, "bufferViews", index);
  const Json& buffer = element(source.json, "buffers", static_cast<std::size_t>(indexOr(view, "buffer")));
  const std::uint64_t end = wholeOr(view, "byteOffset", 0) + wholeOr(view, "byteLength", 0);
  if (end > wholeOr(buffer, "byteLength", 0)) {
    problems.error(at("bufferViews", index), "reaches past the end of its buffer");
  }
  if (wholeOr(view, "byteStride", 4) % 4 != 0) {
    problems.error(at("bufferViews", index) + ".byteStride", "is no multiple of 4");
  }
}

// One accessor; answers whether it can be read.
class AccessorCheck {
public:
  AccessorCheck(const Source& source, std::size_t index, Problems& problems)
      : source_(source), json_(element(source.json, "accessors", index)), index_(index), problems_(problems) {
  }

  bool run() {
    const std::optional<AccessorShape> shape = shapeOf(source_, static_cast<int>(index_));
    if (!shape) {
      problems_.warning(where(), "has an unknown type or component type and is not used");
      return false;
    }
    if (find(json_, "bufferView") != nullptr) {
      part(json_, where(), *shape, shape->count, true);
    } else if (shape->count > mostZeroElements) {
      problems_.error(where(), fmt::format("has {} elements, but no data", shape->count));
    }
    if (const Json* sparse = find(json_, "sparse")) {
      sparsePart(*sparse, *shape);
    }
    return !hasErrors_;
  }

private:
  [[nodiscard]] std::string where() const { return at("accessors", index_); }

  void error(std::string place, std::string what) {
    problems_.error(std::move(place), std::move(what));
    hasErrors_ = true;
  }

  bool bytesAreThere(const Json& view) {
    const int buffer = indexOr(view, "buffer");
    if (!source_.buffers[static_cast<std::size_t>(buffer)].empty()) {
      return true;
    }
    const Json& json = element(source_.json, "buffers", static_cast<std::size_t>(buffer));
    error(
        at("buffers", static_cast<std::size_t>(buffer)),
        fmt::format("its data ('{}') is missing, but the model needs it", textOr(json, "uri", "BIN chunk")));
    return false;
  }

  void part(const Json& json, const std::string& place, const AccessorShape& shape, std::size_t count,
            bool mayBeStrided) {
    const Json& view =
        element(source_.json, "bufferViews", static_cast<std::size_t>(indexOr(json, "bufferView")));
    if (!bytesAreThere(view)) {
      return;
    }
    const std::size_t size = elementSize(shape);
    const std::uint64_t stride = mayBeStrided ? wholeOr(view, "byteStride", size) : size;
    const std::uint64_t start = wholeOr(json, "byteOffset", 0);
    const std::uint64_t end =
        start + stride * (count - 1) + size; // count is below 2^32, stride below 2^8: no overflow
    if (stride < size) {
      error(place, "has elements longer than their stride");
    } else if (end > wholeOr(view, "byteLength", 0)) {
      error(place, "reads past the end of its buffer view");
    } else if ((start + wholeOr(view, "byteOffset", 0)) % componentSize(shape.component) != 0) {
      problems_.warning(place, "is not aligned to the size of its components");
    }
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
    if (!hasErrors_) {
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
  bool hasErrors_ = false;
};

struct Bounds {
  std::vector<float> least;
  std::vector<float> most;
};

Bounds boundsOf(const std::vector<float>& values, std::size_t width) {
  Bounds bounds{{values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width)},
                {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(width)}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    bounds.least[i % width] = std::min(bounds.least[i % width], values[i]);
    bounds.most[i % width] = std::max(bounds.most[i % width], values[i]);
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

void validateValues(const Source& source, std::size_t index, const AccessorShape& shape, Problems& problems) {
  const Json& json = element(source.json, "accessors", index);
  const std::vector<float> values = readFloats(source, static_cast<int>(index));
  if (!std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); })) {
    problems.warning(at("accessors", index), "holds values that are no finite numbers");
    return;
  }
  const Bounds bounds = boundsOf(values, static_cast<std::size_t>(shape.width));
  // What min and max mean for normalised integers is read both ways in the wild.
  const bool isComparable = !shape.isNormalized;
  if (isComparable && (!agrees(numbersOf(json, "min"), bounds.least, bounds) ||
                       !agrees(numbersOf(json, "max"), bounds.most, bounds))) {
    problems.warning(at("accessors", index), "has a min or max that its values do not have");
  }
}

} // namespace

void validateAccessors(const Source& source, Problems& problems) {
  for (std::size_t i = 0; i < sizeOf(source.json, "bufferViews"); ++i) {
    validateBufferView(source, i, problems);
  }
  if (problems.hasErrors()) {
    return;
  }
  std::size_t compared = 0;
  for (std::size_t i = 0; i < sizeOf(source.json, "accessors"); ++i) {
    if (!AccessorCheck(source, i, problems).run()) {
      continue;
    }
    const AccessorShape shape = *shapeOf(source, static_cast<int>(i));
    compared += shape.count * static_cast<std::size_t>(shape.width);
    if (compared <= mostValuesCompared) {
      validateValues(source, i, shape, problems);
    }
  }
}

} // namespace stretch::gltf

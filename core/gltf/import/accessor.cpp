#include "core/gltf/import/accessor.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>

#include "core/gltf/import/accessor_layout.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

template <typename T>
T valueAt(const std::uint8_t* bytes) {
  T value{};
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

float componentAsFloat(const std::uint8_t* bytes, ComponentType type, bool isNormalized) {
  switch (type) {
  case ComponentType::int8: {
    const auto value = static_cast<float>(valueAt<std::int8_t>(bytes));
    return isNormalized ? std::max(value / 127.0F, -1.0F) : value;
  }
  case ComponentType::uint8:
    return isNormalized ? static_cast<float>(*bytes) / 255.0F : static_cast<float>(*bytes);
  case ComponentType::int16: {
    const auto value = static_cast<float>(valueAt<std::int16_t>(bytes));
    return isNormalized ? std::max(value / 32767.0F, -1.0F) : value;
  }
  case ComponentType::uint16: {
    const auto value = static_cast<float>(valueAt<std::uint16_t>(bytes));
    return isNormalized ? value / 65535.0F : value;
  }
  case ComponentType::uint32:
    return static_cast<float>(valueAt<std::uint32_t>(bytes));
  case ComponentType::float32:
    return valueAt<float>(bytes);
  }
  return 0.0F;
}

std::uint32_t componentAsInteger(const std::uint8_t* bytes, ComponentType type) {
  switch (type) {
  case ComponentType::uint8:
    return *bytes;
  case ComponentType::uint16:
    return valueAt<std::uint16_t>(bytes);
  case ComponentType::uint32:
    return valueAt<std::uint32_t>(bytes);
  default:
    return 0;
  }
}

// Calls take(element, component, its bytes) for the elements of one run of data.
template <typename Take>
void forEachComponent(const ElementRun& run, const AccessorShape& shape, Take&& take) {
  const std::vector<std::size_t> offsets = componentOffsets(shape);
  for (std::size_t element = 0; element < run.count; ++element) {
    const std::uint8_t* bytes = run.first + element * run.stride;
    for (std::size_t component = 0; component < offsets.size(); ++component) {
      take(element, component, bytes + offsets[component]);
    }
  }
}

template <typename Number, typename Convert>
void readAll(const Source& source, int accessor, std::vector<Number>& values, Convert&& convert) {
  const std::optional<AccessorShape> shape = shapeOf(source, accessor);
  check(shape.has_value(), "only accessors of known shape are read");
  const auto width = static_cast<std::size_t>(shape->width);
  const std::size_t count = shape->count * width;
  const std::optional<ElementRun> run = denseRun(source, accessor, *shape);
  constexpr auto own = std::is_same_v<Number, float> ? ComponentType::float32 : ComponentType::uint32;
  const bool isPlain = run && shape->component == own && run->stride == width * sizeof(Number);
  if (isPlain) { // the numbers themselves
    values.resize(count);
    std::memcpy(values.data(), run->first, count * sizeof(Number));
  } else {
    values.assign(count, Number{});
  }
  if (run && !isPlain) {
    forEachComponent(*run, *shape,
                     [&](std::size_t element, std::size_t component, const std::uint8_t* bytes) {
                       values[element * width + component] = convert(bytes, *shape);
                     });
  }
  if (const std::optional<SparseRuns> sparse = sparseRuns(source, accessor, *shape)) {
    const std::vector<std::uint32_t> targets = sparseTargets(*sparse);
    forEachComponent(sparse->values, *shape,
                     [&](std::size_t element, std::size_t component, const std::uint8_t* bytes) {
                       values[targets[element] * width + component] = convert(bytes, *shape);
                     });
  }
}

} // namespace

std::vector<std::uint32_t> sparseTargets(const SparseRuns& sparse) {
  std::vector<std::uint32_t> targets(sparse.indices.count);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    targets[i] = componentAsInteger(sparse.indices.first + i * sparse.indices.stride, sparse.indexType);
  }
  return targets;
}

void readFloats(const Source& source, int accessor, std::vector<float>& values) {
  readAll(source, accessor, values, [](const std::uint8_t* bytes, const AccessorShape& shape) {
    return componentAsFloat(bytes, shape.component, shape.isNormalized);
  });
}

std::vector<float> readFloats(const Source& source, int accessor) {
  std::vector<float> values;
  readFloats(source, accessor, values);
  return values;
}

std::vector<std::uint32_t> readIntegers(const Source& source, int accessor) {
  std::vector<std::uint32_t> values;
  readAll(source, accessor, values, [](const std::uint8_t* bytes, const AccessorShape& shape) {
    return componentAsInteger(bytes, shape.component);
  });
  return values;
}

} // namespace stretch::gltf

#include "core/gltf/import/accessor_layout.h"

#include <algorithm>
#include <array>

#include "core/gltf/json/json.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

namespace {

struct ElementType {
  std::string_view name;
  int columns;
  int rows;
};

constexpr std::array<ElementType, 7> elementTypes{{{"SCALAR", 1, 1},
                                                   {"VEC2", 1, 2},
                                                   {"VEC3", 1, 3},
                                                   {"VEC4", 1, 4},
                                                   {"MAT2", 2, 2},
                                                   {"MAT3", 3, 3},
                                                   {"MAT4", 4, 4}}};

const ElementType* elementType(std::string_view name) {
  const auto* const found =
      std::ranges::find_if(elementTypes, [&](const ElementType& type) { return type.name == name; });
  return found == elementTypes.end() ? nullptr : found;
}

std::size_t columnStride(const ElementType& type, ComponentType component) {
  const std::size_t size = static_cast<std::size_t>(type.rows) * componentSize(component);
  return type.columns == 1 ? size : (size + 3) / 4 * 4;
}

bool hasBytes(const Source& source, const Json& view) {
  return !source.buffers[static_cast<std::size_t>(indexOr(view, "buffer"))].empty();
}

const std::uint8_t* startOf(const Source& source, const Json& view, const Json& within) {
  const Bytes& bytes = source.buffers[static_cast<std::size_t>(indexOr(view, "buffer"))];
  return bytes.data() + wholeOr(view, "byteOffset", 0) + wholeOr(within, "byteOffset", 0);
}

ElementRun packedRun(const Source& source, const Json& part, std::size_t count, std::size_t stride) {
  const Json& view =
      element(source.json, "bufferViews", static_cast<std::size_t>(indexOr(part, "bufferView")));
  return hasBytes(source, view) ? ElementRun{startOf(source, view, part), stride, count} : ElementRun{};
}

} // namespace

std::size_t componentSize(ComponentType type) {
  switch (type) {
  case ComponentType::int8:
  case ComponentType::uint8:
    return 1;
  case ComponentType::int16:
  case ComponentType::uint16:
    return 2;
  case ComponentType::uint32:
  case ComponentType::float32:
    return 4;
  }
  return 0;
}

std::optional<AccessorShape> shapeOf(const Source& source, int accessor) {
  const Json& json = element(source.json, "accessors", static_cast<std::size_t>(accessor));
  AccessorShape shape;
  shape.type = textOr(json, "type");
  shape.component = static_cast<ComponentType>(indexOr(json, "componentType"));
  const ElementType* type = elementType(shape.type);
  if (type == nullptr || componentSize(shape.component) == 0) {
    return std::nullopt;
  }
  shape.count = static_cast<std::size_t>(wholeOr(json, "count", 0));
  shape.width = type->columns * type->rows;
  shape.isNormalized = flagOr(json, "normalized", false);
  return shape;
}

std::vector<std::size_t> componentOffsets(const AccessorShape& shape) {
  const ElementType* type = elementType(shape.type);
  check(type != nullptr, "a shape has a known type");
  std::vector<std::size_t> offsets;
  for (int column = 0; column < type->columns; ++column) {
    for (int row = 0; row < type->rows; ++row) {
      offsets.push_back(static_cast<std::size_t>(column) * columnStride(*type, shape.component) +
                        static_cast<std::size_t>(row) * componentSize(shape.component));
    }
  }
  return offsets;
}

std::size_t elementSize(const AccessorShape& shape) {
  const ElementType* type = elementType(shape.type);
  check(type != nullptr, "a shape has a known type");
  return static_cast<std::size_t>(type->columns) * columnStride(*type, shape.component);
}

std::size_t lastElementSize(const AccessorShape& shape) {
  const ElementType* type = elementType(shape.type);
  check(type != nullptr, "a shape has a known type");
  const std::size_t column = static_cast<std::size_t>(type->rows) * componentSize(shape.component);
  return elementSize(shape) - columnStride(*type, shape.component) + column;
}

std::optional<ElementRun> denseRun(const Source& source, int accessor, const AccessorShape& shape) {
  const Json& json = element(source.json, "accessors", static_cast<std::size_t>(accessor));
  if (find(json, "bufferView") == nullptr) {
    return std::nullopt;
  }
  const Json& view =
      element(source.json, "bufferViews", static_cast<std::size_t>(indexOr(json, "bufferView")));
  if (!hasBytes(source, view)) {
    return std::nullopt;
  }
  const auto stride = static_cast<std::size_t>(wholeOr(view, "byteStride", elementSize(shape)));
  return ElementRun{startOf(source, view, json), stride, shape.count};
}

std::optional<SparseRuns> sparseRuns(const Source& source, int accessor, const AccessorShape& shape) {
  const Json& json = element(source.json, "accessors", static_cast<std::size_t>(accessor));
  const Json* sparse = find(json, "sparse");
  if (sparse == nullptr) {
    return std::nullopt;
  }
  const auto count = static_cast<std::size_t>(wholeOr(*sparse, "count", 0));
  const Json& indices = *find(*sparse, "indices");
  const auto indexType = static_cast<ComponentType>(indexOr(indices, "componentType"));
  const ElementRun indexRun = packedRun(source, indices, count, componentSize(indexType));
  const ElementRun valueRun = packedRun(source, *find(*sparse, "values"), count, elementSize(shape));
  if (indexRun.count != valueRun.count) {
    return std::nullopt; // one of them lies in a buffer without bytes
  }
  return SparseRuns{indexRun, indexType, valueRun};
}

} // namespace stretch::gltf

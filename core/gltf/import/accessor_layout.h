#pragma once

#include <optional>
#include <vector>

#include "core/gltf/import/accessor.h"

namespace stretch::gltf {

/// Elements that lie in a buffer, `stride` bytes from one to the next.
struct ElementRun {
  const std::uint8_t* first = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
};

/// The elements that a sparse accessor replaces.
struct SparseRuns {
  ElementRun indices;
  ComponentType indexType = ComponentType::uint32;
  ElementRun values;
};

[[nodiscard]] std::size_t componentSize(ComponentType type);

/// Offsets in bytes of an element's components: columns of matrices start at multiples of 4 bytes.
[[nodiscard]] std::vector<std::size_t> componentOffsets(const AccessorShape& shape);

/// Bytes of one element, the padding of matrix columns included.
[[nodiscard]] std::size_t elementSize(const AccessorShape& shape);
/// Bytes that the last element of a run needs: the padding after its last column may be missing.
[[nodiscard]] std::size_t lastElementSize(const AccessorShape& shape);

/// Nothing for an accessor without a buffer view or bytes: all zeros. The accessor has to be validated.
[[nodiscard]] std::optional<ElementRun> denseRun(const Source& source, int accessor,
                                                 const AccessorShape& shape);

/// Nothing for an accessor that is not sparse, or whose sparse values have no bytes. The accessor has to be
/// validated, except the values of the indices.
[[nodiscard]] std::optional<SparseRuns> sparseRuns(const Source& source, int accessor,
                                                   const AccessorShape& shape);

/// The elements that sparse values replace.
[[nodiscard]] std::vector<std::uint32_t> sparseTargets(const SparseRuns& sparse);

} // namespace stretch::gltf

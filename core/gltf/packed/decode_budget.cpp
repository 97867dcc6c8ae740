#include <algorithm>

#include "core/gltf/import/import.h"

namespace stretch::gltf {

// Meshes of one file may share their vertices: each byte counts for many values.
DecodeBudget::DecodeBudget(const Source& source) : left_(std::size_t{1} << 23U) {
  constexpr std::size_t mostOfAnyFile = std::size_t{1} << 29U;
  constexpr std::size_t valuesOfOneByte = 32;
  for (const Bytes& buffer : source.buffers) {
    left_ = std::min(mostOfAnyFile, left_ + valuesOfOneByte * buffer.size());
  }
}

} // namespace stretch::gltf

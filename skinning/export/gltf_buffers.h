#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/gltf/json/json.h"

namespace stretch::skinning {

/// Appends accessors to one binary buffer and describes them in the document.
class GltfBuffers {
public:
  explicit GltfBuffers(gltf::Json& json) : json_(json) {}

  enum class Target { none = 0, vertices = 34962, indices = 34963 };

  /// Index of a new accessor. `width` numbers per element ("SCALAR" 1, "VEC3" 3, ...); `bounds` writes min
  /// and max.
  std::size_t addFloats(const std::vector<float>& values, const char* type, std::size_t width, Target target,
                        bool bounds);
  /// Signed numbers in -1..1, as normalised 16-bit integers.
  std::size_t addNormalised(const std::vector<float>& values, const char* type, std::size_t width);
  template <typename T>
  std::size_t addIntegers(const std::vector<T>& values, const char* type, std::size_t width, Target target,
                          bool normalised);

  /// Integers of a vertex attribute, `stored` numbers per element of which `width` count, so that elements
  /// begin at multiples of 4 bytes; `bounds` writes min and max.
  template <typename T>
  std::size_t addPadded(const std::vector<T>& values, const char* type, std::size_t width, std::size_t stored,
                        bool bounds);

  /// Index of a new buffer view of bytes that no accessor describes, as an image's.
  std::size_t addView(std::span<const std::uint8_t> bytes);

  /// Bytes of the data of an accessor, its padding left out.
  [[nodiscard]] std::size_t bytesOf(std::size_t accessor) const { return sizes_.at(accessor); }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

private:
  std::size_t addView(const void* data, std::size_t size, Target target);
  template <typename T>
  void addBounds(std::size_t accessor, const std::vector<T>& values, std::size_t width, std::size_t stored);
  std::size_t add(const void* data, std::size_t size, std::size_t elements, int componentType,
                  const char* type, Target target, bool normalised);

  gltf::Json& json_;
  std::vector<std::uint8_t> bytes_;
  std::map<std::size_t, std::size_t> sizes_;
};

} // namespace stretch::skinning

#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/gltf/source/problems.h"
#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// glTF's component types, by its own numbers.
enum class ComponentType {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

/// Count, type and layout of an accessor's elements.
struct AccessorShape {
  std::size_t count = 0; ///< Elements.
  std::string type;      ///< "SCALAR", "VEC3", "MAT4"...
  int width = 1;         ///< Components per element.
  ComponentType component = ComponentType::float32;
  bool isNormalized = false; ///< Integers stand for 0..1 or -1..1.
};

/// Elements that an accessor without data (all zeros) may have at most.
inline constexpr std::size_t mostZeroElements = std::size_t{1} << 24U;

/// Nothing for a type or a component type that glTF does not know.
[[nodiscard]] std::optional<AccessorShape> shapeOf(const Source& source, int accessor);

/// Buffer views and accessors stay within their bytes, sparse ones included. After a pass without errors
/// every accessor of known shape can be read. The structure has to be validated, the buffers read. `rounded`
/// are accessors whose values need not be quite within the min and max that they say.
void validateAccessors(const Source& source, const std::set<std::size_t>& rounded, Problems& problems);

/// Accessors that attributes, indices, skins and animations name.
[[nodiscard]] std::vector<bool> usedAccessors(const Json& json);

/// All components as numbers; normalised integers become fractions. The accessor has to be validated.
[[nodiscard]] std::vector<float> readFloats(const Source& source, int accessor);
/// Likewise, in place of what `values` holds, in its memory where that is enough.
void readFloats(const Source& source, int accessor, std::vector<float>& values);

/// All components of an accessor of unsigned integers. The accessor has to be validated.
[[nodiscard]] std::vector<std::uint32_t> readIntegers(const Source& source, int accessor);

} // namespace stretch::gltf

#pragma once

#include <limits>
#include <span>
#include <string_view>

namespace stretch::gltf {

/// Type of value that a property of a glTF object holds.
enum class PropertyKind {
  object,    ///< An object of the kind `target`.
  objects,   ///< An array of them.
  index,     ///< An index into the root array `target`.
  indices,   ///< An array of such indices.
  indexMap,  ///< An object whose values are such indices (attributes).
  indexMaps, ///< An array of those (morph targets).
  whole,     ///< A whole number, minimum to maximum.
  number,    ///< A number, minimum to maximum.
  numbers,   ///< An array of `count` numbers; any number of them when count is 0.
  text,
  texts,
  flag,
  localIndex, ///< An index into an array of the enclosing object; checked where that object is known.
};

struct Property {
  std::string_view owner; ///< Kind of the object that has it.
  std::string_view name;
  PropertyKind kind = PropertyKind::object;
  std::string_view target{};
  bool isRequired = false;
  double minimum = 0.0;
  double maximum = std::numeric_limits<double>::infinity();
  int count = 0;
};

/// The properties of the glTF 2.0 core that this program or its file writer relies on.
[[nodiscard]] std::span<const Property> schema();

} // namespace stretch::gltf

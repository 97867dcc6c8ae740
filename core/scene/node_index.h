#pragma once

#include <compare>
#include <cstddef>

#include "core/base/index.h"

namespace stretch {

/// Which node of a scene: the index that its file gives it (names repeat). A type of its own, so that no
/// clip, skin or place in another list is taken for a node.
struct NodeIndex {
  int value = -1; ///< Counted from 0, as in files and messages. -1: none.

  constexpr NodeIndex() = default;
  constexpr explicit NodeIndex(int index) : value(index) {}
  constexpr explicit NodeIndex(std::size_t index) : value(static_cast<int>(index)) {}

  static const NodeIndex none;

  [[nodiscard]] constexpr bool exists() const { return value >= 0; }

  friend constexpr auto operator<=>(const NodeIndex&, const NodeIndex&) = default;
};

inline constexpr NodeIndex NodeIndex::none{};

/// Position of a node, and of what is kept for each node, in its list; the node must exist.
[[nodiscard]] constexpr std::size_t at(NodeIndex node) {
  return at(node.value);
}

} // namespace stretch

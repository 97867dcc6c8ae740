#pragma once

#include <cstddef>

namespace stretch {

/// Position in a container of something that a file numbers with an int; the number must not be negative.
[[nodiscard]] constexpr std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

} // namespace stretch

#pragma once

#include <cstdint>

#include "core/math/types.h"

namespace stretch::test {

/// A row of numbers that look random, the same on every machine and with every compiler.
class Row {
public:
  explicit Row(std::uint32_t seed) : state_(seed * 2654435761U + 1U) {}

  /// 0 to end - 1.
  std::uint32_t below(std::uint32_t end) {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8U) % end;
  }
  /// True once in `often` times.
  bool once(std::uint32_t often) { return below(often) == 0; }
  double between(double low, double high) { return low + (high - low) * 1e-4 * below(10001); }
  double around(double reach) { return between(-reach, reach); }
  Vec3 vector(double reach) {
    const double x = around(reach);
    const double y = around(reach);
    return {x, y, around(reach)};
  }
  /// One of a list that is not empty.
  template <typename List>
  const auto& oneOf(const List& list) {
    return list[below(static_cast<std::uint32_t>(list.size()))];
  }

private:
  std::uint32_t state_;
};

} // namespace stretch::test

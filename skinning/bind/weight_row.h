#pragma once

#include <cstdint>
#include <vector>

#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// Weights that come together from several places: joint and weight, each joint once.
class WeightSum {
public:
  void add(std::uint16_t joint, double weight);
  void add(const Influences& row, double factor);
  [[nodiscard]] double of(std::uint16_t joint) const;

  /// The `most` largest ones (at most Influences::capacity), the largest first, sum 1; of two that are equal
  /// the joint with the lower number. Nothing added: all weight to joint 0.
  [[nodiscard]] Influences strongest(std::size_t most) const;

private:
  struct Entry {
    std::uint16_t joint = 0;
    double weight = 0.0;
  };
  std::vector<Entry> entries_;
};

inline constexpr std::size_t mostInfluences = 4; ///< That a bound vertex has.

} // namespace stretch::skinning

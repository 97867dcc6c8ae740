#pragma once

#include <cstddef>

#include "skinning/skinned_sequence.h"

namespace stretch::test {

/// How much a vertex follows a bone, 0..1.
[[nodiscard]] inline double weightOf(const skinning::Influences& row, std::size_t bone) {
  double weight = 0.0;
  for (std::size_t i = 0; i < skinning::Influences::capacity; ++i) {
    weight += row.bones[i] == bone ? static_cast<double>(row.weights[i]) : 0.0;
  }
  return weight;
}

} // namespace stretch::test

#pragma once

#include <cstddef>
#include <vector>

namespace stretch::rig {

/// How much a sum of candidates that comes to 1 misses: the products of their differences from what is
/// wanted, summed over the times that are looked at. Square, row by row.
struct MissProducts {
  std::size_t count = 0;
  std::vector<double> products;

  [[nodiscard]] double at(std::size_t a, std::size_t b) const { return products[a * count + b]; }
};

/// Weights, none below 0 and together 1, at most `limit` of them above it, that miss least in the squared
/// mean (non-negative least squares; which candidates stay is found by taking away the one that costs least,
/// and by exchanging one for another as long as that helps). `exact`: candidates that would do together; at
/// least one.
[[nodiscard]] std::vector<double> fewWeights(const MissProducts& products,
                                             const std::vector<std::size_t>& exact, std::size_t limit);

} // namespace stretch::rig

#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace stretch {

/// Things numbered from 0 on, parted into sets that only grow together: union-find with path halving. Each
/// set is known by its leader, the smallest of its numbers, in whichever order its things were joined.
class DisjointSets {
public:
  /// Every thing is a set of its own.
  explicit DisjointSets(std::size_t count) : leaders_(count) {
    std::iota(leaders_.begin(), leaders_.end(), std::size_t{0});
  }

  [[nodiscard]] std::size_t leaderOf(std::size_t one) {
    while (leaders_[one] != one) {
      leaders_[one] = leaders_[leaders_[one]];
      one = leaders_[one];
    }
    return one;
  }

  /// Makes the sets of both one; answers whether they were two.
  bool join(std::size_t a, std::size_t b) {
    const auto [first, second] = std::minmax({leaderOf(a), leaderOf(b)});
    leaders_[second] = first;
    return first != second;
  }

private:
  std::vector<std::size_t> leaders_;
};

} // namespace stretch

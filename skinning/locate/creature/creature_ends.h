#pragma once

#include <vector>

#include "skinning/locate/body_ends.h"

namespace stretch::skinning {

/// Ends on the two sides of a body that mirror each other.
struct EndPair {
  BodyEnd left; ///< At +X of the body's space.
  BodyEnd right;

  [[nodiscard]] double length() const { return left.length < right.length ? left.length : right.length; }
};

struct CreatureEnds {
  std::vector<EndPair> legs;   ///< Ascending in z.
  std::vector<EndPair> others; ///< Pairs that do not stand.
  std::vector<BodyEnd> middle; ///< Head and tail.

  /// All of them.
  [[nodiscard]] std::vector<BodyEnd> all() const;
};

/// Sorts the ends of a body. `rows`: how many pairs of legs, the longest are taken; 0: as many as stand.
[[nodiscard]] CreatureEnds creatureEnds(const StandingBody& body, const std::vector<double>& ways, int rows);

} // namespace stretch::skinning

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "skinning/locate/standing_body.h"

namespace stretch::skinning {

/// End of a body: farther from the middle, by the way inside, than all around it. A head, a hand, a foot, a
/// tail, an ear.
struct BodyEnd {
  std::uint32_t cell = 0; ///< Cell of the tip.
  double length = 0.0;    ///< Way from the tip to where it meets what reaches farther out.
  Vec3 root{0.0};         ///< Place where they meet.
};

/// For each cell the way inside a body from the cell that is nearest to its centroid.
[[nodiscard]] std::vector<double> waysFromCentre(const StandingBody& body);

/// Cells from the farthest one inwards, and the place of each cell in that order.
struct InwardOrder {
  std::vector<std::size_t> cells;
  std::vector<std::size_t> places;
};
[[nodiscard]] InwardOrder inwardOrder(const std::vector<double>& ways);

/// All of them that are longer than `shortest` of the farthest way, the longest first.
[[nodiscard]] std::vector<BodyEnd> bodyEnds(const StandingBody& body, const std::vector<double>& ways,
                                            double shortest);

/// How many ends a body has that are at least a fifth of the farthest way long.
[[nodiscard]] std::size_t endsOf(const StandingBody& body);

} // namespace stretch::skinning

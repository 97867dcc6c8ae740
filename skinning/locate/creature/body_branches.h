#pragma once

#include <cstdint>
#include <vector>

#include "skinning/locate/body_ends.h"

namespace stretch::skinning {

/// Part of a body that belongs to one of its ends, from the tip inwards until it meets what is another one's.
struct BodyBranch {
  std::uint32_t tip = 0;
  std::vector<std::uint32_t> cells; ///< From the tip inwards.
};

/// One for each end, in their order. `ways`: of waysFromCentre(). Ends that are not named, such as toes and
/// ears, belong to what they grow on.
[[nodiscard]] std::vector<BodyBranch> branchesOf(const StandingBody& body, const std::vector<double>& ways,
                                                 const std::vector<BodyEnd>& ends);

/// A section of a branch, or of what leads to any tip.
struct BranchSection {
  Vec3 middle{0.0};
  double radius = 0.0; ///< Radius of a disc as large as the section.
};

/// The sections of `cells`, two cubes long each, by their ways to the tip, from the tip inwards.
[[nodiscard]] std::vector<BranchSection> sectionsOf(const StandingBody& body,
                                                    const std::vector<std::uint32_t>& cells,
                                                    const std::vector<double>& fromTip);

} // namespace stretch::skinning

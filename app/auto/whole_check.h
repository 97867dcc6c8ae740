#pragma once

#include <vector>

#include "app/auto/planned_trail.h"

namespace stretch::app {

enum class FaultKind {
  lengths, ///< A limb longer or shorter than the style lets it be.
  floor,   ///< Something goes through the floor.
  stand,   ///< A foot that stands is moved.
  chain,   ///< Limbs of one chain pull opposite ways.
  seam,    ///< From the clip's last pose to its first.
  sides,   ///< Limbs of two sides whose ends change sides.
  lifted   ///< A body without legs leaves the ground that it lies on.
};

/// Words that an animator is told it in.
[[nodiscard]] const char* textOf(FaultKind kind);

/// Something wrong with all trails of a plan together, and one that has a part in it.
struct Fault {
  std::size_t trail = 0; ///< Place in AutoPlan::trails.
  FaultKind kind = FaultKind::lengths;
  double depth = 0.0; ///< World units that its limb is below the floor while it acts, at most.
};

/// Looks at every frame on which a trail acts: limbs through the floor where the source has them above it,
/// limbs longer or shorter than the style lets them be, feet
/// that stand and are moved, trails that pull one chain opposite ways, wings and the like that pass through
/// each other, and a seam that is wider than the source's. At most one for each trail: of several that move a
/// limb the weakest is meant without which nothing is wrong.
[[nodiscard]] std::vector<Fault> faultsOf(const ClipGround& ground, const AutoSettings& settings,
                                          const AutoPlan& plan);

} // namespace stretch::app

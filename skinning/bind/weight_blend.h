#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "skinning/bind/bone_lines.h"
#include "skinning/bind/skeleton_ways.h"
#include "skinning/fit/alternate.h"

namespace stretch::skinning {

/// The bone that is nearest to a cell.
struct CellOwner {
  static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t line = nobody; ///< Index of a bone line; `nobody`: no bone reaches the cell through the body.
  float along = 0.0F;          ///< Place on the line: 0 at its start, 1 at its end.
  float distance = 0.0F;       ///< From there to the cell.
};

/// The bone that is nearest to each cell, by the way inside the body, less `sections` times the bone's
/// radius: a thick bone owns more of the body than a thin one beside it.
[[nodiscard]] std::vector<CellOwner> boneRegions(const VoxelBody& body, const std::vector<BoneLine>& lines,
                                                 const std::vector<BoneCell>& cells,
                                                 const std::vector<double>& radii, double sections);

/// Joints that a cell follows: joints and weights that sum to 1, the largest first, unused slots 0.
struct CellWeights {
  static constexpr std::size_t capacity = 6;
  std::array<std::uint16_t, capacity> joints{};
  std::array<float, capacity> weights{};
};

/// Regions made to flow into each other about their borders, as heat would from cell to cell: over `blend`
/// times the radius of the bone that owns a cell. Nothing flows between parts that touch and are far from
/// each other along the skeleton. Every cell has to have an owner. Told to stop, it answers what it has.
[[nodiscard]] std::vector<CellWeights>
blendedRegions(const VoxelBody& body, const std::vector<BoneLine>& lines, const SkeletonWays& ways,
               const std::vector<CellOwner>& owners, const std::vector<double>& radii, double blend,
               const Proceed& proceed);

} // namespace stretch::skinning

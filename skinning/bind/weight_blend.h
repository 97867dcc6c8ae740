#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "skinning/bind/bone_lines.h"

namespace stretch::skinning {

/// A cell that no bone reaches through the body.
inline constexpr std::uint16_t nobody = std::numeric_limits<std::uint16_t>::max();

/// The joint whose bone is nearest to each cell, by the way inside the body, less `sections` times the bone's
/// radius: a thick bone owns more of the body than a thin one beside it.
[[nodiscard]] std::vector<std::uint16_t> boneRegions(const VoxelBody& body,
                                                     const std::vector<BoneCell>& cells,
                                                     const std::vector<double>& radii, double sections);

/// What a cell follows: joints and weights that sum to 1, the largest first, unused slots 0.
struct CellWeights {
  static constexpr std::size_t capacity = 6;
  std::array<std::uint16_t, capacity> joints{};
  std::array<float, capacity> weights{};
};

/// Regions made to flow into each other about their borders, as heat would from cell to cell: over `blend`
/// times the radius of the bone that owns a cell. Every cell has to have an owner.
[[nodiscard]] std::vector<CellWeights> blendedRegions(const VoxelBody& body,
                                                      const std::vector<std::uint16_t>& owners,
                                                      const std::vector<double>& radii, double blend);

} // namespace stretch::skinning

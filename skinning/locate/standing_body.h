#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "skinning/bind/voxel_body.h"
#include "skinning/fit/alternate.h"
#include "skinning/locate/upright.h"

namespace stretch::skinning {

/// Cells of one layer that touch each other.
struct SliceRegion {
  std::vector<std::uint32_t> cells;
  Vec3 middle{0.0};
  Vec3 low{0.0}; ///< Least coordinates of the cells' middles.
  Vec3 high{0.0};
};

/// A body as cubes in its own space (Upright::toBody): one piece, whatever the mesh is made of.
struct StandingBody {
  Upright upright;
  VoxelBody cubes;
  std::size_t ownCells = 0;                     ///< Cells of the mesh; those behind them join its pieces.
  std::vector<std::vector<SliceRegion>> layers; ///< From the ground up, one for each layer of cubes.

  [[nodiscard]] Vec3 middleOf(std::size_t cell) const { return cubes.middleOf(cell); }
  [[nodiscard]] bool isBridge(std::size_t cell) const { return cell >= ownCells; }
  [[nodiscard]] double layerHeight(std::size_t layer) const {
    return cubes.grid.origin.y + (static_cast<double>(layer) + 0.5) * cubes.grid.size;
  }
  [[nodiscard]] std::size_t layerAt(double height) const;
};

/// Fills the mesh into cubes as its stance says. Pieces that nothing joins are joined by the shortest ways
/// between them. Error: what voxelBody refuses.
[[nodiscard]] Result<StandingBody>
standingBody(std::span<const Vec3> positions, const std::vector<Triangle>& triangles, const Upright& upright);

/// Fills the mesh after its stance was found (findUpright). Error, one line: no triangle, nothing that has an
/// extent or encloses anything, places that are no numbers, told to stop.
[[nodiscard]] Result<StandingBody> standingIn(std::span<const Vec3> positions,
                                              const std::vector<Triangle>& triangles, UpAxis up,
                                              const Proceed& proceed);

/// Remedy of errors about meshes that show no body.
inline constexpr const char* byHand = "set all locators by hand and give them: --locators";

} // namespace stretch::skinning

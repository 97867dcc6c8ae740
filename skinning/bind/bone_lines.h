#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "skinning/bind/voxel_body.h"

namespace stretch::skinning {

/// A joint that a mesh is to follow, in the space of the mesh.
struct BindJoint {
  Vec3 place{0.0};
  int parent = -1; ///< Index into the joints; -1: none.
};

/// A straight piece of the bone of a joint.
struct BoneLine {
  std::uint16_t joint = 0;
  Vec3 start{0.0};
  Vec3 end{0.0};
};

/// From each joint to each of its children; that of a last joint goes on as the bone before it came, most of
/// the way to the end of the body: through the head, the hand, the toes.
[[nodiscard]] std::vector<BoneLine> boneLines(const VoxelBody& body, const std::vector<BindJoint>& joints);

/// A cell that a bone passes.
struct BoneCell {
  std::size_t cell = 0;
  std::uint16_t joint = 0;
  double distance = 0.0; ///< From the bone to the cell's middle; more than a cube where the bone runs
                         ///< outside.
};

/// The cells along all bones; a bone that runs far outside of the body has none.
[[nodiscard]] std::vector<BoneCell> boneCells(const VoxelBody& body, const std::vector<BoneLine>& lines);

/// Half the thickness of the body along each joint's bones: the median depth of the cells that they pass, one
/// cube where there are none.
[[nodiscard]] std::vector<double> boneRadii(const VoxelBody& body, const std::vector<BoneCell>& cells,
                                            std::size_t jointCount);

} // namespace stretch::skinning

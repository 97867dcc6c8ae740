#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "skinning/bind/voxel_body.h"

namespace stretch::skinning {

/// A joint that a mesh is to follow, in the space of the mesh.
struct BindJoint {
  Vec3 place{0.0};
  int parent = -1;   ///< Index into the joints; -1: none.
  Vec3 forward{0.0}; ///< Unit direction that its bone runs in; zero: not known.
};

/// A straight piece of the bone of a joint.
struct BoneLine {
  std::uint16_t joint = 0;
  Vec3 start{0.0};
  Vec3 end{0.0};
  int endJoint = -1; ///< The joint that stands at its end; -1: none, the bone is a last one.
};

/// From each joint to each of its children; that of a last joint goes on in its own direction, or as the bone
/// before it came, most of the way to the end of the body: through the head, the hand, the toes. A joint
/// whose direction leads to a child has no line to the children that stand beside it, short thick ones that
/// begin deep in the body apart.
[[nodiscard]] std::vector<BoneLine> boneLines(const VoxelBody& body, const std::vector<BindJoint>& joints);

/// Returns the same lines where no body is known, so that what begins deep in it counts as beside as well;
/// `endOfLast` answers where the bone of a last joint ends, from its place and a bone as long as the one
/// before it that goes on in its direction.
[[nodiscard]] std::vector<BoneLine>
boneLines(const std::vector<BindJoint>& joints,
          const std::function<Vec3(const Vec3& place, const Vec3& along)>& endOfLast);

/// A cell that a bone passes.
struct BoneCell {
  std::size_t cell = 0;
  std::uint32_t line = 0; ///< Index of a bone line.
  float along = 0.0F;     ///< 0 at the line's start, 1 at its end.
  double distance = 0.0;  ///< From the bone to the cell's middle; more than a cube where the bone runs
                          ///< outside.
};

/// The cells along all bones; a bone that runs far outside of the body has none.
[[nodiscard]] std::vector<BoneCell> boneCells(const VoxelBody& body, const std::vector<BoneLine>& lines);

/// Half the thickness of the body along each joint's bones: the median depth of the cells that they pass, one
/// cube where there are none.
[[nodiscard]] std::vector<double> boneRadii(const VoxelBody& body, const std::vector<BoneLine>& lines,
                                            const std::vector<BoneCell>& cells, std::size_t jointCount);

} // namespace stretch::skinning

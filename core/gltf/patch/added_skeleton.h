#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/gltf/patch/edits.h"
#include "core/scene/scene.h"

namespace stretch::gltf {

/// A joint of a skeleton that a scene is to get, in the world as the scene stands at rest.
struct SkeletonJoint {
  std::string name;
  int parent = -1; ///< An earlier one of the list; -1: none.
  Vec3 place{0.0};
  Quat orientation{1.0, 0.0, 0.0, 0.0};
};

/// The node that a skeleton for these meshes hangs on: the lowest one above all of them whose world matrix at
/// rest turns, moves and scales alike in all directions, so that the skeleton goes where they were carried.
/// None: the scene itself.
[[nodiscard]] NodeIndex carrierOfSkeleton(const Scene& scene, const std::vector<NodeIndex>& meshNodes);

/// The nodes that make the skeleton, in the order of the joints, without scale of their own: the carrier's
/// goes through to all of them.
[[nodiscard]] std::vector<AddedNode>
skeletonNodes(const Scene& scene, const std::vector<SkeletonJoint>& joints, NodeIndex carrier);

/// World matrices of the joints as `skeletonNodes` places them.
[[nodiscard]] std::vector<Mat4> skeletonWorlds(const Scene& scene, const std::vector<SkeletonJoint>& joints,
                                               NodeIndex carrier);

/// Takes a skeleton out again that nothing uses: the nodes from `firstNode` on, what refers to them, and the
/// last skin, which names them.
void takeOutSkeleton(std::size_t firstNode, Json& json);

} // namespace stretch::gltf

#pragma once

#include <set>
#include <vector>

#include "app/document.h"
#include "core/gltf/patch/added_skeleton.h"
#include "rig/body/locators/locators.h"
#include "skinning/bind/bone_lines.h"

namespace stretch::app {

/// A mesh that is to be bound, as one piece of the body.
struct MeshToBind {
  NodeIndex node;
  int skin = -1;               ///< That it has; -1: none.
  Mat4 toWorld{1.0};           ///< From the mesh's space, in the pose that it is bound in.
  std::size_t firstVertex = 0; ///< First vertex in the body; its primitives follow each other.
};

/// The meshes as one body in the world, in the pose that they are bound in.
struct BodyToBind {
  std::vector<MeshToBind> meshes;
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// A skeleton to bind to.
struct SkeletonToBind {
  std::vector<NodeIndex> nodes; ///< Nodes of the document's scene, or behind its nodes those of `added`.
  std::vector<Mat4> worlds;     ///< In the pose that meshes are bound in.
  std::vector<skinning::BindJoint> joints; ///< Their places, parents and directions.
  std::vector<gltf::AddedNode> added;      ///< Joints that the file does not have yet.
};

/// Whether a joint is one of a limb, or its end.
[[nodiscard]] bool isOfLimb(const rig::Body& body, NodeIndex joint);

/// Joints of skins that vertices follow, in the file as it is.
[[nodiscard]] std::set<NodeIndex> followedJoints(const Scene& scene);

/// The joints that the file has: those of its skins that the hips or a limb carry, or that vertices follow
/// and that do not carry the hips, without handles that no limb hangs on, or where it has no skin all that
/// hangs on the hips. Empty where no joint is found.
[[nodiscard]] SkeletonToBind ownSkeleton(const Document& document);

/// Joints made at the locators, carried as `meshes` are.
[[nodiscard]] SkeletonToBind skeletonOf(const rig::Locators& locators, const Scene& scene,
                                        const std::vector<NodeIndex>& meshes);

/// Nodes whose meshes follow a skeleton of these joints: those with a skin, and those that no joint carries.
[[nodiscard]] std::vector<NodeIndex> meshNodesToBind(const Scene& scene,
                                                     const std::vector<NodeIndex>& joints);

/// The meshes as they stand in the bind pose of their skins, or at rest.
[[nodiscard]] BodyToBind bodyToBind(const Scene& scene, const std::vector<NodeIndex>& nodes);

} // namespace stretch::app

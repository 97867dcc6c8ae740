#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/evidence/name_evidence.h"

namespace stretch::rig::body {

/// Which nodes may be joints of the body.
enum class Candidates {
  deformJoints,  ///< Joints of any skin that move a mesh or are called DEF-, as rigs of Blender call those.
  skinJoints,    ///< Joints of any skin.
  nodesNoMeshes, ///< Nodes without a mesh of their own: rigid pieces hang under them.
  allNodes       ///< Every node: rigid pieces are the limbs.
};

/// Whether these are joints of skins.
[[nodiscard]] inline bool isOfSkins(Candidates candidates) {
  return candidates == Candidates::deformJoints || candidates == Candidates::skinJoints;
}

/// A bone tree reduced to the joints that can belong to limbs and trunk, with all evidence at hand. Vectors
/// are indexed by candidate, which is an int; -1 means none. Positions are of the bind pose, in world units.
struct BodyView {
  std::vector<NodeIndex> nodes;     ///< Node of each candidate.
  std::vector<int> candidateOfNode; ///< One for each node.
  std::vector<int> parent;          ///< Nearest candidate above.
  std::vector<bool> isDetached;     ///< A foot that hangs elsewhere in the file: its parent is the shin whose
                                    ///< mesh ends at it.
  std::vector<std::vector<int>> children;
  std::vector<int> depth;
  std::vector<Vec3> position;
  std::vector<std::string> called;       ///< Name of each candidate without what all joints' names share.
  std::vector<NameEvidence> names;       ///< Evidence that it gives.
  std::vector<std::vector<Vec3>> points; ///< Vertices that follow this joint most.
  std::vector<std::vector<Vec3>> tips; ///< Positions of end joints that hang from this joint, not of handles.
  std::vector<std::size_t> verticesBelow; ///< Vertices of the joint and of all below it.
  std::vector<double> reach;              ///< Farthest vertex, joint or tip below, from the joint.
  bool hasVertices = false;
  double size = 1.0; ///< Largest extent of joints and vertices, > 0.

  [[nodiscard]] int count() const { return static_cast<int>(nodes.size()); }
  [[nodiscard]] const Vec3& at(int candidate) const { return position[static_cast<std::size_t>(candidate)]; }
  [[nodiscard]] const NameEvidence& name(int candidate) const {
    return names[static_cast<std::size_t>(candidate)];
  }
  [[nodiscard]] int parentOf(int candidate) const { return parent[static_cast<std::size_t>(candidate)]; }
  [[nodiscard]] const std::vector<int>& childrenOf(int candidate) const {
    return children[static_cast<std::size_t>(candidate)];
  }
  /// Whether vertices follow the joint or a joint below it; true where there are no vertices at all.
  [[nodiscard]] bool movesMesh(int candidate) const {
    return !hasVertices || verticesBelow[static_cast<std::size_t>(candidate)] > 0;
  }
  /// Whether `above` is `candidate` or above it.
  [[nodiscard]] bool isAboveOrSelf(int above, int candidate) const;
  /// Nearest common candidate above-or-self; -1 where the two hang from different roots.
  [[nodiscard]] int commonAncestor(int a, int b) const;
  /// Candidates from `above` down to `candidate`, both included; empty where `above` is not above.
  [[nodiscard]] std::vector<int> path(int above, int candidate) const;
};

/// Handles of the animator's, tips, and joints that nothing follows are left out; what hung from them hangs
/// from the nearest candidate above, or from the candidate that stands in the same place (deform bones under
/// their masters). Feet that hang from the root, as rigs for inverse kinematics have them, hang from the last
/// joint of the leg that ends there.
/// `within`: the topmost joint of the one skeleton that is looked at; -1: all of them.
[[nodiscard]] BodyView viewBody(const Scene& scene, const BindPose& bindPose, Candidates candidates,
                                NodeIndex within = NodeIndex::none);

/// Vertices of every node in the bind pose, world units, each at the node that moves it most: the joint of
/// greatest weight, or the node that carries a rigid mesh.
enum class RigidMeshes {
  none,
  bodyParts, ///< Those on joints in a row that move no vertices of a skin; the others are held or worn.
  all
};
[[nodiscard]] std::vector<std::vector<Vec3>> vertexClouds(const Scene& scene, const BindPose& bindPose,
                                                          RigidMeshes rigid);

} // namespace stretch::rig::body

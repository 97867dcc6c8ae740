#pragma once

#include <vector>

#include "core/scene/scene.h"
#include "rig/limb.h"
#include "rig/reach/bind_places.h"

namespace stretch::rig {

/// Nodes that hang on one bone of a limb, those that its stretch concerns (docs/rig.md, What belongs
/// to a bone).
struct BoneTopology {
  /// The joint that carries the bone.
  NodeIndex joint;
  /// From the joint's child down to the next limb joint or the end, both included; empty where the end is
  /// estimated or not a descendant.
  std::vector<NodeIndex> pathNodes;
  /// Joints that lie along the bone and rigid meshes that cover it, with the nodes between them and the bone:
  /// they deform with it; parents first. May contain path nodes.
  std::vector<NodeIndex> twistNodes;
  /// Children of the joint that are neither on the path nor companions of the end: moved by the bone's
  /// stretch.
  std::vector<NodeIndex> hanging;
};

/// The nodes of a limb, by bone.
struct LimbTopology {
  /// One for each joint of the limb, base first.
  std::vector<BoneTopology> bones;
  /// Children of the base joint that start another limb on the body's side (thighs under a joint that also
  /// starts the spine): they stay where they are.
  std::vector<NodeIndex> staying;
  /// Whether the end descends from the last joint; not so for a foot under the root. True when the end is
  /// estimated.
  bool endIsDescendant = true;
  /// Nodes that stand at the limb's end and do not hang on the end joint: a heel or a toe beside the foot, or
  /// under the root as the foot, arms beside the spine. They move with the end as one piece; parents first.
  std::vector<NodeIndex> companions;
  /// For a limb that is led by its first joint: the node that carries that joint and the one after it, and
  /// moves as one piece. None otherwise.
  NodeIndex leader;
};

/// `others`: all limbs of the character, so that a limb hanging on a bone is not taken for a twist joint.
[[nodiscard]] LimbTopology limbTopology(const Scene& scene, const Limb& limb, const std::vector<Limb>& others,
                                        const BindPlaces& places);

/// Every node whose local transform a trail on this limb may change, ascending, without repeats.
[[nodiscard]] std::vector<NodeIndex> touchedNodes(const Limb& limb, const LimbTopology& topology);

} // namespace stretch::rig

#pragma once

#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/ik/limb_shape.h"
#include "rig/limb.h"
#include "rig/reach/limb_topology.h"

namespace stretch::rig {

/// Stretch of one bone in its joint's space: K = A diag(s, q, q) A^T along a unit axis, q = s^(-volume/2).
[[nodiscard]] Mat3 boneStretch(const Vec3& unitAxis, double stretch, double volume);

struct DeformOptions {
  double volume = 1.0;  ///< 0..1: volume preservation.
  bool turnEnd = false; ///< The end joint turns with the limb instead of keeping its world orientation.
  Quat endTurn{1.0, 0.0, 0.0, 0.0}; ///< In the world, of an end joint that does not turn with the limb.
};

/// A limb brought elsewhere, bone by bone: bone i turns by turns[i] (world space, about its joint) and is
/// stretched to stretches[i] times its length.
struct LimbPose {
  std::vector<Quat> turns;
  std::vector<double> stretches;
  Vec3 baseMove{0.0}; ///< How far the first joint is moved away from what it hangs on.
  Vec3 end{0.0};      ///< Place that the limb's end comes to.
  bool leads = false; ///< The first joint leads the others, where the topology has a leader.
};

[[nodiscard]] LimbPose limbPose(const LimbShape& shape);

/// The pose of a shape that was solved for pointsToLead of the limb in this frame.
[[nodiscard]] LimbPose poseToLead(const Limb& limb, const LimbShape& shape, const FrameState& frame);

/// Brings a limb's pose onto the character: turns the limb's joints, moves what hangs on its bones by K,
/// puts K into FrameState::stretch for the joints that deform with the bone, keeps the end's orientation, and
/// leaves the subtrees that stay (LimbTopology::staying) where they are. `frame` is what the pose
/// was solved for; its worlds are kept up to date. Of a pose whose first joint leads, that joint is the one
/// that keeps its orientation, as a hand does, and its bone is not stretched: the head of a serpent stays a
/// head.
void deformLimb(const Scene& scene, const Limb& limb, const LimbTopology& topology, const LimbPose& shape,
                const DeformOptions& options, FrameState& frame);

/// Stretches the bones of a limb, one K each in its joint's space that has the bone as an axis, without
/// turning anything: what hangs on a bone moves by K, the joints that deform with it get it, the end keeps
/// its orientation.
void stretchLimb(const Scene& scene, const Limb& limb, const LimbTopology& topology,
                 const std::vector<Mat3>& stretches, FrameState& frame);

/// Brings a node, and what hangs on it, to a place in the world; its orientation stays.
void moveNode(const Scene& scene, NodeIndex node, const Vec3& positionWorld, FrameState& frame);

/// Brings a node, and what hangs on it, to a place in the world, turned there from where it stands.
void placeNode(const Scene& scene, NodeIndex node, const Quat& turnWorld, const Vec3& positionWorld,
               FrameState& frame);

} // namespace stretch::rig

#pragma once

#include <vector>

#include "core/anim/clip.h"
#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/ik/two_bone.h"
#include "rig/limb.h"
#include "rig/reach/bend_directions.h"
#include "rig/reach/bind_places.h"
#include "rig/reach/limb_topology.h"

namespace stretch::rig {

/// A limb whose end can be brought to a place.
struct ReachingLimb {
  Limb limb;
  LimbTopology topology;
  std::vector<double> along; ///< u of each point of the limb: rest arc length over the whole.
  std::size_t bendPoint = 0; ///< The point between its two spans: the joint that bends most; 0: it is turned
                             ///< and stretched as one.
  BendDirections bends;      ///< Which way it bends over the clip.
};

/// Input from which a limb's reach is worked out.
struct ReachInput {
  const Scene& scene;
  const Clip& clip;
  const std::vector<Limb>& limbs; ///< All limbs of the character.
  const BindPlaces& places;
};

/// Direction that the character faces in the bind pose, as its left and up tell: unit, level.
[[nodiscard]] Vec3 facingInBind(const std::vector<Limb>& limbs, const BindPlaces& places);

[[nodiscard]] ReachingLimb reachingLimb(const ReachInput& input, const Limb& limb);

/// A limb of two spans as a frame has it.
[[nodiscard]] TwoBoneProblem posedLimb(const ReachingLimb& reaching, const FrameState& frame);

/// Place where the end of a limb is wanted.
struct ReachGoal {
  Vec3 place{0.0};
  Quat endTurn{1.0, 0.0, 0.0, 0.0}; ///< How the end joint turns from where the frame has it, world space.
  double stretchSwitch = 1.0;       ///< 0..1: 1 reaches every place, 0 leaves the bones as long as they are.
  double volume = 1.0;              ///< 0..1: volume preservation.
  double softness = 0.0;            ///< 0..0.3 of the limb's length; see softReach.
  Vec3 pole{0.0};                   ///< How far the pole is moved; zero: the bend keeps its direction.
};

/// Brings the end of a limb to its goal (docs/controllers.md, Arms and legs). `frame` keeps its time.
void reach(const Scene& scene, const ReachingLimb& reaching, const ReachGoal& goal, FrameState& frame);

/// The limb as one shape, turned and stretched. Answers where its end comes to if nothing is scaled unevenly.
Vec3 reachAsOne(const Scene& scene, const ReachingLimb& reaching, const ReachGoal& goal, FrameState& frame);

} // namespace stretch::rig

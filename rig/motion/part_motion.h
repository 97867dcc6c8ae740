#pragma once

#include <vector>

#include "core/anim/clip.h"
#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/motion/motion.h"
#include "rig/trail/limb_path.h"

namespace stretch::rig {

/// The motion of some nodes alone: what evaluateMotion answers for them, without the cost of the others. What
/// it is made from has to outlive it.
class PartMotion {
public:
  /// Looks at `nodes`, at all that adjustments, active trails, holds and weights of `motion` move, and at
  /// what these hang from.
  PartMotion(const Scene& scene, const Clip& clip, const MotionState& motion, std::vector<NodeIndex> nodes);

  /// Samples as sampledFrame does; nodes that are not looked at keep the identity. `frame` may be one of this
  /// motion's before.
  void source(double timeSeconds, FrameState& frame) const;
  /// Evaluates as evaluateMotion does.
  void moved(double timeSeconds, FrameState& frame) const;
  /// Brings adjustments, trails, holds and weight onto a frame of `source`.
  void move(FrameState& frame) const;

private:
  const Clip& clip_;
  const MotionState& motion_;
  NodeSampler sampler_;
  Scene skeleton_; // the sampled nodes only
};

/// Every node that the adjustments, the active trails, the holds and the weights of a motion may move: what
/// they touch and all that hangs from it; ascending.
[[nodiscard]] std::vector<NodeIndex> movedNodes(const Scene& scene, const MotionState& motion);

} // namespace stretch::rig

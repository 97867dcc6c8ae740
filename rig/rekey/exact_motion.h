#pragma once

#include <map>
#include <vector>

#include "core/anim/clip.h"
#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/motion/evaluate.h"
#include "rig/rekey/mesh_reach.h"

namespace stretch::rig {

/// The motion that keys are made to follow, remembered per time.
class ExactMotion {
public:
  ExactMotion(const Scene& scene, const Clip& clip, const MotionState& motion)
      : scene_(scene), clip_(clip), motion_(motion), reach_(meshReach(scene)) {}

  [[nodiscard]] const FrameState& at(double timeSeconds);
  [[nodiscard]] const Pose& sourceAt(double timeSeconds);
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Clip& clip() const { return clip_; }
  [[nodiscard]] const MotionState& motion() const { return motion_; }
  [[nodiscard]] double reachOf(std::size_t node) const { return reach_[node]; } ///< See meshReach.

private:
  const Scene& scene_;
  const Clip& clip_;
  const MotionState& motion_;
  std::vector<double> reach_;
  std::map<double, FrameState> frames_;
  std::map<double, Pose> sources_;
};

/// A node's animated property as numbers: translation and scale in x, y, z, rotation as (x, y, z, w).
[[nodiscard]] Vec4 channelValue(const Pose& pose, NodeIndex node, Channel channel);
void setChannelValue(Pose& pose, NodeIndex node, Channel channel, const Vec4& value);

} // namespace stretch::rig

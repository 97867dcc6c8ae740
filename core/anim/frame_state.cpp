#include "core/anim/frame_state.h"

#include <utility>

namespace stretch {

FrameState frameOf(const Scene& scene, Pose pose, double timeSeconds) {
  FrameState frame;
  frame.timeSeconds = timeSeconds;
  frame.worlds = worldMatrices(scene, pose);
  frame.pose = std::move(pose);
  return frame;
}

Mat4 meshMatrix(const FrameState& frame, int node) {
  const auto index = static_cast<std::size_t>(node);
  return frame.stretch.empty() ? frame.worlds[index] : frame.worlds[index] * Mat4(frame.stretch[index]);
}

std::vector<Mat4> skinMatrices(const Skin& skin, const FrameState& frame) {
  std::vector<Mat4> matrices;
  matrices.reserve(skin.joints.size());
  for (std::size_t slot = 0; slot < skin.joints.size(); ++slot) {
    matrices.push_back(meshMatrix(frame, skin.joints[slot]) * skin.inverseBind[slot]);
  }
  return matrices;
}

} // namespace stretch

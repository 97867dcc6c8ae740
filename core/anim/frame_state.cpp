#include "core/anim/frame_state.h"

#include <utility>

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

namespace stretch {

namespace {

std::vector<Mat3> stretchOfPose(const Scene& scene, const Pose& pose) {
  std::vector<Mat3> stretch(scene.bindChains.empty() ? 0 : scene.nodes.size(), Mat3(1.0));
  for (const BindChain& chain : scene.bindChains) {
    stretch[at(chain.joint)] = stretchOf(scene, pose, chain);
  }
  return stretch;
}

// The K that brings each corner to where the pose has it, nearest to the identity where they tell only a part
// of it (least squares).
Mat3 stretchOfCorners(const Scene& scene, const Pose& pose, const std::vector<BindCorner>& corners) {
  constexpr double share = 1e-9; // of the corners' squares: the weight of the identity
  Mat3 moved(0.0);
  Mat3 rest(0.0);
  for (const BindCorner& corner : corners) {
    moved += glm::outerProduct(Vec3(localMatrix(scene, pose, corner.node)[3]), corner.place);
    rest += glm::outerProduct(corner.place, corner.place);
  }
  const Mat3 identity(share * (rest[0][0] + rest[1][1] + rest[2][2]));
  return identity[0][0] > 0.0 ? (moved + identity) * glm::inverse(rest + identity) : Mat3(1.0);
}

} // namespace

Mat3 stretchOf(const Scene& scene, const Pose& pose, const BindChain& chain) {
  if (!chain.corners.empty()) {
    return stretchOfCorners(scene, pose, chain.corners);
  }
  Mat3 turned = Mat3(localMatrix(scene, pose, chain.leaf));
  if (chain.endLeaf.exists()) {
    turned *= Mat3(localMatrix(scene, pose, chain.endLeaf));
  }
  return turned * glm::mat3_cast(glm::inverse(chain.restTurn));
}

FrameState frameOf(const Scene& scene, Pose pose, double timeSeconds) {
  FrameState frame;
  frame.timeSeconds = timeSeconds;
  frame.worlds = worldMatrices(scene, pose);
  frame.stretch = stretchOfPose(scene, pose);
  frame.pose = std::move(pose);
  return frame;
}

Mat4 meshMatrix(const FrameState& frame, NodeIndex node) {
  const auto index = at(node);
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

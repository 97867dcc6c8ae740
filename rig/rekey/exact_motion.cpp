#include "rig/rekey/exact_motion.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/check.h"

namespace stretch::rig {

const FrameState& ExactMotion::at(double timeSeconds) {
  const auto found = frames_.find(timeSeconds);
  return found != frames_.end()
             ? found->second
             : frames_.emplace(timeSeconds, evaluateMotion(scene_, clip_, motion_, timeSeconds))
                   .first->second;
}

const Pose& ExactMotion::sourceAt(double timeSeconds) {
  const auto found = sources_.find(timeSeconds);
  return found != sources_.end()
             ? found->second
             : sources_.emplace(timeSeconds, samplePose(scene_, clip_, timeSeconds)).first->second;
}

Vec4 channelValue(const Pose& pose, int node, Channel channel) {
  const Transform& local = pose.locals[static_cast<std::size_t>(node)];
  switch (channel) {
  case Channel::translation:
    return Vec4(local.translation, 0.0);
  case Channel::scale:
    return Vec4(local.scale, 0.0);
  case Channel::rotation:
    return {local.rotation.x, local.rotation.y, local.rotation.z, local.rotation.w};
  case Channel::weights:
    break;
  }
  check(false, "morph weights are no transform");
  return Vec4(0.0);
}

void setChannelValue(Pose& pose, int node, Channel channel, const Vec4& value) {
  pose.usesMatrix[static_cast<std::size_t>(node)] = false;
  Transform& local = pose.locals[static_cast<std::size_t>(node)];
  if (channel == Channel::translation) {
    local.translation = Vec3(value);
  } else if (channel == Channel::scale) {
    local.scale = Vec3(value);
  } else {
    local.rotation = glm::normalize(Quat(value.w, value.x, value.y, value.z));
  }
}

StretchParts partsOf(const Mat3& stretch) {
  // K has the eigenvalues s, q, q: trace = s + 2 q, trace of K K = s^2 + 2 q^2, determinant = s q^2.
  const double trace = stretch[0][0] + stretch[1][1] + stretch[2][2];
  const Mat3 squared = stretch * stretch;
  const double traceOfSquare = squared[0][0] + squared[1][1] + squared[2][2];
  const double root = std::sqrt(std::max(0.0, 6.0 * traceOfSquare - 2.0 * trace * trace));
  const double determinant = glm::determinant(stretch);
  StretchParts best;
  double leastMiss = -1.0;
  for (const double sign : {-1.0, 1.0}) {
    const double across = (2.0 * trace + sign * root) / 6.0;
    const double along = trace - 2.0 * across;
    const double miss = std::abs(along * across * across - determinant);
    if (leastMiss < 0.0 || miss < leastMiss) {
      leastMiss = miss;
      best.along = along;
      best.across = across;
    }
  }
  // K - q I = (s - q) a a^T: any of its columns points along the axis, the longest does so best.
  const Mat3 rankOne = stretch - Mat3(best.across);
  Vec3 longest(0.0);
  for (std::size_t column = 0; column < 3; ++column) {
    if (glm::length(rankOne[column]) > glm::length(longest)) {
      longest = rankOne[column];
    }
  }
  constexpr double noAxis = 1e-9;
  best.axis = std::abs(best.along - best.across) > noAxis ? glm::normalize(longest) : Vec3(0.0);
  return best;
}

} // namespace stretch::rig

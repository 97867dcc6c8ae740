#include "rig/rekey/exact_motion.h"

#include <glm/geometric.hpp>

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

Vec4 channelValue(const Pose& pose, NodeIndex node, Channel channel) {
  const Transform& local = pose.locals[at(node)];
  switch (channel) {
  case Channel::translation:
    return {local.translation, 0.0};
  case Channel::scale:
    return {local.scale, 0.0};
  case Channel::rotation:
    return {local.rotation.x, local.rotation.y, local.rotation.z, local.rotation.w};
  case Channel::weights:
    break;
  }
  check(false, "morph weights are no transform");
  return Vec4(0.0);
}

void setChannelValue(Pose& pose, NodeIndex node, Channel channel, const Vec4& value) {
  pose.usesMatrix[at(node)] = false;
  Transform& local = pose.locals[at(node)];
  if (channel == Channel::translation) {
    local.translation = Vec3(value);
  } else if (channel == Channel::scale) {
    local.scale = Vec3(value);
  } else {
    local.rotation = glm::normalize(Quat(value.w, value.x, value.y, value.z));
  }
}

} // namespace stretch::rig

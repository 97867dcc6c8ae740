#include "rig/rekey/exact_motion.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "core/base/check.h"

namespace stretch::rig {

std::vector<double> stopsAmong(std::vector<double> times) {
  constexpr std::size_t keysBetween = 64;
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<double> stops;
  for (std::size_t i = keysBetween; i < times.size(); i += keysBetween) {
    stops.push_back(times[i]);
  }
  stops.push_back(std::numeric_limits<double>::infinity());
  return stops;
}

std::size_t ExactMotion::usualCapacity(const Scene& scene) {
  constexpr std::size_t bytes = std::size_t{1} << 26U;
  constexpr std::size_t bytesOfNode =
      sizeof(Transform) + sizeof(Mat4) + sizeof(Mat3) + sizeof(std::vector<float>);
  constexpr std::size_t fewest = 120;
  return std::max(fewest, bytes / (bytesOfNode * std::max<std::size_t>(1, scene.nodes.size())));
}

const FrameState& ExactMotion::at(double timeSeconds) {
  return frames_.of(timeSeconds, [&] {
    FrameState frame;
    part_.moved(timeSeconds, frame);
    ++made_;
    return frame;
  });
}

const Pose& ExactMotion::sourceAt(double timeSeconds) {
  part_.source(timeSeconds, source_);
  return source_.pose;
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

void setChannelValue(Transform& local, Channel channel, const Vec4& value) {
  if (channel == Channel::translation) {
    local.translation = Vec3(value);
  } else if (channel == Channel::scale) {
    local.scale = Vec3(value);
  } else {
    local.rotation = glm::normalize(Quat(value.w, value.x, value.y, value.z));
  }
}

} // namespace stretch::rig

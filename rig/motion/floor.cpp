#include "rig/motion/floor.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "rig/motion/solve_steps.h"
#include "rig/trail/limb_path.h"

namespace stretch::rig {

std::optional<double> standingHeight(const Scene& scene, const Clip& clip, const Limb& leg) {
  constexpr double restingSpeed = 0.25; // Limb lengths per second.
  constexpr double restingSeconds = 0.1;
  std::vector<NodeIndex> nodes = leg.joints;
  if (leg.endNode.exists()) {
    nodes.push_back(leg.endNode);
  }
  const NodeSampler sampler(scene, clip, nodes);
  const double last = wholeFrameAtMost(std::min(endInFrames(clip), longestFrames));
  const double farthestStep = restingSpeed * leg.restLength / clip.framesPerSecond;
  const double leastRest = std::max(1.0, std::round(restingSeconds * clip.framesPerSecond));
  std::optional<double> lowest;
  std::optional<Vec3> before;
  FrameState pose;
  double rested = 0.0;
  for (double frame = 0.0; frame <= last; frame += 1.0) {
    sampler.sample(frame / clip.framesPerSecond, pose);
    const Vec3 end = endPosition(leg, pose);
    rested = before && glm::length(end - *before) <= farthestStep ? rested + 1.0 : 0.0;
    before = end;
    if (rested >= leastRest) {
      lowest = std::min(lowest.value_or(end.y), end.y);
    }
  }
  return lowest;
}

} // namespace stretch::rig

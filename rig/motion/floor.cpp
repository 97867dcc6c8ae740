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
  constexpr double clearly = 0.1; // limb lengths
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
  double level = 0.0;
  std::optional<double> lowestLevel;
  for (double frame = 0.0; frame <= last; frame += 1.0) {
    sampler.sample(frame / clip.framesPerSecond, pose);
    const Vec3 end = endPosition(leg, pose);
    rested = before && glm::length(end - *before) <= farthestStep ? rested + 1.0 : 0.0;
    level = before && std::abs(end.y - before->y) <= farthestStep ? level + 1.0 : 0.0;
    before = end;
    lowest = rested >= leastRest ? std::min(lowest.value_or(end.y), end.y) : lowest;
    lowestLevel = level >= leastRest ? std::min(lowestLevel.value_or(end.y), end.y) : lowestLevel;
  }
  // In a walk on the spot a foot rests in the air alone, where it turns round, and slides far below that.
  return lowest && lowestLevel && *lowest - *lowestLevel > clearly * leg.restLength ? lowestLevel : lowest;
}

} // namespace stretch::rig

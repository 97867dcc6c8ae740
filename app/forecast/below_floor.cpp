#include "app/forecast/below_floor.h"

#include <algorithm>

#include "core/anim/frame_state.h"
#include "core/anim/sampling.h"
#include "skinning/linear_blend_skinning.h"

namespace stretch::app {

BelowFloor belowFloor(const Scene& scene, const Clip& clip) {
  constexpr std::size_t most = 48;
  constexpr std::size_t fewest = 8;
  constexpr std::size_t mostVertices = 5'000'000; // of all times together
  const std::vector<NodeIndex> nodes = skinning::strongestNodes(scene);
  BelowFloor below;
  std::size_t count = most;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double seconds = clip.startSeconds + share * (clip.endSeconds - clip.startSeconds);
    const std::vector<Vec3> places =
        skinning::skinnedPositions(scene, frameOf(scene, samplePose(scene, clip, seconds), seconds));
    if (places.empty()) {
      return below;
    }
    const auto lowest = std::ranges::min_element(places, {}, &Vec3::y);
    if (-lowest->y > below.depth) {
      const auto vertex = static_cast<std::size_t>(lowest - places.begin());
      below = {-lowest->y, seconds, nodes[vertex]};
    }
    count = std::clamp(mostVertices / places.size(), fewest, most);
  }
  return below;
}

} // namespace stretch::app

#include "app/weight/loop.h"

#include <algorithm>
#include <cmath>

namespace stretch::app {

LoopRoom loopRoom(bool loops, std::size_t samples, double samplesPerSecond) {
  constexpr double smoothedSeconds = 0.2;
  const auto smoothed = static_cast<std::size_t>(std::ceil(smoothedSeconds * samplesPerSecond));
  const std::size_t period = samples - 1;
  return loops && samples > 2 ? LoopRoom{period, std::min(smoothed, period)} : LoopRoom{};
}

void wrapJoints(std::vector<std::vector<Vec3>>& joints, const LoopRoom& room) {
  if (room.before == 0) {
    return;
  }
  const Vec3 travel = joints.back().front() - joints.front().front();
  const std::size_t period = room.before;
  wrapList(joints, room);
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const double turn = k < period ? -1.0 : (k > 2 * period ? 1.0 : 0.0);
    for (Vec3& joint : joints[k]) {
      joint += turn * travel;
    }
  }
}

} // namespace stretch::app

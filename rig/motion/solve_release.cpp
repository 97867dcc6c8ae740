#include "rig/motion/solve_steps.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace stretch::rig {

namespace {

// To the limb's next key on a sparsely keyed clip, else a third of the range; within the
// clip unless it loops.
double releaseSecondsOf(const MotionInput& input, const SolvedTrail& solved,
                        const std::vector<NodeIndex>& nodes) {
  const Clip& clip = *input.clip;
  const bool forwards = solved.settings.pivot == Pivot::start;
  const double room =
      forwards ? clip.endSeconds - solved.endSeconds : solved.startSeconds - std::min(0.0, clip.startSeconds);
  const double limit = std::min(input.loops ? clip.endSeconds - clip.startSeconds : room,
                                longestFrames / clip.framesPerSecond);
  if (solved.settings.releaseFrames) {
    return std::clamp(*solved.settings.releaseFrames / clip.framesPerSecond, 0.0, std::max(0.0, limit));
  }
  const std::vector<double> keys = keyTimesOf(clip, nodes, clip.startSeconds, clip.endSeconds);
  double wanted = (solved.endSeconds - solved.startSeconds) / 3.0;
  if (!isDenselyKeyed(keys, clip.startSeconds, clip.endSeconds, clip.framesPerSecond)) {
    constexpr double later = 1e-5;
    const auto next = std::upper_bound(keys.begin(), keys.end(), solved.tipSeconds + later);
    const auto before = std::lower_bound(keys.begin(), keys.end(), solved.tipSeconds - later);
    if (forwards && next != keys.end()) {
      wanted = *next - solved.tipSeconds;
    } else if (!forwards && before != keys.begin()) {
      wanted = solved.tipSeconds - *(before - 1);
    }
  }
  return std::clamp(wanted, 0.0, std::max(0.0, limit));
}

void setWindow(SolvedTrail& solved, double fadeSeconds) {
  const bool forwards = solved.settings.pivot == Pivot::start;
  const double release = solved.release.seconds();
  solved.windowStartSeconds = solved.startSeconds - (forwards ? fadeSeconds : release);
  solved.windowEndSeconds = solved.endSeconds + (forwards ? release : fadeSeconds);
}

bool pullsPivot(const SolvedTrail& solved, double framesPerSecond) {
  const bool forwards = solved.settings.pivot == Pivot::start;
  const double pivotSeconds = forwards ? solved.startSeconds : solved.endSeconds;
  return glm::length(solved.offsets.at(pivotSeconds * framesPerSecond)) > 0.0;
}

} // namespace

void setRelease(const MotionInput& input, SolvedTrail& solved, const std::vector<NodeIndex>& nodes) {
  const double seconds = releaseSecondsOf(input, solved, nodes);
  solved.release = Release(seconds, solved.settings.overshoot);
  setWindow(solved, pullsPivot(solved, input.clip->framesPerSecond) ? seconds : 0.0);
}

} // namespace stretch::rig

#include "rig/motion/release_length.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "rig/motion/range_offset.h"
#include "rig/motion/solve_steps.h"

namespace stretch::rig {

namespace {

bool isForwards(const SolvedTrail& solved) {
  return solved.settings.pivot == Pivot::start;
}

// Over how long a time the speed of a stroke is told: half a frame and more, and where more frames are
// counted than the keys have, one of these.
double strokeSeconds(double keysPerSecond, double framesPerSecond) {
  constexpr double nearlyAll = 0.999;
  return keysPerSecond < framesPerSecond ? nearlyAll / keysPerSecond : 0.5 / framesPerSecond;
}

// Of the limb's end on its exaggerated path, seen from its base: units per second.
double fastestStroke(const SolvedTrail& solved, const Clip& clip) {
  const double leastSeconds = strokeSeconds(solved.times.spacing.keysPerSecond, clip.framesPerSecond);
  double fastest = 0.0;
  double lastSeconds = 0.0;
  std::optional<Vec3> last;
  for (const LimbSample& sample : solved.path.samples) {
    const double passed = sample.timeSeconds - lastSeconds;
    if (last && passed < leastSeconds) {
      continue;
    }
    const double weight = solved.remap.at(solved.path.ratioAt(sample.timeSeconds));
    const Vec3 reach = sample.end - sample.base +
                       rangeOffset(solved, sample, sample.timeSeconds * clip.framesPerSecond, weight);
    fastest = last ? std::max(fastest, glm::length(reach - *last) / passed) : fastest;
    last = reach;
    lastSeconds = sample.timeSeconds;
  }
  return fastest;
}

// The decay is at most 1.5 times as steep as a straight one, steeper where it swings past the original.
double calmSeconds(const SolvedTrail& solved, const Clip& clip) {
  const double fastest = fastestStroke(solved, clip);
  const double offset =
      glm::length(rangeOffset(solved, tipSample(solved), solved.tipSeconds * clip.framesPerSecond, 1.0));
  return fastest > 0.0 ? 1.5 * (1.0 + solved.settings.overshoot) * offset / fastest : 0.0;
}

// So much longer that the release ends on a frame.
double toWholeFrame(const SolvedTrail& solved, double seconds, double framesPerSecond) {
  const double direction = isForwards(solved) ? 1.0 : -1.0;
  const double edge = (direction * solved.tipSeconds + seconds) * framesPerSecond;
  return std::max(0.0, wholeFrameAtLeast(edge) / framesPerSecond - direction * solved.tipSeconds);
}

// On a loop until the range begins again: there the limb starts from its own path.
double roomFor(const MotionInput& input, const SolvedTrail& solved) {
  const Clip& clip = *input.clip;
  const double inside = isForwards(solved) ? clip.endSeconds - solved.endSeconds
                                           : solved.startSeconds - std::min(0.0, clip.startSeconds);
  const double range = solved.endSeconds - solved.startSeconds;
  const double room = input.loops ? clip.endSeconds - clip.startSeconds - range : inside;
  return std::max(0.0, std::min(room, longestFrames / clip.framesPerSecond));
}

} // namespace

std::optional<double> secondsToNextKey(const Clip& clip, const PathKey& key,
                                       const std::vector<NodeIndex>& nodes, const KeySpacing& keys) {
  if (keys.isDense) {
    return std::nullopt;
  }
  constexpr double later = 1e-5;
  const bool isForwards = key.pivot == Pivot::start;
  const double tipSeconds = (isForwards ? key.endFrame : key.startFrame) / clip.framesPerSecond;
  const std::vector<double> times = keyTimesOf(clip, nodes, isForwards ? tipSeconds : clip.startSeconds,
                                               isForwards ? clip.endSeconds : tipSeconds);
  const auto next = std::upper_bound(times.begin(), times.end(), tipSeconds + later);
  const auto before = std::lower_bound(times.begin(), times.end(), tipSeconds - later);
  if (isForwards) {
    return next == times.end() ? std::nullopt : std::optional(*next - tipSeconds);
  }
  return before == times.begin() ? std::nullopt : std::optional(tipSeconds - *(before - 1));
}

ReleaseLength releaseLength(const MotionInput& input, const SolvedTrail& solved) {
  const Clip& clip = *input.clip;
  ReleaseLength length;
  length.calmSeconds = calmSeconds(solved, clip) + solved.settings.lingerFrames / clip.framesPerSecond;
  if (solved.settings.releaseFrames) {
    length.wantedSeconds = *solved.settings.releaseFrames / clip.framesPerSecond;
  } else {
    const std::optional<double> nextKey = solved.times.nextKeySeconds;
    const double usual = nextKey.value_or((solved.endSeconds - solved.startSeconds) / 3.0);
    constexpr double hardlyFaster = 0.75; // The artist's own key is worth that much.
    const bool isLongEnough = nextKey && *nextKey >= hardlyFaster * length.calmSeconds;
    length.wantedSeconds =
        isLongEnough ? usual
                     : toWholeFrame(solved, std::max(usual, length.calmSeconds), clip.framesPerSecond);
  }
  length.seconds = std::clamp(length.wantedSeconds, 0.0, roomFor(input, solved));
  return length;
}

double firstSeconds(const MotionState& motion, const SolvedTrail& solved) {
  return motion.loops ? std::min(motion.startSeconds, solved.startSeconds) : 0.0;
}

bool pullsPivot(const SolvedTrail& solved, double framesPerSecond) {
  return glm::length(pivotOffset(solved, framesPerSecond)) > 0.0;
}

} // namespace stretch::rig

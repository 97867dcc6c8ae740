#include "rig/motion/range_offset.h"

namespace stretch::rig {

Vec3 rangeOffset(const SolvedTrail& solved, const LimbSample& sample, double frame, double weight) {
  const Vec3 original = solved.path.toSpace(sample, sample.end);
  Vec3 offset(0.0);
  if (solved.tip.outcome != TipOutcome::nothingToScale) {
    offset = weight * (exaggeratePoint(solved.tip, original) - original) + weight * solved.tip.pull;
  }
  return solved.path.axes * (offset + solved.offsets.at(frame));
}

Vec3 pivotOffset(const SolvedTrail& solved, double framesPerSecond) {
  const bool forwards = solved.settings.pivot == Pivot::start;
  return solved.offsets.at((forwards ? solved.startSeconds : solved.endSeconds) * framesPerSecond);
}

const LimbSample& tipSample(const SolvedTrail& solved) {
  return solved.settings.pivot == Pivot::start ? solved.path.samples.back() : solved.path.samples.front();
}

} // namespace stretch::rig

#include "app/evaluate/evaluate.h"

#include <utility>

#include "rig/motion/evaluate.h"

namespace stretch::app {

namespace {

WeightMotion weightOn(const EvaluationInput& input, const rig::MotionState& trails) {
  const WeightInput weight = weightInput(input);
  LimbSizes sizes;
  return activeWeights(weight).empty() ? WeightMotion{}
                                       : weightMotion(weight, sampleClip(weight, trails), sizes);
}

} // namespace

rig::MotionState prepareMotion(const Document& document, int clip) {
  const EvaluationInput input = evaluationInput(document, clip);
  rig::MotionState motion = solveTrails(input, {});
  addHolds(input, motion);
  if (std::vector<rig::LimbWeight> weights = weightOn(input, motion).weights; !weights.empty()) {
    addWeight(input, std::move(weights), motion);
  }
  return motion;
}

std::vector<WeightReport> weightReports(const Document& document, int clip) {
  const EvaluationInput input = evaluationInput(document, clip);
  rig::MotionState motion = solveTrails(input, {});
  addHolds(input, motion);
  WeightMotion made = weightOn(input, motion);
  addWeight(input, std::move(made.weights), motion);
  measureLengths(weightInput(input), motion, made.reports);
  return std::move(made.reports);
}

FrameState evaluate(const Document& document, const rig::MotionState& motion, double timeSeconds) {
  return rig::evaluateMotion(*document.scene, clipOrStill(*document.clips, motion.clip), motion, timeSeconds);
}

FrameState evaluateOriginal(const Document& document, int clip, double timeSeconds) {
  const Clip& shown = clipOrStill(*sourceClipsOf(document), clip);
  return frameOf(*document.scene, samplePose(*document.scene, shown, timeSeconds), timeSeconds);
}

std::vector<TrailPaths> trailPaths(const Document& document, const rig::MotionState& motion,
                                   std::size_t samplesPerFrame) {
  return drawPaths(evaluationInput(document, motion.clip).ground, motion, samplesPerFrame, {});
}

} // namespace stretch::app

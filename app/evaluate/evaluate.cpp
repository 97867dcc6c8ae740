#include "app/evaluate/evaluate.h"

#include "app/evaluate/cache.h"
#include "rig/motion/evaluate.h"

namespace stretch::app {

rig::MotionState prepareMotion(const Document& document, int clip) {
  return *EvaluationCache().motion(document, clip);
}

std::vector<WeightReport> weightReports(const Document& document, int clip) {
  return EvaluationCache().weightReports(document, clip);
}

FrameState evaluate(const Document& document, const rig::MotionState& motion, double timeSeconds) {
  return rig::evaluateMotion(*document.scene, clipOrStill(*document.clips, motion.clip), motion, timeSeconds);
}

FrameState evaluateOriginal(const Document& document, int clip, double timeSeconds) {
  return EvaluationCache().original(document, clip, timeSeconds);
}

std::vector<TrailPaths> trailPaths(const Document& document, const rig::MotionState& motion,
                                   std::size_t samplesPerFrame) {
  return drawPaths(evaluationInput(document, motion.clip).ground, motion, samplesPerFrame, {});
}

} // namespace stretch::app

#include "rig/motion/evaluate.h"

#include <algorithm>

#include "rig/motion/apply.h"

namespace stretch::rig {

FrameState sampledFrame(const Scene& scene, const Clip& clip, double timeSeconds) {
  const double heldSeconds = std::min(timeSeconds, clip.endSeconds);
  return frameOf(scene, samplePose(scene, clip, heldSeconds), heldSeconds);
}

void applyTrails(const Scene& scene, const MotionState& motion, FrameState& frame) {
  const FrameState source = frame;
  for (std::size_t trail = 0; trail < motion.trails.size(); ++trail) {
    if (motion.trails[trail].active) {
      applyTrail(scene, motion, trail, source, frame);
    }
  }
}

FrameState evaluateMotion(const Scene& scene, const Clip& clip, const MotionState& motion,
                          double timeSeconds) {
  FrameState frame = sampledFrame(scene, clip, timeSeconds);
  applyTrails(scene, motion, frame);
  applyWeight(scene, motion.weights, motion.hips, frame);
  frame.timeSeconds = timeSeconds;
  return frame;
}

} // namespace stretch::rig

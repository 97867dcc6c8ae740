#include <algorithm>

#include "rig/motion/apply.h"
#include "rig/motion/motion.h"

namespace stretch::rig {

FrameState evaluateMotion(const Scene& scene, const Clip& clip, const MotionState& motion,
                          double timeSeconds) {
  // Past the last key every track is held, and so is what the trails make of it.
  const double heldSeconds = std::min(timeSeconds, clip.endSeconds);
  FrameState frame = frameOf(scene, samplePose(scene, clip, heldSeconds), heldSeconds);
  const FrameState source = frame;
  for (const SolvedTrail& solved : motion.trails) {
    if (solved.active) {
      applyTrail(scene, motion, solved, source, frame);
    }
  }
  applyWeight(scene, motion.weights, motion.hips, frame);
  frame.timeSeconds = timeSeconds;
  return frame;
}

} // namespace stretch::rig

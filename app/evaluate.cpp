#include "app/evaluate.h"

#include <algorithm>

namespace stretch::app {

namespace {

std::vector<rig::Limb> allLimbs(const Document& document) {
  std::vector<rig::Limb> limbs = document.biped.limbs;
  limbs.insert(limbs.end(), document.chains.begin(), document.chains.end());
  return limbs;
}

std::vector<rig::Trail> trailsOf(const Document& document, int clip) {
  std::vector<rig::Trail> trails;
  std::copy_if(document.trails.begin(), document.trails.end(), std::back_inserter(trails),
               [&](const rig::Trail& trail) { return trail.clip == clip; });
  return trails;
}

bool loops(const Document& document, int clip) {
  return std::find(document.loopingClips.begin(), document.loopingClips.end(), clip) !=
         document.loopingClips.end();
}

// A file without a clip shows the character at rest.
const Clip& clipOrStill(const Document& document, int clip, const Clip& still) {
  return clip >= 0 && static_cast<std::size_t>(clip) < document.clips->size() ? clipOf(document, clip)
                                                                              : still;
}

} // namespace

rig::MotionState prepareMotion(const Document& document, int clip) {
  const Clip still;
  rig::MotionInput input;
  input.scene = document.scene.get();
  input.clip = &clipOrStill(document, clip, still);
  input.clipIndex = clip;
  input.biped = &document.biped;
  input.limbs = allLimbs(document);
  input.trails = trailsOf(document, clip);
  input.loops = loops(document, clip);
  return rig::solveMotion(input);
}

FrameState evaluate(const Document& document, const rig::MotionState& motion, double timeSeconds) {
  const Clip still;
  return rig::evaluateMotion(*document.scene, clipOrStill(document, motion.clip, still), motion, timeSeconds);
}

FrameState evaluateOriginal(const Document& document, int clip, double timeSeconds) {
  const Clip still;
  return frameOf(*document.scene,
                 samplePose(*document.scene, clipOrStill(document, clip, still), timeSeconds), timeSeconds);
}

EvaluationCache::MotionKey EvaluationCache::keyOf(const Document& document, int clip) {
  return {document.scene.get(),     document.clips.get(), clip,
          trailsOf(document, clip), allLimbs(document),   document.loopingClips};
}

const rig::MotionState& EvaluationCache::motion(const Document& document, int clip) {
  MotionKey key = keyOf(document, clip);
  if (!motion_ || !(key == motionKey_)) {
    motion_ = std::make_shared<const rig::MotionState>(prepareMotion(document, clip));
    motionKey_ = std::move(key);
  }
  return *motion_;
}

const FrameState& EvaluationCache::frame(const Document& document, int clip, double timeSeconds) {
  static_cast<void>(motion(document, clip));
  if (frameMotion_ != motion_ || frameSeconds_ != timeSeconds) {
    frame_ = evaluate(document, *motion_, timeSeconds);
    frameMotion_ = motion_;
    frameSeconds_ = timeSeconds;
  }
  return frame_;
}

const FrameState& EvaluationCache::original(const Document& document, int clip, double timeSeconds) {
  if (originalClips_ != document.clips.get() || originalClip_ != clip || originalSeconds_ != timeSeconds) {
    original_ = evaluateOriginal(document, clip, timeSeconds);
    originalClips_ = document.clips.get();
    originalClip_ = clip;
    originalSeconds_ = timeSeconds;
  }
  return original_;
}

} // namespace stretch::app

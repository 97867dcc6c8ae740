#include "app/evaluate/missed_places.h"

#include <algorithm>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/evaluate/hold_report.h"
#include "core/anim/frames.h"
#include "rig/adjust/apply_adjustments.h"
#include "rig/motion/evaluate.h"

namespace stretch::app {

namespace {

// The half frames of the clip, and the keys between them.
std::vector<double> lookedAtFrames(const rig::MotionState& motion) {
  std::vector<double> frames = halfFramesOf(motion);
  const double last = frames.back();
  for (const auto& [id, curves] : motion.adjustments.curves) {
    for (const rig::OffsetCurve& curve : curves) {
      for (const double seconds : curve.keySeconds()) {
        frames.push_back(seconds * motion.framesPerSecond);
      }
    }
  }
  std::erase_if(frames, [&](double frame) { return frame < 0.0 || frame > last + frameTolerance; });
  std::ranges::sort(frames);
  frames.erase(std::unique(frames.begin(), frames.end(), sameFrame), frames.end());
  return frames;
}

MissedPlace& missedBy(const std::string& controller, std::vector<MissedPlace>& all) {
  const auto known = std::ranges::find(all, controller, &MissedPlace::controller);
  return known != all.end() ? *known : all.emplace_back(MissedPlace{controller, {}, 0.0, 0.0});
}

} // namespace

std::vector<MissedPlace> missedPlaces(const Document& document, const rig::MotionState& motion) {
  constexpr double seen = 1e-3; // of the height
  std::vector<MissedPlace> all;
  if (motion.adjustments.empty()) {
    return all;
  }
  const Clip& clip = clipOf(document, motion.clip);
  for (const double frame : lookedAtFrames(motion)) {
    FrameState state = rig::sampledFrame(*document.scene, clip, frame / clip.framesPerSecond);
    for (const rig::AskedPlace& asked : rig::applyAdjustments(*document.scene, motion.adjustments, state)) {
      if (asked.controller == "body") { // which moves as one piece, and whose hips may go on by their own
                                        // offset
        continue;
      }
      const Vec3 reached = rig::controllerPlace(motion.adjustments, asked.controller, state);
      const double miss = glm::length(reached - asked.place);
      if (miss <= seen * document.body.height) {
        continue;
      }
      MissedPlace& missed = missedBy(asked.controller, all);
      missed.frames.push_back(frame);
      if (miss > missed.farthest) {
        missed.farthest = miss;
        missed.worstFrame = frame;
      }
    }
  }
  return all;
}

std::string missWarning(const MissedPlace& missed) {
  const bool once = missed.frames.size() == 1;
  const std::string when =
      once ? fmt::format("frame {:g} by {:.4g}", missed.worstFrame, missed.farthest)
           : fmt::format("frames {:g} to {:g} by up to {:.4g}, most at frame {:g}", missed.frames.front(),
                         missed.frames.back(), missed.farthest, missed.worstFrame);
  return fmt::format("{} misses its place at {}: its limb is not to stretch so far", missed.controller, when);
}

} // namespace stretch::app

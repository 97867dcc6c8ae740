#pragma once

#include <memory>
#include <vector>

#include "app/document.h"
#include "core/anim/frame_state.h"
#include "rig/motion.h"

namespace stretch::app {

/// The trails of one clip, prepared for evaluation at any time. Active trails only move the character; the
/// others are prepared too, so that their paths can be drawn.
[[nodiscard]] rig::MotionState prepareMotion(const Document& document, int clip);

/// The character at one time (seconds of the clip), trails included. The one function that renderer, panels,
/// batch and tests read.
[[nodiscard]] FrameState evaluate(const Document& document, const rig::MotionState& motion,
                                  double timeSeconds);

/// The clip as the source has it.
[[nodiscard]] FrameState evaluateOriginal(const Document& document, int clip, double timeSeconds);

/// Remembers the last answers; keys on the identity and value of what they were made from, so nobody
/// invalidates it.
class EvaluationCache {
public:
  [[nodiscard]] const rig::MotionState& motion(const Document& document, int clip);
  [[nodiscard]] const FrameState& frame(const Document& document, int clip, double timeSeconds);
  [[nodiscard]] const FrameState& original(const Document& document, int clip, double timeSeconds);

private:
  struct MotionKey {
    const Scene* scene = nullptr;
    const void* clips = nullptr;
    int clip = -1;
    std::vector<rig::Trail> trails;
    std::vector<rig::Limb> limbs;
    std::vector<int> looping;
    friend bool operator==(const MotionKey&, const MotionKey&) = default;
  };
  [[nodiscard]] static MotionKey keyOf(const Document& document, int clip);

  MotionKey motionKey_;
  std::shared_ptr<const rig::MotionState> motion_;
  std::shared_ptr<const rig::MotionState> frameMotion_;
  double frameSeconds_ = 0.0;
  FrameState frame_;
  const void* originalClips_ = nullptr;
  int originalClip_ = -1;
  double originalSeconds_ = 0.0;
  FrameState original_;
};

} // namespace stretch::app

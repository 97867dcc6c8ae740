#pragma once

#include <vector>

#include "app/document.h"
#include "app/evaluate/evaluation_input.h"
#include "app/weight/report.h"
#include "core/anim/frame_state.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// The trails, the holds and the weight of limbs of one clip, prepared for evaluation at any time. Active
/// trails only move the character; the others are prepared too, so that their paths can be drawn.
[[nodiscard]] rig::MotionState prepareMotion(const Document& document, int clip);

/// Reports what the limbs of a clip that have weight come to.
[[nodiscard]] std::vector<WeightReport> weightReports(const Document& document, int clip);

/// The character at one time (seconds of the clip), trails, holds and weight included. The one function that
/// renderer, panels, batch and tests read.
[[nodiscard]] FrameState evaluate(const Document& document, const rig::MotionState& motion,
                                  double timeSeconds);

/// The clip as the source has it.
[[nodiscard]] FrameState evaluateOriginal(const Document& document, int clip, double timeSeconds);

/// One for each trail of `motion`, `samplesPerFrame` samples per frame.
[[nodiscard]] std::vector<TrailPaths> trailPaths(const Document& document, const rig::MotionState& motion,
                                                 std::size_t samplesPerFrame);

} // namespace stretch::app

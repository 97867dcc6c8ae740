#pragma once

#include <cstddef>

#include "app/auto/clip_ground.h"
#include "rig/motion/motion.h"

namespace stretch::app {

/// Limbs at both ends of a clip that is played as a loop, and a little inside each.
struct LoopSeam {
  LimbPlaces first = {};
  LimbPlaces afterFirst = {};
  LimbPlaces beforeLast = {};
  LimbPlaces last = {};
};

/// Seam of the ground's clip with what a document does to it.
[[nodiscard]] LoopSeam seamOf(const ClipGround& ground, const Document& document,
                              const rig::MotionState& motion);

/// Seam of the clip itself.
[[nodiscard]] LoopSeam seamOfSource(const ClipGround& ground);

/// Whether a limb, by its place in ClipGround::limbs, is farther from its place or turns more sharply from
/// the last pose to the first than in the source: by more than 8 mm or 0.06 m/s of a person.
[[nodiscard]] bool closesWorse(const ClipGround& ground, const LoopSeam& now, const LoopSeam& source,
                               std::size_t limb);

} // namespace stretch::app

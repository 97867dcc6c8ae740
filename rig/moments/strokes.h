#pragma once

#include <cstddef>
#include <vector>

#include "rig/moments/body_motion.h"

namespace stretch::rig {

/// A stroke by the samples of a motion (BodyMotion), from its start over the fastest sample to its tip.
struct SampledStroke {
  std::size_t start = 0;
  std::size_t peak = 0;
  std::size_t tip = 0;
  double strength = 0.0;
};

/// The strokes of one limb of the motion, strongest first; they share at most their ends. `velocities`: of
/// its places. `goesRound`: the limb is in a cycle, where every way leads back to the beginning and a leg's
/// ways are steps; elsewhere one or two steps only carry the body and count less.
[[nodiscard]] std::vector<SampledStroke> strokesOf(const BodyMotion& motion, const LimbMotion& limb,
                                                   const Velocities& velocities, bool goesRound);

} // namespace stretch::rig

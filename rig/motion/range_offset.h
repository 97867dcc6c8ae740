#pragma once

#include "rig/motion/motion.h"

namespace stretch::rig {

/// How far the exaggerated path is from the original at a time of the range, with the spheres' pull: w(r)
/// E(c) - c (docs/exaggeration.md, Remap and ease), world space. `sample`: of the source at that time,
/// `frame`: the same time in frames, `weight`: w there.
[[nodiscard]] Vec3 rangeOffset(const SolvedTrail& solved, const LimbSample& sample, double frame,
                               double weight);

/// How far a sphere pulls the end of the range that stays, along the axes of the trail's space.
[[nodiscard]] Vec3 pivotOffset(const SolvedTrail& solved, double framesPerSecond);

/// The sample at the tip.
[[nodiscard]] const LimbSample& tipSample(const SolvedTrail& solved);

} // namespace stretch::rig

#pragma once

#include <vector>

#include "core/math/types.h"

namespace stretch::rig {

/// Frames over which a foot keeps its place, both ends included.
struct Stand {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Where a foot rests: slower than a quarter of the leg's length a second, for a tenth of a second at least.
/// One place and one time for each frame; none for less than two frames.
[[nodiscard]] std::vector<Stand> standsOf(const std::vector<Vec3>& places, const std::vector<double>& seconds,
                                          double legLength);

/// The wishes, made one and the same over each stand (their mean), and carried over smoothly from stand to
/// stand. Without a stand they stay as they are.
[[nodiscard]] std::vector<Vec3> heldOver(const std::vector<Stand>& stands, std::vector<Vec3> wishes);

/// A curve that is nowhere below the given one and rises and falls over `frames`.
[[nodiscard]] std::vector<double> easedAbove(const std::vector<double>& needed, std::size_t frames);

} // namespace stretch::rig

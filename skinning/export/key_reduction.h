#pragma once

#include <cstddef>
#include <vector>

namespace stretch::skinning {

/// Values of a property over the frames: 3 numbers per frame, or 4 (x, y, z, w) for rotations.
using Course = std::vector<float>;

/// The frames that are enough as keys: what is interpolated between them (linearly, rotations along the
/// shorter arc) is nowhere farther than `bound` from the course. The first and the last frame are keys.
/// Distances are those of the vectors, and angles in radians of rotations. A bound of 0 keeps every frame.
[[nodiscard]] std::vector<std::size_t> keysWithin(const Course& course, std::size_t width, double bound);

/// Whether no frame is farther than `bound` from the first one, in the same measure.
[[nodiscard]] bool staysWithin(const Course& course, std::size_t width, double bound);

} // namespace stretch::skinning

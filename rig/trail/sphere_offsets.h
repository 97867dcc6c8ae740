#pragma once

#include <vector>

#include "rig/trail/trail.h"

namespace stretch::rig {

/// The offset o(t) that pulled control spheres add to a path (docs/exaggeration.md, Control spheres): cubic
/// Hermite in time through one offset for each control sphere, with three-point tangents where a sphere has
/// none of its own: C1, equal steps give a straight ramp, nothing moves beyond the second neighbours.
class SphereOffsets {
public:
  SphereOffsets() = default;
  /// `controlFrames`: all spheres of the trail, ascending; those not named in `pulled` have offset 0. Pulled
  /// spheres at frames that are no control frame become control frames.
  SphereOffsets(const std::vector<double>& controlFrames, const std::vector<SphereOffset>& pulled);

  /// Held before the first and after the last sphere.
  [[nodiscard]] Vec3 at(double frame) const;
  /// The slope at a sphere's frame, for each frame of time; between spheres that of the curve. 0 outside.
  [[nodiscard]] Vec3 slopeAt(double frame) const;
  [[nodiscard]] bool empty() const { return frames_.empty(); }

private:
  std::vector<double> frames_;
  std::vector<Vec3> values_;
  std::vector<Vec3> slopes_; ///< Per frame.
};

} // namespace stretch::rig

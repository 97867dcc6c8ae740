#pragma once

#include "core/math/types.h"

namespace stretch::assets {

/// Signed distance to the whole body in the bind pose, metres: skin, hair, gloves, trunks and boots are one
/// surface. Near the surface the gradient is about 1 long; far away it is a lower estimate.
[[nodiscard]] double bodyDistance(const Vec3& point);

/// Outward unit normal of the surface through (or near) `point`.
[[nodiscard]] Vec3 bodyNormal(const Vec3& point);

/// Moves a point that is near the surface onto it, along the gradient.
[[nodiscard]] Vec3 projectToBody(const Vec3& point);

/// Distances to what the body is made of, metres; the body is their union.
struct Layers {
  double skin = 0.0;
  double hair = 0.0;
  double glove = 0.0;
  double boot = 0.0;
  double trunks = 0.0;
  double waistband = 0.0;
};

[[nodiscard]] Layers layersAt(const Vec3& point);

/// How far a point on either side lies along the glove's axis, from the wrist towards the knuckles; negative
/// on the cuff.
[[nodiscard]] double gloveReach(const Vec3& point);

/// The left glove's own frame: columns point from the wrist to the knuckles, towards the thumb, out of the
/// palm.
[[nodiscard]] Mat3 gloveAxes();

} // namespace stretch::assets

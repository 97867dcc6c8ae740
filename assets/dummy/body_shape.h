#pragma once

#include "core/math/types.h"

namespace stretch::assets {

/// Distances to what the body is made of, metres, bind pose; the body is their union. What is far away is
/// `farAway`.
struct Layers {
  double skin = 0.0;
  double hair = 0.0;
  double glove = 0.0;
  double boot = 0.0;
  double trunks = 0.0;
  double waistband = 0.0;
};

inline constexpr double farAway = 1.0;
inline constexpr double trunksHem = 0.655; ///< Height of the trunks' lower edge.
inline constexpr double bootHem = 0.262;   ///< Height of the boots' upper edge.
inline constexpr double cuffEnd = -0.078;  ///< Reach of the glove's open end (see gloveReach).

[[nodiscard]] Layers layersAt(const Vec3& point);

/// Signed distance to the whole body in the bind pose, metres: skin, hair, gloves, trunks and boots are one
/// surface. Near the surface the gradient is about 1 long.
[[nodiscard]] double bodyDistance(const Vec3& point);

/// Outward unit normal of the surface through (or near) `point`.
[[nodiscard]] Vec3 bodyNormal(const Vec3& point);

/// The same of one layer alone: where two meet in a crease each has its own.
[[nodiscard]] Vec3 layerNormal(double Layers::*layer, const Vec3& point);

/// Moves a point that is near the surface onto it, along the gradient.
[[nodiscard]] Vec3 projectToBody(const Vec3& point);

/// How far a point on either side lies along the glove's axis, metres from the wrist towards the knuckles;
/// negative on the cuff.
[[nodiscard]] double gloveReach(const Vec3& point);

} // namespace stretch::assets

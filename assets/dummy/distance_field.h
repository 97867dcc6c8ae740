#pragma once

#include "core/math/types.h"

namespace stretch::assets {

// Signed distances in metres (negative inside). Only sums, products and square roots: the same bits on every
// machine.

/// Axis-aligned ellipsoid; a first-order distance, exact on the surface. Radii above 0.
[[nodiscard]] double ellipsoidDistance(const Vec3& point, const Vec3& center, const Vec3& radii);

/// Ellipsoid whose axes are the columns of `axes` (orthonormal).
[[nodiscard]] double ellipsoidDistance(const Vec3& point, const Vec3& center, const Vec3& radii,
                                       const Mat3& axes);

/// Convex hull of two spheres. When one sphere holds the other it is the larger sphere.
[[nodiscard]] double roundConeDistance(const Vec3& point, const Vec3& start, const Vec3& end,
                                       double startRadius, double endRadius);

[[nodiscard]] double sphereDistance(const Vec3& point, const Vec3& center, double radius);

/// Union of two shapes whose crease is filled over `width` metres (cubic polynomial, C2). Width 0 is the
/// plain union.
[[nodiscard]] double smoothUnion(double a, double b, double width);

/// Intersection of two shapes with its edge rounded over `width` metres.
[[nodiscard]] double smoothIntersection(double a, double b, double width);

/// Gradient of a field of distances, by central differences of a tenth of a millimetre.
template <typename Field>
[[nodiscard]] Vec3 gradientOf(const Field& field, const Vec3& point) {
  constexpr double step = 1e-4;
  const auto slope = [&](const Vec3& offset) { return field(point + offset) - field(point - offset); };
  return Vec3(slope({step, 0.0, 0.0}), slope({0.0, step, 0.0}), slope({0.0, 0.0, step})) / (2.0 * step);
}

} // namespace stretch::assets

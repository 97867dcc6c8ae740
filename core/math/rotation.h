#pragma once

#include "core/math/types.h"

namespace stretch {

/// Rotation by an angle in radians about a unit axis, right-handed.
[[nodiscard]] Quat axisAngle(const Vec3& unitAxis, double angleRadians);

/// Smallest rotation that turns the direction of `from` into that of `to`; exact at 0 degrees. For opposite
/// directions any perpendicular axis; identity when either vector has no length.
[[nodiscard]] Quat shortestArc(const Vec3& from, const Vec3& to);

/// A unit vector perpendicular to `direction`; the x axis for a vector without length.
[[nodiscard]] Vec3 anyPerpendicular(const Vec3& direction);

/// Angle between two vectors in radians, accurate near 0 and pi; 0 when either has no length.
[[nodiscard]] double angleBetween(const Vec3& a, const Vec3& b);

/// Cosine of that angle; 0 when either has no length.
[[nodiscard]] double cosineBetween(const Vec3& a, const Vec3& b);

/// Angle in radians, 0..pi, by which one unit rotation turns further than the other.
[[nodiscard]] double angleBetween(const Quat& a, const Quat& b);

/// Whether a unit rotation turns anything, by more than rounding does.
[[nodiscard]] bool isTurn(const Quat& rotation);

} // namespace stretch

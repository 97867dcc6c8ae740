#pragma once

#include "core/math/types.h"

namespace stretch {

// A rotation as three angles X, Y, Z in radians: turned about the fixed axes X, then Y, then Z.

/// Angles of the rotation that are nearest to `previous`, of all that say the same: a curve without jumps.
[[nodiscard]] Vec3 eulerNear(const Quat& rotation, const Vec3& previous);

[[nodiscard]] Quat rotationOf(const Vec3& angles);

/// How the quaternion rotationOf(angles) changes while the angles change at `rates`: the same unit of time.
/// Order (w, x, y, z) as a quaternion.
[[nodiscard]] Quat rotationRate(const Vec3& angles, const Vec3& rates);

/// The rates of the angles (those of `angles`, which say the direction of `rotation`) while the quaternion,
/// of any length above 0, changes by `rate`.
[[nodiscard]] Vec3 eulerRate(const Quat& rotation, const Quat& rate, const Vec3& angles);

} // namespace stretch

#pragma once

#include <vector>

#include "core/math/types.h"

namespace stretch::rig {

/// Corners of the smallest tetrahedron, of those that were tried, that holds all points; `axes` turns the x
/// axis onto the bone. Points in a plane or on a line get one that is a thousandth as thick as it is long. At
/// least one point.
[[nodiscard]] std::vector<Vec3> enclosingTetrahedron(const std::vector<Vec3>& points, const Quat& axes);

/// The points on the line through the origin along `direction` (a unit vector) that hold all points between
/// them, seen along it; one on each side of the origin that has any.
[[nodiscard]] std::vector<Vec3> enclosingEnds(const std::vector<Vec3>& points, const Vec3& direction);

/// Affine coordinates of a point: how much it belongs to each corner, none below 0, together 1. Of one or two
/// ends what is missing to 1 belongs to the origin, and the point counts by its place along them.
[[nodiscard]] std::vector<double> affineCoordinates(const std::vector<Vec3>& corners, const Vec3& point);

} // namespace stretch::rig

#pragma once

#include <vector>

#include "core/math/types.h"

namespace stretch::rig {

/// A spine at one time, to follow its three controls. World space.
struct SplineSpineProblem {
  std::vector<Vec3> points;  ///< p_0 .. p_n, base first: at least two.
  std::vector<double> along; ///< u of each: rest arc length over the whole, 0..1, ascending.
  Vec3 low{0.0};             ///< How far each control is moved.
  Vec3 middle{0.0};
  Vec3 top{0.0};
  Vec3 turn{0.0}; ///< Turn of the top: rotation vector, axis times angle; more than half a turn is possible.
  double stretchSwitch = 1.0;
};

/// Turns and stretches that bring the spine there.
struct SplineSpineShape {
  std::vector<Vec3> wanted; ///< Places that the controls ask for.
  std::vector<Vec3> points; ///< Places that the points come to, as long as the switch lets the bones become.
  std::vector<Quat> turns;  ///< Turn of each bone, world space, about its start.
  std::vector<double> stretches;    ///< Stretch of each bone.
  Quat topTurn{1.0, 0.0, 0.0, 0.0}; ///< Turn of the last point's joint, world space.
};

/// docs/controllers.md, Spine. Exactly the identity where no control has moved or turned. Bones without
/// length stay as they are.
[[nodiscard]] SplineSpineShape solveSplineSpine(const SplineSpineProblem& problem);

/// The points at these arc lengths along a polyline, counted from its start, which continues straight past
/// its end.
[[nodiscard]] std::vector<Vec3> laidAlong(const std::vector<Vec3>& polyline,
                                          const std::vector<double>& lengths);

/// The rotation of a rotation vector: its direction the axis, its length the angle in radians.
[[nodiscard]] Quat rotationOfVector(const Vec3& rotationVector);

} // namespace stretch::rig

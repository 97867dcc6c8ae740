#pragma once

#include <vector>

#include "core/math/types.h"
#include "rig/trail/trail.h"

namespace stretch::rig {

inline constexpr double smallestStretch = 0.05;
inline constexpr double largestStretch = 25.0;

/// One limb at one time, to be brought to a target (docs/rig.md, The shape of a stretched limb).
/// World space.
struct LimbShapeProblem {
  std::vector<Vec3> points; ///< Joints, base first, and the end: at least two.
  Vec3 target{0.0};         ///< F.
  Vec3 bendNormal{0.0}; ///< Unit normal of the bend plane: the axis of the elbow or knee. Zero: taken from
                        ///< the points.
  double shortestReach = 0.0; ///< d0 is never taken shorter than this (1e-3 of the rest length).
  double stretchSwitch = 1.0; ///< 0..1.
  Bend bend = Bend::keep;
  double restLength = 0.0;       ///< L_rest, for straighten.
  double straightenAmount = 1.0; ///< k = switch * w * b / 2 * release, for straighten.
  bool grows = true;             ///< S >= 1: a straightening limb is never squashed.
};

enum class ShapeOutcome { reached, clamped, degenerate };

/// Turns and stretches that bring the limb there: bone i turns by turns[i] (world space, about its joint) and
/// is stretched to s times its length.
struct LimbShape {
  std::vector<Quat> turns;
  double stretch = 1.0; ///< s, within [smallestStretch, largestStretch].
  Vec3 end{0.0};        ///< Place that the limb's end comes to.
  ShapeOutcome outcome = ShapeOutcome::reached;

  /// Whether nothing changes.
  [[nodiscard]] bool isIdentity() const;
};

/// Keep: grown and turned as one shape. Straighten: two bones by the law of cosines in the bend plane carried
/// over, longer chains by uncurling towards the chord or by rolling up; a single bone has no bend and is
/// kept. The identity when the target is where the end is and nothing stretches. Finite for every finite
/// input: a limb without length stays as it is (degenerate).
[[nodiscard]] LimbShape solveLimbShape(const LimbShapeProblem& problem);

/// Smallest turn of `from` to `to`; between 150 and 170 degrees it goes over into a turn about `normal`, so
/// that it stays continuous where the smallest turn has no direction.
[[nodiscard]] Quat steadyTurn(const Vec3& from, const Vec3& to, const Vec3& normal);

} // namespace stretch::rig

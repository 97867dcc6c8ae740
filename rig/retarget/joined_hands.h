#pragma once

#include <array>
#include <optional>
#include <vector>

#include "rig/retarget/skeleton.h"

namespace stretch::rig {

/// How much two hands work together at one time, and how far the one is from the other then.
struct JoinedHands {
  /// 0..1: 1 where the wrists are nearer to each other than the elbows, which is so whatever the arms'
  /// length, and in front of the trunk, over it or behind it: arms that hang at the sides do no work
  /// together.
  double share = 0.0;
  Vec3 leftToRight{0.0}; ///< From wrist to wrist, world space, in widths of the shoulders.
};

/// Distance between the first joints of both arms in the bind pose, world units; nothing where an arm is
/// missing.
[[nodiscard]] std::optional<double> shoulderWidth(const Skeleton& skeleton);

/// `worlds`: of the skeleton's nodes. `width`: its shoulderWidth, > 0. An arm of one bone does no work with
/// the other.
[[nodiscard]] JoinedHands joinedHands(const Skeleton& skeleton, const std::vector<Mat4>& worlds,
                                      double width);

struct Ball {
  Vec3 centre{0.0};
  double radius = 0.0; ///< > 0
};

/// Returns a place in both balls that is near the wanted one, by turns the nearest in each; where they do not
/// meet, a place between them.
[[nodiscard]] Vec3 middleInReach(const std::array<Ball, 2>& balls, const Vec3& wanted);

} // namespace stretch::rig

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "skinning/bind/bone_lines.h"

namespace stretch::skinning {

/// A point of a bone.
struct OnBone {
  std::size_t line = 0; ///< Index into the bone lines.
  double along = 0.0;   ///< 0 at its start, 1 at its end.
};

/// The point of a line that is nearest to a place.
[[nodiscard]] double nearestAlong(const BoneLine& line, const Vec3& place);

/// The nearest point of some of the lines (`among`), and how far it is.
[[nodiscard]] std::pair<OnBone, double>
nearestOnBones(const std::vector<BoneLine>& lines, const std::vector<std::size_t>& among, const Vec3& place);

/// Ways along the skeleton, from joint to joint. They tell what belongs together from what only touches: two
/// legs side by side, a hand on a thigh are near each other across the gap and far along the bones.
class SkeletonWays {
public:
  SkeletonWays(const std::vector<BindJoint>& joints, const std::vector<BoneLine>& lines);

  [[nodiscard]] double between(const OnBone& a, const OnBone& b) const;

  /// How much two bones may share what lies between them: 1 where the way along the skeleton is about as long
  /// as the way across (`across`), 0 where it is several times as long.
  [[nodiscard]] double kinship(const OnBone& a, const OnBone& b, double across) const;

private:
  [[nodiscard]] double betweenJoints(int a, int b) const;
  [[nodiscard]] Vec3 pointOf(const OnBone& on) const;

  const std::vector<BoneLine>& lines_;
  std::vector<int> parents_;
  std::vector<Vec3> places_;
  std::vector<int> generations_;  ///< Number of joints above each joint.
  std::vector<double> fromRoots_; ///< Length along the bones to each joint.
};

} // namespace stretch::skinning

#pragma once

#include <vector>

#include "core/math/types.h"

namespace stretch::rig {

/// Which way an elbow or knee bends over a clip, seen from the base joint, in whose frame it hardly moves.
/// Where the limb is nearly straight, or overextended, the pose does not tell: the nearest times at which it
/// bends do.
class BendDirections {
public:
  /// `unseen`: for a limb that never bends, unit, in the space of the base joint.
  explicit BendDirections(const Vec3& unseen = Vec3(0.0)) : unseen_(unseen) {}

  /// Takes in one pose, later than those before: base, joint and end, world space, and the base joint's world
  /// rotation. A pose that is nearly straight says nothing.
  void add(double timeSeconds, const Vec3& base, const Vec3& joint, const Vec3& end,
           const Quat& baseRotation);

  /// After the last pose: forgets those in which the limb is overextended, bent a little against what the
  /// clear bends and `unseen` tell, and those that are not clear. Where no bend is clear, `unseen` becomes
  /// what they tell together.
  void keepClear();

  /// Unit, in the space of the base joint, or zero. Between two times at which the limb bends it goes over
  /// evenly from the one's to the other's; before the first and after the last it is theirs.
  [[nodiscard]] Vec3 at(double timeSeconds) const;

private:
  struct Seen {
    double timeSeconds = 0.0;
    Vec3 direction{0.0};
    double height = 0.0; // of the limb's length
  };
  std::vector<Seen> seen_;
  Vec3 unseen_;
};

} // namespace stretch::rig

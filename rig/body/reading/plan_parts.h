#pragma once

#include <optional>
#include <vector>

#include "rig/body/reading/extremities.h"
#include "rig/limb.h"

namespace stretch::rig::body {

/// A pair of limbs of some kind.
struct KindredPair {
  LimbKind kind = LimbKind::leg;
  ExtremityPair pair;
  bool stands = false;
  bool isGuessed = false; ///< No name tells whether they are arms or wings, or wings or feelers.
};

/// The middle of a body that is no upright one: candidates, each list from the hips outwards.
struct Axis {
  std::vector<int> row; ///< From the topmost joint to the end of the head.
  int hips = -1;        ///< Carries all legs; of the row.
  int head = -1;
  std::vector<int> spine;
  int spineEnd = -1;
  std::vector<int> neck;         ///< Ends at the head.
  std::optional<Extremity> tail; ///< Without the joints that it shares with the row.
  bool headIsNamed = false;
  bool frontIsTold = true;     ///< Names or shape tell which end is the head; false: either may be.
  Vec3 forward{0.0, 0.0, 1.0}; ///< Unit, in the mirror plane, level.
};

/// Parts of a body, as far as plans ask.
struct PlanParts {
  std::vector<KindredPair> pairs; ///< Pairs of each kind from front to back.
  Axis axis;
  Extremities extremities;

  [[nodiscard]] int standingLegs() const;
};

/// `legPairs`: how many the user says there are; nothing: as many as stand on the ground.
[[nodiscard]] PlanParts partsOfBody(const Scene& scene, const BindPose& bindPose, const BodyView& view,
                                    const MirrorPlane& plane, const Vec3& up, std::optional<int> legPairs);

} // namespace stretch::rig::body

#pragma once

#include <optional>

#include "rig/body/reading/limb_guess.h"

namespace stretch::rig::body {

/// Two limbs that mirror each other, or one alone.
struct LimbPair {
  std::optional<LimbGuess> negative; ///< On the negative side of the mirror plane.
  std::optional<LimbGuess> positive;
  double mirrorError = 0.0; ///< Mean distance of a joint from its counterpart's mirror image, in lengths of
                            ///< the limb.
  double score = 0.0;
};

/// Which pair is the arms and which the legs.
struct BipedReading {
  std::optional<LimbPair> arms;
  std::optional<LimbPair> legs;
  double score = 0.0;
  double relation = 0.0;     ///< How well arms and legs sit on one trunk, -2..2; 0 where one pair is missing.
  double armsAhead = 1e9;    ///< By how much the score is better than with other rows of joints as arms.
  double legsAhead = 1e9;    ///< Likewise as legs.
  bool hasOtherArms = false; ///< Another pair of arms is named as well.
};

/// The best reading of arms and legs together: each by itself, the two of a pair by symmetry, arms and legs
/// by where they sit on the trunk (legs point away from the arms and end lowest, the head is near the arms).
[[nodiscard]] BipedReading readBiped(const BodyView& view, const MirrorPlane& plane);

/// Whether names say of the better named one of a pair that it is what it is read as.
[[nodiscard]] bool isNamed(const LimbPair& pair);

/// The joint that both limbs of a pair hang from; that which carries the only one; -1: none.
[[nodiscard]] int meetingJoint(const BodyView& view, const LimbPair& pair);

/// Mean position of the bases, or of the ends, of a pair.
[[nodiscard]] Vec3 meanBase(const BodyView& view, const LimbPair& pair);
[[nodiscard]] Vec3 meanEnd(const LimbPair& pair);

} // namespace stretch::rig::body

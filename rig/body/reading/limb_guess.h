#pragma once

#include <vector>

#include "rig/body/evidence/symmetry.h"
#include "rig/body/reading/limb_end.h"

namespace stretch::rig::body {

enum class Region { arm, leg };

/// One way to read a limb into the bone tree: base, middle and end as candidates (-1: none), with what speaks
/// for it.
struct LimbGuess {
  int base = -1;
  int middle = -1;          ///< -1 for a limb of one bone.
  int end = -1;             ///< -1: the end is estimated.
  bool endDetached = false; ///< The end joint hangs from elsewhere (a foot under the root).
  Vec3 endPosition{0.0};
  double length = 0.0;  ///< Sum of the bones' lengths, world units.
  double nameFit = 0.0; ///< Sum over the three joints of how well names fit, up to 3; negative where they
                        ///< speak against.
  double shapePenalty = 0.0; ///< 0 where proportions are those of a limb.
  double lateral = 0.0;      ///< Side of the mirror plane that the limb begins on; where it begins in the
                             ///< middle of the body, that its middle is on.

  [[nodiscard]] double score() const { return nameFit - shapePenalty; }
};

/// The likely readings of arms or legs anywhere in the tree, best first, at most `most` on each side.
[[nodiscard]] std::vector<LimbGuess> guessLimbs(const BodyView& view, const MirrorPlane& plane, Region region,
                                                std::size_t most);

/// Names' side of a guess: what the majority of its joints say.
[[nodiscard]] Side namedSide(const BodyView& view, const LimbGuess& guess);

} // namespace stretch::rig::body

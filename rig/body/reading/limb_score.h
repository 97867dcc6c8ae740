#pragma once

#include "rig/body/reading/limb_guess.h"

namespace stretch::rig::body {

/// How well the names of a guess's joints fit their places, the joints that it skips included.
[[nodiscard]] double nameFit(const BodyView& view, const LimbGuess& guess, Region region);

/// Whether a joint's bone goes on as the one that leads to it does: in line, about as long, and called alike
/// but for a number.
[[nodiscard]] bool continuesEqualBone(const BodyView& view, int joint);

/// How far a guess's proportions are from a limb's: lengths of its bones against each other and the body,
/// joints skipped that bend, the rest beyond the end, and what stands before the base.
[[nodiscard]] double shapePenalty(const BodyView& view, const MirrorPlane& plane, const LimbGuess& guess,
                                  Region region);

} // namespace stretch::rig::body

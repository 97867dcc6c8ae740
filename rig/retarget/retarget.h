#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/anim/clip.h"
#include "core/base/result.h"
#include "rig/retarget/skeleton.h"

namespace stretch::rig {

/// How far a joint may be from where the retargeted clip has it, of the character's height: what keys may be
/// left out by.
inline constexpr double retargetTolerance = 1e-4;

struct Retargeted {
  Clip clip;                     ///< Clip for the character: LINEAR keys from the source's first to its last.
  std::vector<std::string> left; ///< Parts that the source moves and the character lacks: "fingers".
};

/// Whether feet and hands are put where the source's body has them, or stay where the turned bones take them.
enum class Correction { none, feetAndHands };

/// The clip of one biped on another (docs/import_clip.md): joints turn from the bind pose as the source's do,
/// the body travels by the ratio of the legs' lengths, feet that stand in the source stand. Finite for every
/// file that was read; an error where the clip is too long, or nothing in it can be followed.
/// `proceed` is told the share that is done, 0..1, and answers whether to go on: else an error.
[[nodiscard]] Result<Retargeted> retarget(const Skeleton& from, const Clip& clip, const Skeleton& to,
                                          const std::function<bool(double)>& proceed = {},
                                          Correction correction = Correction::feetAndHands);

} // namespace stretch::rig

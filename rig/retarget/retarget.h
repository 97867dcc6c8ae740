#pragma once

#include <array>
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

/// How far an arm is moved from where its bones have it: its wrist, and its elbow about the line from
/// shoulder to wrist.
struct ArmShift {
  Vec3 wrist{0.0};     ///< World space.
  double swivel = 0.0; ///< Radians.
};
using ArmShifts = std::array<ArmShift, 2>; ///< Left, right.

/// A clip while it is brought over.
struct FollowedClip {
  const std::vector<double>& seconds; ///< Of its frames, rising.
  Quat world;                         ///< World directions of the source to those of the character.
  std::vector<double> joined; ///< How much both hands work together at each frame, 0..1; empty: they do not.
  /// World matrices of the character's nodes at a frame, its arms moved. What is out of an arm's reach is
  /// reached for.
  std::function<std::vector<Mat4>(std::size_t frame, const ArmShifts& shifts)> worlds;
  std::function<bool(double)> proceed; ///< Told the share that is done, 0..1; false: it is not wanted any
                                       ///< more.
};

/// Says how far the arms are moved at every frame; empty: they are not.
using ShiftArms = std::function<std::vector<ArmShifts>(const FollowedClip&)>;

/// The clip of one biped on another (docs/import_clip.md): joints turn from the bind pose as the source's do,
/// the body travels by the ratio of the legs' lengths, feet that stand in the source stand. Finite for every
/// file that was read; an error where the clip is too long, or nothing in it can be followed.
/// `proceed` is told the share that is done, 0..1, and answers whether to go on: else an error. `shiftArms`:
/// asked once, where feet and hands are put where they belong.
[[nodiscard]] Result<Retargeted> retarget(const Skeleton& from, const Clip& clip, const Skeleton& to,
                                          const std::function<bool(double)>& proceed = {},
                                          Correction correction = Correction::feetAndHands,
                                          const ShiftArms& shiftArms = {});

} // namespace stretch::rig

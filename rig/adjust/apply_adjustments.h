#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/adjust/solved_adjustments.h"

namespace stretch::rig {

/// Place that the offsets of a time, or what it follows, want for a controller, world space.
struct AskedPlace {
  std::string controller;
  Vec3 place{0.0};
};

/// Brings the adjustments onto a sampled frame of the clip at its own time, from the root outwards
/// (docs/controllers.md, Solving): nothing at all is written where every offset is zero. Only the nodes of
/// SolvedAdjustments::nodes and their ancestors need to be filled in. Answers where the controllers that are
/// offset, and the ends of all limbs that offsets concern, were wanted; those that only turn are where they
/// are.
std::vector<AskedPlace> applyAdjustments(const Scene& scene, const SolvedAdjustments& adjustments,
                                         FrameState& frame);
/// Applies adjustments where `frame` is a copy of `source`, which is spared another one.
std::vector<AskedPlace> applyAdjustments(const Scene& scene, const SolvedAdjustments& adjustments,
                                         const FrameState& source, FrameState& frame);

/// How the offset of a controller counts in a frame, whether it has one there or not.
struct ControllerSpace {
  std::string controller;
  Quat axes{1.0, 0.0, 0.0, 0.0}; ///< World: along which it is counted.
  std::optional<Vec3> place;     ///< Place by the offset of what is on no joint: the body's controller, and a
                                 ///< pole, whose distance from the limb does not count.
};

/// Returns the spaces of all controllers but those on other joints. Adjusts the frame as applyAdjustments
/// does; `adjustments.body` must be there.
[[nodiscard]] std::vector<ControllerSpace>
controllerSpaces(const Scene& scene, const SolvedAdjustments& adjustments, FrameState& frame);

/// Returns the place of the pole of a limb of two spans in a frame: half the limb's length before the joint,
/// the way the limb bends.
[[nodiscard]] Vec3 posedPole(const AdjustedLimb& adjusted, const FrameState& frame);

/// Returns the place of a controller in a frame; of a pole the joint that it leads.
[[nodiscard]] Vec3 controllerPlace(const SolvedAdjustments& adjustments, const std::string& controller,
                                   const FrameState& frame);

} // namespace stretch::rig

#pragma once

#include <string>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/motion/solved_adjustments.h"

namespace stretch::rig {

/// Where the offsets of a time want a controller, world space.
struct AskedPlace {
  std::string controller;
  Vec3 place{0.0};
};

/// Brings the adjustments onto a sampled frame of the clip at its own time, from the root outwards
/// (docs/controllers.md, Solving): nothing at all is written where every offset is zero. Only the nodes of
/// SolvedAdjustments::nodes and their ancestors need to be filled in. Answers where the controllers that are
/// offset were wanted; those that only turn are where they are.
std::vector<AskedPlace> applyAdjustments(const Scene& scene, const SolvedAdjustments& adjustments,
                                         FrameState& frame);

/// Where a controller stands in a frame; of a pole the joint that it leads.
[[nodiscard]] Vec3 controllerPlace(const SolvedAdjustments& adjustments, const std::string& controller,
                                   const FrameState& frame);

} // namespace stretch::rig

#pragma once

#include <string>
#include <vector>

#include "app/auto/planned_trail.h"

namespace stretch::app {

/// Props for what the hands of planned trails swing, as a bat: a node with a mesh that is no part of the body
/// and keeps its place in a hand while that moves. Each hand holds it for as long as it does in the clip,
/// where the clip has it at each frame.
[[nodiscard]] std::vector<rig::Prop> propsFor(const ClipGround& ground, const AutoPlan& plan);

/// Whether this arm's hand holds the prop at some time.
[[nodiscard]] bool isHeldBy(const rig::Prop& prop, const std::string& arm);

/// Whether it does at this frame, and does not just let go.
[[nodiscard]] bool isHeldBy(const rig::Prop& prop, const std::string& arm, double frame);

/// Whether both arms' hands hold one of the plan's props at this frame.
[[nodiscard]] bool areOnProp(const AutoPlan& plan, const std::string& arm, const std::string& other,
                             double frame);

} // namespace stretch::app

#pragma once

#include <vector>

#include "app/auto/planned_trail.h"

namespace stretch::app {

/// Grips for arms whose hand holds on to what the hand of a planned trail holds, as a bat: the one keeps its
/// place seen from the other over the trail's frames although both move. Of two planned trails for such a
/// pair the weaker one is left out. Hands on a prop of the plan keep to that instead.
[[nodiscard]] std::vector<rig::Grip> gripsFor(const ClipGround& ground, AutoPlan& plan);

} // namespace stretch::app

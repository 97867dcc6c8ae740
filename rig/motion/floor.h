#pragma once

#include <optional>

#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::rig {

/// How high the end of a leg is where it stands lowest in the clip: it rests there for a while. World units
/// along +Y; nothing for a leg that never stands.
[[nodiscard]] std::optional<double> standingHeight(const Scene& scene, const Clip& clip, const Limb& leg);

} // namespace stretch::rig

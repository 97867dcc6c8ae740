#pragma once

#include "core/anim/clip.h"
#include "core/scene/scene.h"

namespace stretch::app {

/// How far the shown surface of a character gets below the floor, which lies at y = 0, in a clip.
struct BelowFloor {
  double depth = 0.0;   ///< World units, >= 0; 0 where nothing is below it, or nothing is shown.
  double seconds = 0.0; ///< Time at which it is deepest.
  NodeIndex node;       ///< What gets there follows this node most.
};

/// Looked for at 48 times that are spread over the clip, at fewer of them for a surface of very many
/// vertices.
[[nodiscard]] BelowFloor belowFloor(const Scene& scene, const Clip& clip);

} // namespace stretch::app

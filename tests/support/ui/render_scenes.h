#pragma once

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"

namespace stretch::test {

/// One white unlit triangle in the plane z = 0: (-1, 0), (1, 0), (0, 2).
[[nodiscard]] Scene triangleScene();

/// Node indices of bipedScene.
struct BipedNodes {
  NodeIndex hips{0};
  NodeIndex chest{1};
  NodeIndex head{2};
  NodeIndex leftUpperArm{3};
  NodeIndex leftForearm{4};
  NodeIndex leftHand{5};
};

/// A biped 1.8 high that stands on y = 0, faces +Z and is skinned to 15 joints: boxes that bend at elbows and
/// knees. Shirt orange, trousers blue, skin pale.
[[nodiscard]] Scene bipedScene();

/// The biped at rest, with its left forearm raised.
[[nodiscard]] FrameState wavingFrame(const Scene& biped);

/// A grid of 40 x 40 vertices whose every vertex follows 8 of 200 joints, with morph targets: what the
/// formulas of CPU and graphics card are compared on.
[[nodiscard]] Scene manyJointsScene();

/// A frame of manyJointsScene with rotations, uneven and mirrored scales, stretch and morph weights.
[[nodiscard]] FrameState twistedFrame(const Scene& manyJoints);

} // namespace stretch::test

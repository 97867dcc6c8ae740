#pragma once

#include "ui/render/view/camera.h"

namespace stretch::ui {

/// Directions towards the studio's lights, world space, unit length.
struct StudioLights {
  Vec3 key{0.0, 1.0, 0.0}; ///< Fixed in the world, so that shadows stay where they are when the camera moves.
  Vec3 fill{0.0, 1.0, 0.0}; ///< Beside the camera.
  Vec3 rim{0.0, 1.0, 0.0};  ///< Behind the character as the camera sees it, from above.
};

[[nodiscard]] StudioLights studioLights(const View& view);

/// Part of the floor that shadows fall on.
struct FloorArea {
  Vec2 centre{0.0}; ///< World x, z.
  Vec2 halfSize{1.0};
};

/// The floor under a box and under its shadow, with a margin for the blur.
[[nodiscard]] FloorArea shadowedFloor(const Box& box, double floorHeight, const Vec3& towardsLight);

/// World to clip space of a camera at the light that sees just the box.
[[nodiscard]] Mat4 lightProjection(const Box& box, const Vec3& towardsLight);

/// Distance between the fine lines of the floor: a round number of about half a character's height.
[[nodiscard]] double floorCellSize(double characterHeight);

} // namespace stretch::ui

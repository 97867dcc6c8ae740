#pragma once

#include <optional>

#include "core/math/types.h"
#include "core/scene/camera.h"

namespace stretch::rig {

/// Input from which a tip is solved whose length counts as a camera sees it (docs/exaggeration.md, As the
/// camera sees it). All of it in one space.
struct SeenProblem {
  CameraPlace camera;
  Vec3 base{0.0};             ///< P0.
  Vec3 tip{0.0};              ///< P1.
  Vec3 direction{0.0};        ///< Outwards along the path, unit.
  double pivotDistance = 0.0; ///< From the tip back to the pivot along the direction: no walk inwards is
                              ///< longer.
  double scale = 1.0;         ///< How many times as long as P1 the limb is to look; above 1 walks outwards.
  bool keepDepth = true;      ///< Walks parallel to the picture.
};

/// The walk from the tip to where the limb looks as long as it should.
struct SeenTip {
  Vec3 tip{0.0};          ///< P2.
  Vec3 direction{0.0};    ///< The one that was walked along, outwards; unit.
  double walk = 0.0;      ///< Along it; negative towards the pivot.
  bool alongLimb = false; ///< The path points at the camera: the limb's own seen direction was taken.
  double seen = 1.0;      ///< Length in the picture over that of P1.
  bool reached = true;    ///< Else the tip that looks longest (inwards: shortest).
};

inline constexpr double farthestSeen = 5.0; ///< No tip gets farther from the base than this times P1.

/// Never fails: where the limb is not in front of the camera, or points straight at it, nothing moves and
/// nothing is reached.
[[nodiscard]] SeenTip solveSeenTip(const SeenProblem& problem);

/// Distance of two points in the picture, in perspective at the depth 1; nothing where one is not seen.
[[nodiscard]] std::optional<double> seenLength(const CameraPlace& camera, const Vec3& from, const Vec3& to);

/// Returns the part of a direction that is parallel to the picture.
[[nodiscard]] Vec3 flattened(const CameraPlace& camera, const Vec3& direction);

} // namespace stretch::rig

#pragma once

#include "rig/body/evidence/body_view.h"

namespace stretch::rig::body {

/// The plane that mirrors a body onto itself. Which of its sides is left is not known here.
struct MirrorPlane {
  Vec3 normal{1.0, 0.0, 0.0}; ///< Unit length.
  double offset = 0.0;        ///< Distance of the plane along the normal, world units.

  /// Signed distance of a point.
  [[nodiscard]] double lateral(const Vec3& point) const;
  [[nodiscard]] Vec3 mirrored(const Vec3& point) const;
};

/// Finds the plane from pairs of bones that mirror each other: siblings whose subtrees are alike, and joints
/// whose names differ in their side only. Without any pair, the plane through the mean joint along the body.
[[nodiscard]] MirrorPlane findMirrorPlane(const BodyView& view);

} // namespace stretch::rig::body

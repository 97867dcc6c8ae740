#pragma once

#include <array>
#include <optional>

#include "ui/render/view/camera.h"

namespace stretch::ui {

/// A face, an edge or a corner of the view cube, by its direction from the cube's centre. Axes of the
/// character: x to its left, y up, z the way it faces.
struct CubePart {
  std::array<int, 3> side{0, 0, 0}; ///< Each -1, 0 or 1, not all 0; one that is not 0 is a face, two an edge,
                                    ///< three a corner.

  [[nodiscard]] bool isFace() const;
  friend bool operator==(const CubePart&, const CubePart&) = default;
};

/// The view cube as a view shows it: half an edge is the unit of length.
class ViewCube {
public:
  /// `facingYawRadians`: where the character faces, as in lookFrom.
  ViewCube(const View& view, double facingYawRadians);

  /// Place at which a point of the cube (character's axes) is seen, from the cube's centre, y up.
  [[nodiscard]] Vec2 seenAt(const Vec3& point) const;
  /// The cosine between the way to the viewer and an axis of the cube that points to `side`: above 0 the face
  /// is seen.
  [[nodiscard]] double towardsViewer(int axis, int side) const;
  /// The part that is seen at a place, as seenAt tells places; nothing beside the cube.
  [[nodiscard]] std::optional<CubePart> partAt(const Vec2& place) const;

private:
  Vec3 right_; ///< The view's own axes, in the cube's.
  Vec3 up_;
  Vec3 back_;
};

/// Edges and corners reach from here to 1 on each face.
inline constexpr double cubeMiddle = 0.55;

/// The camera turned to look at a part straight on: at a face without perspective, as the standard views do.
[[nodiscard]] Camera lookingAt(Camera camera, const CubePart& part, double facingYawRadians);

} // namespace stretch::ui

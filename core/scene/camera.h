#pragma once

#include <optional>
#include <string>

#include "core/math/types.h"
#include "core/scene/node_index.h"

namespace stretch {

enum class CameraKind { perspective, orthographic };

/// A camera of the file: a node that carries one.
struct SceneCamera {
  std::string name; ///< The node's, else the camera's own, else "camera #3"; no two cameras have the same.
  NodeIndex node;   ///< Looks along its -Z, with +Y up.
  CameraKind kind = CameraKind::perspective;
  double fieldOfViewRadians = 0.8; ///< Vertical, above 0 and below pi; of a perspective camera.
  double halfHeight = 1.0;         ///< World units, above 0; of an orthographic camera.
  std::optional<double> aspect;    ///< Width over height of its picture; empty: as wide as where it is shown.
};

/// A camera where it stands at one time. The axes are unit vectors at right angles.
struct CameraPlace {
  CameraKind kind = CameraKind::perspective;
  Vec3 position{0.0};
  Vec3 right{1.0, 0.0, 0.0};
  Vec3 up{0.0, 1.0, 0.0};
  Vec3 forward{0.0, 0.0, -1.0}; ///< Away from the eye.

  friend bool operator==(const CameraPlace&, const CameraPlace&) = default;
};

/// Places nearer to a perspective camera than this along its view, world units, are not seen.
inline constexpr double nearestSeen = 1e-3;

/// The part of a picture, along each side, that every screen shows.
inline constexpr double safeFrame = 0.9;

/// A camera at its node's world matrix, whose scale does not count; nothing where the matrix has no such
/// axes.
[[nodiscard]] std::optional<CameraPlace> cameraPlace(CameraKind kind, const Mat4& world);

/// An orthographic camera that looks from this direction (towards the eye, not zero), up as far as may be.
[[nodiscard]] CameraPlace cameraFrom(const Vec3& towardsEye);

/// Place of a point in the camera's picture: along right and up, in perspective divided by its depth.
/// Nothing where it is not in front of a perspective camera.
[[nodiscard]] std::optional<Vec2> inPicture(const CameraPlace& camera, const Vec3& point);

/// The focal length, mm, at which a full-frame picture, 24 mm high, has this vertical angle.
[[nodiscard]] double focalLength(double fieldOfViewRadians);

/// The unit direction from a point to the eye; that of the whole view for an orthographic camera.
[[nodiscard]] Vec3 towardsEye(const CameraPlace& camera, const Vec3& point);

} // namespace stretch

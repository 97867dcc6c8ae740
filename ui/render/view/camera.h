#pragma once

#include <optional>

#include "core/math/types.h"

namespace stretch::ui {

/// Axis-aligned box in world units. Empty (minimum above maximum) until a point is added.
struct Box {
  Vec3 minimum{1e300};
  Vec3 maximum{-1e300};

  [[nodiscard]] bool empty() const { return minimum.x > maximum.x; }
  [[nodiscard]] Vec3 centre() const { return 0.5 * (minimum + maximum); }
  [[nodiscard]] Vec3 size() const { return maximum - minimum; }
  void add(const Vec3& point);
  void add(const Box& other); ///< An empty box adds nothing.
};

/// A rectangle of framebuffer pixels that a view fills. Sizes below one pixel count as one.
struct Viewport {
  double widthPixels = 1.0;
  double heightPixels = 1.0;
  double pixelsPerPoint = 1.0; ///< 1 at 100 % display scale, 2 at 200 %: what is measured in points grows by
                               ///< it.
};

enum class ProjectionKind { perspective, orthographic };

/// Sides from which the standard views look: glTF characters face +Z, so `front` looks from +Z, `side` from
/// +X, `top` from +Y.
enum class ViewDirection { front, back, side, otherSide, top, threeQuarter };

/// A camera that orbits a target. +Y is up.
struct Camera {
  Vec3 target{0.0, 1.0, 0.0};
  double distance = 5.0;              ///< Eye to target, world units, above 0.
  double yawRadians = 0.0;            ///< 0 looks from +Z; a quarter turn looks from +X.
  double pitchRadians = 0.0;          ///< -pi/2..pi/2; positive looks from above.
  double fieldOfViewRadians = 0.5236; ///< Vertical. An orthographic view shows what this angle shows at the
                                      ///< target.
  ProjectionKind projection = ProjectionKind::perspective;

  friend bool operator==(const Camera&, const Camera&) = default;
};

/// Facts that drawing and picking need of a camera: any camera, the file's too, can be put here.
struct View {
  Mat4 view{1.0};       ///< World to eye space (right-handed, looking along -Z).
  Mat4 projection{1.0}; ///< Eye to clip space, OpenGL depth range (-1..1).
  Vec3 eye{0.0};        ///< World. For an orthographic view a point at the target's distance.
  Vec3 forward{0.0, 0.0, -1.0};
  Viewport viewport;
};

struct Ray {
  Vec3 origin{0.0};
  Vec3 direction{0.0, 0.0, -1.0}; ///< Unit length.
};

/// A point as it lies on the screen.
struct ScreenPoint {
  Vec2 pixels{0.0};   ///< From the viewport's top left, y down.
  double depth = 0.0; ///< Distance from the eye along the viewing direction, world units; larger is farther.
};

[[nodiscard]] View makeView(const Camera& camera, const Viewport& viewport);

/// The camera turned to a standard view; target, distance and field of view stay. `facingYawRadians`: where
/// the character faces (0 for +Z, pi for -Z). `front`, `side` and `top` become orthographic, `threeQuarter`
/// perspective.
[[nodiscard]] Camera lookFrom(Camera camera, ViewDirection direction, double facingYawRadians = 0.0);

/// The camera turned to look from a direction (towards the eye, unit), in perspective; all else stays.
[[nodiscard]] Camera lookingFrom(Camera camera, const Vec3& towardsEye);

/// Turns by a drag of the mouse; a drag across the viewport's height is half a turn. The pitch stops at the
/// poles.
[[nodiscard]] Camera orbited(Camera camera, const Viewport& viewport, const Vec2& dragPixels);

/// Moves the target in the view plane so that the point under the mouse stays under it.
[[nodiscard]] Camera panned(Camera camera, const Viewport& viewport, const Vec2& dragPixels);

/// Multiplies the distance by `factor` (below 1 comes closer) and keeps the point under the mouse where it
/// is.
[[nodiscard]] Camera zoomed(Camera camera, const Viewport& viewport, double factor, const Vec2& mousePixels);

/// Moves and backs the camera until the box fills the viewport but for `margin` (share of its size on every
/// side). The viewing direction stays. An empty box changes nothing; a box of one point is seen from one unit
/// away.
[[nodiscard]] Camera fitted(Camera camera, const Viewport& viewport, const Box& box, double margin = 0.08);

/// Nothing for points at or behind the eye.
[[nodiscard]] std::optional<ScreenPoint> projectToPixels(const View& view, const Vec3& pointWorld);

[[nodiscard]] Ray rayThroughPixel(const View& view, const Vec2& pixels);

/// World units that one pixel covers at the depth of a point; the sign is dropped for points behind the eye.
[[nodiscard]] double unitsPerPixel(const View& view, const Vec3& pointWorld);

/// Returns the mouse's place in the plane that faces the viewer and passes through `pointWorld`.
[[nodiscard]] Vec3 pointInViewPlane(const View& view, const Vec3& pointWorld, const Vec2& pixels);

/// Position along the line origin + t * axis that is nearest to the ray through the pixel; 0 when the axis
/// (unit length) points at the viewer.
[[nodiscard]] double positionAlongAxis(const View& view, const Vec3& origin, const Vec3& axis,
                                       const Vec2& pixels);

/// Right and up of the view plane, in world space.
[[nodiscard]] Vec3 viewRight(const View& view);
[[nodiscard]] Vec3 viewUp(const View& view);

} // namespace stretch::ui

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/scene/node_index.h"
#include "ui/render/view/camera.h"

namespace stretch::ui {

// Hit tests: pure functions of a view and a mouse position in pixels from the viewport's top left. Radii are
// in points and grow with Viewport::pixelsPerPoint. What lies behind the eye is never hit.

struct SphereRadii {
  double hitPoints = 20.0;  ///< How far from its centre a sphere still takes the mouse.
  double drawnPoints = 7.0; ///< The radius it is drawn with.
};

/// The control sphere under the mouse. Where several drawn discs lie under it, the one in front (which is the
/// one seen); else the nearest within the hit radius; at the same distance the one in front, then the first.
[[nodiscard]] std::optional<std::size_t> pickSphere(const View& view, std::span<const Vec3> centresWorld,
                                                    const Vec2& mousePixels, const SphereRadii& radii = {});

/// Three arrows of constant size on the screen.
struct AxisHandles {
  Vec3 origin{0.0};
  std::array<Vec3, 3> axes{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}; ///< World, unit length.
  double lengthPoints = 72.0;
};

/// World position of the three arrow tips.
[[nodiscard]] std::array<Vec3, 3> handleTips(const View& view, const AxisHandles& handles);

/// Which arrow (0 x, 1 y, 2 z) the mouse is on. The first fifth next to the origin belongs to the sphere
/// there; an arrow that points at the viewer (shorter than 8 points on the screen) cannot be hit.
[[nodiscard]] std::optional<std::size_t> pickAxis(const View& view, const AxisHandles& handles,
                                                  const Vec2& mousePixels, double tolerancePoints = 9.0);

struct PolylineHit {
  std::size_t segment = 0; ///< Between points segment and segment + 1.
  double fraction = 0.0;   ///< 0..1 along the segment in world space.
  Vec3 pointWorld{0.0};
  double distancePixels = 0.0; ///< Mouse to line.
};

/// The nearest place of a polyline to the mouse; nothing for fewer than two points or farther than the
/// tolerance.
[[nodiscard]] std::optional<PolylineHit> pickPolyline(const View& view, std::span<const Vec3> pointsWorld,
                                                      const Vec2& mousePixels, double tolerancePoints = 10.0);

/// A bone as it is drawn: from its joint towards the next one.
struct BoneSegment {
  NodeIndex node; ///< The joint that moves this bone.
  Vec3 fromWorld{0.0};
  Vec3 toWorld{0.0};
};

/// Index into `bones` of the bone under the mouse: the nearest on the screen; of bones equally near (within 3
/// points) the front one.
[[nodiscard]] std::optional<std::size_t> pickBone(const View& view, std::span<const BoneSegment> bones,
                                                  const Vec2& mousePixels, double tolerancePoints = 14.0);

} // namespace stretch::ui

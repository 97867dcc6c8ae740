#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "core/math/types.h"
#include "core/scene/mesh_sequence.h"

namespace stretch::skinning {

/// Triangles of places in the world: indices into `places`.
struct PlacedSurface {
  const std::vector<Vec3>& places;
  const std::vector<Triangle>& triangles;
};

/// How often a surface winds around a place: 1 inside of a closed one, 0 outside of it, a number between them
/// beside a hole (solid angles after Van Oosterom and Strackee 1983, their sum over 4 pi as in Jacobson,
/// Kavan and Sorkine-Hornung 2013). 0 for a surface without triangles.
[[nodiscard]] double windingNumber(const PlacedSurface& surface, const Vec3& place);

/// A point of a surface.
struct SurfacePoint {
  std::size_t triangle = 0;   ///< Index into the surface's triangles.
  Vec3 shares{1.0, 0.0, 0.0}; ///< Of its corners, summing to 1.
};

/// The point's place in the world.
[[nodiscard]] Vec3 placeOf(const PlacedSurface& surface, const SurfacePoint& point);

/// The point of the triangles that is nearest to a place; nothing where none is nearer than `limit`.
[[nodiscard]] std::optional<SurfacePoint> nearestOn(const PlacedSurface& surface, const Vec3& place,
                                                    double limit = std::numeric_limits<double>::infinity());

/// Points in which a ray from `start` goes through the triangles, in no order. `way`: not zero.
[[nodiscard]] std::vector<SurfacePoint> crossedBy(const PlacedSurface& surface, const Vec3& start,
                                                  const Vec3& way);

/// Distance of a place from the nearest point of the triangles, or `limit` where none is nearer.
[[nodiscard]] double distanceFrom(const PlacedSurface& surface, const Vec3& place,
                                  double limit = std::numeric_limits<double>::infinity());

} // namespace stretch::skinning

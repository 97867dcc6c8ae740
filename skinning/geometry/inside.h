#pragma once

#include <limits>
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

/// Distance of a place from the nearest point of the triangles, or `limit` where none is nearer.
[[nodiscard]] double distanceFrom(const PlacedSurface& surface, const Vec3& place,
                                  double limit = std::numeric_limits<double>::infinity());

} // namespace stretch::skinning

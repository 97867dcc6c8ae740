#pragma once

#include "assets/dummy/editable_mesh.h"

namespace stretch::assets {

/// Merges vertices that all but coincide.
void mergeCoincident(EditableMesh& mesh);

/// Flips edges that lie between two thin triangles of one region, so that the triangles become rounder.
/// Borders between regions (`regionOf` tells it of a point) and sharp rims stay.
void flipSlivers(EditableMesh& mesh, const std::function<int(const Vec3&)>& regionOf);

} // namespace stretch::assets

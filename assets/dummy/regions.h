#pragma once

#include "assets/dummy/surface_mesh.h"

namespace stretch::assets {

/// What a patch of the body's surface is made of.
enum class Region { skin, hair, glove, cuff, trunks, stripe, waistband, boot, sole, bootTrim };

/// Region of a point on the surface.
[[nodiscard]] Region regionAt(const Vec3& point);

/// Outward unit normal of the surface on the region's side: regions meet in sharp creases.
[[nodiscard]] Vec3 regionNormal(Region region, const Vec3& point);

/// Moves and adds vertices so that the borders between regions run along edges: every triangle lies in one
/// region.
[[nodiscard]] SurfaceMesh cutAlongRegions(const SurfaceMesh& mesh);

} // namespace stretch::assets

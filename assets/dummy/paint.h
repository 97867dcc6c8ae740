#pragma once

#include "assets/dummy/regions.h"

namespace stretch::assets {

/// sRGB, 0xRRGGBB, to linear 0..1.
[[nodiscard]] Vec3 linearColor(unsigned hex);

/// Linear colour of a region at a point of the surface: the palette, cheeks and ears a little warmer, darker
/// in creases.
[[nodiscard]] Vec3 paintedColor(Region region, const Vec3& point, const Vec3& normal);

inline constexpr unsigned skinHex = 0xF2C7A0;
inline constexpr unsigned lidHex = 0xEDBC96;
inline constexpr unsigned hairHex = 0x7A3E1D;

} // namespace stretch::assets

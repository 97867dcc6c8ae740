#pragma once

#include "core/math/types.h"

namespace stretch::assets {

inline constexpr double headScale = 1.10; ///< The head is drawn at natural size and made larger, as in
                                          ///< cartoons.

/// From the space in which the head is drawn to model space.
[[nodiscard]] Vec3 headToModel(const Vec3& point);

/// Distance to head and neck without hair, metres, model space.
[[nodiscard]] double headDistance(const Vec3& point);

[[nodiscard]] double hairDistance(const Vec3& point);

} // namespace stretch::assets

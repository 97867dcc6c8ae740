#pragma once

#include <string>

#include "assets/dummy/glb_writer.h"

namespace stretch::assets {

inline constexpr double batLength = 0.88;    ///< Metres.
inline constexpr double batGripHeight = 0.2; ///< Of the middle between the hands, above the knob.

/// A baseball bat along +Y; its origin is the middle between the hands.
[[nodiscard]] Prop makeBat();

/// A box between two corners in the world; its node stands in its middle.
[[nodiscard]] Prop makeBlock(const std::string& name, const Vec3& low, const Vec3& high);

} // namespace stretch::assets

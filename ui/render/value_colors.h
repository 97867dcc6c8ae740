#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace stretch::ui {

/// Colours of values from nothing to the largest shown; the lightness changes with them, so that they read
/// without colour too.
enum class ValueScale {
  error,    ///< Calm grey, then yellow to vermilion.
  thickness ///< Dark blue, bluish green, yellow.
};

/// Colour (linear light) of a share of the largest shown value; shares outside 0..1 keep the end's colour.
[[nodiscard]] glm::vec4 valueColor(ValueScale scale, double share);

/// The same in sRGB, for legends: 0xRRGGBB.
[[nodiscard]] std::uint32_t valueColorHex(ValueScale scale, double share);

/// One colour for each value; `largest` is the value of the scale's end. All of the first colour when it is
/// not above 0.
[[nodiscard]] std::vector<glm::vec4> valueColors(ValueScale scale, std::span<const float> values,
                                                 double largest);

/// An sRGB colour 0..1 as linear light.
[[nodiscard]] glm::vec4 linearLight(const glm::vec4& srgb);

} // namespace stretch::ui

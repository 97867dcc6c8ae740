#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/anim/frame_state.h"

namespace stretch::ui {

/// Colours of values from nothing to the largest shown; the lightness changes with them, so that they read
/// without colour too.
enum class ValueScale {
  error,     ///< Calm grey, then yellow to vermilion.
  thickness, ///< Dark blue, bluish green, yellow.
  weight     ///< Calm grey for nothing; from the least on blue, purple, orange, yellow.
};

/// Colour (linear light) of a share of the largest shown value; shares outside 0..1 keep the end's colour.
[[nodiscard]] glm::vec4 valueColor(ValueScale scale, double share);

/// Returns the colour in sRGB, for legends: 0xRRGGBB.
[[nodiscard]] std::uint32_t valueColorHex(ValueScale scale, double share);

/// One colour for each value; `largest` is the value of the scale's end. All of the first colour when it is
/// not above 0.
[[nodiscard]] std::vector<glm::vec4> valueColors(ValueScale scale, std::span<const float> values,
                                                 double largest);

/// An sRGB colour 0..1 as linear light.
[[nodiscard]] glm::vec4 linearLight(const glm::vec4& srgb);

/// The heat-map runs from half to three times a joint's own length, even in the logarithm.
inline constexpr double smallestShownStretch = 0.5;
inline constexpr double largestShownStretch = 3.0;

/// Colour (linear light) of a stretch ratio: blue where squashed, grey at 1, orange to vermilion where
/// stretched; the lightness changes with it, so that it reads without colour too. Ratios beyond the shown
/// ones keep the end's colour.
[[nodiscard]] glm::vec3 stretchColor(double ratio);

/// Returns the colour in sRGB, for legends.
[[nodiscard]] glm::vec4 stretchColorSrgb(double ratio);

/// How much a linear map stretches: its singular value farthest from 1 in the logarithm. 1 for the identity;
/// a map that flattens to nothing answers 0.
[[nodiscard]] double stretchRatio(const Mat3& linear);

/// One ratio for each node, as FrameState::stretch says; all 1 when nothing is stretched.
[[nodiscard]] std::vector<double> stretchRatios(const FrameState& frame);

} // namespace stretch::ui

#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "core/anim/frame_state.h"

namespace stretch::ui {

/// The heat-map runs from half to three times a joint's own length, even in the logarithm.
inline constexpr double smallestShownStretch = 0.5;
inline constexpr double largestShownStretch = 3.0;

/// Colour (linear light) of a stretch ratio: blue where squashed, grey at 1, orange to vermilion where
/// stretched; the lightness changes with it, so that it reads without colour too. Ratios beyond the shown
/// ones keep the end's colour.
[[nodiscard]] glm::vec3 stretchColor(double ratio);

/// How much a linear map stretches: its singular value farthest from 1 in the logarithm. 1 for the identity;
/// a map that flattens to nothing answers 0.
[[nodiscard]] double stretchRatio(const Mat3& linear);

/// One ratio for each node, as FrameState::stretch says; all 1 when nothing is stretched.
[[nodiscard]] std::vector<double> stretchRatios(const FrameState& frame);

} // namespace stretch::ui

#include "ui/render/scene/value_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include "core/math/srgb.h"
#include "ui/render/view/palette.h"

namespace stretch::ui {

namespace {

struct ShareStop {
  double share;
  std::uint32_t hex; // sRGB
};

constexpr std::array<ShareStop, 4> errorStops{
    {{0.0, 0x5B6470}, {0.35, 0xF0E442}, {0.7, 0xE69F00}, {1.0, 0xC1390A}}};
constexpr std::array<ShareStop, 4> thicknessStops{
    {{0.0, 0x2B2F77}, {0.4, 0x0072B2}, {0.7, 0x35B779}, {1.0, 0xF0E442}}};

// The step at the beginning tells the least weight from none.
constexpr std::array<ShareStop, 6> weightStops{{{0.0, 0x4D525B},
                                                {0.004, 0x4D525B},
                                                {0.01, 0x3F55C4},
                                                {0.35, 0x9C4FB8},
                                                {0.65, 0xE9764A},
                                                {1.0, 0xFBE95C}}};

std::span<const ShareStop> stopsOf(ValueScale scale) {
  switch (scale) {
  case ValueScale::error:
    return errorStops;
  case ValueScale::thickness:
    return thicknessStops;
  case ValueScale::weight:
    break;
  }
  return weightStops;
}

glm::vec4 srgbColor(ValueScale scale, double share) {
  const std::span<const ShareStop> stops = stopsOf(scale);
  const double place = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (place <= stops[i].share) {
      const double part = (place - stops[i - 1].share) / (stops[i].share - stops[i - 1].share);
      return glm::mix(rgba(stops[i - 1].hex), rgba(stops[i].hex), static_cast<float>(part));
    }
  }
  return rgba(stops.back().hex);
}

// Eigenvalues of a symmetric matrix in closed form (trigonometric solution of its characteristic polynomial).
std::array<double, 3> symmetricEigenvalues(const Mat3& m) {
  const double mean = (m[0][0] + m[1][1] + m[2][2]) / 3.0;
  const Mat3 deviation = m - mean * Mat3(1.0);
  double squares = 0.0;
  for (glm::length_t column = 0; column < 3; ++column) {
    squares += glm::dot(deviation[column], deviation[column]);
  }
  const double spread = std::sqrt(squares / 6.0);
  if (spread <= 1e-14 * std::abs(mean)) {
    return {mean, mean, mean};
  }
  const double cosine = std::clamp(0.5 * glm::determinant(deviation * (1.0 / spread)), -1.0, 1.0);
  const double angle = std::acos(cosine) / 3.0;
  const double largest = mean + 2.0 * spread * std::cos(angle);
  const double smallest = mean + 2.0 * spread * std::cos(angle + 2.0 * pi / 3.0);
  return {largest, 3.0 * mean - largest - smallest, smallest};
}

struct Stop {
  double log2Ratio;
  glm::vec3 color; // linear light
};

constexpr std::array<Stop, 5> stops{{{-1.0, {0.050F, 0.250F, 0.720F}},
                                     {0.0, {0.300F, 0.300F, 0.300F}},
                                     {0.35, {0.620F, 0.400F, 0.140F}},
                                     {0.85, {0.830F, 0.270F, 0.015F}},
                                     {1.585, {0.620F, 0.045F, 0.005F}}}};

} // namespace

glm::vec4 linearLight(const glm::vec4& srgb) {
  return {linearFromSrgb(srgb.x), linearFromSrgb(srgb.y), linearFromSrgb(srgb.z), srgb.w};
}

glm::vec4 valueColor(ValueScale scale, double share) {
  return linearLight(srgbColor(scale, share));
}

std::uint32_t valueColorHex(ValueScale scale, double share) {
  const glm::vec4 color = srgbColor(scale, share);
  const auto byte = [](float channel) { return static_cast<std::uint32_t>(std::lround(channel * 255.0F)); };
  return (byte(color.x) << 16U) | (byte(color.y) << 8U) | byte(color.z);
}

std::vector<glm::vec4> valueColors(ValueScale scale, std::span<const float> values, double largest) {
  std::vector<glm::vec4> colors;
  colors.reserve(values.size());
  for (const float value : values) {
    colors.push_back(valueColor(scale, largest > 0.0 ? static_cast<double>(value) / largest : 0.0));
  }
  return colors;
}

glm::vec3 stretchColor(double ratio) {
  const double place = std::log2(std::clamp(ratio, smallestShownStretch, largestShownStretch));
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (place <= stops[i].log2Ratio) {
      const double share = (place - stops[i - 1].log2Ratio) / (stops[i].log2Ratio - stops[i - 1].log2Ratio);
      return glm::mix(stops[i - 1].color, stops[i].color, static_cast<float>(share));
    }
  }
  return stops.back().color;
}

glm::vec4 stretchColorSrgb(double ratio) {
  const glm::vec3 color = stretchColor(ratio);
  return {srgbFromLinear(color.x), srgbFromLinear(color.y), srgbFromLinear(color.z), 1.0F};
}

double stretchRatio(const Mat3& linear) {
  double farthest = 1.0;
  for (const double squared : symmetricEigenvalues(glm::transpose(linear) * linear)) {
    const double ratio = std::sqrt(std::max(squared, 0.0));
    if (ratio == 0.0) {
      return 0.0;
    }
    if (std::abs(std::log(ratio)) > std::abs(std::log(farthest))) {
      farthest = ratio;
    }
  }
  return farthest;
}

std::vector<double> stretchRatios(const FrameState& frame) {
  std::vector<double> ratios(frame.worlds.size(), 1.0);
  std::transform(frame.stretch.begin(), frame.stretch.end(), ratios.begin(), stretchRatio);
  return ratios;
}

} // namespace stretch::ui

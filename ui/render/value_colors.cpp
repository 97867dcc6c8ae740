#include "ui/render/value_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

#include "ui/render/palette.h"

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

glm::vec4 srgbColor(ValueScale scale, double share) {
  const auto& stops = scale == ValueScale::error ? errorStops : thicknessStops;
  const double place = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (place <= stops[i].share) {
      const double part = (place - stops[i - 1].share) / (stops[i].share - stops[i - 1].share);
      return glm::mix(rgba(stops[i - 1].hex), rgba(stops[i].hex), static_cast<float>(part));
    }
  }
  return rgba(stops.back().hex);
}

float linearChannel(float srgb) {
  return srgb <= 0.04045F ? srgb / 12.92F : std::pow((srgb + 0.055F) / 1.055F, 2.4F);
}

} // namespace

glm::vec4 linearLight(const glm::vec4& srgb) {
  return {linearChannel(srgb.x), linearChannel(srgb.y), linearChannel(srgb.z), srgb.w};
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

} // namespace stretch::ui

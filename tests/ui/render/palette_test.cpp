// Colours of the viewport that have to be told apart, whatever the theme.
#include "ui/render/view/palette.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <catch2/catch.hpp>

using namespace stretch::ui;

namespace {

/// Relative luminance of an sRGB colour, 0..1 (WCAG 2.1).
double luminance(const glm::vec3& colour) {
  const auto linear = [](float value) {
    return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
  };
  return 0.2126 * static_cast<double>(linear(colour.r)) + 0.7152 * static_cast<double>(linear(colour.g)) +
         0.0722 * static_cast<double>(linear(colour.b));
}

template <typename Colour, typename Other>
double contrast(const Colour& a, const Other& b) {
  const auto [low, high] = std::minmax({luminance(glm::vec3(a)), luminance(glm::vec3(b))});
  return (high + 0.05) / (low + 0.05);
}

} // namespace

TEST_CASE("In each theme words, lines and marks stand out of what lies behind them") {
  for (const auto& [name, palette] : {std::pair("dark", darkPalette()), std::pair("light", lightPalette()),
                                      std::pair("high contrast", highContrastPalette())}) {
    CAPTURE(name);
    for (const glm::vec3& ground : {palette.backgroundTop, palette.backgroundBottom, palette.floor}) {
      CHECK(contrast(palette.label, ground) > 7.0);
      CHECK(contrast(palette.bone, ground) > 7.0);
      CHECK(contrast(palette.boneSelected, ground) > 1.9);
      CHECK(contrast(palette.ghostTip, ground) > 2.5);
    }
    CHECK(contrast(palette.floorLine, palette.floor) > 1.4);
    CHECK(contrast(palette.shadow, palette.floor) > 1.05);
    CHECK(contrast(palette.selectionLine, palette.selectionGround) > 15.0);
    CHECK(contrast(palette.outline, palette.label) > 12.0);
    CHECK(contrast(palette.wire, palette.floor) > 1.04);
    CHECK(luminance(palette.backgroundTop) >= luminance(palette.backgroundBottom));
    CHECK(contrast(palette.backgroundTop, palette.backgroundBottom) < 1.6);
    CHECK(contrast(palette.floor, palette.backgroundBottom) < 1.6);
    for (const glm::vec4& drawn : {palette.wire, palette.outline}) {
      CHECK(drawn.a >= 0.5F);
    }
    for (const glm::vec4& whole : {palette.selectionLine, palette.selectionGround, palette.boneSelected,
                                   palette.label, palette.ghostTip}) {
      CHECK(whole.a == 1.0F);
    }
    const glm::vec4 controllers[] = {palette.controllerCentre, palette.controllerLeft,
                                     palette.controllerRight};
    for (const glm::vec4& controller : controllers) {
      CHECK(contrast(controller, palette.backgroundBottom) > 2.5);
      CHECK(std::ranges::count(controllers, controller) == 1);
    }
  }
}

TEST_CASE("A colour is read from its hexadecimal notation, channel by channel") {
  CHECK(rgb(0xFF0000) == glm::vec3(1.0F, 0.0F, 0.0F));
  CHECK(rgb(0x00FF00) == glm::vec3(0.0F, 1.0F, 0.0F));
  CHECK(rgb(0x0000FF) == glm::vec3(0.0F, 0.0F, 1.0F));
  CHECK(rgb(0x336699) == glm::vec3(0.2F, 0.4F, 0.6F));
  CHECK(rgba(0x336699, 0.25F) == glm::vec4(0.2F, 0.4F, 0.6F, 0.25F));
  CHECK(rgba(0x000000).a == 1.0F);
}

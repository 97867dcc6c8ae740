#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace stretch::ui {

/// sRGB colour 0..1 from its hexadecimal notation: rgb(0x56B4E9).
[[nodiscard]] glm::vec3 rgb(std::uint32_t hex);
[[nodiscard]] glm::vec4 rgba(std::uint32_t hex, float alpha = 1.0F);

/// Okabe and Ito's colours, which stay apart for every kind of colour vision.
namespace okabe {
inline constexpr std::uint32_t skyBlue = 0x56B4E9;
inline constexpr std::uint32_t orange = 0xE69F00;
inline constexpr std::uint32_t bluishGreen = 0x009E73;
inline constexpr std::uint32_t reddishPurple = 0xCC79A7;
inline constexpr std::uint32_t yellow = 0xF0E442;
inline constexpr std::uint32_t blue = 0x0072B2;
inline constexpr std::uint32_t vermilion = 0xD55E00;
} // namespace okabe

/// Roles of colour in the viewport, sRGB.
struct Palette {
  glm::vec3 backgroundTop{};
  glm::vec3 backgroundBottom{};
  glm::vec3 floor{};
  glm::vec3 floorLine{};
  glm::vec3 shadow{};
  glm::vec4 wire{};
  glm::vec4 selectionLine{};   ///< Around a selected limb,
  glm::vec4 selectionGround{}; ///< and around that line: of opposite lightness.
  glm::vec4 bone{};
  glm::vec4 boneSelected{};
  glm::vec4 outline{}; ///< Around lines and marks, so that they read on any ground.
  glm::vec4 label{};
  glm::vec4 controllerCentre = rgba(okabe::yellow); ///< Controllers by the side of the body they are on.
  glm::vec4 controllerLeft = rgba(0x4DA3FF);
  glm::vec4 controllerRight = rgba(0xF0703A);
  glm::vec4 original = rgba(okabe::skyBlue); ///< The original path.
  std::array<glm::vec4, 5> trails{rgba(okabe::orange), rgba(okabe::bluishGreen), rgba(okabe::reddishPurple),
                                  rgba(okabe::yellow), rgba(okabe::blue)};
  glm::vec4 ghostBefore = rgba(0x7A6FD6); ///< The character at frames before, and after: no trail's colours.
  glm::vec4 ghostAfter = rgba(0x5FB8A0);
  glm::vec4 ghostTip = rgba(0xE070C8); ///< The character at a trail's tip: of no skin's and no selection's
                                       ///< hue.
};

[[nodiscard]] Palette darkPalette();
[[nodiscard]] Palette lightPalette();
[[nodiscard]] Palette highContrastPalette();

} // namespace stretch::ui

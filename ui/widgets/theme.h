#pragma once

#include <array>
#include <string>

#include <imgui.h>

namespace stretch::ui {

enum class ThemeKind { dark, light, highContrast };

/// Colours by what they are for; every theme fills the same roles.
struct ThemeColours {
  ImU32 background = 0; ///< Behind the panels, and of the empty viewport.
  ImU32 panel = 0;
  ImU32 raised = 0;  ///< Controls, headers, popups.
  ImU32 hovered = 0; ///< A raised thing under the mouse.
  ImU32 pressed = 0;
  ImU32 border = 0;
  ImU32 sunken = 0; ///< Graphs, text fields, lists.
  ImU32 text = 0;
  ImU32 quietText = 0;
  ImU32 accent = 0;      ///< The one accent: what is on, selected, or the next thing to do.
  ImU32 onAccent = 0;    ///< Text on the accent.
  ImU32 accentQuiet = 0; ///< Accent as a tint behind text.
  ImU32 success = 0;
  ImU32 warning = 0;
  ImU32 error = 0;
  ImU32 shadow = 0;
};

/// Null fonts mean the default font of ImGui.
struct ThemeFonts {
  ImFont* body = nullptr;    ///< 15 px.
  ImFont* label = nullptr;   ///< 13 px.
  ImFont* strong = nullptr;  ///< 15 px, semi-bold.
  ImFont* heading = nullptr; ///< 20 px, semi-bold.
  bool hasIcons = false;     ///< The icon font is merged into all of them.
};

/// How everything looks: roles, sizes in screen pixels and fonts.
struct Theme {
  ThemeKind kind = ThemeKind::dark;
  float scale = 1.0F; ///< Screen pixels a design pixel.
  ThemeColours colours;
  ThemeFonts fonts;

  /// Design pixels as screen pixels.
  [[nodiscard]] float px(float designPixels) const { return designPixels * scale; }
  [[nodiscard]] float unit() const { return px(8.0F); } ///< The grid.
  [[nodiscard]] float corner() const { return px(4.0F); }
  [[nodiscard]] float rowHeight() const { return px(26.0F); }
};

[[nodiscard]] ThemeColours coloursOf(ThemeKind kind);

/// Loads the fonts (found through fontconfig; ImGui's own where there are none) into the current context's
/// atlas, which is cleared first, at `scale` times their size. The renderer's font texture must be made again
/// afterwards.
[[nodiscard]] Theme makeTheme(ThemeKind kind, float scale);

/// Sets the current context's style: colours, spacing and rounding. To be called when the theme or the scale
/// changed.
void applyStyle(const Theme& theme);

/// How much of the window an open dialog darkens, 0..1.
inline constexpr float behindDialogs = 0.47F;

/// Colour of the original path: sky blue.
inline constexpr ImU32 originalTrailColour = IM_COL32(0x56, 0xB4, 0xE9, 255);
/// A mesh sequence and the skinned clip that it was compressed to, one over the other.
inline constexpr ImU32 originalMeshColour = IM_COL32(0xC8, 0x4A, 0x3C, 255);
inline constexpr ImU32 skinnedMeshColour = IM_COL32(0x4C, 0xA8, 0x5F, 255);
/// Colours of exaggerated paths (M. Okabe, K. Ito, "Color Universal Design"): orange, bluish green, reddish
/// purple, yellow, blue.
inline constexpr std::array<ImU32, 5> trailPalette{
    IM_COL32(0xE6, 0x9F, 0x00, 255), IM_COL32(0x00, 0x9E, 0x73, 255), IM_COL32(0xCC, 0x79, 0xA7, 255),
    IM_COL32(0xF0, 0xE4, 0x42, 255), IM_COL32(0x00, 0x72, 0xB2, 255)};
/// Palette of the same hues, dark enough for a light ground.
inline constexpr std::array<ImU32, 5> lightTrailPalette{
    IM_COL32(0xB2, 0x6E, 0x00, 255), IM_COL32(0x00, 0x7A, 0x59, 255), IM_COL32(0xA3, 0x43, 0x7B, 255),
    IM_COL32(0x86, 0x7C, 0x00, 255), IM_COL32(0x00, 0x5C, 0x94, 255)};
inline constexpr ImU32 lightOriginalTrailColour = IM_COL32(0x16, 0x74, 0xAD, 255);
/// On a black ground the blue is brighter.
inline constexpr ImU32 contrastBlueTrailColour = IM_COL32(0x4D, 0xA3, 0xFF, 255);

/// Colour of a trail by its index into the palette, which repeats; on the light theme's ground a darker one
/// of the same hue.
[[nodiscard]] ImU32 trailColour(int index, ThemeKind theme);
/// Colour of the original path on that ground.
[[nodiscard]] ImU32 originalColour(ThemeKind theme);

/// The colour with its opacity multiplied by `opacity` (0..1).
[[nodiscard]] ImU32 faded(ImU32 colour, float opacity);
/// Between two colours, 0 = a, 1 = b.
[[nodiscard]] ImU32 mixed(ImU32 a, ImU32 b, float amount);

/// Path of the font file that fontconfig finds for a family and weight (0..210 as fontconfig counts), empty
/// when that family is not installed.
[[nodiscard]] std::string findFont(const std::string& family, int weight);

} // namespace stretch::ui

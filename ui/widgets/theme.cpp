#include "ui/widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fontconfig/fontconfig.h>
#include <imgui_freetype.h>

#include "ui/widgets/icons.h"

namespace stretch::ui {

namespace {

constexpr ImU32 rgb(unsigned hex) {
  return IM_COL32((hex >> 16U) & 255U, (hex >> 8U) & 255U, hex & 255U, 255U);
}

/// One role in each theme, in the order of ThemeKind.
struct RoleColours {
  ImU32 ThemeColours::*role;
  std::array<ImU32, 3> byTheme;
};

constexpr RoleColours roleColours[] = {
    {&ThemeColours::background, {rgb(0x151618), rgb(0xC9CBD0), rgb(0x000000)}},
    {&ThemeColours::panel, {rgb(0x1E1F22), rgb(0xECEDEF), rgb(0x000000)}},
    {&ThemeColours::raised, {rgb(0x2A2C31), rgb(0xFBFBFC), rgb(0x1C1C1C)}},
    {&ThemeColours::hovered, {rgb(0x34373D), rgb(0xE1E2E6), rgb(0x3A3A3A)}},
    {&ThemeColours::pressed, {rgb(0x3E424A), rgb(0xD3D5DA), rgb(0x505050)}},
    {&ThemeColours::border, {rgb(0x33363C), rgb(0xC6C8CE), rgb(0xA8A8A8)}},
    {&ThemeColours::sunken, {rgb(0x17181B), rgb(0xF7F7F8), rgb(0x0A0A0A)}},
    {&ThemeColours::text, {rgb(0xD8DADF), rgb(0x1F2126), rgb(0xFFFFFF)}},
    {&ThemeColours::quietText, {rgb(0x8B9098), rgb(0x5C616B), rgb(0xD2D2D2)}},
    {&ThemeColours::accent, {rgb(0xA594F9), rgb(0x5A45C6), rgb(0xFFD84A)}},
    {&ThemeColours::onAccent, {rgb(0x16121F), rgb(0xFFFFFF), rgb(0x000000)}},
    {&ThemeColours::accentQuiet, {rgb(0x3A3554), rgb(0xDAD4F7), rgb(0x5A4A00)}},
    {&ThemeColours::success, {rgb(0x5BBF96), rgb(0x00714F), rgb(0x5CFFB8)}},
    {&ThemeColours::warning, {rgb(0xE8B450), rgb(0x8A5A00), rgb(0xFFC857)}},
    {&ThemeColours::error, {rgb(0xE8773C), rgb(0xB24700), rgb(0xFF8A4C)}},
    {&ThemeColours::shadow, {IM_COL32(0, 0, 0, 110), IM_COL32(0, 0, 0, 50), IM_COL32(0, 0, 0, 180)}},
};

constexpr float lineHeightOfEm = 1.21F; ///< Of Inter: ascent and descent over the em.

struct FontFiles {
  std::string regular;
  std::string semiBold;
  std::string icons;
};

ImFont* loadFont(ImFontAtlas& atlas, const std::string& file, float pixels, const ImWchar* ranges) {
  ImFontConfig config;
  config.OversampleH = 1;
  config.OversampleV = 1;
  config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  if (!file.empty()) {
    return atlas.AddFontFromFileTTF(file.c_str(), pixels, &config, ranges);
  }
  config.SizePixels = std::max(13.0F, 13.0F * std::round(pixels / 13.0F));
  return atlas.AddFontDefault(&config);
}

void mergeIcons(ImFontAtlas& atlas, const std::string& file, float pixels, const ImWchar* ranges) {
  ImFontConfig config;
  config.MergeMode = true;
  config.GlyphMinAdvanceX = pixels * 1.1F;
  config.GlyphOffset = ImVec2(0.0F, std::round(pixels * 0.06F));
  config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  atlas.AddFontFromFileTTF(file.c_str(), std::round(pixels * 0.95F), &config, ranges);
}

void textRanges(ImFontAtlas& atlas, ImVector<ImWchar>& ranges) {
  ImFontGlyphRangesBuilder builder;
  builder.AddRanges(atlas.GetGlyphRangesDefault());
  builder.AddRanges(atlas.GetGlyphRangesCyrillic());
  const ImWchar more[] = {0x0100, 0x017F, 0x0370, 0x03FF, 0x2000, 0x2044, 0x2190, 0x2199, 0x2212, 0x2212, 0};
  builder.AddRanges(more);
  builder.BuildRanges(&ranges);
}

ThemeFonts loadFonts(float scale) {
  const FontFiles files{findFont("Inter", FC_WEIGHT_REGULAR), findFont("Inter", FC_WEIGHT_DEMIBOLD),
                        findFont("FontAwesome", FC_WEIGHT_REGULAR)};
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  ImVector<ImWchar> text;
  textRanges(atlas, text);
  ImVector<ImWchar> icons;
  ImFontGlyphRangesBuilder builder;
  builder.AddText(icon::all);
  builder.BuildRanges(&icons);
  const auto load = [&](const std::string& file, float designPixels) {
    const float pixels = std::round(designPixels * scale);
    // The atlas counts the height of a line, people count the em.
    ImFont* font = loadFont(atlas, file, std::round(pixels * lineHeightOfEm), text.Data);
    if (!files.icons.empty()) {
      mergeIcons(atlas, files.icons, pixels, icons.Data);
    }
    return font;
  };
  ThemeFonts fonts;
  fonts.body = load(files.regular, 15.0F);
  fonts.label = load(files.regular, 13.0F);
  fonts.strong = load(files.semiBold, 15.0F);
  fonts.heading = load(files.semiBold, 20.0F);
  fonts.hasIcons = !files.icons.empty();
  atlas.Build();
  return fonts;
}

/// What ImGui draws in the colour of a role.
struct StyleRole {
  ImGuiCol style;
  ImU32 ThemeColours::*role;
};

constexpr StyleRole styleRoles[] = {
    {ImGuiCol_Text, &ThemeColours::text},
    {ImGuiCol_TextDisabled, &ThemeColours::quietText},
    {ImGuiCol_WindowBg, &ThemeColours::panel},
    {ImGuiCol_PopupBg, &ThemeColours::raised},
    {ImGuiCol_Border, &ThemeColours::border},
    {ImGuiCol_FrameBg, &ThemeColours::raised},
    {ImGuiCol_FrameBgHovered, &ThemeColours::hovered},
    {ImGuiCol_FrameBgActive, &ThemeColours::pressed},
    {ImGuiCol_TitleBg, &ThemeColours::raised},
    {ImGuiCol_TitleBgActive, &ThemeColours::raised},
    {ImGuiCol_TitleBgCollapsed, &ThemeColours::raised},
    {ImGuiCol_MenuBarBg, &ThemeColours::panel},
    {ImGuiCol_ScrollbarGrab, &ThemeColours::hovered},
    {ImGuiCol_ScrollbarGrabHovered, &ThemeColours::pressed},
    {ImGuiCol_ScrollbarGrabActive, &ThemeColours::quietText},
    {ImGuiCol_Separator, &ThemeColours::border},
    {ImGuiCol_CheckMark, &ThemeColours::accent},
    {ImGuiCol_SliderGrab, &ThemeColours::accent},
    {ImGuiCol_SliderGrabActive, &ThemeColours::accent},
    {ImGuiCol_Button, &ThemeColours::raised},
    {ImGuiCol_ButtonHovered, &ThemeColours::hovered},
    {ImGuiCol_ButtonActive, &ThemeColours::pressed},
    {ImGuiCol_Header, &ThemeColours::accentQuiet},
    {ImGuiCol_HeaderHovered, &ThemeColours::hovered},
    {ImGuiCol_HeaderActive, &ThemeColours::pressed},
    {ImGuiCol_SeparatorHovered, &ThemeColours::accent},
    {ImGuiCol_SeparatorActive, &ThemeColours::accent},
    {ImGuiCol_ResizeGripHovered, &ThemeColours::hovered},
    {ImGuiCol_ResizeGripActive, &ThemeColours::accent},
    {ImGuiCol_Tab, &ThemeColours::panel},
    {ImGuiCol_TabHovered, &ThemeColours::hovered},
    {ImGuiCol_TabActive, &ThemeColours::raised},
    {ImGuiCol_TextSelectedBg, &ThemeColours::accentQuiet},
    {ImGuiCol_DragDropTarget, &ThemeColours::accent},
    {ImGuiCol_NavHighlight, &ThemeColours::accent},
    {ImGuiCol_TableHeaderBg, &ThemeColours::raised},
    {ImGuiCol_TableBorderStrong, &ThemeColours::border},
    {ImGuiCol_TableBorderLight, &ThemeColours::border},
};

void setColour(ImGuiStyle& style, ImGuiCol role, ImU32 colour) {
  style.Colors[role] = ImGui::ColorConvertU32ToFloat4(colour);
}

void setColours(ImGuiStyle& style, const ThemeColours& colours) {
  for (const StyleRole& entry : styleRoles) {
    setColour(style, entry.style, colours.*entry.role);
  }
  for (const ImGuiCol unseen :
       {ImGuiCol_ChildBg, ImGuiCol_BorderShadow, ImGuiCol_ScrollbarBg, ImGuiCol_ResizeGrip}) {
    setColour(style, unseen, IM_COL32_BLACK_TRANS);
  }
  style.Colors[ImGuiCol_ModalWindowDimBg] = {0.0F, 0.0F, 0.0F, behindDialogs};
}

} // namespace

ThemeColours coloursOf(ThemeKind kind) {
  ThemeColours colours;
  for (const RoleColours& entry : roleColours) {
    colours.*entry.role = entry.byTheme[static_cast<std::size_t>(kind)];
  }
  return colours;
}

Theme makeTheme(ThemeKind kind, float scale) {
  Theme theme;
  theme.kind = kind;
  theme.scale = scale;
  theme.colours = coloursOf(kind);
  theme.fonts = loadFonts(scale);
  return theme;
}

void applyStyle(const Theme& theme) {
  ImGuiStyle style;
  style.WindowPadding = ImVec2(12.0F, 8.0F);
  style.FramePadding = ImVec2(8.0F, 5.0F);
  style.CellPadding = ImVec2(4.0F, 2.0F);
  style.ItemSpacing = ImVec2(8.0F, 6.0F);
  style.ItemInnerSpacing = ImVec2(6.0F, 4.0F);
  style.IndentSpacing = 16.0F;
  style.ScrollbarSize = 10.0F;
  style.GrabMinSize = 10.0F;
  style.WindowRounding = 0.0F;
  style.ChildRounding = 4.0F;
  style.FrameRounding = 4.0F;
  style.PopupRounding = 6.0F;
  style.ScrollbarRounding = 5.0F;
  style.GrabRounding = 4.0F;
  style.TabRounding = 4.0F;
  style.WindowBorderSize = theme.kind == ThemeKind::highContrast ? 1.0F : 0.0F;
  style.ChildBorderSize = 1.0F;
  style.PopupBorderSize = 1.0F;
  style.FrameBorderSize = theme.kind == ThemeKind::highContrast ? 1.0F : 0.0F;
  style.DisabledAlpha = 0.45F;
  style.ScaleAllSizes(theme.scale);
  style.MouseCursorScale = 1.0F;
  setColours(style, theme.colours);
  ImGui::GetStyle() = style;
  ImGui::GetIO().FontDefault = theme.fonts.body;
}

ImU32 trailColour(int index, ThemeKind theme) {
  const int count = static_cast<int>(trailPalette.size());
  const auto place = static_cast<std::size_t>(((index % count) + count) % count);
  if (theme == ThemeKind::highContrast && place + 1 == trailPalette.size()) {
    return contrastBlueTrailColour;
  }
  return theme == ThemeKind::light ? lightTrailPalette[place] : trailPalette[place];
}

ImU32 originalColour(ThemeKind theme) {
  return theme == ThemeKind::light ? lightOriginalTrailColour : originalTrailColour;
}

ImU32 faded(ImU32 colour, float opacity) {
  const float alpha = static_cast<float>(colour >> IM_COL32_A_SHIFT) * std::clamp(opacity, 0.0F, 1.0F);
  return (colour & ~IM_COL32_A_MASK) | (static_cast<ImU32>(std::lround(alpha)) << IM_COL32_A_SHIFT);
}

ImU32 mixed(ImU32 a, ImU32 b, float amount) {
  const ImVec4 from = ImGui::ColorConvertU32ToFloat4(a);
  const ImVec4 to = ImGui::ColorConvertU32ToFloat4(b);
  const auto mix = [amount](float x, float y) { return x + (y - x) * amount; };
  return ImGui::ColorConvertFloat4ToU32(
      {mix(from.x, to.x), mix(from.y, to.y), mix(from.z, to.z), mix(from.w, to.w)});
}

std::string findFont(const std::string& family, int weight) {
  const std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)> config(FcInitLoadConfigAndFonts(),
                                                                     &FcConfigDestroy);
  if (!config) {
    return {};
  }
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> pattern(FcPatternCreate(), &FcPatternDestroy);
  FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  FcPatternAddInteger(pattern.get(), FC_WEIGHT, weight);
  FcPatternAddInteger(pattern.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcConfigSubstitute(config.get(), pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult outcome = FcResultNoMatch;
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> match(
      FcFontMatch(config.get(), pattern.get(), &outcome), &FcPatternDestroy);
  FcChar8* text = nullptr;
  if (!match || FcPatternGetString(match.get(), FC_FAMILY, 0, &text) != FcResultMatch ||
      reinterpret_cast<const char*>(text) != family) {
    return {}; // fontconfig always answers with some font: another family is no answer
  }
  return FcPatternGetString(match.get(), FC_FILE, 0, &text) == FcResultMatch
             ? reinterpret_cast<const char*>(text)
             : std::string();
}

} // namespace stretch::ui

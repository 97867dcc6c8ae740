#include "ui/render/view/palette.h"

namespace stretch::ui {

glm::vec3 rgb(std::uint32_t hex) {
  const auto channel = [hex](unsigned shift) { return static_cast<float>((hex >> shift) & 0xFFU) / 255.0F; };
  return {channel(16), channel(8), channel(0)};
}

glm::vec4 rgba(std::uint32_t hex, float alpha) {
  return {rgb(hex), alpha};
}

Palette darkPalette() {
  Palette palette;
  palette.backgroundTop = rgb(0x2C2E33);
  palette.backgroundBottom = rgb(0x1B1C1F);
  palette.floor = rgb(0x303338);
  palette.floorLine = rgb(0x4A4E55);
  palette.shadow = rgb(0x0E0F11);
  palette.wire = rgba(0x0B0C0E, 0.55F);
  palette.selectionLine = rgba(0xFFFFFF);
  palette.selectionGround = rgba(0x0B0C0E);
  palette.bone = rgba(0xD8DADF, 0.9F);
  palette.boneSelected = rgba(okabe::orange);
  palette.outline = rgba(0x121316, 0.75F);
  palette.label = rgba(0xD8DADF);
  return palette;
}

Palette lightPalette() {
  Palette palette;
  palette.backgroundTop = rgb(0xD9DBDF);
  palette.backgroundBottom = rgb(0xC3C6CB);
  palette.floor = rgb(0xD3D5D9);
  palette.floorLine = rgb(0xA7ABB2);
  palette.shadow = rgb(0x6A6E76);
  palette.wire = rgba(0x1E1F22, 0.5F);
  palette.selectionLine = rgba(0x1E1F22);
  palette.selectionGround = rgba(0xFFFFFF);
  palette.ghostTip = rgba(0xB0309A);
  palette.controllerCentre = rgba(0x5F6600);
  palette.controllerLeft = rgba(0x005C94);
  palette.controllerRight = rgba(0xC23B00);
  palette.bone = rgba(0x33363B, 0.9F);
  palette.boneSelected = rgba(okabe::vermilion);
  palette.outline = rgba(0xF4F5F6, 0.8F);
  palette.label = rgba(0x1E1F22);
  return palette;
}

Palette highContrastPalette() {
  Palette palette;
  palette.backgroundTop = rgb(0x000000);
  palette.backgroundBottom = rgb(0x000000);
  palette.floor = rgb(0x0A0A0A);
  palette.floorLine = rgb(0x606060);
  palette.shadow = rgb(0x000000);
  palette.wire = rgba(0x000000, 0.8F);
  palette.selectionLine = rgba(0xFFFFFF);
  palette.selectionGround = rgba(0x000000);
  palette.ghostTip = rgba(0xFF6BE0);
  palette.bone = rgba(0xFFFFFF);
  palette.boneSelected = rgba(okabe::yellow);
  palette.outline = rgba(0x000000);
  palette.label = rgba(0xFFFFFF);
  return palette;
}

} // namespace stretch::ui

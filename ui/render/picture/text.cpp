#include "ui/render/picture/text.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H

namespace stretch::ui {

struct TextFace::Library {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  Library() = default;
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() {
    if (face != nullptr) {
      FT_Done_Face(face);
    }
    if (library != nullptr) {
      FT_Done_FreeType(library);
    }
  }
};

namespace {

std::string fontFile() {
  FcConfig* config = FcInitLoadConfigAndFonts();
  FcPattern* wanted = FcNameParse(reinterpret_cast<const FcChar8*>("Inter:style=Medium,sans"));
  FcConfigSubstitute(config, wanted, FcMatchPattern);
  FcDefaultSubstitute(wanted);
  FcResult result = FcResultNoMatch;
  FcPattern* found = FcFontMatch(config, wanted, &result);
  FcChar8* path = nullptr;
  std::string file;
  if (found != nullptr && FcPatternGetString(found, FC_FILE, 0, &path) == FcResultMatch) {
    file = reinterpret_cast<const char*>(path);
  }
  if (found != nullptr) {
    FcPatternDestroy(found);
  }
  FcPatternDestroy(wanted);
  FcConfigDestroy(config);
  return file;
}

// Code points of UTF-8; a byte that starts none becomes the replacement character.
std::vector<char32_t> codePoints(std::string_view text) {
  std::vector<char32_t> points;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80U    ? 1
                               : lead >= 0xF0U ? 4
                               : lead >= 0xE0U ? 3
                               : lead >= 0xC0U ? 2
                                               : 0;
    if (length == 0 || i + length > text.size()) {
      points.push_back(0xFFFD);
      ++i;
      continue;
    }
    char32_t point = length == 1 ? lead : lead & (0x7FU >> length);
    for (std::size_t k = 1; k < length; ++k) {
      point = (point << 6U) | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
    }
    points.push_back(point);
    i += length;
  }
  return points;
}

void blendPixel(Image& image, int x, int y, const glm::vec4& color, float coverage) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) {
    return;
  }
  const auto index =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  for (glm::length_t channel = 0; channel < 3; ++channel) {
    std::uint8_t& value = image.rgba[index + channel];
    const float blended = std::lerp(static_cast<float>(value), 255.0F * color[channel], coverage * color.a);
    value = static_cast<std::uint8_t>(std::lround(std::clamp(blended, 0.0F, 255.0F)));
  }
}

void blendGlyph(Image& image, const FT_GlyphSlot glyph, int x, int y, const glm::vec4& color) {
  const FT_Bitmap& bitmap = glyph->bitmap;
  for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
    for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
      const unsigned char coverage = bitmap.buffer[row * bitmap.pitch + column];
      blendPixel(image, x + glyph->bitmap_left + column, y - glyph->bitmap_top + row, color,
                 static_cast<float>(coverage) / 255.0F);
    }
  }
}

} // namespace

TextFace::TextFace(int heightPixels) : library_(std::make_unique<Library>()) {
  const std::string file = fontFile();
  if (file.empty() || FT_Init_FreeType(&library_->library) != 0 ||
      FT_New_Face(library_->library, file.c_str(), 0, &library_->face) != 0) {
    return;
  }
  FT_Set_Pixel_Sizes(library_->face, 0, static_cast<FT_UInt>(std::max(1, heightPixels)));
}

TextFace::TextFace(TextFace&&) noexcept = default;
TextFace& TextFace::operator=(TextFace&&) noexcept = default;
TextFace::~TextFace() = default;

void TextFace::write(Image& image, int x, int y, std::string_view text, const glm::vec4& colorSrgb) const {
  const FT_Face face = library_->face;
  int pen = x;
  for (const char32_t point : codePoints(text)) {
    if (face == nullptr || FT_Load_Char(face, point, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) != 0) {
      continue;
    }
    blendGlyph(image, face->glyph, pen, y, colorSrgb);
    pen += static_cast<int>(face->glyph->advance.x >> 6);
  }
}

int TextFace::widthOf(std::string_view text) const {
  const FT_Face face = library_->face;
  int width = 0;
  for (const char32_t point : codePoints(text)) {
    if (face != nullptr && FT_Load_Char(face, point, FT_LOAD_TARGET_LIGHT) == 0) {
      width += static_cast<int>(face->glyph->advance.x >> 6);
    }
  }
  return width;
}

} // namespace stretch::ui

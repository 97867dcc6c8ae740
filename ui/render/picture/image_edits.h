#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "ui/render/view/camera_view.h"

namespace stretch::ui {

/// Averages blocks of `factor` x `factor` pixels; sides are divided by it (rounded down).
[[nodiscard]] Image reduced(const Image& image, int factor);

void makeOpaque(Image& image);

[[nodiscard]] Image filled(int widthPixels, int heightPixels, const glm::vec3& colorSrgb);

/// Copies `picture` into `sheet`, its top left at (x, y); what does not fit is cut off.
void paste(Image& sheet, const Image& picture, int x, int y);

/// Draws a thin rectangle; what lies outside is cut off.
void outline(Image& image, const PixelBox& box, const glm::vec3& colorSrgb);

/// Places of pictures of one size on a sheet, row by row, with a thin gap between them.
struct SheetLayout {
  int columns = 1;
  int cellWidth = 0; ///< Gap included, pixels.
  int cellHeight = 0;
  int widthPixels = 0;
  int heightPixels = 0;

  [[nodiscard]] int left(std::size_t index) const;
  [[nodiscard]] int top(std::size_t index) const;
};

/// `columns` 0 chooses so that the sheet comes out about as wide as high. Sides that would overflow are
/// clamped.
[[nodiscard]] SheetLayout layOutSheet(std::size_t count, int pictureWidth, int pictureHeight, int columns);

/// An error for a sheet without pictures, or over 16384 pixels along a side.
[[nodiscard]] Status checkSheet(const SheetLayout& layout, std::size_t count);

/// The picture as a PNG file's bytes (RGBA). Empty pictures are an error.
[[nodiscard]] Result<std::vector<std::uint8_t>> encodePng(const Image& image);

/// Writes a PNG; an existing file is replaced at once or, on an error, left as it is.
[[nodiscard]] Status writePng(const std::filesystem::path& path, const Image& image);

/// Reads a PNG, JPEG, BMP or TGA as RGBA. An error for another one, and for over 100 million pixels.
[[nodiscard]] Result<Image> readImage(const std::filesystem::path& path);

} // namespace stretch::ui

#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

#include "core/scene/scene.h"

namespace stretch::ui {

/// Averages blocks of `factor` x `factor` pixels; sides are divided by it (rounded down).
[[nodiscard]] Image reduced(const Image& image, int factor);

void makeOpaque(Image& image);

[[nodiscard]] Image filled(int widthPixels, int heightPixels, const glm::vec3& colorSrgb);

/// Copies `picture` into `sheet`, its top left at (x, y); what does not fit is cut off.
void paste(Image& sheet, const Image& picture, int x, int y);

/// Where pictures of one size go on a sheet, row by row, with a thin gap between them.
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

} // namespace stretch::ui

#include <algorithm>

#include <catch2/catch.hpp>

#include "ui/render/picture/image_edits.h"
#include "ui/render/picture/picture_legend.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

constexpr int letterPixels = 16;
const glm::vec4 whiteText(1.0F);
const glm::vec4 lowEnd(1.0F, 0.0F, 0.0F, 1.0F);
const glm::vec4 highEnd(0.0F, 0.0F, 1.0F, 1.0F);

Image withLegend(const PictureLegend& legend) {
  Image image = filled(800, 300, glm::vec3(0.0F));
  drawLegend(image, TextFace(letterPixels), letterPixels, legend, whiteText);
  return image;
}

/// Whether anything is drawn in a column, between two rows.
bool isDrawnIn(const Image& image, int column, int top, int bottom) {
  for (int y = top; y < bottom; ++y) {
    const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(column));
    if (image.rgba[at] > 40 || image.rgba[at + 1] > 40 || image.rgba[at + 2] > 40) {
      return true;
    }
  }
  return false;
}

/// The most columns beside each other, between things that are drawn, that hold nothing.
int widestGap(const Image& image, int top, int bottom) {
  int widest = 0;
  int gap = 0;
  bool began = false;
  for (int x = 0; x < image.width; ++x) {
    if (isDrawnIn(image, x, top, bottom)) {
      widest = began ? std::max(widest, gap) : widest;
      began = true;
      gap = 0;
    } else {
      ++gap;
    }
  }
  return widest;
}

int lastDrawn(const Image& image, int top, int bottom) {
  int last = -1;
  for (int x = 0; x < image.width; ++x) {
    last = isDrawnIn(image, x, top, bottom) ? x : last;
  }
  return last;
}

} // namespace

TEST_CASE("The bar of a legend is twelve letters wide, and begins a letter from the left") {
  const Image image = withLegend({.title = "Stretch", .low = "0", .high = "1", .colours = {lowEnd, highEnd}});
  // Over the texts of its ends: the bar's own rows.
  const int barBottom = 300 - letterPixels - letterPixels - letterPixels / 4;
  const int top = barBottom - letterPixels;
  CHECK_FALSE(isDrawnIn(image, letterPixels - 1, top, barBottom));
  CHECK(isDrawnIn(image, letterPixels, top, barBottom));
  CHECK(lastDrawn(image, top, barBottom) == 13 * letterPixels - 1);
  CHECK_FALSE(isDrawnIn(image, letterPixels + 3, 0, top - 2 * letterPixels)); // Nothing stands higher than
                                                                              // its title.
}

TEST_CASE(
    "Long texts at the ends of a legend's bar keep two letters apart, and the bar is as wide as they need") {
  const TextFace face(letterPixels);
  const PictureLegend legend{.title = "Stretch",
                             .low = "shorter than it was at rest",
                             .high = "longer than it was at rest",
                             .colours = {lowEnd, highEnd}};
  const int wanted = face.widthOf(legend.low) + 2 * letterPixels + face.widthOf(legend.high);
  if (face.widthOf(legend.low) == 0) {
    return; // A system without any font writes nothing.
  }
  REQUIRE(wanted > 12 * letterPixels);
  const Image image = withLegend(legend);
  const int barBottom = 300 - letterPixels - letterPixels - letterPixels / 4;
  CHECK(lastDrawn(image, barBottom - letterPixels, barBottom) == letterPixels + wanted - 1);
  const int gap = widestGap(image, 300 - 2 * letterPixels + 2, 300 - letterPixels);
  CHECK(gap > 2 * letterPixels - 4);
  CHECK(gap < 2 * letterPixels + 6);
}

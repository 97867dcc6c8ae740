#include "ui/render/picture/picture_legend.h"

#include <algorithm>
#include <cstddef>

#include "ui/render/picture/image_edits.h"

namespace stretch::ui {

void drawLegend(Image& image, const TextFace& face, int letterHeight, const PictureLegend& legend,
                const glm::vec4& textColor) {
  const int line = letterHeight + letterHeight / 2;
  const int left = letterHeight;
  const int width = std::max({12 * letterHeight, face.widthOf(legend.title), face.widthOf(legend.detail),
                              face.widthOf(legend.low) + 2 * letterHeight + face.widthOf(legend.high)});
  int bottom = image.height - letterHeight;
  if (!legend.detail.empty()) {
    face.write(image, left, bottom, legend.detail, textColor);
    bottom -= line;
  }
  face.write(image, left, bottom, legend.low, textColor);
  face.write(image, left + width - face.widthOf(legend.high), bottom, legend.high, textColor);
  const int barBottom = bottom - letterHeight - letterHeight / 4;
  const auto count = static_cast<int>(legend.colours.size());
  for (int i = 0; i < count; ++i) {
    const int begin = width * i / count;
    const int end = width * (i + 1) / count;
    if (end > begin) {
      paste(image, filled(end - begin, letterHeight, glm::vec3(legend.colours[static_cast<std::size_t>(i)])),
            left + begin, barBottom - letterHeight);
    }
  }
  face.write(image, left, barBottom - letterHeight - letterHeight / 2, legend.title, textColor);
}

} // namespace stretch::ui

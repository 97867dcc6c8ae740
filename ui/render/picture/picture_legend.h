#pragma once

#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "core/scene/scene.h"
#include "ui/render/picture/text.h"

namespace stretch::ui {

/// Legend of the colours of a picture.
struct PictureLegend {
  std::string title;
  std::string low;                ///< At the left end, with the unit.
  std::string high;               ///< At the right end.
  std::string detail = {};        ///< A further line; may be empty.
  std::vector<glm::vec4> colours; ///< From left to right, sRGB.
};

/// A bar of the colours with its texts, in the lower left corner. `letterHeight`: of the face, pixels.
void drawLegend(Image& image, const TextFace& face, int letterHeight, const PictureLegend& legend,
                const glm::vec4& textColor);

} // namespace stretch::ui

#pragma once

#include <optional>
#include <string>

#include "ui/viewport/viewport_context.h"

namespace stretch::ui {

/// Draws the view cube with the world's axes below it in the upper right corner of the picture; the axes
/// alone while the cube is switched off, and nothing in a picture that is too small.
void drawViewCube(ViewportContext& context);

/// The part of the cube under the mouse; nothing beside it, and while it is not drawn.
[[nodiscard]] std::optional<CubePart> cubePartUnderMouse(const ViewportContext& context);

/// Name of a part: "front", "left top", "front right under".
[[nodiscard]] std::string nameOf(const CubePart& part);

} // namespace stretch::ui

#pragma once

#include "ui/viewport/viewport_context.h"

namespace stretch::ui {

/// Draws what the lines, ghosts and colours in the picture mean, in its lower right corner.
void drawLegends(ViewportContext& context);

} // namespace stretch::ui

#pragma once

#include <vector>

#include "ui/render/gl/gl_objects.h"
#include "ui/viewport/viewport_context.h"

namespace stretch::ui {

/// Pictures of the bundled clips on the graphics card, in their order; empty for one that is not there.
struct WelcomePictures {
  std::vector<GlTexture> textures;
  bool tried = false;
};

/// Draws what the viewport says while no file is open: the bundled clips, a button that opens a file, recent
/// files.
void drawWelcome(ViewportContext& context, WelcomePictures& pictures, const Rect& box);

} // namespace stretch::ui

#pragma once

#include "core/scene/scene.h"
#include "ui/render/gl/gl_objects.h"

namespace stretch::ui {

/// A picture for drawing as it is, smaller too; an empty texture for an empty picture.
[[nodiscard]] GlTexture uploadPicture(const Image& image);

} // namespace stretch::ui

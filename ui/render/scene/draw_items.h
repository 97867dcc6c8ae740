#pragma once

#include "core/anim/frame_state.h"
#include "ui/render/scene/scene_upload.h"

namespace stretch::ui {

/// Draws the posed triangles of an item with the program in use.
void drawTriangles(const UploadedScene& uploaded, const DrawItem& item);

/// Tells OpenGL which side of the item's triangles is the front: what is mirrored turns them inside out.
void setFrontFace(const Scene& scene, const DrawItem& item, const FrameState& frame);

} // namespace stretch::ui

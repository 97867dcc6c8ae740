#pragma once

#include "ui/viewport/viewport_pane.h"

namespace stretch::ui {

// The viewport while a mesh sequence is open.

/// Moves the camera so that all frames are seen.
void frameSequence(ViewportContext& context);

/// The frame at the playhead, the result over it, bones and legend, in `picture` (window units).
void drawSequenceScene(ViewportContext& context, ViewportGpu& gpu, const Rect& picture);

} // namespace stretch::ui

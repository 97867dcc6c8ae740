#pragma once

#include <optional>

#include "rig/trail/trail.h"

namespace stretch::ui {

struct ViewportContext;

/// Memory of what the viewport saw of the selected trail in the frame before: whether it is being changed.
struct TipWatch {
  int trail = 0; ///< Id; 0: none.
  rig::TrailSettings settings;
  bool applied = false;
  float secondsLeft = 0.0F;   ///< For which the pose at the tip is still shown.
  bool toldOutOfView = false; ///< That the tip left the picture.
};

/// The frame whose pose stands as a ghost: the tip of the trail that E works on, or of the selected one while
/// it is changed by any hand and a moment after. Nothing while the playhead stands there.
[[nodiscard]] std::optional<double> tipGhostFrame(ViewportContext& context);

/// Tells once, while the tip is changed, that it left the picture, and which key frames it.
void tellTipOutOfView(ViewportContext& context);

} // namespace stretch::ui

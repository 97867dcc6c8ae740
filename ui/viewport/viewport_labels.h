#pragma once

#include <optional>

#include <imgui.h>

#include "ui/viewport/viewport_context.h"

namespace stretch::ui {

/// A world point in window units; nothing behind the eye.
[[nodiscard]] std::optional<ImVec2> placeOf(const ViewportState& viewport, const Vec3& world);

/// Text and flat shapes over the picture: frame numbers, joint names, what is shown, the box of a selection,
/// the ease curve while it is edited. Records where spheres and limbs are.
void drawViewportLabels(ViewportContext& context, const FrameState& frame);

} // namespace stretch::ui

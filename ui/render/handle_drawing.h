#pragma once

#include <optional>

#include "ui/render/overlay.h"
#include "ui/render/picking.h"

namespace stretch::ui {

/// The three arrows of axis handles. `active`: the axis under the mouse or being dragged, drawn brighter and
/// thicker; the others are then quieter. Red, green, blue for x, y, z as everywhere, in shades that stay
/// apart for every eye.
[[nodiscard]] Overlay drawAxisHandles(const View& view, const AxisHandles& handles,
                                      std::optional<std::size_t> active = std::nullopt);

} // namespace stretch::ui

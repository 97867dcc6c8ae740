#pragma once

#include <optional>
#include <string>

#include "core/math/types.h"
#include "ui/panels/panel_context.h"

namespace stretch::ui {

/// Young's modulus, mass, scale, gravity and the moduli of segments of the sequence that is open.
void elasticModelRows(PanelContext& context);

/// Three numbers as people type them: "0, -9.81, 0" or "0 -9.81 0". Empty when they are anything else.
[[nodiscard]] std::optional<Vec3> parseThree(const std::string& text);

} // namespace stretch::ui

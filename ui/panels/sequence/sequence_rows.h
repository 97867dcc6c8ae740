#pragma once

#include "ui/panels/context/panel_context.h"

namespace stretch::ui {

/// Young's modulus, mass, scale, gravity and the moduli of segments of the sequence that is open.
void elasticModelRows(PanelContext& context);

} // namespace stretch::ui

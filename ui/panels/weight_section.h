#pragma once

#include <string>

#include "ui/panels/panel_context.h"

namespace stretch::ui {

/// The weight of a limb in the viewed clip: on or off, how soft, what it comes to. Edits change the same
/// setting of every selected limb that has weight.
void weightSection(PanelContext& context, const std::string& limbId);

} // namespace stretch::ui

#pragma once

#include <span>
#include <string>

#include "ui/panels/context/panel_context.h"
#include "ui/widgets/key_diamond.h"

namespace stretch::ui {

/// Where these controllers and attributes have keys in the viewed clip.
[[nodiscard]] KeyMark keyMarkOf(const app::Session& session, std::span<const std::string> ids);

/// What the selected controllers are offset by, as numbers, and what goes with it: keys, range, attributes.
/// At least one is selected.
void drawControllerSettings(PanelContext& context);

} // namespace stretch::ui

#pragma once

#include <span>
#include <string>

#include "ui/panels/context/panel_context.h"
#include "ui/widgets/key_diamond.h"

namespace stretch::ui {

/// Says where these controllers and attributes have keys in the viewed clip.
[[nodiscard]] KeyMark keyMarkOf(const app::Session& session, std::span<const std::string> ids);

/// Draws the offsets of the selected controllers, as numbers, and what goes with it: keys, range, attributes.
/// At least one is selected.
void drawControllerSettings(PanelContext& context);

} // namespace stretch::ui

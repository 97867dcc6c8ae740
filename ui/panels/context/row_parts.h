#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/panels/context/panel_context.h"

namespace stretch::ui {

/// A control in a row that may be too short for all of them.
struct RowControl {
  float width = 0.0F;         ///< Screen pixels, with the space behind it.
  std::function<void()> draw; ///< At the cursor; the next part follows on the same line.
};

/// Draws as many parts as fit, the first ones first; the others behind a button at the row's end, which opens
/// them below each other. The button is `id`, its list `id` and "/list".
void rowOfParts(PanelContext& context, const std::string& id, float available,
                const std::vector<RowControl>& parts);

} // namespace stretch::ui

#pragma once

#include <string>

#include "core/base/result.h"
#include "ui/panels/ui_state.h"

namespace stretch::ui {

/// Tells the user something for a few seconds; what is told already is not told twice.
void tell(UiState& ui, ToastKind kind, const std::string& text);

/// An error as a toast; nothing for success.
void tellProblem(UiState& ui, const Status& status);

} // namespace stretch::ui

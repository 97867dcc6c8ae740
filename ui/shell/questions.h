#pragma once

#include "ui/shell/shell.h"

namespace stretch::ui {

/// Asks whether to overwrite a file that another program changed since it was opened, while that is open.
void drawOverwriteQuestion(Shell& shell, PanelContext& context);

} // namespace stretch::ui

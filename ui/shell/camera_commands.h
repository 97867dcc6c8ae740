#pragma once

#include <vector>

#include "ui/shell/shell.h"

namespace stretch::ui {

/// Cameras of the file, the best view, and the views that are kept under numbers.
[[nodiscard]] std::vector<app::Command<Shell>> cameraCommands();

} // namespace stretch::ui

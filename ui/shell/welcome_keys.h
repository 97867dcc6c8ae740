#pragma once

#include "ui/shell/shell.h"

namespace stretch::ui {

/// A key for what is offered while nothing is open: arrows choose, Enter opens. False: it is not meant.
bool pressWelcomeKey(Shell& shell, const app::KeyPress& press);

} // namespace stretch::ui

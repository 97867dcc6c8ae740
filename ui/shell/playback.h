#pragma once

#include "ui/shell/shell.h"

namespace stretch::ui {

/// Moves the playhead by the time that passed, while playing.
void play(Shell& shell, double secondsPassed);

} // namespace stretch::ui

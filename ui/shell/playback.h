#pragma once

#include "ui/shell/shell.h"

namespace stretch::ui {

/// Moves the playhead by the time that passed, while playing.
void play(Shell& shell, double secondsPassed);

/// Stops the playhead: at the nearest frame while snapping is on.
void snapPlayhead(Shell& shell);

} // namespace stretch::ui

#pragma once

#include "ui/shell/shell.h"

namespace stretch::ui {

// Work of the shell on an open mesh sequence.

/// Turns the view to a sequence that was opened.
void showSequence(Shell& shell);

/// Once per frame: takes up what was made beside the window, and has the result encoded as it is asked for.
void updateSequence(Shell& shell);

/// Takes what a dialog answered while a sequence is open: where to export to, moduli or a skeleton.
void answerSequenceFile(Shell& shell, const FileChoice& choice);

/// Commands that ask for a file: moduli of segments to read or write, a skeleton to take.
[[nodiscard]] std::vector<app::Command<Shell>> sequenceFileCommands();

} // namespace stretch::ui

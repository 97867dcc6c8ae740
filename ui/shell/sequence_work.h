#pragma once

#include "ui/shell/shell.h"

namespace stretch::ui {

// What the shell does with an open mesh sequence.

/// Turns the view to a sequence that was opened.
void showSequence(Shell& shell);

/// Once per frame: takes up a compression that is done, tells how far one is.
void updateSequence(Shell& shell);

/// What a dialog answered while a sequence is open: where to export to, moduli to read or write.
void answerSequenceFile(Shell& shell, const FileChoice& choice);

/// Reading and writing the moduli of segments.
[[nodiscard]] std::vector<app::Command<Shell>> moduliCommands();

} // namespace stretch::ui

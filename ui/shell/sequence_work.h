#pragma once

#include "ui/shell/shell.h"

namespace stretch::ui {

// What the shell does with an open mesh sequence.

/// Shows it in place of what was open.
void showSequence(Shell& shell, app::SequenceDocument document);

/// Once per frame: takes up a compression that is done, tells how far one is.
void updateSequence(Shell& shell);

/// What a dialog answered while a sequence is open: where to export to, moduli to read or write.
void answerSequenceFile(Shell& shell, const FileChoice& choice);

/// Commands that only a sequence has.
[[nodiscard]] std::vector<app::Command<Shell>> sequenceCommands();

/// What commands of the character do on a sequence instead, by id: time, saving, showing the original.
struct SequenceMeaning {
  const char* commandId = "";
  bool (*enabled)(const app::SequenceSession&) = nullptr;
  Status (*run)(Shell&) = nullptr;
};
[[nodiscard]] const std::vector<SequenceMeaning>& sequenceMeanings();

} // namespace stretch::ui

#pragma once

#include <optional>
#include <string>

#include "ui/shell/shell.h"

namespace stretch::test {

/// Remembers how the open character was opened, to see whether the history gives that back.
class DocumentWatch {
public:
  /// After each frame: another file may be open.
  void look(ui::Shell& shell);
  /// Takes every step back, or brings those steps again, by the commands. Answers what is wrong, else
  /// nothing.
  [[nodiscard]] std::string undoAll(ui::Shell& shell);
  [[nodiscard]] std::string redoAll(ui::Shell& shell);

private:
  std::optional<app::Document> opened_;
  std::optional<app::Document> beforeUndo_;
  int stepsBack_ = 0;
};

/// What Escape is there to end: "the dialog of files", "a tool"; empty in the plain state.
[[nodiscard]] std::string openThing(const ui::Shell& shell);

} // namespace stretch::test

#include "tests/support/ui_driver/document_watch.h"

#include <utility>

#include <imgui.h>

#include "app/commands/table/command_ids.h"
#include "ui/shell/shell_commands.h"

namespace stretch::test {

using namespace ui;

void DocumentWatch::look(Shell& shell) {
  const app::Session* const character = shell.open.character();
  if (character == nullptr) {
    opened_.reset();
    beforeUndo_.reset();
  } else if (!opened_ ||
             (opened_->source != character->document().source && !character->history().canUndo())) {
    opened_ = character->document();
    beforeUndo_.reset();
  }
}

std::string DocumentWatch::undoAll(Shell& shell) {
  app::Session* const character = shell.open.character();
  if (character == nullptr || !opened_) {
    return {};
  }
  beforeUndo_ = character->document();
  for (stepsBack_ = 0; character->history().canUndo(); ++stepsBack_) {
    runCommand(shell, app::command::undo);
  }
  return sameDocument(character->document(), *opened_) ? ""
                                                       : "undoing all does not give back what was opened";
}

std::string DocumentWatch::redoAll(Shell& shell) {
  app::Session* const character = shell.open.character();
  const std::optional<app::Document> wanted = std::exchange(beforeUndo_, std::nullopt);
  if (character == nullptr || !wanted) {
    return {};
  }
  for (; stepsBack_ > 0; --stepsBack_) {
    runCommand(shell, app::command::redo);
  }
  return sameDocument(character->document(), *wanted)
             ? ""
             : "bringing all back does not give what was there before";
}

std::string openThing(const Shell& shell) {
  const app::Session* const character = shell.open.character();
  const std::pair<bool, const char*> things[] = {
      {isRunning(shell.tool), "the tool"},
      {shell.ui.dialogs.file.open, "the dialog of files"},
      {shell.ui.dialogs.palette.open, "the palette"},
      {shell.ui.dialogs.rangeClash.has_value(), "the question which trail is meant"},
      {shell.files.question().kind != app::FileQuestion::Kind::none, "the question about a file"},
      {widgetsOwnKeys(shell), "a dialog"},
      {ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel), "a menu"},
      {ImGui::GetIO().WantTextInput, "a text field"},
      {shell.viewport.gesture != ViewportGesture::none, "a gesture in the viewport"},
      {shell.ui.panelDrag, "a drag in a panel"},
      {character != nullptr && character->isDragging(), "an edit that was begun"},
  };
  for (const auto& [isOpen, name] : things) {
    if (isOpen) {
      return name;
    }
  }
  return {};
}

} // namespace stretch::test

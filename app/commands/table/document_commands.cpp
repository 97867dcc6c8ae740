#include "app/commands/table/document_commands.h"

#include <iterator>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/tables.h"

namespace stretch::app {

namespace {

constexpr auto canUndo = [](const auto& session) { return session.history().canUndo(); };
constexpr auto canRedo = [](const auto& session) { return session.history().canRedo(); };
} // namespace

bool isEnabled(const DocumentCommand& command, const OpenDocument& open) {
  if (const Session* const character = open.character()) {
    return command.enabled && command.enabled(*character);
  }
  const SequenceSession* const sequence = open.sequence();
  return sequence != nullptr && command.enabledOnSequence && command.enabledOnSequence(*sequence);
}

bool isChecked(const DocumentCommand& command, const OpenDocument& open) {
  const Session* const character = open.character();
  return character != nullptr && command.checked && command.checked(*character);
}

std::string labelNow(const DocumentCommand& command, const OpenDocument& open) {
  const Session* const character = open.character();
  return character != nullptr && command.labelNow ? command.labelNow(*character) : command.label;
}

std::string helpNow(const DocumentCommand& command, const OpenDocument& open) {
  const Session* const character = open.character();
  return character != nullptr && command.helpNow ? command.helpNow(*character) : command.help;
}

std::string whyOff(const DocumentCommand& command, const OpenDocument& open) {
  if (isEnabled(command, open)) {
    return {};
  }
  if (open.isEmpty()) {
    return "open a file first";
  }
  if (open.character() == nullptr) {
    return command.enabledOnSequence ? command.needs : "needs a character";
  }
  if (command.needsNow) {
    return command.needsNow(*open.character());
  }
  return command.enabled ? command.needs : "needs a mesh sequence";
}

Status run(const DocumentCommand& command, OpenDocument& open) {
  if (Session* const character = open.character()) {
    return command.run(*character);
  }
  return command.runOnSequence(*open.sequence());
}

std::vector<DocumentCommand> historyCommands() {
  const auto undo = doing([](auto& session) { session.undo(); });
  // A pose without a key came after every step of the history.
  const auto undoOfCharacter = doing([](Session& session) {
    if (isPosedWithoutKey(session.view())) {
      session.view().unkeyed = {};
    } else {
      session.undo();
    }
  });
  const auto canUndoOfCharacter = [](const Session& session) {
    return canUndo(session) || isPosedWithoutKey(session.view());
  };
  const auto redo = doing([](auto& session) { session.redo(); });
  return {
      entry(command::undo, "Undo", "Takes the last change back.", {"Ctrl+Z"},
            {canUndoOfCharacter, "nothing was done yet"}, undoOfCharacter, canUndo, undo),
      entry(command::redo, "Redo", "Brings the change that was taken back again.", {"Ctrl+Shift+Z", "Ctrl+Y"},
            {canRedo, "nothing was undone"}, redo, canRedo, redo),
  };
}

std::vector<DocumentCommand> documentCommands() {
  std::vector<DocumentCommand> all;
  for (const auto table : {historyCommands, limbCommands, selectionSetCommands, locatorCommands, timeCommands,
                           clipCommands, trailCommands, groupCommands, sphereCommands, controllerCommands,
                           poseCommands, keyCommands, holdCommands, weightCommands, sequenceCommands}) {
    std::vector<DocumentCommand> commands = table();
    std::move(commands.begin(), commands.end(), std::back_inserter(all));
  }
  return all;
}

} // namespace stretch::app

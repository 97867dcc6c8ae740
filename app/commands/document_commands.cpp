#include "app/commands/document_commands.h"

#include <iterator>

namespace stretch::app {

std::vector<Command<Session>> historyCommands() {
  return {
      {"edit.undo",
       "Undo",
       "Takes the last change back.",
       {"Ctrl+Z"},
       [](const Session& session) { return session.history().canUndo(); },
       [](Session& session) -> Status {
         session.undo();
         return Success{};
       }},
      {"edit.redo",
       "Redo",
       "Brings the change that was taken back again.",
       {"Ctrl+Shift+Z", "Ctrl+Y"},
       [](const Session& session) { return session.history().canRedo(); },
       [](Session& session) -> Status {
         session.redo();
         return Success{};
       }},
  };
}

std::vector<Command<Session>> documentCommands() {
  std::vector<Command<Session>> all;
  for (const auto table :
       {historyCommands, limbCommands, timeCommands, trailCommands, sphereCommands, weightCommands}) {
    std::vector<Command<Session>> commands = table();
    std::move(commands.begin(), commands.end(), std::back_inserter(all));
  }
  return all;
}

} // namespace stretch::app

#include "tests/support/app/run_command.h"

#include <algorithm>
#include <vector>

#include "app/commands/table/document_commands.h"
#include "core/base/check.h"

namespace stretch::test {

std::string run(app::Session& session, const std::string& commandId) {
  const std::vector<app::DocumentCommand> commands = app::documentCommands();
  const auto command = std::ranges::find(commands, commandId, &app::DocumentCommand::id);
  check(command != commands.end(), "a command of this id");
  if (!command->enabled(session)) {
    return command->needsNow ? command->needsNow(session) : command->needs;
  }
  const Status done = command->run(session);
  return done ? std::string() : done.error().line();
}

} // namespace stretch::test

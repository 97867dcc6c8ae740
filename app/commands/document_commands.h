#pragma once

#include <vector>

#include "app/commands/command.h"

namespace stretch::app {

/// Every command of the document, in the order in which menus show them. They act on what is selected in the
/// session's view: `enabled` tells whether there is something to act on, `run` says in one line why it could
/// not.
[[nodiscard]] std::vector<Command<Session>> documentCommands();

// The tables that it is made of, one per subject.
[[nodiscard]] std::vector<Command<Session>> historyCommands();
[[nodiscard]] std::vector<Command<Session>> limbCommands();
[[nodiscard]] std::vector<Command<Session>> timeCommands();
[[nodiscard]] std::vector<Command<Session>> trailCommands();
[[nodiscard]] std::vector<Command<Session>> sphereCommands();
[[nodiscard]] std::vector<Command<Session>> weightCommands();

} // namespace stretch::app

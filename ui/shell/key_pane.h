#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/shell/shell.h"

namespace stretch::ui {

/// The commands of graph and dope sheet that are the window's.
[[nodiscard]] std::vector<app::Command<Shell>> keyPaneCommands();

/// Finds the command that a key means: over graph and dope sheet the command of theirs that is like the one
/// elsewhere, so that G moves keys there, and a key that was changed is changed for both.
[[nodiscard]] std::string commandUnderMouse(const Shell& shell, const app::Chord& chord,
                                            const std::string& elsewhere);

/// Keys that mean a command over graph and dope sheet alone; none for a command that has none there.
[[nodiscard]] std::vector<app::Chord> chordsOverKeys(const Shell& shell, std::string_view commandId);

/// The mouse for a tool that moves or scales keys: once a frame, after the panels.
void moveKeysTool(Shell& shell);

} // namespace stretch::ui

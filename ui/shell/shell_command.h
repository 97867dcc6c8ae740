#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/table/command.h"
#include "ui/shell/shell.h"

namespace stretch::ui {

using ShellCommand = app::Command<Shell>;

/// When a command of the window is on, and what to do first while it is off.
struct ShellNeed {
  bool (*holds)(const Shell&) = [](const Shell&) { return true; };
  const char* text = "";
};

/// One row of a table of the window's commands.
[[nodiscard]] inline ShellCommand shellCommand(std::string id, std::string label, std::string help,
                                               std::vector<std::string> keys, const ShellNeed& need,
                                               std::function<Status(Shell&)> run) {
  return {.id = std::move(id),
          .label = std::move(label),
          .help = std::move(help),
          .keys = std::move(keys),
          .enabled = need.holds,
          .run = std::move(run),
          .checked = nullptr,
          .labelNow = nullptr,
          .needs = [need](const Shell& shell) { return need.holds(shell) ? "" : need.text; },
          .otherwise = {}};
}

} // namespace stretch::ui

#pragma once

#include "app/commands/table/command.h"
#include "app/session.h"

namespace stretch::app {

// Parts that the tables of commands share.

/// One finished edit from its result; an error is passed on.
[[nodiscard]] inline Status finish(Session& session, Result<Document> changed, const char* label) {
  if (!changed) {
    return changed.error();
  }
  session.edit(std::move(changed).value(), label);
  return Success{};
}

[[nodiscard]] inline bool always(const Session&) {
  return true;
}

/// One row of a table: a command of a character, and what it means for a sequence where it means something.
[[nodiscard]] inline DocumentCommand entry(std::string id, std::string label, std::string help,
                                           std::vector<std::string> keys, Need need,
                                           std::function<Status(Session&)> run,
                                           std::function<bool(const SequenceSession&)> enabledOnSequence = {},
                                           std::function<Status(SequenceSession&)> runOnSequence = {}) {
  return {.id = std::move(id),
          .label = std::move(label),
          .help = std::move(help),
          .keys = std::move(keys),
          .enabled = std::move(need.holds),
          .run = std::move(run),
          .enabledOnSequence = std::move(enabledOnSequence),
          .runOnSequence = std::move(runOnSequence),
          .needs = std::move(need.text)};
}

/// A command that is a switch.
[[nodiscard]] inline DocumentCommand ticked(DocumentCommand command,
                                            std::function<bool(const Session&)> checked) {
  command.checked = std::move(checked);
  return command;
}

/// A command whose label says what it would do now.
[[nodiscard]] inline DocumentCommand labelled(DocumentCommand command,
                                              std::function<std::string(const Session&)> labelNow) {
  command.labelNow = std::move(labelNow);
  return command;
}

/// A command whose keys run another one while it is off.
[[nodiscard]] inline DocumentCommand orElse(DocumentCommand command, std::string otherwise) {
  command.otherwise = std::move(otherwise);
  return command;
}

/// Runs what cannot fail.
template <typename Action>
[[nodiscard]] auto doing(Action action) {
  return [action](auto& context) -> Status {
    action(context);
    return Success{};
  };
}

} // namespace stretch::app

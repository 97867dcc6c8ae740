#pragma once

#include "app/commands/command.h"
#include "app/session.h"

namespace stretch::app {

// What the tables of commands share.

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
                                           std::vector<std::string> keys,
                                           std::function<bool(const Session&)> enabled,
                                           std::function<Status(Session&)> run,
                                           std::function<bool(const SequenceSession&)> enabledOnSequence = {},
                                           std::function<Status(SequenceSession&)> runOnSequence = {}) {
  return {std::move(id),
          std::move(label),
          std::move(help),
          std::move(keys),
          std::move(enabled),
          std::move(run),
          std::move(enabledOnSequence),
          std::move(runOnSequence),
          {},
          {}};
}

/// The rows, and what each of them needs that does not say it itself: "select a trail first".
[[nodiscard]] inline std::vector<DocumentCommand> needing(const std::string& needs,
                                                          std::vector<DocumentCommand> rows) {
  for (DocumentCommand& row : rows) {
    row.needs = row.needs.empty() ? needs : row.needs;
  }
  return rows;
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

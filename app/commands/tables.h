#pragma once

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

} // namespace stretch::app

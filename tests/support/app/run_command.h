#pragma once

#include <string>

#include "app/session.h"

namespace stretch::test {

/// Runs a command of the document; answers the problem that it tells, empty when it did its work. One that is
/// off tells what it needs.
[[nodiscard]] std::string run(app::Session& session, const std::string& commandId);

} // namespace stretch::test

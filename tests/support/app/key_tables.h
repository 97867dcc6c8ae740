#pragma once

#include <string>
#include <vector>

#include "app/commands/table/key.h"
#include "app/commands/table/keymap.h"

namespace stretch::test {

/// Every key that has a name.
[[nodiscard]] std::vector<app::Key> allKeys();

/// What is wrong with the default keys of a table: bound twice, or not to be read; one line each.
[[nodiscard]] std::vector<std::string> keyProblems(const std::vector<app::KeyedCommand>& commands);

} // namespace stretch::test

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace stretch::app {

/// The words of a command as a shell takes them apart: blanks between, '...' and "..." as one word, \ before
/// a letter that is meant as it stands. None for an empty line and for one that begins with #. Error: a quote
/// that is not closed.
[[nodiscard]] Result<std::vector<std::string>> commandWords(std::string_view line);

} // namespace stretch::app

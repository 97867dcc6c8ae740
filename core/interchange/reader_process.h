#pragma once

#include <optional>

namespace stretch::interchange {

/// The other half of convertedInProcess: a program whose first word is the hidden verb reads the file that
/// is named by the second one, under limits of memory and time, and writes what came of it to standard
/// output. Exit status of that; nothing for every other command line. Called first by each program that opens
/// files.
[[nodiscard]] std::optional<int> runAsReader(int argumentCount, const char* const* arguments);

} // namespace stretch::interchange

#pragma once

#include <string>

namespace stretch::test {

/// A report in JSON as lines of a path and a value, so that its numbers can be compared as numbers; of a long
/// one, for each kind of value, how many there are and what they add up to. Anything else stays as it is.
[[nodiscard]] std::string reportText(const std::string& output);

} // namespace stretch::test

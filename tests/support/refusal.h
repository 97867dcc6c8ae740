#pragma once

#include <string>

namespace stretch::test {

/// The line that a Result or a Status refuses with; "accepted" where it does not.
template <typename Answer>
[[nodiscard]] std::string refusal(const Answer& answer) {
  return answer ? std::string("accepted") : answer.error().line();
}

} // namespace stretch::test

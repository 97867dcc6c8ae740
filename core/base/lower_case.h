#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace stretch {

/// The text with its letters A to Z small; other bytes stay.
[[nodiscard]] inline std::string lowerCase(std::string_view text) {
  std::string low(text);
  std::transform(low.begin(), low.end(), low.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return low;
}

} // namespace stretch

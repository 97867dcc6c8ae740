#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace stretch {

/// The whole text as one number, written as in C in every locale: "-2.5e3", "+1". Nothing for anything else,
/// for blanks around it, and for numbers that are out of range or not finite.
template <typename Number = double>
[[nodiscard]] std::optional<Number> parseNumber(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') {
    text.remove_prefix(1);
  }
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc{} || stop != end) {
    return std::nullopt;
  }
  if constexpr (std::is_floating_point_v<Number>) {
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }
  return value;
}

} // namespace stretch

#pragma once

#include <source_location>
#include <string_view>

namespace stretch {

/// Prints what and where, then aborts. For broken invariants only: never for what a file or a user can cause.
[[noreturn]] void failCheck(std::string_view message, const std::source_location& location);

/// An invariant of the program; stays on in release builds.
inline void check(bool condition, std::string_view message,
                  const std::source_location& location = std::source_location::current()) {
  if (!condition) {
    failCheck(message, location);
  }
}

} // namespace stretch

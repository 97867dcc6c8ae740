#include "core/base/check.h"

#include <cstdlib>

#include <fmt/core.h>

namespace stretch {

void failCheck(std::string_view message, const std::source_location& location) {
  fmt::print(stderr, "{}:{}: broken invariant: {}\n", location.file_name(), location.line(), message);
  std::abort();
}

} // namespace stretch

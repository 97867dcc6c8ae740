#pragma once

#include <string_view>

namespace stretch::app {

/// Version, commit and compiler of this build: "0.1.0 (commit 1a2b3c4, GNU 12.2.0, x86_64)". Only the program
/// has it (third_party/BuildName.cmake), so that a new commit compiles one small file.
[[nodiscard]] std::string_view buildName();

} // namespace stretch::app

#pragma once

#include <filesystem>

namespace stretch::test {

/// Folder of the files that are not in the repository, which STRETCH_DATA names; empty without it.
[[nodiscard]] std::filesystem::path realFiles();

/// Whether there is such a folder. Without one it is told that nothing ran: CTest then counts the test as
/// skipped, not as passed (tests/CMakeLists.txt).
[[nodiscard]] bool hasRealFiles();

} // namespace stretch::test

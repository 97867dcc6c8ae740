#pragma once

namespace stretch::test {

/// Runs the tests of a program as its command line says; its exit status.
[[nodiscard]] int runTests(int argumentCount, char** arguments);

} // namespace stretch::test

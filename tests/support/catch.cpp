// Catch without a main, so that tools may use what tests use.
#define CATCH_CONFIG_RUNNER
#include "tests/support/run_tests.h"

#include <catch2/catch.hpp>

namespace stretch::test {

int runTests(int argumentCount, char** arguments) {
  return Catch::Session().run(argumentCount, arguments);
}

} // namespace stretch::test

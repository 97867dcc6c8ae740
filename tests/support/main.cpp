#include <cstdlib>

#include "core/interchange/reader_process.h"
#include "tests/support/run_tests.h"
#include "tests/support/temporary_folder.h"

int main(int argumentCount, char** arguments) {
  if (const auto status = stretch::interchange::runAsReader(argumentCount, arguments)) {
    return *status;
  }
  // What the user of this machine has set and kept is no part of a test.
  const stretch::test::TemporaryFolder settings;
  setenv("XDG_CONFIG_HOME", settings.path().c_str(), 1);
  return stretch::test::runTests(argumentCount, arguments);
}

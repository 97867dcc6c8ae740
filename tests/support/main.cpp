#include "core/interchange/reader_process.h"
#include "tests/support/run_tests.h"

int main(int argumentCount, char** arguments) {
  if (const auto status = stretch::interchange::runAsReader(argumentCount, arguments)) {
    return *status;
  }
  return stretch::test::runTests(argumentCount, arguments);
}

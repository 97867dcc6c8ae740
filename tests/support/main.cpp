#include "tests/support/run_tests.h"

int main(int argumentCount, char** arguments) {
  return stretch::test::runTests(argumentCount, arguments);
}

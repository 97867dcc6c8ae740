#include <filesystem>

#include <catch2/catch.hpp>

#include "core/base/file.h"
#include "tests/support/fuzz/readers.h"

using namespace stretch;

// A reader that is brought down ends the program: its name is told before.
TEST_CASE("what fuzzing starts from, and what it has found, brings no reader down") {
  const std::filesystem::path seeds(STRETCH_SOURCE_DIR "/tests/fuzz/seeds");
  for (const test::Reader& reader : test::fuzzedReaders()) {
    int read = 0;
    for (const auto& entry : std::filesystem::directory_iterator(seeds / reader.name)) {
      const Result<Bytes> bytes = readFile(entry.path());
      REQUIRE(bytes);
      UNSCOPED_INFO(entry.path().string());
      reader.read(*bytes);
      ++read;
    }
    CHECK(read > 0);
  }
}

#include "tests/support/real_files.h"

#include <cstdlib>

#include <catch2/catch.hpp>

namespace stretch::test {

std::filesystem::path realFiles() {
  const char* folder = std::getenv("STRETCH_DATA");
  return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder);
}

bool hasRealFiles() {
  if (!realFiles().empty()) {
    return true;
  }
  WARN("nothing ran: STRETCH_DATA names no folder of real files");
  return false;
}

} // namespace stretch::test

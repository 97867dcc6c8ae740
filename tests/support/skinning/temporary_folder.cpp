#include "tests/support/skinning/temporary_folder.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace stretch::test {

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "stretch-test-XXXXXX").string();
  path_ = ::mkdtemp(pattern.data());
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code problem;
  std::filesystem::remove_all(path_, problem);
}

std::filesystem::path TemporaryFolder::write(const std::string& name, std::string_view content) const {
  std::ofstream stream(path_ / name, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  return path_ / name;
}

} // namespace stretch::test

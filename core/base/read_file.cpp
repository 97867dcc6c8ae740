#include <fstream>
#include <limits>
#include <system_error>

#include "core/base/file.h"

namespace stretch {

namespace {

template <typename Content>
Result<Content> readWhole(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) {
    std::error_code ignored;
    return fs::is_directory(path, ignored) ? Error{"is a folder", path.string(), "give a file"}
                                           : Error{"there is no such file", path.string(), "check the path"};
  }
  const std::uintmax_t size = fs::file_size(path, failure);
  if (failure || size >= std::numeric_limits<std::uint32_t>::max()) {
    return Error{failure ? "cannot be read" : "is larger than 4 GiB", path.string(), "check the file"};
  }
  Content content(static_cast<std::size_t>(size), {});
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(size));
  if (!stream || static_cast<std::uintmax_t>(stream.gcount()) != size) {
    return Error{"cannot be read", path.string(), "check that you may read it"};
  }
  return content;
}

} // namespace

Result<Bytes> readFile(const std::filesystem::path& path) {
  return readWhole<Bytes>(path);
}

Result<std::string> readText(const std::filesystem::path& path) {
  return readWhole<std::string>(path);
}

} // namespace stretch

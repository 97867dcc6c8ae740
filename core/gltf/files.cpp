#include "core/gltf/files.h"

#include <fstream>
#include <limits>
#include <system_error>

namespace stretch::gltf {

Result<Bytes> readFile(const std::filesystem::path& path) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure)) {
    return Error{"there is no such file", path.string(), "check the path"};
  }
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  if (failure || size >= std::numeric_limits<std::uint32_t>::max()) {
    return Error{failure ? "cannot be read" : "is larger than 4 GiB", path.string(), "check the file"};
  }
  Bytes bytes(static_cast<std::size_t>(size));
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!stream || static_cast<std::uintmax_t>(stream.gcount()) != size) {
    return Error{"cannot be read", path.string(), "check that you may read it"};
  }
  return bytes;
}

} // namespace stretch::gltf

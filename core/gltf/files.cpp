#include "core/gltf/files.h"

#include <fstream>
#include <limits>
#include <system_error>

namespace stretch::gltf {

namespace {

namespace fs = std::filesystem;

// What was made so far; removed again unless everything succeeds.
class Undo {
public:
  Undo() = default;
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;
  ~Undo() {
    for (auto path = made_.rbegin(); path != made_.rend(); ++path) {
      std::error_code ignored;
      fs::remove(*path, ignored); // folders go only when nothing else was put into them
    }
  }

  void made(fs::path path) { made_.push_back(std::move(path)); }
  void keepAll() { made_.clear(); }

private:
  std::vector<fs::path> made_;
};

Error cannotWrite(const fs::path& path) {
  return {"cannot be written", path.string(),
          "check that the folder is there, that you may write to it and that the disk has room"};
}

bool makeFolders(const fs::path& folder, Undo& undo) {
  std::error_code failure;
  if (folder.empty() || fs::is_directory(folder, failure)) {
    return true;
  }
  if (!makeFolders(folder.parent_path(), undo) || !fs::create_directory(folder, failure)) {
    return false;
  }
  undo.made(folder);
  return true;
}

fs::path temporaryName(const fs::path& path) {
  fs::path name = path;
  name += ".partial";
  return name;
}

bool writeTemporary(const OutputFile& file, Undo& undo) {
  const fs::path temporary = temporaryName(file.path);
  undo.made(temporary);
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  stream.write(reinterpret_cast<const char*>(file.bytes.data()),
               static_cast<std::streamsize>(file.bytes.size()));
  stream.close();
  return !stream.fail();
}

bool moveIntoPlace(const OutputFile& file, Undo& undo) {
  std::error_code failure;
  const bool existed = fs::exists(file.path, failure);
  fs::rename(temporaryName(file.path), file.path, failure);
  if (!failure && !existed) {
    undo.made(file.path);
  }
  return !failure;
}

} // namespace

Result<Bytes> readFile(const fs::path& path) {
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
  Bytes bytes(static_cast<std::size_t>(size));
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!stream || static_cast<std::uintmax_t>(stream.gcount()) != size) {
    return Error{"cannot be read", path.string(), "check that you may read it"};
  }
  return bytes;
}

Status writeFiles(const std::vector<OutputFile>& files) {
  Undo undo;
  for (const OutputFile& file : files) {
    std::error_code failure;
    const bool isFolder = fs::is_directory(file.path, failure);
    if (isFolder || !makeFolders(file.path.parent_path(), undo) || !writeTemporary(file, undo)) {
      return cannotWrite(file.path);
    }
  }
  for (const OutputFile& file : files) {
    if (!moveIntoPlace(file, undo)) {
      return cannotWrite(file.path);
    }
  }
  undo.keepAll();
  return Success{};
}

} // namespace stretch::gltf

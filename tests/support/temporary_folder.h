#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace stretch::test {

/// A folder of its own for one test; removed with everything in it at the end.
class TemporaryFolder {
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  /// Writes a file into the folder; answers its path.
  std::filesystem::path write(const std::string& name, std::string_view content) const;
  /// Number of files in it and below.
  [[nodiscard]] std::size_t fileCount() const;

private:
  std::filesystem::path path_;
};

} // namespace stretch::test

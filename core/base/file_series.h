#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "core/base/result.h"

namespace stretch {

/// Files of one folder that are made one after the other, as pictures of a series are: each is on the disk,
/// under another name, when it was added, and none is at its place before finish(). One that is not finished
/// leaves nothing, and while it is written removeLeftParts leaves the folder alone.
class FileSeries {
public:
  explicit FileSeries(const std::filesystem::path& folder);
  FileSeries(FileSeries&&) noexcept;
  FileSeries& operator=(FileSeries&&) = delete;
  ~FileSeries();

  [[nodiscard]] Status add(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
  /// Puts all into their places. Error: as writeFiles, and then every file is as it was.
  [[nodiscard]] Status finish();

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Says before any work why a file cannot be written there: no folder, a folder of that name, no right to
/// write, or one of the reasons of writeFiles.
[[nodiscard]] Status checkPlace(const std::filesystem::path& path);

} // namespace stretch

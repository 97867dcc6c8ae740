#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace stretch {

using Bytes = std::vector<std::uint8_t>;

// The only way to read a whole file and the only way to write one.

/// All bytes of a file. Error: not there, no regular file, not readable, 4 GiB or more.
[[nodiscard]] Result<Bytes> readFile(const std::filesystem::path& path);
[[nodiscard]] Result<std::string> readText(const std::filesystem::path& path);

/// How the name of a file begins that is written beside its place.
inline constexpr const char* partName = ".stretch-engine-part-";

/// Removes the parts that killed programs left in a folder. Whoever writes a part holds its lock: one that
/// can be locked belongs to nobody. On a network's disk whose locks do not reach other machines it may be
/// theirs.
void removeLeftParts(const std::filesystem::path& folder);

struct OutputFile {
  std::filesystem::path path;
  Bytes bytes;
  std::vector<Bytes> more = {}; ///< Come after `bytes`, in this order: what is large need not be joined
                                ///< first.
};

/// Outcome for a file whose folder is missing.
enum class MissingFolder { isError, isMade };

/// Writes all files or none, so that neither an error nor a crash leaves half a file in the place of a whole
/// one: each is written beside its place under a name that nobody else uses, brought to the disk, and
/// renamed, in the order given: the file that refers to the others comes last. On an error every file is as
/// it was and nothing is left behind. Between the first and the last rename the old files stay on the disk
/// under other names. A file that is replaced keeps its permissions; a symbolic link stays and the file that
/// it leads to is replaced. Error: a place that is not a regular file, a file that is write-protected, and
/// whatever the system refuses.
[[nodiscard]] Status writeFiles(std::span<const OutputFile> files,
                                MissingFolder folder = MissingFolder::isError);

/// Writes one file in the same way; folders of texts are made, as those of a user's settings are at the first
/// start.
[[nodiscard]] Status writeFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                               MissingFolder folder = MissingFolder::isError);
[[nodiscard]] Status writeText(const std::filesystem::path& path, std::string_view text,
                               MissingFolder folder = MissingFolder::isMade);

} // namespace stretch

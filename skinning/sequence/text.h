#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace stretch::skinning {

/// The whole file; an error when it cannot be read.
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path& path);

/// The path's extension in small letters, ".obj".
[[nodiscard]] std::string lowerExtension(const std::filesystem::path& path);

/// Cuts the next line off `rest` (without its line end, CR LF included). False when nothing is left.
[[nodiscard]] bool nextLine(std::string_view& rest, std::string_view& line);

/// Cuts the next word (separated by blanks) off `rest`; empty when none is left.
[[nodiscard]] std::string_view nextWord(std::string_view& rest);

/// The whole word as a finite number.
[[nodiscard]] std::optional<double> toNumber(std::string_view word);
[[nodiscard]] std::optional<long long> toInteger(std::string_view word);

/// "file.obj:12", for messages.
[[nodiscard]] std::string placeOf(std::string_view name, std::size_t lineNumber);

} // namespace stretch::skinning

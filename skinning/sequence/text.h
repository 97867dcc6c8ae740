#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace stretch::skinning {

/// The path's extension in small letters, ".obj".
[[nodiscard]] std::string lowerExtension(const std::filesystem::path& path);

/// Cuts the next line off `rest` (without its line end, CR LF included). False when nothing is left.
[[nodiscard]] bool nextLine(std::string_view& rest, std::string_view& line);

/// Cuts the next word (separated by blanks) off `rest`; empty when none is left.
[[nodiscard]] std::string_view nextWord(std::string_view& rest);

/// The text without the blanks around it: a name that may hold blanks inside.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// "file.obj:12", for messages.
[[nodiscard]] std::string placeOf(std::string_view name, std::size_t lineNumber);

} // namespace stretch::skinning

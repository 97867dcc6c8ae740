#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stretch::rig::body {

/// A piece of a name between separators, digits and changes of script.
struct NameChunk {
  std::vector<std::string> parts; ///< Split again where lower case meets upper case ("LeftArm" -> left, arm).
  std::string whole;              ///< The parts joined.
};

/// Splits a UTF-8 joint name into chunks: a namespace ("mixamorig:", "Armature|") is dropped, letters are
/// folded to lower case without accents, full-width forms become ASCII, digits and punctuation separate.
/// Ideographs and kana form chunks of one part. Bytes that are no UTF-8 separate.
[[nodiscard]] std::vector<NameChunk> nameChunks(std::string_view name);

/// Bytes of a name at which a part of it begins, but for the first.
[[nodiscard]] std::vector<std::size_t> partStarts(std::string_view name);

/// Letters that say of which row and side a limb is: of "fl" and "lh" the front left and the left hind one.
struct RowLetters {
  char row = 'f';  ///< One of f, b, h, r and m: front, back, hind, rear, middle.
  char side = 'l'; ///< One of l and r.
};

/// Reads a folded part of a name that consists of the two letters of row and side and no more. "lf" is none:
/// it says left as well, where "rt" says right.
[[nodiscard]] std::optional<RowLetters> rowLetters(std::string_view part);

} // namespace stretch::rig::body

#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>

#include "core/base/file.h"
#include "core/interchange/file_kind.h"

namespace stretch::interchange {

/// A file whose nodes have a name each: the library tells them apart by nothing else.
struct NamesApart {
  Bytes bytes;
  std::map<std::string, std::string> original; ///< By the name that stands there now.
  std::set<std::string> names; ///< Of an FBX and a BVH: those of all nodes, as they stand there now.

  /// What the file calls a node that the library names so.
  [[nodiscard]] std::string nameOf(const std::string& given) const;
};

/// Gives the second and further nodes of one name a name of the same length: of an FBX (by its objects) and a
/// BVH (by its order). Of a Collada, whose nodes go by their ids, only a name that is another one's id
/// changes.
[[nodiscard]] NamesApart withNamesApart(std::span<const std::uint8_t> bytes, Format format);

} // namespace stretch::interchange

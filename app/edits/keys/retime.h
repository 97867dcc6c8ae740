#pragma once

#include <string>

#include "app/document.h"

namespace stretch::app {

/// A stretch of a clip that is to take another time.
struct Retime {
  double firstFrame = 0.0;
  double lastFrame = 0.0; ///< Above firstFrame.
  double newFrames = 0.0; ///< How long it is to be; above 0.
  bool movesAfter = true; ///< Everything that comes after moves along; else it stays, and gives way where it
                          ///< must.
  std::string limb = {};  ///< Only the keys of this limb; empty: of the whole clip.

  friend bool operator==(const Retime&, const Retime&) = default;
};

/// The clip's own keys, offset keys with their ranges, and, for the whole clip, trails, holds and ranges of
/// weight, slower or faster. Curves get a key at the ends of the range, so that what lies outside stays as it
/// is. Morph weights are left alone.
[[nodiscard]] Result<Document> retimed(const Document& document, int clip, const Retime& wanted);

} // namespace stretch::app

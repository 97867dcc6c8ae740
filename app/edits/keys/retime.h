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

/// The clip's own keys, the offset keys of controllers and, for the whole clip, every thing that stands in
/// its time, slower or faster. Curves get a key at the ends of the range, so that what lies outside stays as
/// it is. Where what comes after stays, keys that the range reaches go; a thing that would share time with
/// one of its kind and subject that the range brings begins where that ends, and goes where nothing is left
/// of it. Refused where things came out that no edit would take. Morph weights are left alone.
[[nodiscard]] Result<Document> retimed(const Document& document, int clip, const Retime& wanted);

} // namespace stretch::app

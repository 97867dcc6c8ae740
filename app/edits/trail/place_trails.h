#pragma once

#include <span>
#include <vector>

#include "app/document.h"

namespace stretch::app {

// The one door for trails: the command line, recipes, the editor and the work that a file carries all pass
// through it, by the same rules. A trail's limb and clip are in the document, each of its settings has a
// value that it takes, its range has a length and shares frames with the clip, and no two trails of one limb
// overlap in time.

/// Who brings the trails, which decides what happens to those that are in their way.
enum class Entry {
  request, ///< Command line or recipe: what is on the same limb at the same time gives way.
  hand,    ///< The editor: an overlap is refused.
  file,    ///< Saved work, as by hand; the range may lie outside the clip, which other programs may have cut.
};

struct PlacedTrails {
  Document document;
  std::vector<int> trailIds; ///< In the order of what was wanted.
};

/// All of them or none. A trail with the id 0 gets the next free one. Errors name the limb. Two of `wanted`
/// that overlap each other are refused whoever brings them.
[[nodiscard]] Result<PlacedTrails> placeTrails(const Document& document, std::span<const rig::Trail> wanted,
                                               Entry entry);

/// Tells what speaks against these settings for a trail of this limb and clip, or success: values, length of
/// the range, overlap with another trail than `trailId`.
[[nodiscard]] Status checkTrailSettings(const Document& document, const rig::Trail& trail);

/// The trail of this limb and clip (other than `exceptTrailId`) that shares time with [start, end]; null when
/// there is none.
[[nodiscard]] const rig::Trail* overlappingTrail(const Document& document, const std::string& limbId,
                                                 int clip, double startFrame, double endFrame,
                                                 int exceptTrailId = 0);

/// Whether the document has this limb (or chain) and this clip; the error says which it lacks.
[[nodiscard]] Status checkLimbAndClip(const Document& document, const std::string& limbId, int clip);

} // namespace stretch::app

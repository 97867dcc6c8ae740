#pragma once

#include <span>
#include <vector>

#include "app/things/place.h"

namespace stretch::app {

using PlacedTrails = Placed;

/// Trails through the door (app/things/place.h).
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

} // namespace stretch::app

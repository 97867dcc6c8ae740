#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/edits/pose/offset_edits.h"
#include "app/edits/pose/seen_pose.h"
#include "app/session.h"

namespace stretch::app {

/// Returns what is seen at the playhead of these controllers; of all where none is named.
[[nodiscard]] SeenPose seenAtPlayhead(Session& session, std::span<const std::string> ids);

/// Offsets that bring controllers to a pose, and those that they do not bring there.
struct PosedAsSeen {
  OffsetPose offsets;              ///< Offsets of those alone that are not there by themselves.
  std::vector<std::string> missed; ///< Held by a trail, a pin, or out of reach.
};

/// "the left hand is held elsewhere", by a trail or a hold; empty where none is.
[[nodiscard]] std::string missedText(const Document& document, const std::vector<std::string>& missed);

/// Offsets with which the character at the playhead is seen in the pose: from the root outwards, each
/// controller moved and turned by what it is off, until it is there. An error where the working range does
/// not hold the playhead.
[[nodiscard]] Result<PosedAsSeen> posedAsSeen(Session& session, const SeenPose& pose);

} // namespace stretch::app

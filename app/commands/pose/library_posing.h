#pragma once

#include <string>
#include <vector>

#include "app/edits/pose/offset_edits.h"
#include "app/edits/pose/seen_pose.h"
#include "app/session.h"

namespace stretch::app {

/// Offsets of controllers as they stand, and those with which they stand in a pose: the same controllers and
/// attributes in the same order.
struct PoseBlend {
  OffsetPose from;
  OffsetPose to;
  std::vector<std::string> missed; ///< Held elsewhere, or out of reach.
};

/// Returns the way of the selected controllers, of all where none is selected, from how they stand at the
/// playhead to a pose. An error where the character has none of the pose's, where all stand so already, and
/// where the working range does not hold the playhead.
[[nodiscard]] Result<PoseBlend> blendInto(Session& session, const SeenPose& pose);

/// The pose at a part of the way, 0 (as they stand) to 1; moves, rotation vectors and values in equal parts.
[[nodiscard]] OffsetPose blended(const PoseBlend& blend, double amount);

} // namespace stretch::app

#pragma once

#include "app/edits/pose/prop_file_edits.h"

namespace stretch::app {

/// Returns the place of the hands that take a file's thing: the middle of the hand, or between both, where
/// the clip with its adjustments has them at the frame. An error for a clip, a frame or a hand that the
/// character lacks.
[[nodiscard]] Result<Vec3> placeInHands(const Document& document, const PropFile& file);

/// holdPropFile with the thing in the hands.
[[nodiscard]] Result<AddedProp> putIntoHands(const Document& document, PropFile file);

} // namespace stretch::app

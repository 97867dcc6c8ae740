#pragma once

#include <string>
#include <vector>

#include "rig/controllers/adjustment.h"
#include "tests/support/rig/rekeyed_clip.h"

namespace stretch::test {

/// One key at a frame, held over the whole clip.
[[nodiscard]] rig::Adjustment moved(const std::string& controller, const Vec3& move, double frame = 12.0);
[[nodiscard]] rig::Adjustment turned(const std::string& controller, const Vec3& turnDegrees,
                                     double frame = 12.0);
[[nodiscard]] rig::Adjustment valued(const std::string& attribute, double value, double frame = 12.0);

/// The same inside a range alone.
[[nodiscard]] rig::Adjustment within(rig::Adjustment adjustment, double startFrame, double endFrame);

/// The motion of a clip with adjustments, and trails on top.
[[nodiscard]] rig::MotionState adjusted(const MovingBiped& moving,
                                        const std::vector<rig::Adjustment>& adjustments,
                                        const std::vector<rig::Trail>& trails = {});

/// The same, keyed, as rekeyedOf does.
[[nodiscard]] Rekeyed rekeyedOf(const MovingBiped& moving, const std::vector<rig::Adjustment>& adjustments);

} // namespace stretch::test

#pragma once

#include "assets/dummy/motion.h"
#include "assets/dummy/pose.h"
#include "assets/dummy/skeleton.h"

namespace stretch::assets {

/// Keys every moving joint at the poses, with tangents that follow the motion between them. The legs are
/// solved from the hips as the keys move them, not as the controls do, so that the feet stay planted between
/// keys as well.
[[nodiscard]] Motion keyPoses(const std::string& name, const std::vector<Joint>& skeleton,
                              const std::vector<Pose>& poses, double framesPerSecond);

/// Keys every moving joint on every frame, joined by straight lines, as exporters bake a clip.
[[nodiscard]] Motion bakePoses(const std::string& name, const std::vector<Joint>& skeleton,
                               const std::vector<Pose>& poses, double framesPerSecond);

/// The value of a cubic track at a frame, as a glTF viewer computes it; rotations normalised.
[[nodiscard]] Vec4 trackValue(const MotionTrack& track, double frame, double framesPerSecond);

} // namespace stretch::assets

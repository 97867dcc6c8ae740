#pragma once

#include <functional>

#include "assets/dummy/motion.h"
#include "assets/dummy/pose.h"
#include "assets/dummy/skeleton.h"

namespace stretch::assets {

/// Keys every moving joint at the poses, with tangents that follow the motion between them. The legs are
/// solved from the hips as the keys move them, not as the controls do, so that the feet stay planted between
/// keys as well.
[[nodiscard]] Motion keyPoses(const std::string& name, const std::vector<Joint>& skeleton,
                              const std::vector<Pose>& poses, double framesPerSecond);

/// Where a prop is.
struct PropPlace {
  Vec3 position;
  Quat rotation{1.0, 0.0, 0.0, 0.0};
};

/// A prop that moves with the poses: its node, and where a pose puts it.
struct MovingProp {
  int node = 0;
  std::function<PropPlace(const Pose& pose)> place;
};

/// The same for a motion whose hands hold something: more keys are put where the wrists or a prop would stray
/// from where the poses have them. `complete` sets the controls that follow from others, such as wrists from
/// what they hold.
[[nodiscard]] Motion keyHolding(const std::string& name, const std::vector<Joint>& skeleton,
                                const std::vector<Pose>& poses, double framesPerSecond,
                                const std::function<Pose(const Pose&)>& complete,
                                const std::vector<MovingProp>& props);

/// Keys every moving joint on every frame, joined by straight lines, as exporters bake a clip.
[[nodiscard]] Motion bakePoses(const std::string& name, const std::vector<Joint>& skeleton,
                               const std::vector<Pose>& poses, double framesPerSecond);

/// The value of a cubic track at a frame, as a glTF viewer computes it; rotations normalised.
[[nodiscard]] Vec4 trackValue(const MotionTrack& track, double frame, double framesPerSecond);

} // namespace stretch::assets

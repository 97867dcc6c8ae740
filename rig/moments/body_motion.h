#pragma once

#include <cstddef>
#include <vector>

#include "core/anim/clip.h"
#include "core/math/types.h"
#include "core/scene/scene.h"
#include "rig/body/reading/detection.h"

namespace stretch::rig {

/// A limb's motion seen from its base, one sample at every half frame from frame 0 to the clip's last key:
/// d(t) = the place that leads minus the place that stays, and where the place that leads is in the world.
struct LimbMotion {
  std::vector<Vec3> places; ///< d(t), world units.
  double weight = 1.0; ///< 1 for limbs that act, less for the trunk that carries them and tails that follow,
                       ///< more for a beast's short neck, whose head acts.
  double reach = 0.0;  ///< Longest |d| in the clip.
  std::vector<Vec3> ends; ///< World space.
  bool isLeg = false;
};

/// The motion of a body over a clip, without any trail.
struct BodyMotion {
  double samplesPerSecond = 60.0;
  std::vector<LimbMotion> limbs; ///< In the order in which they were asked for.
  std::vector<Vec3> hips;        ///< World space; empty for a body without hips.
  /// Way the body faces: up x (middle of the right limbs' bases - that of the left ones), horizontal, length
  /// 1; 0 where it has no two sides.
  std::vector<Vec3> forward;
  double reach = 0.0; ///< R: the median of the limbs' reaches.
};

/// Changes of places over a clip.
struct Velocities {
  std::vector<Vec3> ways;     ///< World units per second: central differences, smoothed 1-2-1.
  std::vector<double> speeds; ///< Their lengths.
};

/// Speeds are taken over a sixtieth of a second where frames are shorter, so that what trembles between the
/// frames of a capture is no motion.
[[nodiscard]] Velocities velocitiesOf(const std::vector<Vec3>& places, double samplesPerSecond);

/// Samples the clip. A pose that stands alone at an end of the clip,
/// from which several limbs leap in one frame (a capture's T-pose), is left out: the one beside it is held.
/// At most `longestFrames` frames are looked at.
[[nodiscard]] BodyMotion motionOfBody(const Scene& scene, const Clip& clip, const Body& body,
                                      const std::vector<Limb>& limbs);

} // namespace stretch::rig

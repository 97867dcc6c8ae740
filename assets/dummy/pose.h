#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/math/types.h"

namespace stretch::assets {

/// What an animator sets in a pose, in world space, metres and degrees. Turns are (pitch, yaw, roll): yaw
/// about +Y is positive to the character's left, pitch leans forward, roll tips the head towards the right
/// shoulder.
enum class Control : std::size_t {
  hips, ///< Position of the hips joint.
  hipsTurn,
  chestTurn, ///< Of the uppermost spine joint; the spine blends from the hips to it.
  headTurn,  ///< The neck blends from the chest to it.
  leftWrist, ///< Where the wrist wants to be; beyond the arm's reach the arm points at it, all but straight.
  leftElbow, ///< Direction in which the elbow points.
  leftClavicle, ///< (forward, up, -).
  leftKnuckles, ///< Direction from wrist to knuckles.
  leftThumb,    ///< Direction of the thumb.
  rightWrist,
  rightElbow,
  rightClavicle,
  rightKnuckles,
  rightThumb,
  leftBall, ///< Position of the ball of the foot.
  leftFoot, ///< (heel lift, yaw, pitch of the toes).
  leftKnee, ///< Direction in which the knee points; zero: where the toes point, a little turned out.
  rightBall,
  rightFoot,
  rightKnee,
  holds,  ///< (left, right, -), 0 to 1: how firmly the wrists are at their places however far the arms reach.
  bat,    ///< Position of the middle between the hands that hold it.
  batAim, ///< (azimuth, elevation, -) of its barrel: from +Z towards the character's left, and up.
  count
};

struct Pose {
  int frame = 0;
  std::array<Vec3, static_cast<std::size_t>(Control::count)> values{};

  [[nodiscard]] Vec3& operator[](Control control) { return values[static_cast<std::size_t>(control)]; }
  [[nodiscard]] const Vec3& operator[](Control control) const {
    return values[static_cast<std::size_t>(control)];
  }
};

/// The pose at a frame, fractions included, of poses in ascending order: every number runs through its keys
/// smoothly and never past them (monotone cubic); it rests at its extremes. Before the first and after the
/// last it is held.
[[nodiscard]] Pose poseAt(const std::vector<Pose>& poses, double frame);

} // namespace stretch::assets

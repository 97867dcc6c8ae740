#include "rig/motion/stop.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "rig/trail/release.h"

namespace stretch::rig {

namespace {

constexpr double besideRestSeconds = 0.1; // a limb that has just been set down, or is about to be
constexpr double settlingSeconds = 0.2;   // from the touch of a foot until its ankle rests

// How far a point is beyond the plane; below 0 in front of it.
double beyond(const StopPlane& plane, const Vec3& point) {
  const double length = glm::length(plane.normal);
  return length > 0.0 ? glm::dot(plane.normal, point - plane.point) / length : -1.0;
}

bool isAtStop(const SolvedTrail& solved, const Rest& rest) {
  constexpr double near = 0.1; // of the limb
  return beyond(*solved.settings.stopAt, rest.place) > -near * solved.limb.restLength;
}

// 0 while the limb rests at the plane, so that a planted foot stays where it is; 1 away from that.
double freeToSlide(const SolvedTrail& solved, double timeSeconds) {
  double free = 1.0;
  for (const Rest& rest : solved.rests.value_or(std::vector<Rest>{})) {
    const double away = std::max({rest.startSeconds - timeSeconds, timeSeconds - rest.endSeconds, 0.0});
    free = isAtStop(solved, rest) ? std::min(free, smoothstep(away / besideRestSeconds)) : free;
  }
  return free;
}

// As large a share of the way towards the plane as leaves the limb's end some of the height that it has in
// the clip; it gives way before it comes there.
Vec3 heldOff(const StoppedReach& reach, double before, double after) {
  constexpr double leastShare = 0.2; // of the distance from the plane
  constexpr double gives = 0.6;
  const double wanted = (after - before) / ((leastShare - 1.0) * before);
  if (!(before < 0.0)) {
    return after <= before ? reach.wanted : reach.original;
  }
  if (wanted <= 1.0 - gives) {
    return reach.wanted;
  }
  const double over = std::min(wanted, 1.0 + gives) - 1.0 + gives;
  const double allowed = std::min(wanted, 1.0 + gives) - over * over / (4.0 * gives);
  return reach.original + (reach.wanted - reach.original) * (allowed / wanted);
}

// Along the plane as far as the limb is to be long, on the side of its base to which it goes already.
Vec3 along(const StopPlane& plane, const StoppedReach& reach, const Vec3& met) {
  constexpr double farthest = 2.0; // times as far aside of the base as the way into the plane would lead it
  const Vec3 normal = glm::normalize(plane.normal);
  const double height = glm::dot(normal, met - reach.base);
  const Vec3 aside = met - reach.base - height * normal;
  const Vec3 limb = reach.wanted - reach.base;
  const double now = glm::length(aside);
  const double wanted = std::sqrt(std::max(glm::dot(limb, limb) - height * height, now * now));
  return now > 0.0 ? met + aside * (std::min(wanted / now, farthest) - 1.0) : met;
}

} // namespace

std::vector<Rest> restsIn(const Clip& clip, const Limb& limb, const Vec2& rangeSeconds, FrameSource& frames) {
  constexpr double restingSpeed = 0.25;   // limb lengths per second
  constexpr double restingSeconds = 0.15; // a strike that holds for a moment does not stand
  const double fps = clip.framesPerSecond;
  const double farthestStep = restingSpeed * limb.restLength / fps;
  const double leastFrames = std::max(1.0, std::round(restingSeconds * fps));
  const double last = wholeFrameAtMost(std::min(rangeSeconds.y, clip.endSeconds) * fps);
  std::vector<Rest> rests;
  std::optional<Vec3> before;
  double rested = 0.0;
  for (double frame = wholeFrameAtLeast(std::max(0.0, rangeSeconds.x) * fps); frame <= last; frame += 1.0) {
    const Vec3 end = leadingPosition(limb, frames.at(frame / fps));
    rested = before && glm::length(end - *before) <= farthestStep ? rested + 1.0 : 0.0;
    before = end;
    if (rested == leastFrames) {
      rests.push_back({(frame - rested) / fps, frame / fps, end});
    } else if (rested > leastFrames) {
      rests.back().endSeconds = frame / fps;
    }
  }
  return rests;
}

Vec3 stoppedTarget(const SolvedTrail& solved, const StoppedReach& reach) {
  const StopPlane& plane = *solved.settings.stopAt;
  const double before = beyond(plane, reach.original);
  const double after = beyond(plane, reach.wanted);
  if (solved.comesToRest) {
    return heldOff(reach, before, after);
  }
  if (after <= 0.0) {
    return reach.wanted;
  }
  // What is beyond the plane in the clip comes no farther.
  const double stays = std::min(after, std::max(before, 0.0));
  const Vec3 met = reach.wanted - (after - stays) * glm::normalize(plane.normal);
  const double share = before < 0.0 ? before / (before - after) : before > after ? 1.0 - after / before : 0.0;
  const Vec3 halted = reach.original + share * (reach.wanted - reach.original);
  return halted + freeToSlide(solved, reach.timeSeconds) * (along(plane, reach, met) - halted);
}

bool comesToRest(const SolvedTrail& solved) {
  const bool forwards = solved.settings.pivot == Pivot::start;
  return std::ranges::any_of(solved.rests.value_or(std::vector<Rest>{}), [&](const Rest& rest) {
    const bool isOnWayBack = forwards ? rest.startSeconds > solved.tipSeconds &&
                                            rest.startSeconds <= solved.windowEndSeconds + settlingSeconds
                                      : rest.endSeconds < solved.tipSeconds &&
                                            rest.endSeconds >= solved.windowStartSeconds - settlingSeconds;
    return isOnWayBack && isAtStop(solved, rest);
  });
}

} // namespace stretch::rig

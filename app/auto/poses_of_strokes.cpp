#include "app/auto/poses_of_strokes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/auto/planned_trail.h"
#include "core/math/polyline.h"

namespace stretch::app {

namespace {

// Bent on purpose, and not so far that its elbow would be thrown out where all of it gets longer.
bool isBentAt(const std::vector<Vec3>& points, double scale) {
  constexpr double nearlyStraight = 0.85; // of all bones
  constexpr double farthestElbow = 0.7;   // of all bones: from the line between its ends
  const double along = polylineLength(points);
  const double straight = straightLength(points);
  const double elbow = 0.5 * std::sqrt(std::max(0.0, along * along - straight * straight));
  return straight < nearlyStraight * along && scale * elbow < farthestElbow * along;
}

double distanceFrom(const std::vector<Vec3>& trunk, const Vec3& point) {
  const Vec3 along = trunk.back() - trunk.front();
  const double share = glm::dot(point - trunk.front(), along) / std::max(1e-12, glm::dot(along, along));
  return glm::distance(point, trunk.front() + std::clamp(share, 0.0, 1.0) * along);
}

} // namespace

Vec3 reachAt(const ClipGround& ground, const std::string& limb, double frame) {
  return ground.reachOf(limb, frame <= ground.lastFrame ? frame
                              : ground.wraps            ? frame - ground.turnFrames
                                                        : ground.lastFrame);
}

double heldFor(const ClipGround& ground, const rig::Trail& trail, double mostFrames) {
  constexpr double longest = 0.4;    // seconds
  constexpr double inOnePose = 0.15; // of the stroke's way
  constexpr double goesOn = 0.3;     // of it, along it
  const double tip = trail.settings.endFrame;
  const Vec3 end = reachAt(ground, trail.limb, tip);
  const Vec3 way = end - reachAt(ground, trail.limb, trail.settings.startFrame);
  const double most = std::round(longest * ground.framesPerSecond);
  double held = 0.0;
  while (held < most) {
    const Vec3 now = reachAt(ground, trail.limb, tip + held + 1.0);
    const double along = glm::dot(now - reachAt(ground, trail.limb, tip + held), way);
    if (glm::distance(now, end) > (along > 0.0 ? goesOn : inOnePose) * glm::length(way)) {
      break;
    }
    held += 1.0;
  }
  return held < most ? std::clamp(std::floor(mostFrames), 0.0, held) : 0.0;
}

double stillFor(const ClipGround& ground, const rig::Trail& trail, double mostFrames) {
  constexpr double still = 0.001;   // of the stroke's way
  constexpr double atOnce = 0.5;    // of it: what the limb itself does is no jump
  constexpr double usualBack = 2.0; // frames
  const double tip = trail.settings.endFrame;
  const Vec3 end = reachAt(ground, trail.limb, tip);
  const double way = glm::distance(end, reachAt(ground, trail.limb, trail.settings.startFrame));
  const auto moved = [&](double frames) {
    return glm::distance(reachAt(ground, trail.limb, tip + frames), end);
  };
  double frames = 0.0;
  while (frames + 2.0 <= mostFrames && moved(frames + 1.0) <= still * way) {
    frames += 1.0;
  }
  const double back = moved(frames + 1.0) >= atOnce * way ? 1.0 : usualBack;
  return std::clamp(std::floor(mostFrames - back), 0.0, frames);
}

bool isPosedBent(const ClipGround& ground, const rig::Limb& limb, const Vec2& range, double scale) {
  int bent = 0;
  int straight = 0;
  for (double frame = std::round(0.4 * range.x + 0.6 * range.y); frame <= range.y; frame += 1.0) {
    ++(isBentAt(ground.pointsOf(limb.id, frame), scale) ? bent : straight);
  }
  return bent > straight;
}

bool foldsIn(const ClipGround& ground, const rig::Limb& limb, const Vec2& range) {
  constexpr double drawnIn = 0.6; // of what the limb reached at the start
  constexpr double nearer = 0.7;  // of the hand's distance from the trunk at the start
  const auto reach = [&](double frame) { return glm::length(ground.reachOf(limb.id, frame)); };
  const double least = drawnIn * reach(range.x);
  if (isLeg(limb)) {
    return reach(range.y) < least;
  }
  const rig::Limb* const spine = rig::limbAt(ground.document.body.limbs, rig::biped::spine);
  if (limb.kind != rig::LimbKind::arm || spine == nullptr) {
    return false;
  }
  const auto fromTrunk = [&](double frame) {
    return distanceFrom(ground.pointsOf(spine->id, frame), ground.pointsOf(limb.id, frame).back());
  };
  bool folds = false;
  for (double frame = range.x; frame <= range.y; frame += 1.0) {
    folds = folds || reach(frame) < least;
  }
  return folds && fromTrunk(range.y) < nearer * fromTrunk(range.x);
}

bool sweepsGround(const ClipGround& ground, const rig::Limb& limb, const Vec2& range, double scale) {
  constexpr double near = 0.2; // of the height
  const double least = ground.groundHeight() + near * ground.document.body.height;
  bool sweeps = false;
  for (double frame = range.x; frame <= range.y; frame += 1.0) {
    const double height = ground.pointsOf(limb.id, frame).back().y;
    const double lower = (scale - 1.0) * ground.reachOf(limb.id, frame).y;
    sweeps = sweeps || (height >= least && height + lower < least);
  }
  return sweeps;
}

bool goesLevel(const ClipGround& ground, const rig::Limb& limb, const Vec2& range) {
  constexpr double level = 0.25; // sine
  const Vec3 tip = ground.reachOf(limb.id, range.y);
  const Vec3 way = tip - ground.reachOf(limb.id, range.x);
  return std::abs(way.y) < level * glm::length(way) && tip.y < -level * glm::length(tip);
}

bool isOnGround(const ClipGround& ground, const rig::Limb& leg, const Vec2& range) {
  constexpr double lifted = 0.05; // of the height: above all of the mesh
  constexpr double near = 0.1;    // of the height: between the ground and that
  const auto soles = ground.soles.find(leg.id);
  const double height = ground.document.body.height;
  bool isOn = soles != ground.soles.end() && !ground.lowestVertices.empty();
  for (double frame = range.x; isOn && frame <= range.y; frame += 1.0) {
    const double here = ground.wraps && frame > ground.lastFrame ? frame - ground.turnFrames : frame;
    const auto at = static_cast<std::size_t>(std::clamp(std::round(here), 0.0, ground.lastFrame));
    const double lowest = ground.lowestVertices[at];
    isOn = soles->second[at] < lowest + lifted * height && lowest < ground.groundHeight() + near * height;
  }
  return isOn;
}

bool crawls(const ClipGround& ground, const rig::Limb& limb, const Vec2& range) {
  constexpr double low = 0.15; // of the height
  bool isLow = rig::isTrunk(limb) && ground.soles.empty();
  for (double frame = range.x; isLow && frame <= range.y; frame += 1.0) {
    isLow = ground.pointsOf(limb.id, frame).back().y < ground.lowest + low * ground.document.body.height;
  }
  return isLow;
}

bool isUpInTheAir(const ClipGround& ground, const rig::Limb& limb, const Vec2& range) {
  constexpr double above = 0.06; // of the height: between the ground and all of the mesh
  constexpr double extends = 1.1;
  const double tip = std::clamp(std::round(range.y), 0.0, ground.lastFrame);
  const bool stands = std::ranges::any_of(ground.stands, [&](const auto& leg) {
    return std::ranges::any_of(leg.second,
                               [&](const Vec2& stand) { return stand.x <= tip && tip <= stand.y; });
  });
  if (!isLeg(limb) || stands || ground.reachOf(limb.id, range.y).y >= 0.0 || ground.lowestVertices.empty()) {
    return false;
  }
  return ground.lowestVertexAt(tip) > ground.groundHeight() + above * ground.document.body.height &&
         glm::length(ground.reachOf(limb.id, range.y)) <
             extends * glm::length(ground.reachOf(limb.id, range.x));
}

} // namespace stretch::app

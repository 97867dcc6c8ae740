#include "app/auto/held_together.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/auto/held_things.h"
#include "app/evaluate/evaluate.h"

namespace stretch::app {

namespace {

constexpr double farthestApart = 0.6;  // of an arm: hands that hold a thing together
constexpr double mostWandering = 0.04; // of an arm: how far one hand moves, seen from the other
constexpr double leastWay = 0.3;       // of an arm: hands that rest hold nothing worth asking about

// The other hand's place seen from the leading hand, its orientation included, over the trail's frames.
bool areJoined(const ClipGround& ground, const rig::Limb& leader, const rig::Limb& other,
               const rig::TrailSettings& settings) {
  if (!leader.endNode.exists() || !other.endNode.exists()) {
    return false;
  }
  const double arm = leader.restLength;
  Vec3 low(INFINITY), high(-INFINITY), lowest(INFINITY), highest(-INFINITY);
  const double last = std::min(windowOf(settings).y, ground.lastFrame);
  for (double frame = settings.startFrame; frame <= last; frame += 1.0) {
    const FrameState state = evaluateOriginal(ground.document, ground.clip, frame / ground.framesPerSecond);
    const Vec3 hand = rig::endPosition(leader, state);
    const Mat3 turn(state.worlds[at(leader.endNode)]);
    const double size = std::cbrt(std::abs(glm::determinant(turn)));
    const Vec3 between = rig::endPosition(other, state) - hand;
    if (!(size > 0.0) || glm::length(between) > farthestApart * arm) {
      return false;
    }
    const Vec3 seen = glm::transpose(turn) * between / size;
    low = glm::min(low, seen);
    high = glm::max(high, seen);
    lowest = glm::min(lowest, hand);
    highest = glm::max(highest, hand);
  }
  return glm::length(high - low) < mostWandering * arm && glm::length(highest - lowest) > leastWay * arm;
}

} // namespace

std::vector<rig::Grip> gripsFor(const ClipGround& ground, AutoPlan& plan) {
  std::vector<rig::Grip> grips;
  for (std::size_t i = 0; i < plan.trails.size(); ++i) { // strongest first
    const rig::Trail leading = plan.trails[i].trail;
    const rig::Limb& leader = *findLimb(ground.document, leading.limb);
    const rig::Limb* const other =
        isArm(leader) ? rig::limbAt(ground.document.body.limbs, rig::mirrored(leader)) : nullptr;
    const bool isOnThing =
        other != nullptr && std::ranges::any_of(plan.holds.props, [&](const rig::Prop& prop) {
          return isHeldBy(prop, leader.id) && isHeldBy(prop, other->id);
        });
    if (other == nullptr || other->id == leader.id || isOnThing ||
        !areJoined(ground, leader, *other, leading.settings)) {
      continue;
    }
    const Vec2 window = windowOf(leading.settings);
    rig::Grip grip;
    grip.follower = other->id;
    grip.leader = leader.id;
    grip.clip = ground.clip;
    grip.time = {{window.x, std::min(window.y, ground.lastFrame)}, {0.0, 0.0}};
    for (std::size_t k = plan.trails.size(); k-- > i + 1;) {
      const Vec2 otherWindow = windowOf(plan.trails[k].trail.settings);
      if (plan.trails[k].trail.limb == other->id && otherWindow.x < window.y && window.x < otherWindow.y) {
        leaveOut(plan, k, "its hand holds what " + leader.id + " holds, and follows it");
      }
    }
    grips.push_back(std::move(grip));
  }
  return grips;
}

} // namespace stretch::app

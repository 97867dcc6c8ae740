#include "rig/moments/body_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "core/math/median.h"
#include "rig/motion/solve_steps.h"
#include "rig/trail/limb_path.h"

namespace stretch::rig {

namespace {

// Samples from one to the next of which a difference is taken.
std::ptrdiff_t spacingOf(double samplesPerSecond) {
  constexpr double shortestSeconds = 1.0 / 60.0;
  return std::max<std::ptrdiff_t>(1, std::lround(shortestSeconds * samplesPerSecond));
}

// What a limb weighs: the trunk carries the limbs that act, a tail follows them, the more the longer it is. A
// serpent's trunk has nothing to carry. A beast's neck bears the head, which bites and butts, and counts in
// lengths of its own where it is short. `lengths`: its reach in those of the body.
double weightOf(const Limb& limb, bool hasOuterLimbs, bool isBiped, double lengths) {
  constexpr double trunk = 0.6;
  constexpr double follower = 0.35;
  constexpr double leastNeck = 0.2; // of the body's reach: what is shorter trembles
  if (limb.kind == LimbKind::neck && !isBiped) {
    return 1.0 / std::clamp(lengths, leastNeck, 1.0);
  }
  if (limb.kind == LimbKind::tail || limb.kind == LimbKind::feeler) {
    return follower / std::sqrt(std::max(1.0, lengths));
  }
  return isTrunk(limb) && hasOuterLimbs ? trunk : 1.0;
}

// The middle of the bases of the limbs of one side; nothing to go by where there are none.
struct Middle {
  Vec3 sum{0.0};
  double count = 0.0;
};

Vec3 forwardOf(const std::vector<Limb>& limbs, const FrameState& frame) {
  Middle left;
  Middle right;
  for (const Limb& limb : limbs) {
    if (limb.side != LimbSide::middle && limb.kind != LimbKind::chain) {
      Middle& side = limb.side == LimbSide::left ? left : right;
      side.sum += stayingPosition(limb, frame);
      side.count += 1.0;
    }
  }
  if (left.count == 0.0 || right.count == 0.0) {
    return Vec3(0.0);
  }
  const Vec3 forward = glm::cross(Vec3(0.0, 1.0, 0.0), right.sum / right.count - left.sum / left.count);
  const double length = glm::length(forward);
  return length > 0.0 ? forward / length : Vec3(0.0);
}

// Whether limbs leap from a pose that stands alone at an end of the clip, as the T-pose in front of a
// capture: far in one frame, and hardly in the next one. `at` counts whole frames from that end.
template <typename At>
bool leapsFrom(const std::vector<LimbMotion>& limbs, const At& at) {
  constexpr double far = 0.2; // Of the limb's longest reach: a capture's limb has no such way in one frame.
  constexpr double sudden = 5.0;
  return 2 <= std::ranges::count_if(limbs, [&](const LimbMotion& limb) {
           const double first = glm::length(at(limb.places, 1) - at(limb.places, 0));
           const double next = glm::length(at(limb.places, 2) - at(limb.places, 1));
           double reach = 0.0;
           for (const Vec3& place : limb.places) {
             reach = std::max(reach, glm::length(place));
           }
           return first > far * reach && first > sudden * next;
         });
}

constexpr std::size_t samplesPerFrame = 2;

// The first of them as those a frame later, where they leap; `reversed` looks at the end.
template <typename Values>
void hold(Values& values, bool reversed) {
  const std::size_t count = values.size();
  for (std::size_t i = 0; i < samplesPerFrame && count > samplesPerFrame; ++i) {
    if (reversed) {
      values[count - 1 - i] = values[count - 1 - samplesPerFrame];
    } else {
      values[i] = values[samplesPerFrame];
    }
  }
}

// A pose that stands alone in front of a motion or behind it is no part of it.
void dropLonePoses(BodyMotion& motion) {
  for (const bool reversed : {false, true}) {
    const auto at = [&](const std::vector<Vec3>& places, std::size_t frame) -> const Vec3& {
      const std::size_t sample = std::min(frame * samplesPerFrame, places.size() - 1);
      return places[reversed ? places.size() - 1 - sample : sample];
    };
    if (!motion.forward.empty() && leapsFrom(motion.limbs, at)) {
      for (LimbMotion& limb : motion.limbs) {
        hold(limb.places, reversed);
        hold(limb.ends, reversed);
      }
      hold(motion.hips, reversed);
      hold(motion.forward, reversed);
    }
  }
}

void setReaches(BodyMotion& motion) {
  std::vector<double> reaches;
  for (LimbMotion& limb : motion.limbs) {
    for (const Vec3& place : limb.places) {
      limb.reach = std::max(limb.reach, glm::length(place));
    }
    reaches.push_back(limb.reach);
  }
  motion.reach = medianOf(std::move(reaches), 0.0);
}

} // namespace

Velocities velocitiesOf(const std::vector<Vec3>& places, double samplesPerSecond) {
  const std::ptrdiff_t spacing = spacingOf(samplesPerSecond);
  const auto last = static_cast<std::ptrdiff_t>(places.size()) - 1;
  const auto within = [&](std::ptrdiff_t i) {
    return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last));
  };
  const auto differenceAt = [&](std::size_t sample) {
    const std::size_t before = within(static_cast<std::ptrdiff_t>(sample) - spacing);
    const std::size_t after = within(static_cast<std::ptrdiff_t>(sample) + spacing);
    const double seconds = static_cast<double>(after - before) / samplesPerSecond;
    return seconds > 0.0 ? (places[after] - places[before]) / seconds : Vec3(0.0);
  };
  Velocities velocities;
  velocities.ways.reserve(places.size());
  velocities.speeds.reserve(places.size());
  for (std::ptrdiff_t i = 0; i <= last; ++i) {
    velocities.ways.push_back(0.25 * (differenceAt(within(i - spacing)) + 2.0 * differenceAt(within(i)) +
                                      differenceAt(within(i + spacing))));
    velocities.speeds.push_back(glm::length(velocities.ways.back()));
  }
  return velocities;
}

BodyMotion motionOfBody(const Scene& scene, const Clip& clip, const Body& body,
                        const std::vector<Limb>& limbs) {
  BodyMotion motion;
  motion.samplesPerSecond = 2.0 * clip.framesPerSecond;
  motion.limbs.resize(limbs.size());
  std::vector<NodeIndex> nodes;
  for (const Limb& limb : limbs) {
    const std::vector<NodeIndex> own = jointsAndEnd(limb);
    nodes.insert(nodes.end(), own.begin(), own.end());
  }
  if (body.hips.exists()) {
    nodes.push_back(body.hips);
  }
  const NodeSampler sampler(scene, clip, nodes);
  const double last = std::min(endInFrames(clip), longestFrames) + frameTolerance;
  for (LimbMotion& limb : motion.limbs) {
    limb.places.reserve(static_cast<std::size_t>(2.0 * last) + 1);
    limb.ends.reserve(limb.places.capacity());
  }
  FrameState frame;
  for (double at = 0.0; at <= last; at += 0.5) {
    sampler.sample(at / clip.framesPerSecond, frame);
    for (std::size_t i = 0; i < limbs.size(); ++i) {
      motion.limbs[i].ends.push_back(leadingPosition(limbs[i], frame));
      motion.limbs[i].places.push_back(motion.limbs[i].ends.back() - stayingPosition(limbs[i], frame));
    }
    if (body.hips.exists()) {
      motion.hips.push_back(positionOf(frame.worlds[stretch::at(body.hips)]));
    }
    motion.forward.push_back(forwardOf(limbs, frame));
  }
  dropLonePoses(motion);
  const bool hasOuterLimbs = std::ranges::any_of(limbs, [](const Limb& limb) { return reachesOut(limb); });
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    motion.limbs[i].isLeg = isLeg(limbs[i]);
  }
  setReaches(motion);
  for (std::size_t i = 0; i < limbs.size() && motion.reach > 0.0; ++i) {
    motion.limbs[i].weight =
        weightOf(limbs[i], hasOuterLimbs, body.plan == "biped", motion.limbs[i].reach / motion.reach);
  }
  return motion;
}

} // namespace stretch::rig

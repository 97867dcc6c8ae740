#include "rig/moments/moments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "core/base/lower_case.h"
#include "rig/moments/cycles.h"
#include "rig/moments/landings.h"
#include "rig/moments/strokes.h"

namespace stretch::rig {

namespace {

// Whether there are feet and all of them stay where they are.
bool feetStand(const BodyMotion& motion) {
  constexpr double still = 0.05; // Of the reach.
  const auto isFoot = [](const LimbMotion& limb) { return limb.isLeg; };
  return std::ranges::any_of(motion.limbs, isFoot) &&
         std::ranges::all_of(motion.limbs, [](const LimbMotion& limb) {
           return !limb.isLeg || std::ranges::all_of(limb.ends, [&](const Vec3& end) {
             return glm::distance(end, limb.ends.front()) <= still * limb.reach;
           });
         });
}

// What goes round so slowly on feet that stand breathes, sways or looks about: it is idle.
bool isSway(const BodyMotion& motion, const Velocities& velocities) {
  constexpr double slow = 2.0; // R per second.
  return std::ranges::max(velocities.speeds) < slow * motion.reach;
}

// Whole frames, where animators key: half a frame is given to the stroke.
Moment momentOf(const std::string& limb, MomentKind kind, const SampledStroke& stroke, double last) {
  const double tip = std::min(std::ceil(0.5 * static_cast<double>(stroke.tip)), last);
  const double start = std::min(std::floor(0.5 * static_cast<double>(stroke.start)), tip - 1.0);
  return {limb, kind, std::max(0.0, start), tip, tip, stroke.strength};
}

void keepApart(std::vector<Moment>& moments) {
  std::vector<Moment> apart;
  for (Moment moment : moments) {
    for (const Moment& stronger : apart) {
      if (stronger.limb != moment.limb) {
        continue;
      }
      if (moment.tipFrame > stronger.startFrame && moment.startFrame < stronger.startFrame) {
        moment.tipFrame = moment.endFrame = stronger.startFrame;
      } else if (moment.startFrame < stronger.endFrame && moment.tipFrame > stronger.endFrame) {
        moment.startFrame = stronger.endFrame;
      }
    }
    if (moment.startFrame < moment.tipFrame) {
      apart.push_back(moment);
    }
  }
  moments = std::move(apart);
}

bool isCycle(const Moment& moment) {
  return moment.kind == MomentKind::cycle;
}

// What swings along with the steps of a walk, no stronger than these, is part of the walk.
void joinSteps(std::vector<Moment>& moments) {
  double strongest = 0.0;
  for (const Moment& moment : moments) {
    strongest = isCycle(moment) ? std::max(strongest, moment.strength) : strongest;
  }
  for (Moment& moment : moments) {
    moment.kind = moment.strength < strongest ? MomentKind::cycle : moment.kind;
  }
}

// "Idle", "Fighting Idle", "toIdle", "idle_2": what a clip is stands last in its name. "Idle_HitReact_Left"
// is a hit, and "Sidle" another word.
bool isCalledIdle(const Clip& clip) {
  constexpr std::string_view word = "idle";
  const std::string low = lowerCase(clip.name);
  const std::size_t end = low.find_last_of("abcdefghijklmnopqrstuvwxyz");
  if (end == std::string::npos || !low.substr(0, end + 1).ends_with(word)) {
    return false;
  }
  const std::size_t first = end + 1 - word.size();
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const bool startsLarge =
      clip.name[first] != low[first] && first > 0 && clip.name[first - 1] == low[first - 1];
  return first == 0 || !isLetter(clip.name[first - 1]) || startsLarge;
}

bool comesBack(const BodyMotion& motion) {
  constexpr double near = 0.1; // Of the reach.
  return std::ranges::all_of(motion.limbs, [](const LimbMotion& limb) {
    return glm::distance(limb.places.front(), limb.places.back()) <= near * limb.reach;
  });
}

// A fidget is as fast as many a gesture. Nothing but its name tells an idle that has one from a greeting.
// What comes again, as wings that beat, is no fidget.
bool onlyFidgets(const Clip& clip, const BodyMotion& motion, const std::vector<Moment>& moments) {
  constexpr double leastStrike = 5.0; // Reaches per second.
  const Moment* const strongest = strongestMoment(moments);
  return strongest != nullptr && strongest->strength < leastStrike && isCalledIdle(clip) &&
         comesBack(motion) && std::ranges::none_of(moments, isCycle);
}

bool goBefore(const Moment& a, const Moment& b) {
  return isCycle(a) != isCycle(b) ? isCycle(b) : a.strength > b.strength;
}

} // namespace

const char* momentKindName(MomentKind kind) {
  constexpr std::array<const char*, 3> names{"stroke", "cycle", "landing"};
  return names[static_cast<std::size_t>(kind)];
}

const Moment* momentAt(const std::vector<Moment>& moments, double frame, double nearFrames) {
  const auto gap = [&](const Moment& moment) {
    const double frames = std::max({0.0, moment.startFrame - frame, frame - moment.endFrame});
    return frames > 0.0 ? std::max(frames, nearFrames) : 0.0;
  };
  const auto nearer = [&](const Moment& a, const Moment& b) {
    return gap(a) != gap(b) ? gap(a) < gap(b) : a.strength > b.strength;
  };
  const auto found = std::ranges::min_element(moments, nearer);
  return found == moments.end() ? nullptr : &*found;
}

const Moment* strongestMoment(const std::vector<Moment>& moments) {
  const auto found = std::ranges::max_element(moments, {}, &Moment::strength);
  return found == moments.end() ? nullptr : &*found;
}

std::vector<Moment> momentsOf(const Scene& scene, const Clip& clip, const Body& body,
                              const std::vector<Limb>& chains) {
  std::vector<Limb> limbs = body.limbs;
  limbs.insert(limbs.end(), chains.begin(), chains.end());
  std::erase_if(limbs, [](const Limb& limb) { return limb.joints.empty(); });
  const BodyMotion motion = motionOfBody(scene, clip, body, limbs);
  std::vector<Moment> moments;
  if (!(motion.reach > 0.0)) {
    return moments;
  }
  const double last = endInFrames(clip);
  const std::vector<bool> cycles = limbsInCycles(motion, limbs);
  const bool stands = feetStand(motion);
  bool steps = false;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    steps = steps || (cycles[i] && isLeg(limbs[i]));
    const MomentKind kind = cycles[i] ? MomentKind::cycle : MomentKind::stroke;
    const Velocities velocities = velocitiesOf(motion.limbs[i].places, motion.samplesPerSecond);
    if (cycles[i] && stands && isSway(motion, velocities)) {
      continue;
    }
    for (const SampledStroke& stroke : strokesOf(motion, motion.limbs[i], velocities, cycles[i])) {
      moments.push_back(momentOf(limbs[i].id, kind, stroke, last));
    }
  }
  if (steps) {
    joinSteps(moments);
  } else {
    for (const SampledStroke& landing : landingsOf(motion, limbs)) {
      moments.push_back(momentOf(wholeBody, MomentKind::landing, landing, last));
    }
  }
  std::ranges::stable_sort(moments, goBefore);
  keepApart(moments);
  return onlyFidgets(clip, motion, moments) ? std::vector<Moment>{} : moments;
}

} // namespace stretch::rig

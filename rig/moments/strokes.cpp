#include "rig/moments/strokes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/moments/moments.h"

namespace stretch::rig {

namespace {

constexpr double slowShare = 0.25;   // Of the peak's speed: less is slow.
constexpr double turnCosine = -0.2;  // Of the directions there and at the peak: less is a turn.
constexpr double leastPeak = 0.25;   // R per second: no way is so far that less came to the least strength.
constexpr double leastTravel = 0.15; // Of the reach: less only trembles.

/// The sample where the stroke with this peak ends, looking from the peak in one direction.
std::size_t edgeOf(const Velocities& velocities, std::size_t peak, std::ptrdiff_t direction) {
  const auto count = static_cast<std::ptrdiff_t>(velocities.speeds.size());
  auto at = static_cast<std::ptrdiff_t>(peak);
  const auto goesOn = [&](std::ptrdiff_t i) {
    const auto sample = static_cast<std::size_t>(i);
    return velocities.speeds[sample] > slowShare * velocities.speeds[peak] &&
           cosineBetween(velocities.ways[sample], velocities.ways[peak]) > turnCosine;
  };
  while (at + direction >= 0 && at + direction < count && goesOn(at)) {
    at += direction;
  }
  return static_cast<std::size_t>(at);
}

/// Whether the stroke takes the limb straight back to where the clip began.
bool isWayBack(const LimbMotion& limb, const SampledStroke& stroke) {
  constexpr double near = 0.15;    // Of the reach.
  constexpr double straight = 0.8; // Of the stroke's length.
  const double fromHome = glm::length(limb.places[stroke.start] - limb.places.front());
  const double toHome = glm::length(limb.places[stroke.tip] - limb.places.front());
  const double travel = glm::length(limb.places[stroke.tip] - limb.places[stroke.start]);
  return toHome < near * limb.reach && fromHome - toHome > straight * travel;
}

/// Share of the stroke that is seen in the world: a hand that stays where it is while its shoulder moves
/// does nothing.
double seenShare(double travel, double travelInWorld) {
  constexpr double leastShare = 0.2;
  return std::clamp(travelInWorld / travel, leastShare, 1.0);
}

/// Whether it is a step: a foot that skims over the ground and is put down to carry.
bool isStep(const BodyMotion& motion, const LimbMotion& limb, const SampledStroke& stroke) {
  constexpr double highest = 0.25; // Of the reach, above its lowest place: a kick or a stamp goes higher.
  constexpr double still = 0.05;   // Likewise.
  constexpr double seconds = 0.1;
  const std::size_t stood =
      stroke.tip + static_cast<std::size_t>(std::ceil(seconds * motion.samplesPerSecond));
  if (!limb.isLeg || stood >= limb.ends.size()) {
    return false;
  }
  const double low = std::ranges::min(limb.ends, {}, &Vec3::y).y;
  double lift = 0.0;
  double after = 0.0;
  for (std::size_t i = stroke.start; i <= stood; ++i) {
    lift = std::max(lift, limb.ends[i].y - low);
    after = i > stroke.tip ? std::max(after, glm::length(limb.ends[i] - limb.ends[stroke.tip])) : 0.0;
  }
  return lift < highest * limb.reach && limb.ends[stroke.tip].y - low < still * limb.reach &&
         after < still * limb.reach;
}

// `speed`: at its peak.
double strengthOf(const BodyMotion& motion, const LimbMotion& limb, const SampledStroke& stroke,
                  double speed) {
  constexpr double forwardGain = 0.4;
  const double travel = glm::length(limb.places[stroke.tip] - limb.places[stroke.start]);
  const Vec3 way = limb.ends[stroke.tip] - limb.ends[stroke.start];
  const double seen = seenShare(travel, glm::length(way));
  const double out = glm::length(limb.places[stroke.tip]) / limb.reach;
  const double forward = cosineBetween(way, motion.forward[stroke.peak]);
  return speed / motion.reach * std::sqrt(travel / limb.reach * seen * out) *
         std::exp(forwardGain * forward) * limb.weight;
}

bool isPeak(const std::vector<double>& speeds, std::size_t i) {
  return speeds[i] > 0.0 && (i == 0 || speeds[i] > speeds[i - 1]) &&
         (i + 1 == speeds.size() || speeds[i] >= speeds[i + 1]);
}

/// A step or two only carry the body along, and are the weakest of moments at least; more of them are a gait
/// that does not close.
void lessenSteps(const BodyMotion& motion, const LimbMotion& limb, std::vector<SampledStroke>& strokes) {
  constexpr double stepShare = 0.3;
  constexpr std::ptrdiff_t fewSteps = 2;
  const auto steps = [&](const SampledStroke& stroke) { return isStep(motion, limb, stroke); };
  if (std::ranges::count_if(strokes, steps) <= fewSteps) {
    for (SampledStroke& stroke : strokes) {
      stroke.strength =
          steps(stroke) ? std::max(leastStrength, stepShare * stroke.strength) : stroke.strength;
    }
    std::ranges::stable_sort(strokes, std::ranges::greater{}, &SampledStroke::strength);
  }
}

} // namespace

std::vector<SampledStroke> strokesOf(const BodyMotion& motion, const LimbMotion& limb,
                                     const Velocities& velocities, bool goesRound) {
  constexpr double wayBackShare = 0.5;
  std::vector<SampledStroke> all;
  for (std::size_t peak = 0; peak < velocities.speeds.size(); ++peak) {
    const double speed = velocities.speeds[peak];
    if (!isPeak(velocities.speeds, peak) || speed < leastPeak * motion.reach) {
      continue;
    }
    SampledStroke stroke{edgeOf(velocities, peak, -1), peak, edgeOf(velocities, peak, 1)};
    if (glm::length(limb.places[stroke.tip] - limb.places[stroke.start]) >= leastTravel * limb.reach) {
      const bool isBack = !goesRound && isWayBack(limb, stroke);
      stroke.strength = strengthOf(motion, limb, stroke, speed) * (isBack ? wayBackShare : 1.0);
      all.push_back(stroke);
    }
  }
  std::erase_if(all, [](const SampledStroke& stroke) { return stroke.strength < leastStrength; });
  std::ranges::stable_sort(all, std::ranges::greater{}, &SampledStroke::strength);
  std::vector<SampledStroke> apart;
  for (const SampledStroke& stroke : all) {
    const bool isApart = std::ranges::all_of(apart, [&](const SampledStroke& stronger) {
      return stroke.tip <= stronger.start + 1 || stroke.start + 1 >= stronger.tip;
    });
    if (isApart) {
      apart.push_back(stroke);
    }
  }
  if (!goesRound) {
    lessenSteps(motion, limb, apart);
  }
  return apart;
}

} // namespace stretch::rig

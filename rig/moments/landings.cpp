#include "rig/moments/landings.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "rig/moments/moments.h"

namespace stretch::rig {

namespace {

constexpr double carriedShare = 0.5; // Of the hips' fastest fall: a foot that falls as fast does not stand.
constexpr double stoodShare = 0.25;  // Likewise: a foot that is slower stands, and so do hips.
constexpr double leastFall = 0.1;    // Of the body's reach.

/// Downward speed of a place at a sample, the one before it to it.
double fallOf(const std::vector<Vec3>& places, std::size_t i, double samplesPerSecond) {
  return i == 0 ? 0.0 : (places[i - 1].y - places[i].y) * samplesPerSecond;
}

/// First sample from `from` on where the place falls no longer, at most the last one.
std::size_t lowestAfter(const std::vector<Vec3>& places, std::size_t from) {
  while (from + 1 < places.size() && places[from + 1].y < places[from].y) {
    ++from;
  }
  return from;
}

std::vector<const LimbMotion*> feetOf(const BodyMotion& motion, const std::vector<Limb>& limbs) {
  std::vector<const LimbMotion*> feet;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    if (isLeg(limbs[i])) {
      feet.push_back(&motion.limbs[i]);
    }
  }
  return feet;
}

} // namespace

std::vector<SampledStroke> landingsOf(const BodyMotion& motion, const std::vector<Limb>& limbs) {
  const std::vector<const LimbMotion*> feet = feetOf(motion, limbs);
  const std::vector<Vec3>& hips = motion.hips;
  std::vector<SampledStroke> landings;
  if (feet.empty() || hips.size() < 3) {
    return landings;
  }
  const double rate = motion.samplesPerSecond;
  std::size_t next = 0;
  while (next + 1 < hips.size()) {
    const std::size_t top = next;
    const std::size_t bottom = lowestAfter(hips, top);
    next = bottom > top ? bottom : top + 1;
    const double fall = hips[top].y - hips[bottom].y;
    if (fall < leastFall * motion.reach) {
      continue;
    }
    std::size_t peak = top;
    for (std::size_t i = top; i <= bottom; ++i) {
      peak = fallOf(hips, i, rate) > fallOf(hips, peak, rate) ? i : peak;
    }
    const double fastest = fallOf(hips, peak, rate);
    const auto fallWith = [&](std::size_t i, double share) {
      return std::ranges::all_of(
          feet, [&](const LimbMotion* foot) { return fallOf(foot->ends, i, rate) > share * fastest; });
    };
    std::size_t carried = bottom;
    while (carried > top && !fallWith(carried, carriedShare)) {
      --carried;
    }
    std::size_t stood = carried;
    while (stood < bottom && fallWith(stood, stoodShare)) {
      ++stood;
    }
    std::size_t tip = stood;
    while (tip < bottom && fallOf(hips, tip + 1, rate) > stoodShare * fastest) {
      ++tip;
    }
    const double strength = fastest / motion.reach * std::sqrt(fall / motion.reach);
    const double falls = hips[top].y - hips[carried].y; // In the air.
    if (falls >= leastFall * motion.reach && stood < tip && strength >= leastStrength) {
      landings.push_back({stood, peak, tip, strength});
    }
  }
  std::ranges::stable_sort(landings, std::ranges::greater{}, &SampledStroke::strength);
  return landings;
}

} // namespace stretch::rig

#include "rig/moments/cycles.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace stretch::rig {

namespace {

constexpr double sameShare = 0.55; // Of how far the limb strays from its middle: nearer is the same.
constexpr double limpShare = 0.4;  // Likewise of legs that do not step in even time.
constexpr double seamSteps = 2.0;  // Longest steps of a frame: no farther is the end from the beginning.
constexpr double leastMove = 0.01; // Of the reach: what strays less from its middle stands still.
constexpr std::size_t fewestSamples = 8;

/// A limb's places as the body carries them, along its right, up and the way that it faces, about their
/// middle.
std::vector<Vec3> placesInBody(const BodyMotion& motion, const LimbMotion& limb) {
  std::vector<Vec3> places;
  Vec3 middle(0.0);
  for (std::size_t i = 0; i < limb.places.size(); ++i) {
    const Vec3& forward = motion.forward[i];
    const Vec3 right = glm::cross(forward, Vec3(0.0, 1.0, 0.0));
    const Vec3& place = limb.places[i];
    places.push_back(forward == Vec3(0.0) ? place
                                          : Vec3(glm::dot(place, right), place.y, glm::dot(place, forward)));
    middle += places.back();
  }
  for (Vec3& place : places) {
    place -= middle / static_cast<double>(places.size());
  }
  return places;
}

double meanSquare(const std::vector<Vec3>& places) {
  double sum = 0.0;
  for (const Vec3& place : places) {
    sum += glm::dot(place, place);
  }
  return sum / static_cast<double>(places.size());
}

/// The place at a sample of a clip that goes round in `period` samples; between its last and its first on the
/// line.
Vec3 placeAt(const std::vector<Vec3>& places, double sample, double period) {
  const auto last = static_cast<double>(places.size() - 1);
  const double at = std::fmod(sample, period);
  if (at >= last) {
    const double share = period > last ? (at - last) / (period - last) : 0.0;
    return glm::mix(places.back(), places.front(), share);
  }
  const auto before = static_cast<std::size_t>(at);
  return glm::mix(places[before], places[before + 1], at - std::floor(at));
}

/// How far the places are from those of the other list `part` of the way round later, as a share of how far
/// they stray from their middle.
double shareApart(const std::vector<Vec3>& places, const std::vector<Vec3>& other, double part,
                  double period) {
  std::vector<Vec3> apart;
  for (std::size_t i = 0; i < places.size(); ++i) {
    apart.push_back(places[i] - placeAt(other, static_cast<double>(i) + part * period, period));
  }
  return std::sqrt(meanSquare(apart) / meanSquare(places));
}

/// How many samples the limb takes to come round: as many as there are steps, or one frame more where the
/// first pose is not repeated; nothing where it does not.
std::vector<double> periodsOf(const std::vector<Vec3>& places) {
  double longest = 0.0;
  for (std::size_t i = 2; i < places.size(); ++i) {
    longest = std::max(longest, glm::length(places[i] - places[i - 2]));
  }
  if (!(longest > 0.0) || glm::length(places.back() - places.front()) > seamSteps * longest) {
    return {};
  }
  const auto steps = static_cast<double>(places.size() - 1);
  return {steps, steps + 2.0};
}

std::vector<Vec3> mirroredPlaces(std::vector<Vec3> places) {
  for (Vec3& place : places) {
    place.x = -place.x;
  }
  return places;
}

bool strays(const LimbMotion& limb, const std::vector<Vec3>& places) {
  const double moves = leastMove * limb.reach;
  return places.size() >= fewestSamples && meanSquare(places) >= moves * moves;
}

/// Whether a leg does what the one beside it does, however much later, but not with it.
bool gallops(const BodyMotion& motion, const std::vector<Limb>& limbs, std::size_t limb) {
  constexpr int parts = 16;
  const Limb* const beside = limbAt(limbs, mirrored(limbs[limb]));
  const std::vector<Vec3> places = placesInBody(motion, motion.limbs[limb]);
  if (beside == nullptr || !strays(motion.limbs[limb], places)) {
    return false;
  }
  const std::vector<Vec3> other =
      placesInBody(motion, motion.limbs[static_cast<std::size_t>(beside - limbs.data())]);
  return std::ranges::any_of(periodsOf(places), [&](double period) {
    double least = limpShare;
    for (int part = 1; part < parts; ++part) {
      least = std::min(least, shareApart(places, other, static_cast<double>(part) / parts, period));
    }
    return least < limpShare && least < shareApart(places, other, 0.0, period);
  });
}

/// All of four legs or more do: a body that only strikes out leaves two where they are.
bool legsGallop(const BodyMotion& motion, const std::vector<Limb>& limbs) {
  int galloping = 0;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    galloping += isLeg(limbs[i]) && gallops(motion, limbs, i) ? 1 : 0;
  }
  return galloping >= 4 && galloping == std::ranges::count_if(limbs, isLeg);
}

bool goesRound(const BodyMotion& motion, const std::vector<Limb>& limbs, std::size_t limb) {
  const std::vector<Vec3> places = placesInBody(motion, motion.limbs[limb]);
  if (!strays(motion.limbs[limb], places)) {
    return false;
  }
  const Limb* const opposite = motion.forward.front() == Vec3(0.0) || limbs[limb].kind == LimbKind::chain
                                   ? nullptr
                                   : limbAt(limbs, mirrored(limbs[limb]));
  const std::vector<Vec3> other =
      opposite == nullptr
          ? places
          : placesInBody(motion, motion.limbs[static_cast<std::size_t>(opposite - limbs.data())]);
  const std::vector<Vec3> mirror = opposite == nullptr ? places : mirroredPlaces(other);
  return std::ranges::any_of(periodsOf(places), [&](double period) {
    const auto isAgain = [&](const std::vector<Vec3>& later, double part) {
      return shareApart(places, later, part, period) < sameShare;
    };
    const auto limps = [&](double part) {
      return isLeg(limbs[limb]) && shareApart(places, other, part, period) < limpShare;
    };
    return isAgain(places, 1.0 / 2.0) || isAgain(places, 1.0 / 3.0) || isAgain(places, 1.0 / 4.0) ||
           isAgain(other, 1.0 / 2.0) || isAgain(mirror, 1.0 / 2.0) || isAgain(mirror, 1.0 / 4.0) ||
           limps(3.0 / 8.0) || limps(5.0 / 8.0);
  });
}

} // namespace

std::vector<bool> limbsInCycles(const BodyMotion& motion, const std::vector<Limb>& limbs) {
  std::vector<bool> cycles;
  bool legsGo = false;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    cycles.push_back(goesRound(motion, limbs, i));
    legsGo = legsGo || (cycles.back() && isLeg(limbs[i]));
  }
  legsGo = legsGo || legsGallop(motion, limbs);
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    cycles[i] = cycles[i] || (legsGo && isLeg(limbs[i]));
  }
  return cycles;
}

} // namespace stretch::rig

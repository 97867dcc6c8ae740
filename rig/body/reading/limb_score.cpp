#include "rig/body/reading/limb_score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <glm/geometric.hpp>

namespace stretch::rig::body {

namespace {

struct LimbRoles {
  Role base;
  Role middle;
  Role end;
};

constexpr LimbRoles rolesOf(Region region) {
  return region == Region::arm ? LimbRoles{Role::upperArm, Role::foreArm, Role::wrist}
                               : LimbRoles{Role::thigh, Role::shin, Role::ankle};
}

double angleBetween(const Vec3& a, const Vec3& b) {
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0.0 ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0)) : 0.0;
}

double jointFit(const NameEvidence& name, Role role) {
  const double here = name.role(role);
  const double best = *std::ranges::max_element(name.roles);
  constexpr double clear = 0.8;
  const double against = best >= clear ? 0.5 * (best - here) : 0.0;
  const bool isFin = name.fin && (role == Role::thigh || role == Role::shin || role == Role::ankle);
  return here - against - (name.finger ? 0.6 : 0.0) - (name.accessory || isFin ? 0.8 : 0.0) -
         (name.twist ? 0.6 : 0.0);
}

// A name's words alone: halves of a bone are told apart by numbers.
std::string_view withoutNumber(std::string_view key) {
  return key.substr(0, key.find('#'));
}

// Names of joints between two of a guess: one that clearly is a limb joint should not have been skipped.
double skippedFit(const BodyView& view, const std::vector<int>& path, const LimbRoles& roles) {
  double fit = 0.0;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const NameEvidence& name = view.name(path[i]);
    const double role = std::max({name.role(roles.base), name.role(roles.middle), name.role(roles.end)});
    const bool sharesBone = withoutNumber(name.key) == withoutNumber(view.name(path.front()).key);
    fit -= role >= 0.8 && !name.twist && !sharesBone ? 0.4 : 0.0;
  }
  return fit;
}

// What a joint above the base takes from it: one on its side that clearly is called by the base's role, where
// the base is called so less, is the base of the limb.
double missedBase(const BodyView& view, const LimbGuess& guess, Role role) {
  constexpr double clear = 0.9;
  const NameEvidence& base = view.name(guess.base);
  for (int above = view.parentOf(guess.base); above >= 0 && view.name(above).side == base.side;
       above = view.parentOf(above)) {
    const NameEvidence& name = view.name(above);
    if (name.role(role) >= std::max(clear, base.role(role) + 0.1) && !name.twist) {
      return 0.8;
    }
  }
  return 0.0;
}

// Joints skipped cost little where they share the bone (twist and split joints lie on its line) and much
// where they bend.
double skipPenalty(const BodyView& view, const std::vector<int>& path) {
  if (path.size() < 3) {
    return 0.0;
  }
  const Vec3 from = view.at(path.front());
  const Vec3 bone = view.at(path.back()) - from;
  const double length = glm::length(bone);
  double penalty = 0.0;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Vec3 there = view.at(path[i]) - from;
    const double along = glm::dot(there, bone) / (length * length);
    const double off = glm::length(there - along * bone) / length;
    const double outside = std::max({0.0, -along, along - 1.0});
    // Where one joint shares a bone, more may.
    const double shared = i > 3 ? 0.01 : i > 1 ? 0.04 : 0.12;
    penalty += (view.name(path[i]).twist ? 0.02 : shared) +
               std::min(1.2, 8.0 * std::max(0.0, off - 0.01) + 2.0 * outside);
  }
  return penalty;
}

// Beyond the end a hand or foot remains: some, but less than the limb.
double remainderPenalty(const BodyView& view, const LimbGuess& guess, Region region) {
  if (guess.end < 0 || guess.endDetached) {
    return 0.0;
  }
  const double beyond = view.reach[static_cast<std::size_t>(guess.end)];
  const double fraction = beyond / (guess.length + beyond);
  const double least = region == Region::arm ? 0.1 : 0.08;
  const double most = region == Region::arm ? 0.4 : 0.5;
  const double outside = std::max(least - fraction, fraction - most);
  return outside > 0.0 ? std::min(0.6, 0.15 + 2.0 * outside) : 0.0;
}

// What it costs to begin after the first of many equal bones, as of a limb of rubber.
double skippedEqual(const BodyView& view, const MirrorPlane& plane, int base, double least) {
  const int above = view.parentOf(base);
  const bool isOff = above >= 0 && std::abs(plane.lateral(view.at(above))) > least;
  return isOff && continuesEqualBone(view, base) ? 0.4 : 0.0;
}

// Of a leg: what lies off the middle before its base. It begins where it leaves the pelvis, however its knee
// is bent; a bone in line with its first is the first half of that.
double bonesBeforeLeg(const BodyView& view, const MirrorPlane& plane, const LimbGuess& guess, double least) {
  constexpr double inLine = 0.2; // radians
  const Vec3 upper = view.at(guess.middle) - view.at(guess.base);
  double length = 0.0;
  double penalty = 0.0;
  for (int below = guess.base, above = view.parentOf(guess.base);
       above >= 0 && std::abs(plane.lateral(view.at(above))) > least;
       below = above, above = view.parentOf(above)) {
    const Vec3 bone = view.at(below) - view.at(above);
    length += glm::length(bone);
    const bool isHalf = below == guess.base && angleBetween(upper, bone) < inLine &&
                        glm::length(bone) > 0.15 * glm::length(upper);
    penalty = isHalf ? 0.35 : penalty;
  }
  // The more of a leg lies before it the less it is the leg: a shin and a foot alone are none.
  const double share = length / guess.length;
  return length > 0.5 * glm::length(upper) ? 0.5 + std::min(1.0, 0.8 * std::max(0.0, share - 0.5)) : penalty;
}

// A leg turns at the ankle: what goes on in its line is the rest of the shin.
double goesOnPenalty(const BodyView& view, const LimbGuess& guess, Region region) {
  constexpr double inLine = 0.2; // radians
  if (region != Region::leg || guess.end < 0 || guess.endDetached) {
    return 0.0;
  }
  const Vec3 lower = guess.endPosition - view.at(guess.middle);
  const bool goesOn = std::ranges::any_of(view.childrenOf(guess.end), [&](int child) {
    const Vec3 bone = view.at(child) - guess.endPosition;
    return glm::length(bone) > 0.15 * glm::length(lower) && angleBetween(lower, bone) < inLine &&
           view.movesMesh(child);
  });
  return goesOn ? 0.3 : 0.0;
}

// A base in the middle of the body is a clavicle or the pelvis; a long bone of the same line before it is the
// real base.
double basePenalty(const BodyView& view, const MirrorPlane& plane, const LimbGuess& guess, Region region) {
  const double lateral = std::abs(plane.lateral(view.at(guess.base)));
  const double least = (region == Region::arm ? 0.12 : 0.04) * guess.length;
  const bool isInMiddle = region == Region::arm && lateral < 0.01 * view.size;
  double penalty = isInMiddle ? 1.2 : lateral < least ? 0.45 : 0.0;
  const int before = view.parentOf(guess.base);
  if (region == Region::leg && guess.middle >= 0) {
    return penalty + bonesBeforeLeg(view, plane, guess, least) + skippedEqual(view, plane, guess.base, least);
  }
  if (before >= 0 && guess.middle >= 0) {
    const Vec3 upper = view.at(guess.middle) - view.at(guess.base);
    const Vec3 earlier = view.at(guess.base) - view.at(before);
    const bool offPlane = std::abs(plane.lateral(view.at(before))) > least;
    const bool sameLine = angleBetween(upper, earlier) < pi / 3.0;
    penalty += offPlane && sameLine && glm::length(earlier) > 0.5 * glm::length(upper)
                   ? 0.5
                   : skippedEqual(view, plane, guess.base, least);
  }
  return penalty;
}

double fanPenalty(const BodyView& view, const LimbGuess& guess, Region region) {
  if (region != Region::arm || guess.middle < 0) {
    return 0.0;
  }
  const bool middleFans = isFan(view, guess.middle);
  if (guess.end < 0) {
    return middleFans ? 0.15 : 0.5;
  }
  const bool endFans = isFan(view, guess.end);
  if (middleFans && !endFans) {
    return 0.6;
  }
  return endFans ? -0.3 : 0.0;
}

double lengthPenalty(const BodyView& view, const LimbGuess& guess) {
  const double share = guess.length / view.size;
  return 1.2 * std::max(0.0, 1.0 - share / 0.25) + std::max(0.0, share - 0.75);
}

double bonesPenalty(const BodyView& view, const LimbGuess& guess, Region region) {
  const Vec3 upper = view.at(guess.middle) - view.at(guess.base);
  const Vec3 lower = guess.endPosition - view.at(guess.middle);
  const double upperLength = glm::length(upper);
  const double lowerLength = glm::length(lower);
  if (upperLength <= 0.0 || lowerLength <= 0.0) {
    return 2.0;
  }
  const double ratio = std::abs(std::log(upperLength / lowerLength)) / std::log(3.0);
  const double widest = region == Region::arm ? 100.0 : 60.0;
  const double bend = angleBetween(upper, lower) * 180.0 / pi;
  return 0.8 * std::min(1.5, ratio) + (bend > widest ? 0.4 : 0.0);
}

// Whether a joint is a helper beside the one by which the limb goes on in the same place: beside a hand one
// may be called its wrist.
bool isHelperOfEnd(const BodyView& view, const LimbGuess& guess) {
  constexpr double near = 0.03; // of the limb
  const int parent = guess.end < 0 ? -1 : view.parentOf(guess.end);
  return parent >= 0 && view.childrenOf(guess.end).empty() &&
         std::ranges::any_of(view.childrenOf(parent), [&](int other) {
           return !view.childrenOf(other).empty() &&
                  glm::distance(view.at(other), guess.endPosition) < near * guess.length;
         });
}

} // namespace

double nameFit(const BodyView& view, const LimbGuess& guess, Region region) {
  const LimbRoles roles = rolesOf(region);
  double fit = jointFit(view.name(guess.base), roles.base);
  if (guess.middle >= 0) {
    fit += jointFit(view.name(guess.middle), roles.middle);
    fit += skippedFit(view, view.path(guess.base, guess.middle), roles);
  }
  if (guess.end >= 0) {
    fit += isHelperOfEnd(view, guess) ? -0.3 : jointFit(view.name(guess.end), roles.end);
    fit += skippedFit(view, view.path(guess.middle, guess.end), roles);
  }
  fit -= missedBase(view, guess, roles.base);
  const int before = view.parentOf(guess.base);
  if (before >= 0 && region == Region::arm) {
    fit += 0.3 * view.name(before).role(Role::clavicle);
  }
  return fit;
}

bool continuesEqualBone(const BodyView& view, int joint) {
  constexpr double inLine = 0.98; // cosine
  constexpr double alike = 0.7;   // of the longer one
  const int above = view.parentOf(joint);
  if (above < 0 || withoutNumber(view.name(above).key) != withoutNumber(view.name(joint).key) ||
      view.name(above).side != view.name(joint).side) {
    return false;
  }
  const Vec3 bone = view.at(joint) - view.at(above);
  const double length = glm::length(bone);
  return std::ranges::any_of(view.childrenOf(joint), [&](int child) {
    const Vec3 next = view.at(child) - view.at(joint);
    const double other = glm::length(next);
    return std::min(length, other) >= alike * std::max(length, other) &&
           glm::dot(bone, next) > inLine * length * other;
  });
}

double shapePenalty(const BodyView& view, const MirrorPlane& plane, const LimbGuess& guess, Region region) {
  double penalty = lengthPenalty(view, guess) + basePenalty(view, plane, guess, region);
  if (guess.middle < 0) {
    return penalty + (guess.end < 0 ? 1.2 : 0.8);
  }
  penalty += bonesPenalty(view, guess, region) + skipPenalty(view, view.path(guess.base, guess.middle));
  penalty += fanPenalty(view, guess, region) + remainderPenalty(view, guess, region) +
             goesOnPenalty(view, guess, region);
  if (guess.endDetached) {
    return penalty + 0.2;
  }
  return penalty + (guess.end < 0 && region == Region::leg ? 0.5 : 0.0) +
         (guess.end >= 0 ? skipPenalty(view, view.path(guess.middle, guess.end)) : 0.0);
}

} // namespace stretch::rig::body

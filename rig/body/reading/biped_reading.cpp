#include "rig/body/reading/biped_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"

namespace stretch::rig::body {

namespace {

constexpr std::size_t guessesOnASide = 50;
constexpr std::size_t mostPairs = 40;
constexpr double leastNameFitAlone = 1.4; // a limb without a counterpart must be named

std::vector<const LimbGuess*> limbsOf(const LimbPair& pair) {
  std::vector<const LimbGuess*> limbs;
  for (const std::optional<LimbGuess>* limb : {&pair.negative, &pair.positive}) {
    if (*limb) {
      limbs.push_back(&**limb);
    }
  }
  return limbs;
}

double boneLength(const BodyView& view, const LimbGuess& guess, bool upper) {
  const Vec3 middle = guess.middle >= 0 ? view.at(guess.middle) : guess.endPosition;
  return glm::distance(upper ? view.at(guess.base) : guess.endPosition, middle);
}

// Compares where the joints are, and for characters that stand out of symmetry the bases and bone lengths
// alone.
double mirrorError(const BodyView& view, const MirrorPlane& plane, const LimbGuess& a, const LimbGuess& b) {
  const double base = glm::distance(plane.mirrored(view.at(a.base)), view.at(b.base));
  const double end = glm::distance(plane.mirrored(a.endPosition), b.endPosition);
  const bool bends = a.middle >= 0 && b.middle >= 0;
  const double middle = bends ? glm::distance(plane.mirrored(view.at(a.middle)), view.at(b.middle)) : 0.0;
  const double posed = (base + middle + end) / (bends ? 3.0 : 2.0);
  const double lengths = std::abs(boneLength(view, a, true) - boneLength(view, b, true)) +
                         std::abs(boneLength(view, a, false) - boneLength(view, b, false));
  const double size = std::max(a.length, b.length);
  return std::min(posed / size, 0.05 + (base + lengths) / 2.0 / size);
}

bool shareJoint(const BodyView& view, const LimbGuess& a, const LimbGuess& b) {
  return view.isAboveOrSelf(a.base, b.base) || view.isAboveOrSelf(b.base, a.base) ||
         (a.end >= 0 && a.end == b.end);
}

// Joints from `from` to `to`; 0 where one of them is missing.
std::size_t jointsBetween(const BodyView& view, int from, int to) {
  std::size_t joints = 1;
  for (; to >= 0 && to != from; to = view.parentOf(to)) {
    ++joints;
  }
  return from < 0 || to < 0 ? 0 : joints;
}

// 0 where both have the same joints; a missing end is worth less than a missing bone.
double structurePenalty(const BodyView& view, const LimbGuess& a, const LimbGuess& b) {
  if (jointsBetween(view, a.base, a.middle) != jointsBetween(view, b.base, b.middle)) {
    return 0.5;
  }
  if ((a.end < 0) != (b.end < 0)) {
    return 0.1;
  }
  return jointsBetween(view, a.middle, a.end) == jointsBetween(view, b.middle, b.end) ? 0.0 : 0.5;
}

LimbPair makePair(const BodyView& view, const MirrorPlane& plane, const LimbGuess& negative,
                  const LimbGuess& positive) {
  LimbPair pair{negative, positive};
  pair.mirrorError = mirrorError(view, plane, negative, positive);
  const Side first = namedSide(view, negative);
  const Side second = namedSide(view, positive);
  const double sides = first == Side::none || second == Side::none ? 0.0 : first == second ? -0.5 : 0.3;
  // Of two that mirror each other the better shape counts: a weapon in one hand makes no difference.
  constexpr double alike = 0.1;
  const double apart = structurePenalty(view, negative, positive);
  const bool areAlike = apart == 0.0 && pair.mirrorError < alike;
  const double spared = areAlike ? std::abs(negative.shapePenalty - positive.shapePenalty) : 0.0;
  pair.score =
      negative.score() + positive.score() + spared - std::min(2.0, 4.0 * pair.mirrorError) + sides - apart;
  return pair;
}

LimbPair makeSingle(const LimbGuess& guess) {
  LimbPair pair;
  (guess.lateral < 0.0 ? pair.negative : pair.positive) = guess;
  pair.score = guess.score() - (guess.nameFit >= leastNameFitAlone ? 0.8 : 1.2);
  return pair;
}

// An arm without a counterpart anywhere: the other one is missing, and names need not say so.
bool standsAlone(const BodyView& view, const MirrorPlane& plane, const LimbGuess& guess,
                 const std::vector<LimbGuess>& guesses) {
  constexpr double leastError = 0.3;
  return guess.end >= 0 && guess.nameFit > -0.2 && std::ranges::none_of(guesses, [&](const LimbGuess& other) {
           return guess.lateral * other.lateral < 0.0 && mirrorError(view, plane, guess, other) < leastError;
         });
}

// Whether two limbs on one side of the mirror plane are a pair nevertheless, as of a trunk that is turned or
// bends aside: names call them left and right and alike but for that, or both hang equally far from one
// joint, and are of equal bones.
bool belongTogether(const BodyView& view, const LimbGuess& one, const LimbGuess& other) {
  constexpr double alike = 0.02; // of a limb
  const Side side = namedSide(view, one);
  const Side opposite = side == Side::left ? Side::right : side == Side::right ? Side::left : Side::none;
  if (namedSide(view, other) != opposite || structurePenalty(view, one, other) > 0.0) {
    return false;
  }
  const auto areCalledAlike = [&](int joint, int counterpart) {
    return joint < 0 || counterpart < 0 ? joint == counterpart
                                        : view.name(joint).key == view.name(counterpart).key;
  };
  const bool areNamedApart =
      side != Side::none &&
      ((areCalledAlike(one.base, other.base) && areCalledAlike(one.middle, other.middle) &&
        areCalledAlike(one.end, other.end)) ||
       std::min(one.nameFit, other.nameFit) >= leastNameFitAlone);
  const int carrier = view.parentOf(one.base);
  return areNamedApart || (carrier >= 0 && carrier == view.parentOf(other.base) && one.middle >= 0 &&
                           std::abs(glm::distance(view.at(carrier), view.at(one.base)) -
                                    glm::distance(view.at(carrier), view.at(other.base))) +
                                   std::abs(boneLength(view, one, true) - boneLength(view, other, true)) +
                                   std::abs(boneLength(view, one, false) - boneLength(view, other, false)) <
                               alike * one.length);
}

// Such a pair, each on its side of the middle between them.
LimbPair pairBesideMiddle(const BodyView& view, const MirrorPlane& plane, LimbGuess negative,
                          LimbGuess positive) {
  const double half = 0.5 * (positive.lateral - negative.lateral);
  negative.lateral = -half;
  positive.lateral = half;
  return makePair(view, plane, negative, positive);
}

std::vector<LimbPair> likelyPairs(const BodyView& view, const MirrorPlane& plane, Region region) {
  const std::vector<LimbGuess> guesses = guessLimbs(view, plane, region, guessesOnASide);
  std::vector<LimbPair> pairs;
  for (const LimbGuess& guess : guesses) {
    if (guess.nameFit >= leastNameFitAlone ||
        (region == Region::arm && standsAlone(view, plane, guess, guesses))) {
      pairs.push_back(makeSingle(guess));
    }
    for (const LimbGuess& other : guesses) {
      if (guess.lateral >= other.lateral || shareJoint(view, guess, other)) {
        continue;
      }
      if (guess.lateral < 0.0 && other.lateral > 0.0) {
        pairs.push_back(makePair(view, plane, guess, other));
      } else if (belongTogether(view, guess, other)) {
        pairs.push_back(pairBesideMiddle(view, plane, guess, other));
      }
    }
  }
  std::ranges::stable_sort(pairs, std::ranges::greater{}, &LimbPair::score);
  pairs.resize(std::min(pairs.size(), mostPairs));
  return pairs;
}

bool overlap(const BodyView& view, const LimbPair& arms, const LimbPair& legs) {
  const auto share = [&](const std::optional<LimbGuess>& arm, const std::optional<LimbGuess>& leg) {
    return arm && leg && shareJoint(view, *arm, *leg);
  };
  return share(arms.negative, legs.negative) || share(arms.negative, legs.positive) ||
         share(arms.positive, legs.negative) || share(arms.positive, legs.positive);
}

// Zero where there are no limbs.
template <typename Mean, typename Value>
Mean meanOf(const LimbPair& pair, const Value& value) {
  const std::vector<const LimbGuess*> limbs = limbsOf(pair);
  Mean sum(0.0);
  for (const LimbGuess* limb : limbs) {
    sum += value(*limb);
  }
  return sum / std::max(1.0, static_cast<double>(limbs.size()));
}

double meanLength(const LimbPair& pair) {
  return meanOf<double>(pair, [](const LimbGuess& limb) { return limb.length; });
}

// 1 where the ends are the body's lowest joints along `up`, 0 where much of it is lower.
double endsLowest(const BodyView& view, const LimbPair& pair, const Vec3& up) {
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  for (int i = 0; i < view.count(); ++i) {
    if (view.movesMesh(i)) {
      low = std::min(low, glm::dot(view.at(i), up));
      high = std::max(high, glm::dot(view.at(i), up));
    }
  }
  const double share = high > low ? (glm::dot(meanEnd(pair), up) - low) / (high - low) : 1.0;
  return std::clamp(1.0 - 4.0 * std::max(0.0, share - 0.1), 0.0, 1.0);
}

// A joint in the middle of the body that is beyond the arms as seen from the legs: head or neck.
bool headBeyond(const BodyView& view, const MirrorPlane& plane, const Vec3& from, const Vec3& up,
                double trunk) {
  for (int i = 0; i < view.count(); ++i) {
    const Vec3 offset = view.at(i) - from;
    if (view.movesMesh(i) && std::abs(plane.lateral(view.at(i))) < 0.02 * view.size &&
        glm::dot(offset, up) > -0.05 * trunk && glm::length(offset) < 1.5 * trunk) {
      return true;
    }
  }
  return false;
}

double relation(const BodyView& view, const MirrorPlane& plane, const LimbPair& arms, const LimbPair& legs) {
  const Vec3 legBase = meanBase(view, legs);
  const Vec3 trunk = meanBase(view, arms) - legBase;
  const double trunkLength = glm::length(trunk);
  if (trunkLength < 0.02 * view.size) {
    return -1.0;
  }
  const Vec3 up = trunk / trunkLength;
  const Vec3 legDirection = meanEnd(legs) - legBase;
  const double ratio = meanLength(arms) / std::max(1e-12, meanLength(legs));
  // Of a body that lies along its trunk the feet are still what stands on the ground.
  constexpr double flat = 0.5;
  const Vec3 above = std::abs(up.y) < flat ? Vec3(0, 1, 0) : up;
  double score = 0.6 * cosineBetween(-legDirection, trunk) + 0.5 * up.y + 0.5 * endsLowest(view, legs, above);
  score -= std::abs(up.y) < flat ? 0.5 * endsLowest(view, arms, above) : 0.0;
  score -= std::clamp(std::abs(std::log(std::max(ratio, 1e-6))) - std::log(2.0), 0.0, 1.0);
  return score + (headBeyond(view, plane, meanBase(view, arms), up, trunkLength) ? 0.3 : 0.0);
}

constexpr double missingPair = -1.5;

// A pair of arms and one of legs, either of which may be missing.
struct Combination {
  const LimbPair* arms = nullptr;
  const LimbPair* legs = nullptr;
  double score = 0.0;
  double relation = 0.0;
};

// Whether of two pairs that are named alike the second is the first of the body: called without a number
// where the other has one, else farther from the legs.
bool isBefore(const BodyView& view, const Combination& one, const Combination& than) {
  const auto hasNumber = [&](const LimbPair& pair) {
    const std::vector<const LimbGuess*> limbs = limbsOf(pair);
    return std::ranges::all_of(limbs, [&](const LimbGuess* limb) {
      return view.name(limb->base).key.find('#') != std::string::npos;
    });
  };
  if (hasNumber(*one.arms) != hasNumber(*than.arms)) {
    return !hasNumber(*one.arms);
  }
  const auto fromLegs = [&](const Combination& of) {
    return of.legs == nullptr ? 0.0 : glm::distance(meanBase(view, *of.arms), meanBase(view, *of.legs));
  };
  return fromLegs(one) > fromLegs(than);
}

// Arms beside those of the likeliest combination: named as well, with hardly a lower score, and not in the
// same place, as the sleeves of a coat are. Null where there are none.
const Combination* otherArms(const BodyView& view, const std::vector<Combination>& all,
                             const Combination& best) {
  constexpr double nearly = 1.3;
  constexpr double asWell = 0.3; // of the names' fit
  constexpr double apart = 0.1;  // of an arm
  const auto fit = [](const LimbPair& pair) {
    double sum = 0.0;
    for (const LimbGuess* limb : limbsOf(pair)) {
      sum += limb->nameFit;
    }
    return sum;
  };
  const Combination* found = nullptr;
  for (const Combination& one : all) {
    if (one.arms != nullptr && one.legs == best.legs && limbsOf(*one.arms).size() == 2 &&
        isNamed(*one.arms) && one.score > best.score - nearly && fit(*one.arms) > fit(*best.arms) - asWell &&
        !overlap(view, *one.arms, *best.arms) &&
        glm::distance(meanBase(view, *one.arms), meanBase(view, *best.arms)) >
            apart * meanLength(*best.arms) &&
        (found == nullptr || one.score > found->score)) {
      found = &one;
    }
  }
  return found;
}

// The best score of those that have other arms, or other legs, than a pair: none of their joints. Nothing
// where there are no others.
std::optional<double> bestOfOthers(const BodyView& view, const std::vector<Combination>& all,
                                   const LimbPair& pair, const LimbPair* Combination::*part) {
  std::optional<double> best;
  for (const Combination& one : all) {
    if ((!best || one.score > *best) && one.*part != nullptr && !overlap(view, *(one.*part), pair)) {
      best = one.score;
    }
  }
  return best;
}

// 1 where names call the limb on the positive side left, -1 where they call it right; 0 where they tell
// nothing.
double namedOrientation(const BodyView& view, const LimbPair& pair) {
  double votes = 0.0;
  for (const LimbGuess* limb : limbsOf(pair)) {
    const Side side = namedSide(view, *limb);
    votes += side == Side::none ? 0.0 : (side == Side::left) == (limb->lateral > 0.0) ? 1.0 : -1.0;
  }
  return votes > 0.0 ? 1.0 : votes < 0.0 ? -1.0 : 0.0;
}

// Arms of a trunk that is turned far stand on the other sides of the plane than the legs: names tell.
void turnArmsToLegs(const BodyView& view, BipedReading& reading) {
  if (!reading.arms || !reading.legs ||
      namedOrientation(view, *reading.arms) * namedOrientation(view, *reading.legs) >= 0.0) {
    return;
  }
  LimbPair& arms = *reading.arms;
  std::swap(arms.negative, arms.positive);
  for (std::optional<LimbGuess>* arm : {&arms.negative, &arms.positive}) {
    if (*arm) {
      (*arm)->lateral = -(*arm)->lateral;
    }
  }
}

} // namespace

Vec3 meanBase(const BodyView& view, const LimbPair& pair) {
  return meanOf<Vec3>(pair, [&](const LimbGuess& limb) { return view.at(limb.base); });
}

bool isNamed(const LimbPair& pair) {
  constexpr double leastOfJoint = 0.27;
  return std::ranges::any_of(limbsOf(pair), [](const LimbGuess* limb) {
    const int joints = 1 + (limb->middle >= 0 ? 1 : 0) + (limb->end >= 0 ? 1 : 0);
    return limb->nameFit >= leastOfJoint * joints;
  });
}

Vec3 meanEnd(const LimbPair& pair) {
  return meanOf<Vec3>(pair, [](const LimbGuess& limb) { return limb.endPosition; });
}

int meetingJoint(const BodyView& view, const LimbPair& pair) {
  if (pair.negative && pair.positive) {
    return view.commonAncestor(pair.negative->base, pair.positive->base);
  }
  const LimbGuess& limb = pair.negative ? *pair.negative : *pair.positive;
  return view.parentOf(limb.base);
}

// Whether arms alone make a body: one that no name calls so is any row of joints.
bool isBody(const LimbPair& arms) {
  const std::vector<const LimbGuess*> limbs = limbsOf(arms);
  return limbs.size() > 1 || (limbs.size() == 1 && limbs.front()->nameFit >= leastNameFitAlone);
}

BipedReading readBiped(const BodyView& view, const MirrorPlane& plane) {
  const std::vector<LimbPair> arms = likelyPairs(view, plane, Region::arm);
  const std::vector<LimbPair> legs = likelyPairs(view, plane, Region::leg);
  std::vector<Combination> all;
  all.reserve(legs.size());
  for (const LimbPair& leg : legs) {
    all.push_back({nullptr, &leg, leg.score + missingPair, 0.0});
  }
  for (const LimbPair& arm : arms) {
    if (isBody(arm)) {
      // What stands on the ground alone is no arm.
      const double standing = endsLowest(view, arm, Vec3(0, 1, 0));
      all.push_back({&arm, nullptr, arm.score + missingPair - 2.0 * standing, 0.0});
    }
    for (const LimbPair& leg : legs) {
      if (!overlap(view, arm, leg)) {
        const double related = relation(view, plane, arm, leg);
        all.push_back({&arm, &leg, arm.score + leg.score + related, related});
      }
    }
  }
  const auto likeliest = std::ranges::max_element(all, {}, &Combination::score);
  const Combination* most = likeliest == all.end() ? nullptr : &*likeliest;
  if (most == nullptr || most->score <= 2.0 * missingPair) {
    BipedReading nothing;
    nothing.score = 2.0 * missingPair;
    return nothing;
  }
  BipedReading best;
  const Combination* const others =
      most->arms != nullptr && isNamed(*most->arms) && limbsOf(*most->arms).size() == 2
          ? otherArms(view, all, *most)
          : nullptr;
  best.hasOtherArms = others != nullptr;
  most = others != nullptr && isBefore(view, *others, *most) ? others : most;
  best.score = most->score;
  best.relation = most->relation;
  if (most->arms != nullptr) {
    best.arms = *most->arms;
    const auto next = bestOfOthers(view, all, *most->arms, &Combination::arms);
    best.armsAhead = next ? most->score - *next : best.armsAhead;
  }
  if (most->legs != nullptr) {
    best.legs = *most->legs;
    const auto next = bestOfOthers(view, all, *most->legs, &Combination::legs);
    best.legsAhead = next ? most->score - *next : best.legsAhead;
  }
  turnArmsToLegs(view, best);
  return best;
}

} // namespace stretch::rig::body

#include "rig/body/reading/facing.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace stretch::rig::body {

namespace {

// Each direction is measured on unit vectors, so that a vote lies in -1..1; positive means along `forward`.
struct Frame {
  Vec3 up{0.0, 1.0, 0.0};
  Vec3 forward{0.0, 0.0, 1.0}; // the way the character faces if its left is on the positive side
};

Frame frameOf(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading) {
  Frame frame;
  Vec3 up(0, 1, 0);
  if (reading.legs) {
    up = (reading.arms ? meanBase(view, *reading.arms) : meanBase(view, *reading.legs)) -
         meanEnd(*reading.legs);
  }
  up -= plane.normal * glm::dot(up, plane.normal);
  if (glm::length(up) > 1e-6 * view.size) {
    frame.up = glm::normalize(up);
  }
  // left = up x forward, so forward = left x up
  const Vec3 forward = glm::cross(plane.normal, frame.up);
  frame.forward = glm::length(forward) > 1e-6 ? glm::normalize(forward) : Vec3(0, 0, 1);
  return frame;
}

double horizontalShare(const Vec3& offset, const Frame& frame) {
  const double length = glm::length(offset);
  return length > 0.0 ? glm::dot(offset, frame.forward) / length : 0.0;
}

// Where the shin ends: a foot that hangs elsewhere may have its joint at its toes.
Vec3 ankleOf(const BodyView& view, const LimbGuess& leg, const Frame& frame) {
  constexpr double lowest = 0.15; // of the shin
  const Vec3 joint = view.at(leg.end >= 0 ? leg.end : leg.middle >= 0 ? leg.middle : leg.base);
  if (!leg.endDetached || leg.middle < 0 || view.points[static_cast<std::size_t>(leg.middle)].empty()) {
    return joint;
  }
  const std::vector<Vec3>& shin = view.points[static_cast<std::size_t>(leg.middle)];
  const auto height = [&](const Vec3& point) { return glm::dot(point, frame.up); };
  const double bottom = height(*std::ranges::min_element(shin, {}, height));
  const double top = height(*std::ranges::max_element(shin, {}, height));
  Vec3 sum(0.0);
  double count = 0.0;
  for (const Vec3& point : shin) {
    const bool isLow = height(point) <= bottom + lowest * (top - bottom);
    sum += isLow ? point : Vec3(0.0);
    count += isLow ? 1.0 : 0.0;
  }
  return count > 0.0 ? sum / count : joint;
}

// Joints and tips below the ankle: the toes, on average, since a spur may point back.
double toeVote(const BodyView& view, const LimbGuess& leg, const Frame& frame) {
  if (leg.end < 0) {
    return 0.0;
  }
  Vec3 sum(0.0);
  for (const int joint : view.childrenOf(leg.end)) {
    const NameEvidence& name = view.name(joint);
    sum += name.control || name.accessory ? Vec3(0.0) : view.at(joint) - view.at(leg.end);
  }
  for (const Vec3& tip : view.tips[static_cast<std::size_t>(leg.end)]) {
    sum += tip - view.at(leg.end);
  }
  return glm::length(sum) > 0.01 * view.size ? std::clamp(2.0 * horizontalShare(sum, frame), -1.0, 1.0) : 0.0;
}

// How much farther the foot's vertices reach forward of the ankle than back of it.
double footMeshVote(const BodyView& view, const LimbGuess& leg, const Frame& frame) {
  const int last = leg.end >= 0 ? leg.end : leg.middle >= 0 ? leg.middle : leg.base;
  const Vec3 ankle = ankleOf(view, leg, frame);
  double front = 0.0;
  double back = 0.0;
  double sum = 0.0;
  double count = 0.0;
  for (int joint = 0; joint < view.count(); ++joint) {
    if (joint != last && view.parentOf(joint) != last) {
      continue;
    }
    for (const Vec3& point : view.points[static_cast<std::size_t>(joint)]) {
      const double along = glm::dot(point - ankle, frame.forward);
      const bool low = glm::dot(point - leg.endPosition, frame.up) < 0.15 * leg.length;
      sum += low ? along : 0.0;
      count += low ? 1.0 : 0.0;
      front = low ? std::max(front, along) : front;
      back = low ? std::max(back, -along) : back;
    }
  }
  const double extent = front + back;
  // Without a joint of its own a foot is measured from the knee: where the shin leads aside, that tells
  // nothing.
  constexpr double shinStraight = 0.12;
  const bool leads = leg.end < 0 && count > 0.0 && std::abs(sum / count) > shinStraight * leg.length;
  if (leads || extent <= 0.05 * leg.length) {
    return 0.0;
  }
  // A block of a foot is the same in front and behind, give or take.
  const double lead = (front - back) / extent;
  return std::copysign(std::clamp((std::abs(lead) - 0.15) / 0.25, 0.0, 1.0), lead);
}

// A bind pose bends knees forward and elbows back, if at all.
double bendVote(const BodyView& view, const LimbGuess& limb, const Frame& frame) {
  if (limb.middle < 0) {
    return 0.0;
  }
  const Vec3 line = limb.endPosition - view.at(limb.base);
  const Vec3 there = view.at(limb.middle) - view.at(limb.base);
  const double lengthSquared = glm::dot(line, line);
  if (lengthSquared <= 0.0) {
    return 0.0;
  }
  const Vec3 off = there - line * (glm::dot(there, line) / lengthSquared);
  return std::clamp(10.0 * glm::dot(off, frame.forward) / limb.length, -1.0, 1.0);
}

// Whether a joint stands where the one that carries it does: which way it lies from there is noise.
bool isOnCarrier(const BodyView& view, int joint) {
  constexpr double near = 0.002; // of the body
  const int carrier = view.parentOf(joint);
  return carrier >= 0 && glm::distance(view.at(joint), view.at(carrier)) < near * view.size;
}

// Eyes and jaws stand before the joint that carries them, or the one that it stands on.
double faceVote(const BodyView& view, const Frame& frame) {
  double sum = 0.0;
  int count = 0;
  for (int joint = 0; joint < view.count(); ++joint) {
    int carrier = view.parentOf(joint);
    while (carrier >= 0 && view.name(carrier).face && isOnCarrier(view, carrier)) {
      carrier = view.parentOf(carrier);
    }
    if (view.name(joint).face && carrier >= 0 && !view.name(carrier).face && !isOnCarrier(view, joint)) {
      sum += std::clamp(2.0 * horizontalShare(view.at(joint) - view.at(carrier), frame), -1.0, 1.0);
      ++count;
    }
  }
  return count > 0 ? sum / count : 0.0;
}

// Each hint lies in -1..1; positive: the character's left is on the positive side.
struct Hints {
  double toes = 0.0;
  double feet = 0.0;
  double face = 0.0;
  double bends = 0.0; // knees and elbows: many creatures bend the other way

  [[nodiscard]] double sum() const { return 2.0 * toes + 2.0 * feet + face + bends; }
  // How many kinds clearly speak for a side (+1 or -1).
  [[nodiscard]] int speakingFor(double side) const {
    constexpr double clear = 0.5;
    return static_cast<int>(side * toes >= clear) + static_cast<int>(side * feet >= clear) +
           static_cast<int>(side * face >= clear);
  }
};

std::vector<const LimbGuess*> limbsOf(const std::optional<LimbPair>& pair) {
  std::vector<const LimbGuess*> limbs;
  for (const std::optional<LimbGuess>* limb : {&pair->negative, &pair->positive}) {
    if (pair && *limb) {
      limbs.push_back(&**limb);
    }
  }
  return limbs;
}

Hints hintsOf(const BodyView& view, const BipedReading& reading, const Frame& frame) {
  Hints hints;
  hints.face = faceVote(view, frame);
  if (reading.legs) {
    const std::vector<const LimbGuess*> legs = limbsOf(reading.legs);
    const auto share = 1.0 / static_cast<double>(legs.size());
    for (const LimbGuess* leg : legs) {
      hints.toes += share * toeVote(view, *leg, frame);
      hints.feet += share * footMeshVote(view, *leg, frame);
      hints.bends += 0.4 * bendVote(view, *leg, frame);
    }
  }
  if (reading.arms) {
    for (const LimbGuess* arm : limbsOf(reading.arms)) {
      hints.bends -= 0.3 * bendVote(view, *arm, frame);
    }
  }
  return hints;
}

struct NameVotes {
  double sum = 0.0; // one for each limb; positive: the left is on the positive side
  int limbs = 0;

  [[nodiscard]] double side() const { return sum > 0.0 ? 1.0 : -1.0; }
  [[nodiscard]] bool clear() const { return limbs > 0 && std::abs(sum) >= 0.5 * limbs; }
};

NameVotes nameVotes(const BodyView& view, const BipedReading& reading) {
  NameVotes votes;
  for (const std::optional<LimbPair>* pair : {&reading.legs, &reading.arms}) {
    if (!*pair) {
      continue;
    }
    for (const LimbGuess* limb : limbsOf(*pair)) {
      const Side side = namedSide(view, *limb);
      if (side != Side::none) {
        votes.sum += (side == Side::left) == (limb->lateral > 0.0) ? 1.0 : -1.0;
        ++votes.limbs;
      }
    }
  }
  return votes;
}

Sides fromNames(const NameVotes& names, const Hints& hints) {
  Sides sides;
  sides.leftIsPositive = names.sum > 0.0;
  sides.contradicted = hints.speakingFor(-names.side()) > 0;
  sides.certainty = sides.contradicted ? 0.5 : 1.0;
  sides.reason = "sides: from the joint names";
  sides.areNamesAlone = hints.speakingFor(names.side()) == 0 && !sides.contradicted;
  if (hints.speakingFor(names.side()) > 0 && !sides.contradicted) {
    sides.reason = "sides: names and feet agree";
  } else if (sides.contradicted) {
    sides.warnings.emplace_back(
        "left and right follow the joint names, but the feet or the face point the other "
        "way: are the sides right?");
  }
  return sides;
}

Sides fromHints(const Hints& hints, const Frame& frame) {
  Sides sides;
  if (std::abs(hints.sum()) < 0.5) {
    constexpr double visible = 0.1;
    const bool bends = std::abs(hints.bends) >= visible;
    sides.leftIsPositive = bends ? hints.bends > 0.0 : frame.forward.z >= 0.0;
    sides.certainty = 0.3;
    sides.reason = bends ? "sides: from the way that knees and elbows bend a little"
                         : "sides: taken to face +Z, as glTF characters do";
    if (!bends) {
      sides.warnings.emplace_back("nothing tells which way the character faces: are left and right right?");
    }
    return sides;
  }
  constexpr double clear = 2.0;
  sides.leftIsPositive = hints.sum() > 0.0;
  sides.certainty = std::abs(hints.sum()) >= clear ? 0.8 : 0.5;
  sides.reason = "sides: from the way the feet point";
  return sides;
}

// Whether a body stands alike on both sides: of one in the middle of an action feet and face point anywhere.
bool standsAlike(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading) {
  constexpr double near = 0.1; // of the body
  const auto isAlike = [&](const std::optional<LimbPair>& pair) {
    return !pair || !pair->negative || !pair->positive ||
           glm::distance(plane.mirrored(pair->negative->endPosition), pair->positive->endPosition) <
               near * view.size;
  };
  return isAlike(reading.legs) && isAlike(reading.arms);
}

} // namespace

Sides findSides(const BodyView& view, const MirrorPlane& plane, const BipedReading& reading) {
  const Frame frame = frameOf(view, plane, reading);
  const Hints hints = hintsOf(view, reading, frame);
  const NameVotes names = nameVotes(view, reading);
  const bool overruled = hints.speakingFor(-names.side()) >= 2 && hints.speakingFor(names.side()) == 0 &&
                         standsAlike(view, plane, reading);
  Sides sides = names.clear() && !overruled ? fromNames(names, hints) : fromHints(hints, frame);
  if (names.clear() && overruled) {
    sides.contradicted = true;
    sides.warnings.emplace_back(
        "joint names call the character's right side left: the sides follow the way its "
        "feet point; are they right?");
  }
  if (names.limbs > 1 && std::abs(names.sum) < names.limbs) {
    sides.contradicted = true;
    sides.warnings.emplace_back(
        names.clear()
            ? "joint names disagree about left and right: the sides follow most of them; are they right?"
            : "joint names disagree about left and right: the sides follow the geometry; are they right?");
  }
  return sides;
}

} // namespace stretch::rig::body

#include "rig/body/facing.h"

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

Frame frameOf(const BodyView& view, const MirrorPlane& plane, const BodyPlan& plan) {
  Frame frame;
  Vec3 up(0, 1, 0);
  if (plan.legs) {
    up = (plan.arms ? meanBase(view, *plan.arms) : meanBase(view, *plan.legs)) - meanEnd(*plan.legs);
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

// Joints and tips below the ankle: the toes.
double toeVote(const BodyView& view, const LimbGuess& leg, const Frame& frame) {
  if (leg.end < 0) {
    return 0.0;
  }
  Vec3 farthest(0.0);
  const auto consider = [&](const Vec3& point) {
    const Vec3 offset = point - view.at(leg.end);
    if (std::abs(glm::dot(offset, frame.forward)) > std::abs(glm::dot(farthest, frame.forward))) {
      farthest = offset;
    }
  };
  for (int joint = 0; joint < view.count(); ++joint) {
    const bool isToe = joint != leg.end && view.parentOf(joint) == leg.end && !view.name(joint).control;
    if (isToe && !view.name(joint).accessory) {
      consider(view.at(joint));
    }
  }
  for (const Vec3& tip : view.tips[static_cast<std::size_t>(leg.end)]) {
    consider(tip);
  }
  return glm::length(farthest) > 0.01 * view.size
             ? std::clamp(2.0 * horizontalShare(farthest, frame), -1.0, 1.0)
             : 0.0;
}

// How much farther the foot's vertices reach forward of the ankle than back of it.
double footMeshVote(const BodyView& view, const LimbGuess& leg, const Frame& frame) {
  const int last = leg.end >= 0 ? leg.end : leg.middle >= 0 ? leg.middle : leg.base;
  const Vec3 ankle = leg.endPosition;
  double front = 0.0;
  double back = 0.0;
  for (int joint = 0; joint < view.count(); ++joint) {
    if (joint != last && view.parentOf(joint) != last) {
      continue;
    }
    for (const Vec3& point : view.points[static_cast<std::size_t>(joint)]) {
      const double along = glm::dot(point - view.at(last), frame.forward);
      const bool low = glm::dot(point - ankle, frame.up) < 0.15 * leg.length;
      front = low ? std::max(front, along) : front;
      back = low ? std::max(back, -along) : back;
    }
  }
  const double extent = front + back;
  if (extent <= 0.05 * leg.length) {
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

struct Votes {
  double geometry = 0.0; // about -5..5; positive: the character's left is on the positive side
  double names = 0.0;    // one for each limb
  int namedLimbs = 0;
};

void addNames(Votes& votes, const BodyView& view, const LimbGuess& limb) {
  const Side side = namedSide(view, limb);
  if (side != Side::none) {
    votes.names += (side == Side::left) == (limb.lateral > 0.0) ? 1.0 : -1.0;
    ++votes.namedLimbs;
  }
}

Votes countVotes(const BodyView& view, const BodyPlan& plan, const Frame& frame) {
  Votes votes;
  for (const std::optional<LimbPair>* pair : {&plan.legs, &plan.arms}) {
    if (!*pair) {
      continue;
    }
    const bool legs = pair == &plan.legs;
    for (const std::optional<LimbGuess>* limb : {&(*pair)->negative, &(*pair)->positive}) {
      if (!*limb) {
        continue;
      }
      addNames(votes, view, **limb);
      votes.geometry += legs ? toeVote(view, **limb, frame) + footMeshVote(view, **limb, frame) +
                                   0.4 * bendVote(view, **limb, frame)
                             : -0.3 * bendVote(view, **limb, frame);
    }
  }
  return votes;
}

} // namespace

Sides findSides(const BodyView& view, const MirrorPlane& plane, const BodyPlan& plan) {
  const Frame frame = frameOf(view, plane, plan);
  const Votes votes = countVotes(view, plan, frame);
  constexpr double clearGeometry = 2.0;
  Sides sides;
  const bool namesClear = votes.namedLimbs > 0 && std::abs(votes.names) >= 0.5 * votes.namedLimbs;
  const bool agree = votes.geometry * votes.names >= 0.0;
  if (namesClear && (agree || std::abs(votes.geometry) < clearGeometry)) {
    sides.leftIsPositive = votes.names > 0.0;
    sides.certainty = agree ? 1.0 : 0.7;
    sides.reason = agree ? "sides: names and feet agree" : "sides: names; the feet say little";
  } else if (std::abs(votes.geometry) >= 0.5) {
    sides.leftIsPositive = votes.geometry > 0.0;
    sides.certainty = std::abs(votes.geometry) >= clearGeometry ? 0.8 : 0.5;
    sides.reason = "sides: from the way the feet point";
  } else {
    sides.leftIsPositive = frame.forward.z >= 0.0;
    sides.certainty = 0.3;
    sides.reason = "sides: taken to face +Z, as glTF characters do";
  }
  if (namesClear && !agree && std::abs(votes.geometry) >= clearGeometry) {
    sides.warnings.emplace_back(
        "joint names call the character's right side left: the sides follow the way its feet point");
  }
  if (votes.namedLimbs > 1 && std::abs(votes.names) < votes.namedLimbs) {
    sides.warnings.emplace_back("joint names disagree about left and right: the sides follow the geometry");
  }
  return sides;
}

} // namespace stretch::rig::body

#include "skinning/locate/leg_joints.h"

#include <algorithm>
#include <limits>

namespace stretch::skinning {

namespace {

// Of the height, as measured on rigged characters (docs/from_a_mesh.md, How locators are found).
constexpr double ankleHeight = 0.055;
constexpr double toesHeight = 0.015;
constexpr double footBehindTip = 0.65; // of the way from the ankle to the tip the toes begin

Vec3 legMiddle(const std::vector<LegSection>& leg, double height) {
  const auto above = std::ranges::lower_bound(leg, height, {}, &LegSection::height);
  const LegSection& near = above == leg.end() ? leg.back() : *above;
  return {near.middle.x, height, near.middle.z};
}

struct Toes {
  Placed joint;
  bool show = false;
};

Toes toesOf(const std::vector<LegSection>& leg, const Vec3& ankle, double facing) {
  constexpr double shortest = 0.06;
  double tip = ankle.z + facing * shortest;
  double across = ankle.x;
  bool shows = false;
  for (const LegSection& section : leg) {
    const double reach = section.middle.z + (facing > 0.0 ? section.front : -section.back);
    if (section.height < ankleHeight && facing * (reach - tip) > 0.0) {
      tip = reach;
      across = section.middle.x;
      shows = true;
    }
  }
  return {{{across, toesHeight, ankle.z + footBehindTip * (tip - ankle.z)}, shows ? 0.8 : 0.5}, shows};
}

bool isBox(const std::vector<LegSection>& leg) {
  constexpr double even = 1.05;
  constexpr double from = 0.8; // of its height: below may be a foot or a boot
  constexpr double to = 0.98;
  double largest = 0.0;
  double smallest = std::numeric_limits<double>::max();
  for (const LegSection& section : leg) {
    const double part = section.height / leg.back().height;
    if (part > from && part < to) {
      largest = std::max(largest, section.area);
      smallest = std::min(smallest, section.area);
    }
  }
  return largest > 0.0 && largest < even * smallest;
}

double ankleOf(double hipHeight) {
  constexpr double mostOfLeg = 0.3;
  return std::min(ankleHeight, mostOfLeg * hipHeight);
}

} // namespace

double facingOf(const LegLines& legs) {
  double facing = 0.0;
  for (const std::vector<LegSection>* leg : {&legs.left, &legs.right}) {
    if (leg->empty()) {
      continue;
    }
    const double shin = legMiddle(*leg, 2.0 * ankleHeight).z;
    double front = 0.0;
    double back = 0.0;
    for (const LegSection& section : *leg) {
      if (section.height < ankleHeight) {
        front = std::max(front, section.middle.z + section.front - shin);
        back = std::max(back, shin - section.middle.z + section.back);
      }
    }
    facing += front - back;
  }
  return facing;
}

bool areBoxes(const LegLines& legs) {
  return legs.found() && isBox(legs.left) && isBox(legs.right);
}

LegJoints legJoints(const std::vector<LegSection>& leg, double hipHeight, double facing) {
  constexpr double belowTop = 0.93; // where the thigh is still a leg's section
  constexpr double shinOverAnkle = 0.035;
  const double ankle = ankleOf(hipHeight);
  LegJoints joints;
  joints.hip = {legMiddle(leg, belowTop * leg.back().height), 0.8};
  joints.hip.place.y = hipHeight;
  joints.ankle = {legMiddle(leg, ankle + shinOverAnkle), 0.8};
  joints.ankle.place.y = ankle;
  const Toes toes = toesOf(leg, joints.ankle.place, facing);
  joints.toes = toes.joint;
  const double shinEnd = toes.show ? ankle : 0.0; // without a foot the shin goes on to the ground
  joints.knee = {legMiddle(leg, 0.5 * (shinEnd + hipHeight)), 0.7};
  return joints;
}

LegJoints guessedLeg(double hipHeight, double side, double facing) {
  constexpr double across = 0.05;
  constexpr double guess = 0.2;
  const double ankle = ankleOf(hipHeight);
  LegJoints joints;
  joints.hip = {{side * across, hipHeight, 0.0}, guess};
  joints.knee = {{side * across, 0.5 * (ankle + hipHeight), 0.0}, guess};
  joints.ankle = {{side * across, ankle, 0.0}, guess};
  joints.toes = toesOf({}, joints.ankle.place, facing).joint;
  joints.toes.confidence = guess;
  return joints;
}

} // namespace stretch::skinning

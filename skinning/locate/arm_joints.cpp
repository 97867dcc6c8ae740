#include "skinning/locate/arm_joints.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stretch::skinning {

namespace {

// Parts of the way from the tip of the hand to the shoulder, as measured on rigged characters
// (docs/from_a_mesh.md, How locators are found).
constexpr double handOfArm = 0.30;
constexpr double upperArmOfArm = 0.55; // of the way from the wrist to the shoulder
constexpr double handless = 0.15;      // where no wrist shows
constexpr double upperPart = 0.5;      // where the upper arm begins, of the way to the middle of the body

constexpr double most = std::numeric_limits<double>::max();

// The middle of the arm there, between those of the sections.
Vec3 middleAt(const std::vector<ArmSection>& sections, double way) {
  const auto after = std::ranges::lower_bound(sections, way, {}, &ArmSection::way);
  if (after == sections.begin() || after == sections.end()) {
    return after == sections.end() ? sections.back().middle : after->middle;
  }
  const ArmSection& before = *(after - 1);
  return glm::mix(before.middle, after->middle, (way - before.way) / (after->way - before.way));
}

double upperArmRadius(const ArmLine& arm) {
  constexpr double trunkPart = 0.8;
  double radius = most;
  for (const ArmSection& section : arm.sections) {
    if (section.way > upperPart * arm.way && section.way < trunkPart * arm.way) {
      radius = std::min(radius, section.radius);
    }
  }
  return radius;
}

double meanRadius(const std::vector<ArmSection>& sections, double from, double to) {
  double sum = 0.0;
  double count = 0.0;
  for (const ArmSection& section : sections) {
    if (section.way >= from && section.way <= to) {
      sum += section.radius;
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

// Where the arm becomes the trunk: its section grows; where it is a piece of its own, it ends.
double shoulderWay(const ArmLine& arm) {
  constexpr double grown = 1.5;
  if (arm.ownPiece > 0.0) {
    return arm.ownPiece;
  }
  const double usual = upperArmRadius(arm);
  auto section = std::ranges::max_element(arm.sections, {}, [&](const ArmSection& one) {
    return one.way > upperPart * arm.way ? one.radius : 0.0;
  });
  while (section != arm.sections.begin() && section->radius > grown * usual) {
    --section;
  }
  return section->way;
}

// Straight on along the upper arm: sections that reach into the trunk lean to it.
Vec3 shoulderPlace(const ArmLine& arm, double way) {
  if (arm.ownPiece > 0.0) {
    constexpr double fromEnd = 0.7; // of the radius
    const Vec3 to = middleAt(arm.sections, 0.8 * way);
    const Vec3 along = to - middleAt(arm.sections, 0.5 * way);
    const double radius = meanRadius(arm.sections, 0.45 * way, 0.55 * way);
    const double rest = std::max(0.0, 0.2 * way - fromEnd * radius);
    return glm::length(along) > 0.0 ? to + glm::normalize(along) * rest : to;
  }
  const Vec3 from = middleAt(arm.sections, 0.7 * way);
  const Vec3 to = middleAt(arm.sections, 0.9 * way);
  return to + 0.5 * (to - from);
}

// Sections from the tip of the hand to the shoulder: straight across the arm, or by the way inside the body
// where it bends too much for that.
std::vector<ArmSection> sectionsOf(const StandingBody& body, const ArmLine& arm, double shoulder) {
  std::vector<ArmSection> sections = straightSections(body, arm, shoulder);
  if (sections.empty()) {
    sections = arm.sections;
    std::erase_if(sections, [&](const ArmSection& section) { return section.way > shoulder; });
  }
  return sections;
}

struct Wrist {
  double part = 0.0; // of the way from the tip of the hand to the shoulder
  bool shows = false;
};

// Whether sections differ at all, as those of a box do not.
bool isShaped(const std::vector<ArmSection>& sections, double length) {
  constexpr double even = 1.14;
  constexpr double window = 0.05; // no cube more or less decides
  double widest = 0.0;
  double narrowest = most;
  for (const ArmSection& section : sections) {
    const double part = section.way / length;
    if (part > 0.06 && part < 0.7) {
      const double radius =
          meanRadius(sections, section.way - window * length, section.way + window * length);
      widest = std::max(widest, radius);
      narrowest = std::min(narrowest, radius);
    }
  }
  return widest > even * narrowest;
}

// The narrowest place near where a hand usually ends.
Wrist wristOf(const std::vector<ArmSection>& sections, double usualRadius) {
  constexpr double nearness = 2.5;
  const double length = sections.back().way;
  Wrist wrist{handless, false};
  double lowest = most;
  for (const ArmSection& section : sections) {
    const double part = section.way / length;
    const double cost = section.radius / usualRadius + nearness * std::abs(part - handOfArm);
    if (part > 0.18 && part < 0.45 && cost < lowest) {
      lowest = cost;
      wrist = {part, true};
    }
  }
  return isShaped(sections, length) ? wrist : Wrist{handless, false};
}

// Where a thin piece meets a thick one, as on a robot: in the end of the thick one. None on an arm whose
// thickness changes slowly.
std::optional<double> jumpPart(const std::vector<ArmSection>& sections) {
  constexpr double least = 2.0;
  constexpr double lowest = 0.45;
  constexpr double highest = 0.85;
  constexpr double window = 0.1;
  constexpr double inThickOne = 0.5; // of its radius
  const double length = sections.back().way;
  const double beside = 0.1 * length / static_cast<double>(sections.size());
  std::optional<double> part;
  double largest = least;
  for (const ArmSection& section : sections) {
    const double outer = meanRadius(sections, section.way - window * length, section.way - beside);
    const double inner = meanRadius(sections, section.way + beside, section.way + window * length);
    const double thick = std::max(outer, inner);
    const double thin = std::min(outer, inner);
    const bool isBetween = section.way > lowest * length && section.way < highest * length;
    if (isBetween && thin > 0.0 && thick > largest * thin) {
      largest = thick / thin;
      part = (section.way + (outer > inner ? -inThickOne : inThickOne) * thick) / length;
    }
  }
  return part;
}

// A box has no hand: its elbow is in the middle.
double elbowPart(const std::vector<ArmSection>& sections, const Wrist& wrist) {
  const double usual = wrist.shows ? wrist.part + (1.0 - upperArmOfArm) * (1.0 - wrist.part) : 0.5;
  return jumpPart(sections).value_or(usual);
}

// A limb is slender and about as thick all along; a corner of the trunk grows from its tip.
bool isLimb(const ArmLine& arm, double shoulder) {
  constexpr double shortest = 0.12;
  constexpr double grows = 1.6;
  constexpr double slender = 3.0; // times as long as it is thick, half
  const double outer = meanRadius(arm.sections, 0.3 * shoulder, 0.45 * shoulder);
  const double inner = meanRadius(arm.sections, 0.6 * shoulder, 0.75 * shoulder);
  return shoulder > shortest && inner < grows * outer && shoulder > slender * outer;
}

std::optional<ArmJoints> armJoints(const StandingBody& body, const ArmLine& arm) {
  constexpr std::size_t fewest = 8; // sections
  if (arm.sections.size() < fewest) {
    return std::nullopt;
  }
  const double shoulder = shoulderWay(arm);
  if (!isLimb(arm, shoulder)) {
    return std::nullopt;
  }
  const std::vector<ArmSection> sections = sectionsOf(body, arm, shoulder);
  const double length = sections.back().way;
  const Wrist wrist = wristOf(sections, upperArmRadius(arm));
  const double elbow = elbowPart(sections, wrist);
  ArmJoints joints;
  joints.shoulder = {shoulderPlace(arm, shoulder), 0.8};
  joints.elbow = {middleAt(sections, elbow * length), wrist.shows ? 0.7 : 0.5};
  joints.wrist = {middleAt(sections, wrist.part * length), wrist.shows ? 0.7 : 0.4};
  return joints;
}

} // namespace

// What one hand holds makes its arm longer: it is cut to the other one's length.
ArmPair armPair(const StandingBody& body, const LegLines& legs) {
  constexpr double holding = 1.1;
  const std::vector<double> fromMiddle = waysFromMiddle(body, legs);
  ArmLine right = armLine(body, legs, fromMiddle, -1.0, most);
  ArmLine left = armLine(body, legs, fromMiddle, 1.0, most);
  if (left.way > 0.0 && right.way > holding * left.way) {
    right = armLine(body, legs, fromMiddle, -1.0, left.way);
  } else if (right.way > 0.0 && left.way > holding * right.way) {
    left = armLine(body, legs, fromMiddle, 1.0, right.way);
  }
  return {armJoints(body, right), armJoints(body, left)};
}

ArmJoints mirroredArm(const ArmJoints& arm) {
  constexpr double lessSure = 0.5;
  ArmJoints mirrored = arm;
  for (Placed* joint : {&mirrored.shoulder, &mirrored.elbow, &mirrored.wrist}) {
    joint->place.x = -joint->place.x;
    joint->confidence *= lessSure;
  }
  return mirrored;
}

ArmJoints guessedArm(double shoulderHeight, double side) {
  constexpr double guess = 0.2;
  ArmJoints joints;
  joints.shoulder = {{side * 0.1, shoulderHeight, 0.0}, guess};
  joints.elbow = {{side * 0.12, shoulderHeight - 0.17, 0.0}, guess};
  joints.wrist = {{side * 0.13, shoulderHeight - 0.32, 0.0}, guess};
  return joints;
}

} // namespace stretch::skinning

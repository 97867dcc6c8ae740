// Joints of legs, arms and trunks on sections that are made by hand: each against its formula.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "skinning/locate/arm_joints.h"
#include "skinning/locate/leg_joints.h"
#include "skinning/locate/trunk_joints.h"
#include "tests/support/skinning/cube_bodies.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// Sections a hundredth apart, each at its own place: the middle leans by its height.
std::vector<LegSection> leaningLeg(double top, double side) {
  std::vector<LegSection> leg;
  for (int i = 0; 0.01 * i + 0.005 < top; ++i) {
    const double height = 0.005 + 0.01 * i;
    leg.push_back(
        {height, Vec3(side * (0.1 + 0.2 * height), height, 0.3 * height), 0.01 * (1.0 + height), 0.02, 0.03});
  }
  return leg;
}

/// Where a leaning leg has its middle: that of the first section that is no lower.
Vec3 leaningAt(double height, double side) {
  const double section = 0.005 + 0.01 * std::ceil((height - 0.005) / 0.01 - 1e-9);
  return {side * (0.1 + 0.2 * section), height, 0.3 * section};
}

bool isNear(const Vec3& is, const Vec3& wanted) {
  return glm::distance(is, wanted) < 1e-9;
}

void addFoot(std::vector<LegSection>& leg, double front, double back) {
  for (LegSection& section : leg) {
    if (section.height < 0.055) {
      section.front = front;
      section.back = back;
    }
  }
}

/// A trunk of square layers of cubes around a line that leans forward: so many cubes across, from the ground
/// up, each `size` wide.
StandingBody stacked(const std::vector<int>& widths, double size, int lean) {
  constexpr int most = 40;
  return test::bodyOfCubes({most, static_cast<int>(widths.size()), most + lean}, size,
                           Vec3(-0.5 * most * size, 0.0, -0.5 * most * size), [&](int x, int y, int z) {
                             const int half = widths[static_cast<std::size_t>(y)] / 2;
                             const int front = z - lean * y / static_cast<int>(widths.size());
                             return x >= most / 2 - half && x < most / 2 + half && front >= most / 2 - half &&
                                    front < most / 2 + half;
                           });
}

} // namespace

TEST_CASE("Joints of a leg lie on its sections, the hip as high as told", "[locators]") {
  for (const double side : {-1.0, 1.0}) {
    for (const double hip : {0.35, 0.42, 0.5}) {
      const std::vector<LegSection> leg = leaningLeg(0.4, side);
      const LegJoints joints = legJoints(leg, hip, 1.0);
      const double top = leg.back().height;
      const Vec3 thigh = leaningAt(0.93 * top, side);
      CHECK(isNear(joints.hip.place, Vec3(thigh.x, hip, thigh.z)));
      const Vec3 shin = leaningAt(0.055 + 0.035, side);
      CHECK(isNear(joints.ankle.place, Vec3(shin.x, 0.055, shin.z)));
      CHECK(isNear(joints.knee.place, leaningAt(0.5 * hip, side))); // no foot: the shin goes to the ground
      CHECK(isNear(joints.toes.place, Vec3(shin.x, 0.015, shin.z + 0.65 * 0.06)));
      CHECK(joints.hip.confidence == 0.8);
      CHECK(joints.knee.confidence == 0.7);
      CHECK(joints.ankle.confidence == 0.8);
      CHECK(joints.toes.confidence == 0.5);
    }
  }
}

TEST_CASE("What is above the top of a leg has its last section's place", "[locators]") {
  const std::vector<LegSection> leg = leaningLeg(0.1, 1.0);
  const LegJoints joints = legJoints(leg, 0.4, 1.0);
  CHECK(isNear(joints.knee.place, Vec3(leg.back().middle.x, 0.2, leg.back().middle.z)));
}

TEST_CASE("Toes begin in a foot that shows, whichever way it points, and the knee is over the ankle",
          "[locators]") {
  for (const double facing : {-1.0, 1.0}) {
    std::vector<LegSection> leg = leaningLeg(0.4, 1.0);
    addFoot(leg, facing > 0.0 ? 0.2 : 0.04, facing > 0.0 ? 0.04 : 0.2);
    leg[2].front += facing > 0.0 ? 0.05 : 0.0;
    leg[2].back += facing > 0.0 ? 0.0 : 0.05;
    leg[2].middle.x = 0.7;
    leg[5].front = leg[5].back = 0.9; // at the ankle's height, no part of the foot
    const LegJoints joints = legJoints(leg, 0.42, facing);
    const double tip = leg[2].middle.z + facing * 0.25;
    CHECK(isNear(joints.toes.place,
                 Vec3(0.7, 0.015, joints.ankle.place.z + 0.65 * (tip - joints.ankle.place.z))));
    CHECK(joints.toes.confidence == 0.8);
    CHECK(joints.knee.place.y == Approx(0.5 * (0.055 + 0.42)));
  }
}

TEST_CASE("The ankle of a short leg is no higher than three tenths of it", "[locators]") {
  const std::vector<LegSection> leg = leaningLeg(0.4, 1.0);
  CHECK(legJoints(leg, 0.1, 1.0).ankle.place.y == Approx(0.03));
  CHECK(legJoints(leg, 0.1, 1.0).ankle.place.x == Approx(leaningAt(0.065, 1.0).x));
  CHECK(legJoints(leg, 0.2, 1.0).ankle.place.y == Approx(0.055));
  CHECK(guessedLeg(0.1, 1.0, 1.0).ankle.place.y == Approx(0.03));
}

TEST_CASE("A leg that does not show is guessed by proportions, on its side, the way that the body faces",
          "[locators]") {
  for (const double side : {-1.0, 1.0}) {
    for (const double facing : {-1.0, 1.0}) {
      const LegJoints joints = guessedLeg(0.48, side, facing);
      CHECK(isNear(joints.hip.place, Vec3(0.05 * side, 0.48, 0.0)));
      CHECK(isNear(joints.knee.place, Vec3(0.05 * side, 0.5 * (0.48 + 0.055), 0.0)));
      CHECK(isNear(joints.ankle.place, Vec3(0.05 * side, 0.055, 0.0)));
      CHECK(isNear(joints.toes.place, Vec3(0.05 * side, 0.015, facing * 0.65 * 0.06)));
      for (const Placed* joint : {&joints.hip, &joints.knee, &joints.ankle, &joints.toes}) {
        CHECK(joint->confidence == 0.2);
      }
    }
  }
}

TEST_CASE("Feet face where they reach farther from their shins, both together", "[locators]") {
  LegLines legs;
  CHECK(facingOf(legs) == 0.0);
  legs.left = leaningLeg(0.4, 1.0);
  legs.right = leaningLeg(0.4, -1.0);
  const double shin = leaningAt(0.11, 1.0).z;
  const auto reachOf = [&](const std::vector<LegSection>& leg) {
    double front = 0.0;
    double back = 0.0;
    for (std::size_t i = 0; i < 5; ++i) {
      front = std::max(front, leg[i].middle.z + leg[i].front - shin);
      back = std::max(back, shin - (leg[i].middle.z - leg[i].back));
    }
    return front - back;
  };
  addFoot(legs.left, 0.2, 0.05);
  addFoot(legs.right, 0.03, 0.12);
  legs.left[1].front = 0.31;
  legs.right[3].back = 0.26;
  legs.left[5].front = 5.0; // no part of the foot
  CHECK(facingOf(legs) == Approx(reachOf(legs.left) + reachOf(legs.right)));
  legs.right.clear();
  CHECK(facingOf(legs) == Approx(reachOf(legs.left)));
}

TEST_CASE("Legs are boxes where both are as thick all along their upper part", "[locators]") {
  const auto legOf = [](double wider, double from, double to) {
    std::vector<LegSection> leg = leaningLeg(0.4, 1.0);
    const double top = leg.back().height;
    for (LegSection& section : leg) {
      const bool isWide = section.height > from * top && section.height < to * top;
      section.area = isWide ? 0.01 * wider : 0.01;
    }
    return leg;
  };
  LegLines legs;
  CHECK_FALSE(areBoxes(legs));
  legs.left = legs.right = legOf(1.0, 0.0, 1.0);
  CHECK(areBoxes(legs));
  legs.left = legOf(1.04, 0.85, 0.9);
  CHECK(areBoxes(legs));
  legs.left = legOf(1.06, 0.85, 0.9);
  CHECK_FALSE(areBoxes(legs));
  std::swap(legs.left, legs.right);
  CHECK_FALSE(areBoxes(legs));
  legs.right = legOf(3.0, 0.0, 0.79); // boots
  CHECK(areBoxes(legs));
  legs.right = legOf(3.0, 0.985, 2.0); // what is not quite a leg any more
  CHECK(areBoxes(legs));
  legs.right = legOf(0.0, 0.0, 2.0); // nothing at all
  CHECK_FALSE(areBoxes(legs));
}

TEST_CASE("Hips lie over the crotch by four rules, each with its edge", "[locators]") {
  struct Row {
    double crotch, neck, hips;
  };
  for (const Row& row : {Row{0.53, 0.8, 0.59 * 0.8}, // over 0.65 of the neck: bones of a pelvis
                         Row{0.51, 0.8, 0.488},      // 0.75 * 0.54 + 0.25 * 0.59 * 0.8 is more
                         Row{0.4, 0.8, 0.4405},      // 0.75 * 0.43 + 0.25 * 0.472
                         Row{0.45, 0.9, 0.49275},    // 0.75 * 0.48 + 0.25 * 0.531
                         Row{0.3, 0.769, 0.33},      // a large head
                         Row{0.3, 0.771, 0.3612225}, // a small one
                         Row{0.49, 0.76, 0.52}}) {   // a large head, a high crotch
    INFO("crotch " << row.crotch << ", neck " << row.neck);
    CHECK(hipHeightOf(row.crotch, row.neck) == Approx(row.hips).epsilon(1e-9));
  }
}

TEST_CASE("A mirrored arm lies on the other side, half as sure", "[locators]") {
  const ArmJoints arm{{{0.2, 0.8, 0.1}, 0.8}, {{0.4, 0.7, -0.1}, 0.7}, {{0.6, 0.6, 0.3}, 0.4}};
  const ArmJoints mirrored = mirroredArm(arm);
  CHECK(isNear(mirrored.shoulder.place, Vec3(-0.2, 0.8, 0.1)));
  CHECK(isNear(mirrored.elbow.place, Vec3(-0.4, 0.7, -0.1)));
  CHECK(isNear(mirrored.wrist.place, Vec3(-0.6, 0.6, 0.3)));
  CHECK(mirrored.shoulder.confidence == Approx(0.4));
  CHECK(mirrored.elbow.confidence == Approx(0.35));
  CHECK(mirrored.wrist.confidence == Approx(0.2));
}

TEST_CASE("An arm that does not show hangs from its shoulder's height, on its side", "[locators]") {
  for (const double side : {-1.0, 1.0}) {
    const ArmJoints arm = guessedArm(0.83, side);
    CHECK(isNear(arm.shoulder.place, Vec3(0.1 * side, 0.83, 0.0)));
    CHECK(isNear(arm.elbow.place, Vec3(0.12 * side, 0.66, 0.0)));
    CHECK(isNear(arm.wrist.place, Vec3(0.13 * side, 0.51, 0.0)));
    for (const Placed* joint : {&arm.shoulder, &arm.elbow, &arm.wrist}) {
      CHECK(joint->confidence == 0.2);
    }
  }
}

namespace {

/// 50 layers of a person: up to the shoulders at layer 38, a neck, a head.
std::vector<int> personWidths() {
  std::vector<int> widths(50, 20);
  for (std::size_t layer = 38; layer < 50; ++layer) {
    widths[layer] = layer < 40 ? 8 : layer == 40 ? 6 : layer < 43 ? 8 : layer < 48 ? 14 : 10;
  }
  return widths;
}

/// The middle of all of a stack from a layer on.
Vec3 middleFrom(const StandingBody& body, double height) {
  Vec3 sum(0.0);
  double count = 0.0;
  for (std::size_t cell = 0; cell < body.cubes.cellCount(); ++cell) {
    if (body.middleOf(cell).y >= height) {
      sum += body.middleOf(cell);
      count += 1.0;
    }
  }
  return sum / count;
}

double depthAt(const StandingBody& body, double height) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t cell = 0; cell < body.cubes.cellCount(); ++cell) {
    if (std::abs(body.middleOf(cell).y - height) < 0.4 * body.cubes.grid.size) {
      sum += body.middleOf(cell).z;
      count += 1.0;
    }
  }
  return sum / count;
}

} // namespace

TEST_CASE("The neck begins where it has grown no more than by six tenths under its narrowest section",
          "[locators]") {
  for (const int lean : {0, 10}) {
    const StandingBody body = stacked(personWidths(), 0.02, lean);
    const TrunkJoints joints = trunkJoints(body, 0.47, 0.74, 1.0);
    // Layer 40 is the narrowest; 39 and 38 have 64 cells, over 1.6 times its 36.
    CHECK(joints.neck.place.y == Approx(0.81 - 0.005));
    CHECK(joints.neck.place.z == Approx(depthAt(body, 0.81)));
    CHECK(joints.neck.place.x == Approx(0.0).margin(1e-9));
    CHECK(joints.neck.confidence == 0.7);
    CHECK(isNear(joints.hips.place, Vec3(0.0, 0.47, depthAt(body, 0.47))));
    CHECK(joints.hips.confidence == 0.8);
    const double head = 0.805 + 0.02; // at least so much over the neck
    const Vec3 top = middleFrom(body, head);
    CHECK(isNear(joints.head.place,
                 glm::mix(joints.neck.place, top, (head - 0.805) / (top.y - joints.neck.place.y))));
    CHECK(joints.head.confidence == 0.7);
  }
}

TEST_CASE("A neck that is about as narrow for long begins at its foot, over the shoulders", "[locators]") {
  std::vector<int> widths = personWidths();
  widths[41] = 6;
  widths[39] = 6; // now 39 to 41 are as narrow; the lowest is the first
  CHECK(trunkJoints(stacked(widths, 0.02, 0), 0.47, 0.74, 1.0).neck.place.y == Approx(0.79 - 0.005));
  widths[40] = 4;
  widths[39] = 4;
  widths[41] = 4;
  widths[38] = 4;
  CHECK(trunkJoints(stacked(widths, 0.02, 0), 0.47, 0.74, 1.0).neck.place.y == Approx(0.77 - 0.005));
  // The shoulders lie higher: no section at or below them counts.
  CHECK(trunkJoints(stacked(widths, 0.02, 0), 0.47, 0.78, 1.0).neck.place.y == Approx(0.79 - 0.005));
}

TEST_CASE("What sticks up from a head is no neck, however narrow", "[locators]") {
  std::vector<int> widths = personWidths();
  for (std::size_t layer = 44; layer < 50; ++layer) {
    widths[layer] = 2; // a tuft
  }
  CHECK(trunkJoints(stacked(widths, 0.02, 0), 0.47, 0.74, 1.0).neck.place.y == Approx(0.81 - 0.005));
}

TEST_CASE("A trunk without a narrow place has a neck that is not sure", "[locators]") {
  const StandingBody body = stacked(std::vector<int>(50, 12), 0.02, 0);
  const TrunkJoints joints = trunkJoints(body, 0.47, 0.74, 1.0);
  CHECK(joints.neck.confidence == 0.4);
  CHECK(joints.head.confidence == 0.4);
  CHECK(joints.hips.confidence == 0.8);
  CHECK(joints.neck.place.y == Approx(0.75 - 0.005));
  CHECK(trunkJoints(test::bodyOfCubes({2, 2, 2}, 0.02, Vec3(0.0), [](int, int, int) { return false; }), 0.4,
                    0.7, 1.0)
            .hips.confidence == 0.0);
}

TEST_CASE("Only what is within the trunk's width and belongs to the mesh counts for its middle",
          "[locators]") {
  StandingBody body = test::bodyOfCubes({30, 50, 10}, 0.02, Vec3(-0.3, 0.0, -0.1), [](int x, int, int z) {
    return (x >= 10 && x < 20 && z < 6) || (x >= 22 && z >= 6); // a trunk, and beside it a wall
  });
  const double middle = trunkJoints(body, 0.47, 0.74, 0.11).hips.place.z;
  CHECK(middle == Approx(-0.1 + 0.02 * 3));
  CHECK(trunkJoints(body, 0.47, 0.74, 1.0).hips.place.z > middle + 0.01);
  const double depth = depthForHeight(body, 0.47, 0.11);
  CHECK(depth == Approx(std::sqrt((36.0 - 1.0) / (27.0 * 27.0 - 1.0)))); // spreads of 6 and of 27 cubes
  CHECK(depthForHeight(body, 0.99, 0.11) == 0.0);                        // one layer has no height
  CHECK(depthForHeight(body, 2.0, 0.11) == 0.0);
  body.ownCells = 0;
  CHECK(depthForHeight(body, 0.47, 0.11) == 0.0);
  CHECK(trunkJoints(body, 0.47, 0.74, 1.0).hips.confidence == 0.0);
}

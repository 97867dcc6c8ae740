// How well joints fit a limb, by names and by shape: from a limb that fits, one thing changed at a time.
#include "rig/body/reading/limb_score.h"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "tests/support/rig/joint_views.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::rig::body;

namespace {

/// A tree of joints that is made one by one, each below one made before.
struct JointTree {
  BodyView view;

  int add(int parent, const Vec3& position) {
    return test::addJoint(view, NodeIndex(static_cast<std::size_t>(view.count())), parent, position);
  }
  NameEvidence& name(int joint) { return view.names[static_cast<std::size_t>(joint)]; }
  void call(int joint, Role role, double fit) { name(joint).roles[static_cast<std::size_t>(role)] = fit; }
};

/// Chest, base, middle and end of a limb out to +X, as long as both of its bones are 0.3, in a body of size 1
/// whose hand or foot goes on for 0.1.
struct StraightLimb : JointTree {
  int chest = add(-1, Vec3(0.0, 1.0, 0.0));
  int base = add(chest, Vec3(0.2, 1.0, 0.0));
  int middle = add(base, Vec3(0.5, 1.0, 0.0));
  int end = add(middle, Vec3(0.8, 1.0, 0.0));
  LimbGuess guess;
  MirrorPlane plane;

  StraightLimb() {
    view.reach[static_cast<std::size_t>(end)] = 0.1;
    measure();
  }

  void measure() {
    guess.base = base;
    guess.middle = middle;
    guess.end = end;
    guess.endPosition = view.at(end);
    guess.length =
        glm::distance(view.at(base), view.at(middle)) + glm::distance(view.at(middle), view.at(end));
  }
  void place(int joint, const Vec3& position) {
    view.position[static_cast<std::size_t>(joint)] = position;
    measure();
  }
  void named(Region region) {
    const bool isArm = region == Region::arm;
    call(base, isArm ? Role::upperArm : Role::thigh, 1.0);
    call(middle, isArm ? Role::foreArm : Role::shin, 1.0);
    call(end, isArm ? Role::wrist : Role::ankle, 1.0);
  }
  [[nodiscard]] double penalty(Region region) const { return shapePenalty(view, plane, guess, region); }
  [[nodiscard]] double fit(Region region) const { return nameFit(view, guess, region); }
};

constexpr double lengthOfBone = 0.3;

} // namespace

TEST_CASE("Names fit a limb by the roles of its three joints, an arm's by its clavicle as well") {
  for (const Region region : {Region::arm, Region::leg}) {
    StraightLimb limb;
    limb.named(region);
    CHECK(limb.fit(region) == Approx(3.0));
    CHECK(limb.fit(region == Region::arm ? Region::leg : Region::arm) == Approx(-1.5));
    limb.call(limb.chest, Role::clavicle, 0.5);
    CHECK(limb.fit(region) == Approx(region == Region::arm ? 3.15 : 3.0));
    limb.guess.end = -1;
    CHECK(limb.fit(region) == Approx(region == Region::arm ? 2.15 : 2.0));
    limb.guess.middle = -1;
    CHECK(limb.fit(region) == Approx(region == Region::arm ? 1.15 : 1.0));
  }
}

TEST_CASE(
    "A name that clearly says another role speaks against a joint, and so do fingers, twists and gear") {
  const int which = GENERATE(0, 1, 2);
  const auto fitWith = [&](auto change) {
    StraightLimb limb;
    limb.named(Region::arm);
    const int joint = which == 0 ? limb.base : which == 1 ? limb.middle : limb.end;
    change(limb, joint);
    return limb.fit(Region::arm) - 2.0; // Of that joint alone.
  };
  const Role own = which == 0 ? Role::upperArm : which == 1 ? Role::foreArm : Role::wrist;
  const auto withRoles = [&](double here, double other) {
    return fitWith([&](StraightLimb& limb, int joint) {
      limb.call(joint, own, here);
      limb.call(joint, Role::head, other);
    });
  };
  CHECK(withRoles(0.4, 0.9) == Approx(0.4 - 0.25));
  CHECK(withRoles(0.4, 0.8) == Approx(0.4 - 0.2));
  CHECK(withRoles(0.4, 0.79) == Approx(0.4));
  CHECK(withRoles(0.9, 0.5) == Approx(0.9));
  CHECK(fitWith([](StraightLimb& limb, int joint) { limb.name(joint).finger = true; }) == Approx(0.4));
  CHECK(fitWith([](StraightLimb& limb, int joint) { limb.name(joint).accessory = true; }) == Approx(0.2));
  CHECK(fitWith([](StraightLimb& limb, int joint) { limb.name(joint).twist = true; }) == Approx(0.4));
}

TEST_CASE(
    "A joint of a limb that is skipped speaks against it, unless it twists or is a part of the first bone") {
  const bool isUpper = GENERATE(true, false);
  const auto fitWith = [&](double role, bool twist, const std::string& key) {
    StraightLimb limb;
    limb.named(Region::arm);
    const int above = isUpper ? limb.base : limb.middle;
    const int below = isUpper ? limb.middle : limb.end;
    const int between = limb.add(above, 0.5 * (limb.view.at(above) + limb.view.at(below)));
    limb.view.parent[static_cast<std::size_t>(below)] = between;
    limb.call(between, Role::wrist, role);
    limb.name(between).twist = twist;
    limb.name(between).key = key;
    limb.name(above).key = "arm#1";
    return limb.fit(Region::arm);
  };
  CHECK(fitWith(0.8, false, "hand") == Approx(2.6));
  CHECK(fitWith(0.79, false, "hand") == Approx(3.0));
  CHECK(fitWith(1.0, true, "hand") == Approx(3.0));
  CHECK(fitWith(1.0, false, "arm#2") == Approx(3.0));
  CHECK(fitWith(1.0, false, "arm") == Approx(3.0));
}

TEST_CASE("A straight limb of a size, off the middle, has nothing against it") {
  const StraightLimb limb;
  CHECK(limb.penalty(Region::arm) == Approx(0.0).margin(1e-12));
  CHECK(limb.penalty(Region::leg) == Approx(0.0).margin(1e-12));
}

TEST_CASE("A limb that is short or long for its body is none") {
  StraightLimb limb;
  const auto penaltyAt = [&](double size) {
    limb.view.size = size;
    return limb.penalty(Region::arm);
  };
  CHECK(penaltyAt(2.4) == Approx(0.0).margin(1e-12));
  CHECK(penaltyAt(4.8) == Approx(0.6));
  CHECK(penaltyAt(0.8) == Approx(0.0).margin(1e-12));
  CHECK(penaltyAt(0.6) == Approx(0.25));
}

TEST_CASE("A limb does not begin in the middle of the body, an arm farther off it than a leg") {
  const auto penaltyAt = [](Region region, double lateral) {
    StraightLimb limb;
    limb.plane.offset = 0.2 - lateral;
    limb.place(limb.chest, Vec3(limb.plane.offset, 1.0, 0.0));
    return limb.penalty(region);
  };
  CHECK(penaltyAt(Region::arm, 0.073) == Approx(0.0).margin(1e-12)); // 0.12 of its length.
  CHECK(penaltyAt(Region::arm, 0.071) == Approx(0.45));
  CHECK(penaltyAt(Region::arm, -0.071) == Approx(0.45));
  CHECK(penaltyAt(Region::arm, 0.011) == Approx(0.45));
  CHECK(penaltyAt(Region::arm, 0.009) == Approx(1.2));
  CHECK(penaltyAt(Region::leg, 0.025) == Approx(0.0).margin(1e-12)); // 0.04 of it.
  CHECK(penaltyAt(Region::leg, 0.023) == Approx(0.45));
}

TEST_CASE("Bones of a limb are about as long as each other, and it is not folded") {
  const auto penaltyOf = [](Region region, double upper, double degrees) {
    StraightLimb limb;
    const double turn = degrees * pi / 180.0;
    limb.place(limb.middle, Vec3(0.2 + upper, 1.0, 0.0));
    limb.place(limb.end,
               Vec3(0.2 + upper + lengthOfBone * std::cos(turn), 1.0 + lengthOfBone * std::sin(turn), 0.0));
    return limb.penalty(region);
  };
  CHECK(penaltyOf(Region::arm, 0.1, 0.0) == Approx(0.8));
  CHECK(penaltyOf(Region::arm, 0.9 / std::sqrt(3.0), 0.0) ==
        Approx(0.4 + (0.9 / std::sqrt(3.0) + 0.3 - 0.75)));
  CHECK(penaltyOf(Region::arm, 0.3, 99.0) == Approx(0.0).margin(1e-9));
  CHECK(penaltyOf(Region::arm, 0.3, 101.0) == Approx(0.4));
  CHECK(penaltyOf(Region::leg, 0.3, 59.0) == Approx(0.0).margin(1e-9));
  CHECK(penaltyOf(Region::leg, 0.3, 61.0) == Approx(0.4));
}

TEST_CASE("A hand or a foot is left beyond a limb's end, and less than the limb") {
  const auto penaltyWith = [](Region region, double share) {
    StraightLimb limb;
    limb.view.reach[static_cast<std::size_t>(limb.end)] = 0.6 * share / (1.0 - share);
    return limb.penalty(region);
  };
  CHECK(penaltyWith(Region::arm, 0.101) == Approx(0.0).margin(1e-9));
  CHECK(penaltyWith(Region::arm, 0.05) == Approx(0.15 + 0.1));
  CHECK(penaltyWith(Region::arm, 0.399) == Approx(0.0).margin(1e-9));
  CHECK(penaltyWith(Region::arm, 0.5) == Approx(0.15 + 0.2));
  CHECK(penaltyWith(Region::arm, 0.9) == Approx(0.6));
  CHECK(penaltyWith(Region::leg, 0.081) == Approx(0.0).margin(1e-9));
  CHECK(penaltyWith(Region::leg, 0.04) == Approx(0.15 + 0.08));
  CHECK(penaltyWith(Region::leg, 0.499) == Approx(0.0).margin(1e-9));
  CHECK(penaltyWith(Region::leg, 0.6) == Approx(0.15 + 0.2));
}

TEST_CASE("Joints that are skipped cost little on the line of their bone, and much where they are off it") {
  const bool isUpper = GENERATE(true, false);
  const auto penaltyWith = [&](std::vector<Vec3> between, bool twist) {
    StraightLimb limb;
    int above = isUpper ? limb.base : limb.middle;
    const int below = isUpper ? limb.middle : limb.end;
    const Vec3 start = limb.view.at(above);
    for (const Vec3& place : between) {
      above = limb.add(above, start + place);
      limb.name(above).twist = twist;
    }
    limb.view.parent[static_cast<std::size_t>(below)] = above;
    return limb.penalty(Region::arm);
  };
  CHECK(penaltyWith({{0.15, 0.0, 0.0}}, false) == Approx(0.12));
  CHECK(penaltyWith({{0.15, 0.0, 0.0}}, true) == Approx(0.02));
  CHECK(penaltyWith({{0.1, 0.0, 0.0}, {0.2, 0.0, 0.0}}, false) == Approx(0.16));
  CHECK(penaltyWith({{0.15, 0.003, 0.0}}, false) == Approx(0.12));
  CHECK(penaltyWith({{0.15, 0.03, 0.0}}, false) == Approx(0.12 + 8.0 * 0.09));
  CHECK(penaltyWith({{-0.03, 0.0, 0.0}}, false) == Approx(0.12 + 0.2));
  CHECK(penaltyWith({{0.36, 0.0, 0.0}}, false) == Approx(0.12 + 0.4));
  CHECK(penaltyWith({{0.15, 0.3, 0.0}}, false) == Approx(0.12 + 1.2));
}

TEST_CASE("A limb without a middle or an end is worth less, and so is a foot that hangs elsewhere") {
  StraightLimb limb;
  limb.guess.endDetached = true;
  CHECK(limb.penalty(Region::leg) == Approx(0.2));
  limb.guess.endDetached = false;
  limb.guess.end = -1;
  CHECK(limb.penalty(Region::leg) == Approx(0.5));
  CHECK(limb.penalty(Region::arm) == Approx(0.5));
  limb.guess.middle = -1;
  CHECK(limb.penalty(Region::arm) == Approx(1.2));
  limb.guess.end = limb.end;
  CHECK(limb.penalty(Region::arm) == Approx(0.8));
}

TEST_CASE("A leg turns at its ankle: what goes on in its line is the rest of the shin") {
  const auto penaltyWith = [](Region region, const Vec3& beyond) {
    StraightLimb limb;
    limb.add(limb.end, limb.view.at(limb.end) + beyond);
    return limb.penalty(region);
  };
  CHECK(penaltyWith(Region::leg, {0.05, 0.0, 0.0}) == Approx(0.3)); // 0.15 of the shin at least.
  CHECK(penaltyWith(Region::leg, {0.044, 0.0, 0.0}) == Approx(0.0).margin(1e-9));
  CHECK(penaltyWith(Region::leg, {0.05, 0.0098, 0.0}) == Approx(0.3)); // Within 0.2 radians.
  CHECK(penaltyWith(Region::leg, {0.05, 0.0105, 0.0}) == Approx(0.0).margin(1e-9));
  CHECK(penaltyWith(Region::arm, {0.05, 0.0, 0.0}) == Approx(0.0).margin(1e-9));
}

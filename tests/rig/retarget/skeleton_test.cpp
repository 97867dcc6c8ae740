// What a biped is to another one whose clip it gets: its joints, and how it stands in the bind pose.
#include "rig/retarget/skeleton.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/boxed_biped.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

const Quat onItsBack = axisAngle(Vec3(1.0, 0.0, 0.0), -0.5 * pi);

/// Ground below feet whose soles are so high, each of a sole and a box above it.
double groundBelow(std::optional<double> left, std::optional<double> right) {
  MovingBiped moving = bareBiped(namedBody());
  const auto addShoe = [&](const std::string& foot, double x, double sole) {
    addBox(moving, foot, Vec3(x, sole + 0.05, 0.05), Vec3(0.04, 0.05, 0.1));
    addBox(moving, foot, Vec3(x, sole + 0.15, 0.05), Vec3(0.04, 0.05, 0.1));
  };
  if (left) {
    addShoe("foot.l", 0.1, *left);
  }
  if (right) {
    addShoe("foot.r", -0.1, *right);
  }
  return skeletonOf(moving).groundHeight;
}

/// How a body without a mesh and a skin stands whose file turns it so.
Skeleton turnedInFile(const Vec3& axis, double degrees) {
  MovingBiped moving = bareBiped(namedBody());
  moving.scene.skins.clear();
  moving.scene.nodes.front().rest.rotation = axisAngle(axis, degrees * pi / 180.0);
  Skeleton skeleton = skeletonOf(moving);
  skeleton.scene = nullptr;
  return skeleton;
}

} // namespace

TEST_CASE("A body's ground is the mean height of its soles, where these are near the floor of its clips") {
  CHECK(groundBelow(0.1, 0.06) == Approx(0.08).margin(1e-6));
  CHECK(groundBelow(-0.1, -0.06) == Approx(-0.08).margin(1e-6));
  CHECK(groundBelow(0.25, 0.25) == 0.0);
  CHECK(groundBelow(-0.25, -0.25) == 0.0);
  CHECK(groundBelow(0.1, std::nullopt) == 0.0);
  CHECK(groundBelow(std::nullopt, 0.1) == 0.0);
}

TEST_CASE(
    "Fingers are known by the table of the file, else by their names, without their bones in the palm") {
  MovingBiped moving = still(namedBody());
  const auto node = [&](const std::string& key) { return moving.node.at(key); };
  for (const auto& [key, name] :
       {std::pair("finger0a.l", "Thumb_Metacarpal_L"), std::pair("finger1a.l", "Index_Metacarpal_L"),
        std::pair("finger2a.l", "Pinky_Palm_L"), std::pair("finger0a.r", "Thumb_R"),
        std::pair("finger1a.r", "Little_R"), std::pair("finger2a.r", "Metacarpal_R")}) {
    moving.scene.nodes[at(node(key))].name = name;
  }
  moving.scene.humanoid = {{"rightIndexProximal", node("finger0a.r")},
                           {"rightRingProximal", node("finger2a.r")}};
  const Skeleton skeleton = skeletonOf(moving);
  REQUIRE((skeleton.arms[leftSide] && skeleton.arms[rightSide]));
  const Fingers left{{"thumb", {node("finger0a.l"), node("finger0b.l")}},
                     {"index", {node("finger1b.l")}},
                     {"little", {node("finger2b.l")}}};
  const Fingers right{{"index", {node("finger0a.r"), node("finger0b.r")}},
                      {"little", {node("finger1a.r"), node("finger1b.r")}},
                      {"ring", {node("finger2a.r"), node("finger2b.r")}}};
  CHECK((skeleton.arms[leftSide]->fingers == left));
  CHECK((skeleton.arms[rightSide]->fingers == right));
}

TEST_CASE("A shoulder is what the table of the file calls so, else the joint farthest up that is one arm's") {
  MovingBiped moving = still(namedBody());
  const auto left = std::ranges::find(moving.body.limbs, "left-arm", &Limb::id);
  REQUIRE(left != moving.body.limbs.end());
  REQUIRE(left->joints.size() == 2);
  left->joints.erase(left->joints.begin()); // Now the upper arm is between the shoulder and the arm.
  const auto shoulders = [&] {
    const Skeleton skeleton = skeletonOf(moving);
    REQUIRE((skeleton.arms[leftSide] && skeleton.arms[rightSide]));
    return std::vector{skeleton.arms[leftSide]->shoulder, skeleton.arms[rightSide]->shoulder};
  };
  CHECK((shoulders() == std::vector{moving.node.at("clavicle.l"), moving.node.at("clavicle.r")}));
  moving.scene.humanoid["leftShoulder"] = moving.node.at("upperArm.l");
  CHECK((shoulders() == std::vector{moving.node.at("upperArm.l"), moving.node.at("clavicle.r")}));
}

TEST_CASE("What bears both legs and the trunk carries a body, not the pelvis that bears the legs alone") {
  MovingBiped apart = still(namedBody());
  const NodeIndex hips = apart.node.at("hips");
  const NodeIndex pelvis = addNode(apart.scene, "pelvis", hips, Vec3(0.0));
  for (const auto& [side, sign] : sides) {
    const NodeIndex thigh = apart.node.at("thigh" + side);
    std::erase(apart.scene.nodes[at(hips)].children, thigh);
    apart.scene.nodes[at(pelvis)].children.push_back(thigh);
    apart.scene.nodes[at(thigh)].parent = pelvis;
  }
  CHECK(skeletonOf(apart).carrier == hips);
  const MovingBiped plain = still(namedBody());
  const Skeleton skeleton = skeletonOf(plain);
  CHECK(skeleton.carrier == plain.node.at("hips"));
  CHECK((skeleton.spine ==
         std::vector{plain.node.at("spine0"), plain.node.at("spine1"), plain.node.at("spine2")}));
  CHECK((skeleton.neck == std::vector{plain.node.at("neck0")}));
  CHECK(skeleton.head == plain.node.at("head"));
}

TEST_CASE("A body that faces within five degrees of an axis of the world faces along it") {
  const Vec3 up(0.0, 1.0, 0.0);
  CHECK(turnedInFile(up, 4.5).axes[0] == Vec3(1.0, 0.0, 0.0));
  CHECK(turnedInFile(up, -4.5).axes[0] == Vec3(1.0, 0.0, 0.0));
  CHECK(turnedInFile(up, 176.0).axes[0] == Vec3(-1.0, 0.0, 0.0));
  CHECK(turnedInFile(up, 94.0).axes[0] == Vec3(0.0, 0.0, -1.0));
  for (const double degrees : {5.5, 40.0, -120.0}) {
    CAPTURE(degrees);
    const Mat3 axes = turnedInFile(up, degrees).axes;
    const double angle = degrees * pi / 180.0;
    CHECK(glm::distance(axes[0], Vec3(std::cos(angle), 0.0, -std::sin(angle))) < 1e-6);
    CHECK(glm::distance(axes[2], Vec3(std::sin(angle), 0.0, std::cos(angle))) < 1e-6);
  }
}

TEST_CASE("A body that leans by less than 45 degrees stands, and one that leans by more does not") {
  const Vec3 sideways(1.0, 0.0, 0.0);
  const Vec3 up(0.0, 1.0, 0.0);
  const Skeleton stands = turnedInFile(sideways, 40.0);
  CHECK(stands.isUpright);
  CHECK(stands.axes[1] == up);
  const Skeleton leans = turnedInFile(sideways, 50.0);
  CHECK_FALSE(leans.isUpright);
  // The head is 0.04 before the feet and 1.49 above them.
  const double ahead = std::atan(0.04 / 1.49) * 180.0 / pi;
  CHECK(angleBetween(leans.axes[1], up) * 180.0 / pi == Approx(50.0 + ahead).margin(0.01));
}

TEST_CASE("A body whose topmost joint rests in the middle of a motion stands as what carries that does") {
  MovingBiped fallen = still(namedBody());
  fallen.scene.nodes[at(fallen.node.at("root"))].rest.rotation = onItsBack;
  const Skeleton stands = skeletonOf(fallen);
  CHECK(stands.isUpright);
  const Vec3 head = positionOf(stands.bind[at(fallen.node.at("head"))]);
  CHECK(glm::distance(head, Vec3(0.0, 1.58, 0.01)) < 1e-6);
  CHECK(stands.groundHeight == Approx(-0.02).margin(1e-6)); // As deep as the mesh of the shoes.
  MovingBiped laid = still(namedBody());
  laid.scene.nodes.front().rest.rotation = onItsBack;
  CHECK_FALSE(skeletonOf(laid).isUpright);
}

TEST_CASE("A body that is no biped, or has one leg, takes no clip of another") {
  const MovingBiped moving = still(namedBody());
  Body beast = moving.body;
  beast.isBiped = false;
  CHECK_FALSE(rig::skeletonOf(moving.scene, beast));
  for (const std::string leg : {"left-leg", "right-leg"}) {
    Body body = moving.body;
    std::erase_if(body.limbs, [&](const Limb& limb) { return limb.id == leg; });
    CHECK_FALSE(rig::skeletonOf(moving.scene, body));
  }
}

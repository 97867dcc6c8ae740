#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/body/locators/locators.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

Locators person() {
  Locators person;
  const auto add = [&](const std::string& name, const Vec3& position) {
    person.list.push_back({.name = name, .position = position});
  };
  add("hips", {0.0, 1.0, 0.0});
  add("spine", {0.0, 1.1, 0.0});
  add("head", {0.0, 1.6, 0.0});
  for (const auto& [side, sign] : {std::pair{"left", 1.0}, std::pair{"right", -1.0}}) {
    add(std::string(side) + "UpperArm", {sign * 0.2, 1.4, 0.0});
    add(std::string(side) + "LowerArm", {sign * 0.5, 1.4, 0.0});
    add(std::string(side) + "Hand", {sign * 0.8, 1.4, 0.0});
    add(std::string(side) + "UpperLeg", {sign * 0.1, 0.9, 0.0});
    add(std::string(side) + "LowerLeg", {sign * 0.1, 0.5, 0.0});
    add(std::string(side) + "Foot", {sign * 0.1, 0.1, 0.0});
    add(std::string(side) + "Toes", {sign * 0.1, 0.02, 0.15});
  }
  return inOrder(person);
}

Vec3 axisOf(const Locators& locators, const std::string& name, const Vec3& axis) {
  return findLocator(locators, name)->orientation * axis;
}

const Vec3 x(1.0, 0.0, 0.0);
const Vec3 y(0.0, 1.0, 0.0);
const Vec3 z(0.0, 0.0, 1.0);

} // namespace

TEST_CASE("A bone goes on to the next joint that the body has", "[locators]") {
  const Locators body = person();
  CHECK(parentLocator(body, "leftUpperArm") == "spine"); // no shoulder, no chest
  CHECK(parentLocator(body, "head") == "spine");
  CHECK(parentLocator(body, "leftToes") == "leftFoot");
  CHECK(parentLocator(body, "hips").empty());
  CHECK(missingLocators(body).empty());
  Locators lacking = body;
  std::erase_if(lacking.list, [](const Locator& locator) { return locator.name == "rightHand"; });
  CHECK(missingLocators(lacking) == std::vector<std::string>{"rightHand"});
}

TEST_CASE("Locators are turned along their bones and look where the body faces", "[locators]") {
  const Locators body = alongBones(person());
  for (const auto& [name, along] :
       {std::pair{"hips", y}, std::pair{"spine", y}, std::pair{"head", y}, std::pair{"leftUpperArm", x},
        std::pair{"leftHand", x}, std::pair{"rightLowerArm", -x}, std::pair{"leftUpperLeg", -y}}) {
    INFO(name);
    CHECK(glm::dot(axisOf(body, name, y), along) == Approx(1.0));
    CHECK(glm::dot(axisOf(body, name, z), z) == Approx(1.0));
  }
  CHECK(axisOf(body, "leftFoot", z).y > 0.8);
  // The mirror image: the same bone and facing, the hinge the other way round.
  CHECK(glm::dot(axisOf(body, "leftLowerArm", x), axisOf(body, "rightLowerArm", x)) == Approx(-1.0));
}

TEST_CASE("A locator at the place of the next one is turned along no bone", "[locators]") {
  Locators body = person();
  const Quat before = axisAngle(z, 0.3);
  findLocator(body, "leftLowerArm")->position = findLocator(body, "leftHand")->position;
  findLocator(body, "leftLowerArm")->orientation = before;
  CHECK(findLocator(alongBones(body), "leftLowerArm")->orientation == before);
}

TEST_CASE("Locators of a trunk alone look along the z of the scene", "[locators]") {
  Locators trunk = person();
  std::erase_if(trunk.list,
                [](const Locator& locator) { return sideOfLocator(locator.name) != BodySide::centre; });
  trunk = alongBones(trunk);
  REQUIRE(trunk.list.size() == 3);
  for (const Locator& locator : trunk.list) {
    INFO(locator.name);
    CHECK(glm::dot(locator.orientation * y, y) == Approx(1.0));
    CHECK(glm::dot(locator.orientation * z, z) == Approx(1.0));
  }
}

TEST_CASE("A turn made by hand stays on a bone whose joints are moved", "[locators]") {
  Locators body = alongBones(person());
  const Quat twist = axisAngle(y, 0.5);
  findLocator(body, "leftUpperArm")->orientation = findLocator(body, "leftUpperArm")->orientation * twist;
  Locators moved = body;
  findLocator(moved, "leftLowerArm")->position = {0.2, 1.1, 0.0}; // the upper arm now hangs down
  const Locators turned = turnedWithBones(body, moved);
  CHECK(glm::dot(axisOf(turned, "leftUpperArm", y), -y) == Approx(1.0));
  CHECK(glm::dot(axisOf(turned, "leftUpperArm", z), z) == Approx(std::cos(0.5)));
  CHECK(findLocator(turned, "rightUpperArm")->orientation == findLocator(body, "rightUpperArm")->orientation);
}

TEST_CASE("Every name with a side has a counterpart", "[locators]") {
  CHECK(mirroredLocator("leftUpperArm") == "rightUpperArm");
  CHECK(mirroredLocator("rightToes") == "leftToes");
  CHECK(mirroredLocator("chest") == "chest");
  for (const char* const bone :
       {"Shoulder", "UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot", "Toes"}) {
    const std::string left = std::string("left") + bone;
    CHECK(findJoint(*locatorPlan("biped"), left) != nullptr);
    CHECK(mirroredLocator(left) == std::string("right") + bone);
    CHECK(findJoint(*locatorPlan("biped"), mirroredLocator(left)) != nullptr);
  }
}

TEST_CASE("Locators of a beast look up along its trunk and forwards on its legs", "[locators]") {
  Locators beast{"quadruped", {}};
  const auto add = [&](const std::string& name, const Vec3& position) {
    beast.list.push_back({.name = name, .position = position});
  };
  add("hips", {0.0, 1.0, -0.5});
  add("spine", {0.0, 1.0, 0.0});
  add("chest", {0.0, 1.0, 0.4});
  add("neck", {0.0, 1.0, 0.6});
  add("head", {0.0, 1.0, 0.9});
  for (const auto& [side, sign] : {std::pair{"left", 1.0}, std::pair{"right", -1.0}}) {
    add(std::string(side) + "Shoulder", {sign * 0.2, 0.9, 0.4});
    add(std::string(side) + "Elbow", {sign * 0.2, 0.5, 0.4});
    add(std::string(side) + "Hip", {sign * 0.2, 0.9, -0.5});
    add(std::string(side) + "Knee", {sign * 0.2, 0.5, -0.5});
  }
  const Locators turned = alongBones(inOrder(beast));
  for (const char* const name : {"hips", "spine", "chest", "neck", "head"}) {
    INFO(name);
    CHECK(glm::dot(axisOf(turned, name, y), z) == Approx(1.0));
    CHECK(glm::dot(axisOf(turned, name, z), y) == Approx(1.0));
  }
  for (const char* const name : {"leftShoulder", "rightShoulder", "leftHip", "rightHip"}) {
    INFO(name);
    CHECK(glm::dot(axisOf(turned, name, y), -y) == Approx(1.0));
    CHECK(glm::dot(axisOf(turned, name, z), z) == Approx(1.0));
  }
}

TEST_CASE("A head with feelers is turned along the body, not along a feeler", "[locators]") {
  Locators insect{"insect", {}};
  const auto add = [&](const std::string& name, const Vec3& position) {
    insect.list.push_back({.name = name, .position = position});
  };
  add("thorax", {0.0, 0.3, 0.0});
  add("head", {0.0, 0.3, 0.2});
  for (const auto& [side, sign] : {std::pair{"left", 1.0}, std::pair{"right", -1.0}}) {
    add(std::string(side) + "Leg1Base", {sign * 0.1, 0.3, 0.1});
    add(std::string(side) + "Feeler1", {sign * 0.05, 0.35, 0.25});
    add(std::string(side) + "Feeler2", {sign * 0.1, 0.4, 0.3});
  }
  const Locators turned = alongBones(inOrder(insect));
  for (const char* const name : {"thorax", "head"}) {
    INFO(name);
    CHECK(glm::dot(axisOf(turned, name, y), z) == Approx(1.0));
    CHECK(glm::dot(axisOf(turned, name, z), y) == Approx(1.0));
  }
  CHECK(glm::dot(axisOf(turned, "leftFeeler1", y), glm::normalize(Vec3(1.0))) == Approx(1.0));
}

TEST_CASE("A bone that points where its body faces is turned along it all the same", "[locators]") {
  Locators kicking = person();
  findLocator(kicking, "leftLowerLeg")->position = findLocator(kicking, "leftUpperLeg")->position + 0.4 * z;
  CHECK(glm::dot(axisOf(alongBones(kicking), "leftUpperLeg", y), z) == Approx(1.0));
}

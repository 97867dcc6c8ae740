#include "rig/adjust/controller_shapes.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "rig/adjust/solve_adjustments.h"
#include "tests/support/recorded.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/moving_creatures.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

struct Shaped {
  MovingBiped moving;
  AdjustedBody body;
  std::vector<ControllerShape> shapes;

  explicit Shaped(MovingBiped biped)
      : moving(std::move(biped)),
        body(adjustedBody({moving.scene, moving.clip, moving.body.hips, moving.body.limbs})),
        shapes(controllerShapes(moving.scene, moving.body.limbs, body)) {}

  [[nodiscard]] const std::vector<std::vector<Vec3>>& linesOf(const std::string& id) const {
    const auto shape = std::ranges::find(shapes, id, &ControllerShape::controller);
    REQUIRE(shape != shapes.end());
    return shape->lines;
  }
  [[nodiscard]] Bounds boundsOf(const std::string& id) const {
    Bounds bounds;
    for (const std::vector<Vec3>& line : linesOf(id)) {
      REQUIRE(line.size() >= 2);
      std::ranges::for_each(line, [&](const Vec3& point) { bounds.add(point); });
    }
    REQUIRE_FALSE(bounds.empty());
    return bounds;
  }
  [[nodiscard]] Vec3 bindPlace(const std::string& key) const {
    return positionOf(body.places.worlds[at(moving.node.at(key))]);
  }
};

SyntheticBiped bonesAlone(BodyOptions options = {}) {
  SyntheticBiped body = namedBody(options);
  body.withMesh = false;
  return body;
}

void checkBounds(const Bounds& bounds, const Vec3& low, const Vec3& high) {
  CAPTURE(bounds.low.x, bounds.low.y, bounds.low.z, bounds.high.x, bounds.high.y, bounds.high.z);
  CHECK(glm::length(bounds.low - low) < 1e-6);
  CHECK(glm::length(bounds.high - high) < 1e-6);
}

Bounds boundsOfLine(const std::vector<Vec3>& line) {
  Bounds bounds;
  std::ranges::for_each(line, [&](const Vec3& point) { bounds.add(point); });
  return bounds;
}

/// How long each line of each shape is, how far it reaches and whether it comes back to where it began.
std::string shapesText(const std::string& title, const Shaped& shaped) {
  std::string text = title + "\n";
  for (const ControllerShape& shape : shaped.shapes) {
    for (const std::vector<Vec3>& line : shape.lines) {
      double length = 0.0;
      for (std::size_t i = 1; i < line.size(); ++i) {
        length += glm::length(line[i] - line[i - 1]);
      }
      const Bounds bounds = boundsOfLine(line);
      const Vec3& quarter = line[line.size() / 4];
      text += fmt::format(
          "  {} {} points {} , {:.4f} long , {:.4f} {:.4f} {:.4f} to {:.4f} {:.4f} {:.4f} , "
          "begins {:.4f} {:.4f} {:.4f} , by {:.4f} {:.4f} {:.4f}\n",
          shape.controller, line.size(), glm::length(line.front() - line.back()) < 1e-9 ? "closed" : "open",
          length, bounds.low.x, bounds.low.y, bounds.low.z, bounds.high.x, bounds.high.y, bounds.high.z,
          line.front().x, line.front().y, line.front().z, quarter.x, quarter.y, quarter.z);
    }
  }
  return text;
}

} // namespace

TEST_CASE("every controller of the body but the poles is drawn, around what it is on") {
  const Shaped shaped(punchingBiped());
  const double height = shaped.moving.body.height;
  for (const Controller& controller : shaped.body.list.controllers) {
    const bool drawn =
        std::ranges::find(shaped.shapes, controller.id, &ControllerShape::controller) != shaped.shapes.end();
    CHECK(drawn == (controller.kind != ControllerKind::pole));
  }
  const Bounds box = shaped.boundsOf("hips");
  const double thighs = std::abs(shaped.bindPlace("thigh.l").x - shaped.bindPlace("thigh.r").x);
  CHECK(box.high.x - box.low.x > thighs);
  CHECK(box.high.x - box.low.x < 0.5 * height);
  const Bounds sole = shaped.boundsOf("left-foot");
  CHECK(sole.high.y - sole.low.y == Approx(0.0).margin(1e-9));
  CHECK(sole.high.y < 0.0);
}

TEST_CASE("shapes grow with the character and turn with where it faces") {
  BodyOptions small;
  const Shaped normal(still(namedBody(small)));
  SyntheticBiped turned = namedBody();
  turned.facesBackwards = true;
  const Shaped backwards(still(turned));
  CHECK(normal.body.forward.z == Approx(-backwards.body.forward.z).margin(1e-6));
  const Bounds there = normal.boundsOf("left-foot");
  const Bounds back = backwards.boundsOf("left-foot");
  CHECK(there.high.z - there.low.z == Approx(back.high.z - back.low.z).epsilon(1e-3));
}

TEST_CASE("every line of a shape is closed but the four posts of the hips' box") {
  const SyntheticBiped body = GENERATE(namedBody(), bonesAlone());
  const Shaped shaped(still(body));
  for (const ControllerShape& shape : shaped.shapes) {
    CAPTURE(shape.controller);
    for (std::size_t i = 0; i < shape.lines.size(); ++i) {
      const bool isPost = shape.controller == "hips" && i >= 2;
      CHECK((glm::length(shape.lines[i].front() - shape.lines[i].back()) < 1e-9) != isPost);
    }
  }
  const std::vector<std::vector<Vec3>>& box = shaped.linesOf("hips");
  REQUIRE(box.size() == 6);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    CHECK(box[0][corner].y < box[1][corner].y);
    CHECK(box[2 + corner] == std::vector<Vec3>{box[0][corner], box[1][corner]});
  }
}

TEST_CASE("shapes of a character without a mesh are as large as its legs are long") {
  const double size = GENERATE(1.0, 2.5);
  SyntheticBiped body = bonesAlone();
  body.size = size;
  const Shaped shaped(still(body));
  const double leg = shaped.moving.limb("left-leg").restLength;
  REQUIRE(leg == Approx(0.83 * size).epsilon(0.01)); // from 0.92 over 0.50 to 0.09, a little bent
  const double armOfLeg = shaped.moving.limb("left-arm").restLength / leg;
  checkBounds(shaped.boundsOf("hips"), leg * Vec3(-0.15, -0.11, -0.15), leg * Vec3(0.15, 0.11, 0.15));
  for (const char* const foot : {"left-foot", "right-foot"}) {
    checkBounds(shaped.boundsOf(foot), leg * Vec3(-0.07, 0.0, -0.15), leg * Vec3(0.07, 0.0, 0.15));
  }
  for (const char* const hand : {"left-hand", "right-hand"}) {
    const Bounds bounds = shaped.boundsOf(hand); // a circle across the arm, about the wrist
    CHECK(glm::length(bounds.high + bounds.low) < 1e-6);
    CHECK(bounds.high.y == Approx(0.12 * armOfLeg * leg).epsilon(1e-3));
    CHECK(bounds.high.z == Approx(0.12 * armOfLeg * leg).epsilon(1e-3));
    CHECK(bounds.high.x < 0.02 * armOfLeg * leg);
  }
  // The sickle stands a tenth of a leg above the head and reaches from 36 to 144 degrees.
  const double reach = 1.1 * 0.12 * leg;
  const Bounds head = shaped.boundsOf("head");
  CHECK(head.low.y == Approx(0.1 * leg + reach * std::sin(0.2 * pi)));
  CHECK(head.high.y == Approx(0.1 * leg + 1.2 * reach));
  CHECK(head.high.x == Approx(-head.low.x));
  CHECK(head.high.z - head.low.z == Approx(0.0).margin(1e-9));
  for (const char* const ring : {"spine-low", "spine-mid", "spine-top"}) {
    CAPTURE(ring);
    CHECK(shaped.boundsOf(ring).high.x == Approx(0.2 * leg).epsilon(1e-6));
    CHECK(shaped.boundsOf(ring).low.x == Approx(-0.2 * leg).epsilon(1e-6));
  }
}

TEST_CASE("four arrows lie on the floor around the body: ahead, to its left, behind and to its right") {
  SyntheticBiped body = bonesAlone();
  body.facesBackwards = GENERATE(false, true);
  const double ahead = body.facesBackwards ? -1.0 : 1.0;
  const Shaped shaped(still(body));
  const double leg = shaped.moving.limb("left-leg").restLength;
  const std::vector<std::vector<Vec3>>& arrows = shaped.linesOf("body");
  REQUIRE(arrows.size() == 4);
  const std::vector<Vec3> ways{{0, 0, ahead}, {ahead, 0, 0}, {0, 0, -ahead}, {-ahead, 0, 0}};
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    CAPTURE(i);
    REQUIRE(arrows[i].size() == 8);
    const Vec3 across = glm::cross(Vec3(0, 1, 0), ways[i]);
    const double from = 1.1 * 0.3 * leg;
    const double length = 0.22 * leg;
    const Vec3 tip = (from + length) * ways[i];
    CHECK(glm::length(arrows[i][3] - tip) < 1e-6);
    CHECK(glm::length(arrows[i][0] - (from * ways[i] + 0.16 * length * across)) < 1e-6);
    CHECK(glm::length(arrows[i][2] - ((from + 0.5 * length) * ways[i] + 0.42 * length * across)) < 1e-6);
    CHECK(glm::length(arrows[i][4] - ((from + 0.5 * length) * ways[i] - 0.42 * length * across)) < 1e-6);
  }
}

TEST_CASE("the sizes of a body without legs go by another limb") {
  SyntheticBiped body = makeSnake();
  nameByKeys(body);
  body.withMesh = false;
  const Shaped snake(still(body));
  REQUIRE_FALSE(snake.moving.body.limbs.empty());
  const double length = snake.moving.body.limbs.front().restLength;
  REQUIRE(length > 0.5);
  for (const ControllerShape& shape : snake.shapes) {
    if (shape.controller.starts_with("spine")) {
      const Bounds ring = snake.boundsOf(shape.controller);
      CHECK(glm::length(ring.high - ring.low) ==
            Approx(glm::length(Vec3(0.4, 0.4, 0)) * length).epsilon(0.05));
    }
  }
}

TEST_CASE("Shapes of controllers on bodies of every build are as they were looked at") {
  std::string text;
  const auto add = [&](const std::string& title, const SyntheticBiped& body) {
    text += shapesText(title, Shaped(still(body)));
  };
  add("as usual", namedBody());
  add("without a mesh", bonesAlone());
  SyntheticBiped tubes = namedBody({.tips = true});
  tubes.tubes = true;
  add("tubes", tubes);
  SyntheticBiped large = namedBody({.spineJoints = 5, .neckJoints = 2, .clavicles = false});
  large.size = 3.0;
  large.facesBackwards = true;
  add("large, facing back", large);
  SyntheticBiped rigid = namedBody({.spineJoints = 1, .toes = false});
  rigid.withSkin = false;
  rigid.rigid = true;
  add("rigid parts, one spine joint", rigid);
  SyntheticBiped shortLegs = namedBody({.fingers = false});
  for (SyntheticJoint& joint : shortLegs.joints) {
    joint.position.y = joint.position.y < 0.95 ? 0.3 * joint.position.y : joint.position.y - 0.65;
  }
  add("short legs", shortLegs);
  add("no hands, no feet", namedBody({.hands = false, .feet = false}));
  for (Creature& creature : creatures()) {
    nameByKeys(creature.body);
    add(creature.title, creature.body);
    creature.body.withMesh = false;
    add(creature.title + ", without a mesh", creature.body);
  }
  const std::string difference = differenceFromRecord("shapes-of-controllers", text, 5e-4);
  INFO(difference);
  CHECK(difference.empty());
}

// What holds of every controller and every attribute of a character, each beside itself and on its other
// side.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/controllers/controller.h"
#include "tests/support/matrices.h"
#include "tests/support/rig/adjusted_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// All that can be keyed of a body: its controllers, those on its other joints, its attributes.
struct Keyed {
  std::vector<Controller> controllers;
  std::vector<Attribute> attributes;

  explicit Keyed(const MovingBiped& moving) {
    const ControllerList list = controllersOf(moving.scene, moving.body.limbs, moving.body.hips);
    controllers = list.controllers;
    attributes = list.attributes;
    const std::vector<Controller> joints =
        jointControllers(moving.scene, moving.body.limbs, moving.body.hips);
    controllers.insert(controllers.end(), joints.begin(), joints.end());
  }
};

Adjustment offset(const Controller& controller, const Vec3& move, const Vec3& turnDegrees, double frame) {
  Adjustment adjustment = moved(controller.id, controller.moves ? move : Vec3(0.0), frame);
  adjustment.keys[0].turn = (controller.turns ? turnDegrees : Vec3(0.0)) * (pi / 180.0);
  return adjustment;
}

/// Of any node, and of its stretch.
double difference(const FrameState& a, const FrameState& b) {
  double largest = largestMatrixMiss(a, b);
  for (std::size_t node = 0; node < a.worlds.size(); ++node) {
    const Mat3 ofA = a.stretch.empty() ? Mat3(1.0) : a.stretch[node];
    const Mat3 ofB = b.stretch.empty() ? Mat3(1.0) : b.stretch[node];
    largest = std::max(largest, largestDifference(ofA, ofB));
  }
  return largest;
}

/// Hands, feet, chest and head out of reach, so that every attribute has something to act on.
std::vector<Adjustment> strained() {
  return {moved("left-hand", Vec3(0.5, 0.3, 0.1)),   moved("right-hand", Vec3(-0.5, 0.3, 0.1)),
          moved("left-foot", Vec3(0.2, -0.4, 0.0)),  moved("right-foot", Vec3(-0.2, -0.4, 0.0)),
          moved("spine-top", Vec3(0.02, 0.2, 0.05)), moved("head", Vec3(0.02, 0.15, 0.05)),
          moved("hips", Vec3(0.03, 0.05, 0.02)),     turned("hips", Vec3(5, 20, 10))};
}

void checkTwoRanges(const MovingBiped& moving, const std::vector<Adjustment>& base, const Adjustment& first,
                    const Adjustment& second) {
  const auto at = [&](std::vector<Adjustment> more, double frame) {
    more.insert(more.begin(), base.begin(), base.end());
    return atFrame(moving, adjusted(moving, more), frame);
  };
  CHECK(difference(at({first, second}, 4.0), at({first}, 4.0)) < 1e-12);
  CHECK(difference(at({first, second}, 12.0), at({second}, 12.0)) < 1e-12);
  CHECK(difference(at({first, second}, 8.0), at({}, 8.0)) < 1e-12);
  CHECK(difference(at({first}, 4.0), at({}, 4.0)) > 1e-4); // It does something.
  CHECK(difference(at({second}, 12.0), at({}, 12.0)) > 1e-4);
}

/// Across the plane between left and right.
Vec3 mirroredPlace(const Vec3& place) {
  return {-place.x, place.y, place.z};
}
Vec3 mirroredTurn(const Vec3& turn) {
  return {turn.x, -turn.y, -turn.z};
}

std::string onOtherSide(std::string id) {
  for (const auto& [from, to] : {std::pair("left", "right"), std::pair("_L", "_R"), std::pair(".l", ".r"),
                                 std::pair("Left", "Right")}) {
    if (const std::size_t place = id.find(from); place != std::string::npos) {
      return id.replace(place, std::string(from).size(), to);
    }
  }
  return {};
}

/// Farthest that a joint of the one is from where the other has the joint of the other side.
double mirrorMiss(const MovingBiped& moving, const FrameState& left, const FrameState& right) {
  double miss = 0.0;
  for (const auto& [key, node] : moving.node) {
    std::string other = key;
    if (key.ends_with(".l") || key.ends_with(".r")) {
      other.back() = key.back() == 'l' ? 'r' : 'l';
    }
    const Vec3 place = positionOf(left.worlds[at(node)]);
    miss = std::max(miss,
                    glm::length(mirroredPlace(place) - positionOf(right.worlds[at(moving.node.at(other))])));
  }
  return miss;
}

} // namespace

TEST_CASE("two ranges of any controller act each by itself, and nothing acts between them") {
  const MovingBiped moving = punchingBiped();
  for (const Controller& controller : Keyed(moving).controllers) {
    CAPTURE(controller.id);
    checkTwoRanges(moving, {},
                   within(offset(controller, Vec3(0.05, -0.04, 0.03), Vec3(10, 15, -8), 4.0), 2.0, 6.0),
                   within(offset(controller, Vec3(-0.03, -0.05, 0.06), Vec3(-12, 5, 9), 12.0), 10.0, 14.0));
  }
}

TEST_CASE("two ranges of any attribute act each by itself, and nothing acts between them") {
  const MovingBiped moving = punchingBiped();
  for (const Attribute& attribute : Keyed(moving).attributes) {
    CAPTURE(attribute.id);
    const double span = attribute.maximum - attribute.minimum;
    const bool isLow = attribute.standard < attribute.minimum + 0.5 * span;
    const double first = isLow ? attribute.minimum + 0.9 * span : attribute.minimum + 0.1 * span;
    const double second = isLow ? attribute.minimum + 0.6 * span : attribute.minimum + 0.4 * span;
    checkTwoRanges(moving, strained(), within(valued(attribute.id, first, 4.0), 2.0, 6.0),
                   within(valued(attribute.id, second, 12.0), 10.0, 14.0));
  }
}

TEST_CASE("offsets of any controller that lie over each other add up, and of values the last one counts") {
  const MovingBiped moving = punchingBiped();
  const Keyed keyed(moving);
  const Vec3 move(0.02, -0.03, 0.01);
  const Vec3 turn(4, -6, 3);
  for (const Controller& controller : keyed.controllers) {
    CAPTURE(controller.id);
    const Adjustment part = offset(controller, move, turn, 4.0);
    const Adjustment whole = offset(controller, 2.0 * move, 2.0 * turn, 4.0);
    CHECK(difference(atFrame(moving, adjusted(moving, {part, part}), 7.0),
                     atFrame(moving, adjusted(moving, {whole}), 7.0)) < 1e-9);
  }
  for (const Attribute& attribute : keyed.attributes) {
    CAPTURE(attribute.id);
    std::vector<Adjustment> both = strained();
    std::vector<Adjustment> last = strained();
    both.push_back(valued(attribute.id, attribute.minimum, 4.0));
    for (std::vector<Adjustment>* list : {&both, &last}) {
      list->push_back(valued(attribute.id, 0.5 * (attribute.minimum + attribute.maximum), 4.0));
    }
    CHECK(difference(atFrame(moving, adjusted(moving, both), 7.0),
                     atFrame(moving, adjusted(moving, last), 7.0)) < 1e-12);
  }
}

TEST_CASE("any controller and attribute of the right side does what the left one's does, mirrored") {
  const MovingBiped moving = still(namedBody());
  const Keyed keyed(moving);
  int pairs = 0;
  const auto check = [&](const std::string& id, const auto& adjustmentOf) {
    const std::string other = onOtherSide(id);
    if (other.empty()) {
      return;
    }
    CAPTURE(id, other);
    ++pairs;
    const FrameState left = atFrame(moving, adjusted(moving, adjustmentOf(id, false)), 0.0);
    const FrameState right = atFrame(moving, adjusted(moving, adjustmentOf(other, true)), 0.0);
    CHECK(mirrorMiss(moving, left, right) < 1e-6);
  };
  for (const Controller& controller : keyed.controllers) {
    check(controller.id, [&](const std::string& id, bool isMirrored) {
      Controller named = controller;
      named.id = id;
      const Vec3 move(0.06, -0.05, 0.08);
      const Vec3 turn(12, 20, -7);
      return std::vector<Adjustment>{offset(named, isMirrored ? mirroredPlace(move) : move,
                                            isMirrored ? mirroredTurn(turn) : turn, 0.0)};
    });
  }
  for (const Attribute& attribute : keyed.attributes) {
    check(attribute.id, [&](const std::string& id, bool) {
      std::vector<Adjustment> all{
          moved("left-hand", Vec3(0.5, 0.3, 0.1), 0.0), moved("right-hand", Vec3(-0.5, 0.3, 0.1), 0.0),
          moved("left-foot", Vec3(0.2, -0.4, 0.0), 0.0), moved("right-foot", Vec3(-0.2, -0.4, 0.0), 0.0)};
      all.push_back(valued(id, attribute.minimum + 0.7 * (attribute.maximum - attribute.minimum), 0.0));
      return all;
    });
  }
  CHECK(pairs >= 15);
}

TEST_CASE("a value beyond the least or the most of its attribute does what that does") {
  const MovingBiped moving = punchingBiped();
  for (const Attribute& attribute : Keyed(moving).attributes) {
    CAPTURE(attribute.id);
    const auto at = [&](double value) {
      std::vector<Adjustment> all = strained();
      all.push_back(valued(attribute.id, value, 4.0));
      return atFrame(moving, adjusted(moving, all), 4.0);
    };
    const double beyond = 0.5 * (attribute.maximum - attribute.minimum);
    CHECK(difference(at(attribute.minimum - beyond), at(attribute.minimum)) < 1e-12);
    CHECK(difference(at(attribute.maximum + beyond), at(attribute.maximum)) < 1e-12);
  }
}

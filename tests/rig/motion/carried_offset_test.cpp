#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr double frameOfTip = 12.0;

// A spine that is pulled over sideways, and turns the chest with it.
Trail bendingSpine() {
  Trail spine = connectedTrail("spine", 0, frameOfTip, 1.2);
  spine.id = 2;
  spine.settings.turnEnd = true;
  spine.settings.spheres = {{6.0, Vec3(0.3, 0.0, 0.0)}, {frameOfTip, Vec3(0.4, -0.1, 0.1)}};
  return spine;
}

struct Places {
  Vec3 hand{0.0};
  Quat carrier{1.0, 0.0, 0.0, 0.0}; // how the node that carries the arm is turned
};

Places placesOf(const MovingBiped& moving, const FrameState& frame) {
  const auto index = [&](const char* key) { return at(moving.node.at(key)); };
  return {positionOf(frame.worlds[index("hand.l")]), rotationOf(frame.worlds[index("clavicle.l")])};
}

} // namespace

TEST_CASE("what a trail adds to the hand turns with the spine that carries the arm") {
  const MovingBiped moving = punchingBiped();
  const Trail arm = connectedTrail("left-arm", 0, frameOfTip, 2.0);
  const Trail spine = bendingSpine();
  const auto at = [&](const std::vector<Trail>& trails, double frame) {
    return placesOf(moving, atFrame(moving, solved(moving, trails), frame));
  };
  for (const double frame : {9.0, frameOfTip, 14.0}) {
    const Places source = at({}, frame);
    const Places carried = at({spine}, frame);
    const Vec3 added = at({arm}, frame).hand - source.hand;
    const Quat turn = carried.carrier * glm::inverse(source.carrier);
    CAPTURE(frame);
    REQUIRE(glm::length(turn * added - added) > 1e-3);
    const Vec3 wanted = carried.hand + turn * added;
    CHECK(glm::length(at({arm, spine}, frame).hand - wanted) < 1e-6);
  }
}

#include "rig/adjust/controller_shapes.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/bounds.h"
#include "rig/adjust/solve_adjustments.h"
#include "tests/support/rig/moving_biped.h"

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

  [[nodiscard]] Bounds boundsOf(const std::string& id) const {
    const auto shape = std::ranges::find(shapes, id, &ControllerShape::controller);
    REQUIRE(shape != shapes.end());
    Bounds bounds;
    for (const std::vector<Vec3>& line : shape->lines) {
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

#include <string>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "tests/support/rig/held_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// A body whose elbows and knees lie on the lines of their limbs.
MovingBiped straightBiped(bool facesBackwards) {
  SyntheticBiped body = namedBody();
  body.facesBackwards = facesBackwards;
  for (const std::string side : {".l", ".r"}) {
    for (const auto& [base, middle, end] :
         {std::tuple("upperArm", "foreArm", "hand"), std::tuple("thigh", "shin", "foot")}) {
      jointOf(body, middle + side).position =
          0.5 * (jointOf(body, base + side).position + jointOf(body, end + side).position);
    }
  }
  return still(body);
}

} // namespace

TEST_CASE("a limb that never bends folds its elbow backwards and its knee forwards") {
  const std::string limb = GENERATE(from_range(handsAndFeet));
  const bool facesBackwards = GENERATE(false, true);
  CAPTURE(limb, facesBackwards);
  const MovingBiped moving = straightBiped(facesBackwards);
  const std::vector<Vec3> points = limbPoints(moving.limb(limb), sourceAtFrame(moving, 0).worlds);
  REQUIRE(points.size() == 3);
  Holds holds;
  holds.pins = {pinAt(limb, heldOver(0, 0), 0)};
  holds.pins.front().place =
      HeldPlace{points.front() + 0.8 * (points.back() - points.front()), Quat(1, 0, 0, 0)};
  const FrameState folded = atFrame(moving, held(moving, holds), 0);
  const double forward = facesBackwards ? -1.0 : 1.0;
  const double ahead = forward * (limbPoints(moving.limb(limb), folded.worlds)[1].z - points[1].z);
  CHECK((limb.ends_with("leg") ? ahead : -ahead) > 0.05);
}

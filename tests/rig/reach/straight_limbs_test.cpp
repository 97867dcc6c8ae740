#include <string>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/reach/limb_reach.h"
#include "rig/reach/limb_weight.h"
#include "tests/support/nodes.h"
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

TEST_CASE("a straight leg whose foot is put elsewhere on its line is scaled as a whole and stays straight") {
  const double share = GENERATE(0.7, 0.9, 1.3);
  const MovingBiped moving = straightBiped(false);
  const Limb& leg = moving.limb("left-leg");
  FrameState frame = sourceAtFrame(moving, 0);
  const std::vector<Vec3> before = limbPoints(leg, frame.worlds);
  const LimbTopology topology = limbTopology(moving.scene, leg, moving.body.limbs, bindPlaces(moving.scene));
  bendBack(moving.scene, leg, topology, before[0] + share * (before[2] - before[0]), frame);
  const std::vector<Vec3> after = limbPoints(leg, frame.worlds);
  CAPTURE(share);
  for (std::size_t i = 0; i < before.size(); ++i) {
    CHECK(glm::length(after[i] - before[0] - share * (before[i] - before[0])) < 1e-6);
  }
}

TEST_CASE("a limb bends at the joint that does, be it in the first or in the last frame of a clip alone") {
  const bool isFirst = GENERATE(true, false);
  CAPTURE(isFirst);
  Scene scene;
  Limb rope;
  rope.kind = LimbKind::chain;
  rope.id = "rope";
  rope.restLength = 4.0;
  for (int i = 0; i < 5; ++i) {
    rope.joints.push_back(addNode(scene, "joint", i == 0 ? NodeIndex::none : rope.joints.back(),
                                  Vec3(i == 0 ? 0.0 : 1.0, 0, 0)));
  }
  rope.endNode = rope.joints.back();
  rope.joints.pop_back();
  const Quat straight(1.0, 0.0, 0.0, 0.0);
  const Quat bent = axisAngle(Vec3(0, 0, 1), 0.5);
  Clip clip;
  clip.framesPerSecond = 24.0;
  clip.tracks.emplace_back(rotationTrack(
      rope.joints[3], Interpolation::step,
      {{0.0, isFirst ? bent : straight}, {0.5 / 24.0, straight}, {1.0, isFirst ? straight : bent}}));
  setEndsFromKeys(clip);
  const std::vector<Limb> limbs{rope};
  const BindPlaces places = bindPlaces(scene);
  CHECK(reachingLimb({scene, clip, limbs, places}, rope).bendPoint == 3); // else in the middle, at the second
}

TEST_CASE("a limb that never bends has its elbow at the joint nearest to its middle") {
  const auto [along, elbow] = GENERATE(table<std::vector<double>, std::size_t>(
      {{{0, 3, 4, 5, 6}, 1}, {{0, 1, 2, 3, 4}, 2}, {{0, 1, 2, 3, 6}, 3}}));
  Scene scene;
  Limb rope;
  rope.kind = LimbKind::chain;
  rope.id = "rope";
  rope.restLength = along.back();
  for (std::size_t i = 0; i < along.size(); ++i) {
    const NodeIndex above = i == 0 ? NodeIndex::none : rope.joints.back();
    rope.joints.push_back(addNode(scene, "joint", above, Vec3(i == 0 ? 0.0 : along[i] - along[i - 1], 0, 0)));
  }
  rope.endNode = rope.joints.back();
  rope.joints.pop_back();
  const Clip clip;
  const std::vector<Limb> limbs{rope};
  const BindPlaces places = bindPlaces(scene);
  CHECK(reachingLimb({scene, clip, limbs, places}, rope).bendPoint == elbow);
}

TEST_CASE("a body faces as its legs say, as its arms do where its legs stand in one place, and else ahead") {
  Scene scene;
  std::vector<Limb> limbs;
  // Arms that are crossed in the bind pose.
  for (const auto& [place, x] : {std::pair(biped::leftArm, -0.2), std::pair(biped::rightArm, 0.2),
                                 std::pair(biped::leftLeg, 0.1), std::pair(biped::rightLeg, -0.1)}) {
    Limb limb;
    static_cast<LimbPlace&>(limb) = place;
    limb.joints = {addNode(scene, "base", NodeIndex::none, Vec3(x, 1.0, 0.0))};
    limbs.push_back(limb);
  }
  const auto facing = [&] { return facingInBind(limbs, bindPlaces(scene)); };
  CHECK(glm::length(facing() - Vec3(0.0, 0.0, 1.0)) < 1e-12);
  scene.nodes[at(limbs[2].joints[0])].rest.translation.x = -0.1;
  CHECK(glm::length(facing() - Vec3(0.0, 0.0, -1.0)) < 1e-12);
  limbs.clear();
  CHECK(facing() == Vec3(0.0, 0.0, 1.0));
}

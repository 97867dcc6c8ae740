#include "rig/motion/seam.h"

#include <optional>
#include <string>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// A second in which the hips get from where they rest to `travel` beside it.
MovingBiped walking(const Vec3& travel) {
  MovingBiped moving = still(namedBody());
  moving.clip.endSeconds = 1.0;
  const NodeIndex hips = moving.node.at("hips");
  const Vec3 rest = moving.scene.nodes[at(hips)].rest.translation;
  moving.clip.tracks.emplace_back(
      vectorTrack(hips, Channel::translation, Interpolation::linear,
                  {{0.0, rest}, {0.5, rest + Vec3(0.0, 0.5, 0.0)}, {1.0, rest + travel}}));
  return moving;
}

std::optional<Vec3> travelOf(const MovingBiped& moving) {
  return loopTravel(moving.scene, moving.clip, moving.body.hips, moving.body.height);
}

// At the end an arm is turned away from how it began.
void turnAnArm(MovingBiped& moving, double radians) {
  moving.clip.tracks.emplace_back(
      rotationTrack(moving.node.at("upperArm.l"), Interpolation::linear,
                    {{0.0, Quat(1, 0, 0, 0)}, {1.0, axisAngle(Vec3(0, 0, 1), radians)}}));
}

} // namespace

TEST_CASE("a clip that ends in its first pose loops, wherever on the ground its body has got") {
  for (const Vec3& travel : {Vec3(0.0), Vec3(0.0, 0.0, 1.4), Vec3(-3.0, 0.0, 0.2)}) {
    const std::optional<Vec3> found = travelOf(walking(travel));
    REQUIRE(found);
    CHECK(glm::length(*found - travel) < 1e-6);
  }
}

TEST_CASE("a body that ends higher or lower than it began does not loop, however far it travels") {
  for (const Vec3& travel : {Vec3(0.0, 0.3, 0.0), Vec3(0.0, -0.3, 0.0), Vec3(0.0, 0.3, 2.0)}) {
    CHECK_FALSE(travelOf(walking(travel)));
  }
  CHECK(travelOf(walking(Vec3(0.0, 0.01, 0.0)))); // less than a hundredth of its height
}

TEST_CASE("a clip whose last pose is another does not loop, one without a length neither") {
  MovingBiped bent = walking(Vec3(0.0));
  turnAnArm(bent, 0.5);
  CHECK_FALSE(travelOf(bent));
  MovingBiped nearly = walking(Vec3(0.0));
  turnAnArm(nearly, 0.01);
  CHECK(travelOf(nearly));
  MovingBiped pose = walking(Vec3(0.0));
  pose.clip.endSeconds = pose.clip.startSeconds;
  CHECK_FALSE(travelOf(pose));
}

TEST_CASE("what does not hang on the hips goes along with them or stays, and what does goes along") {
  const Vec3 travel(0.0, 0.0, 1.4);
  const auto goesOn = [&](const std::string& key, const Vec3& way) {
    SyntheticBiped body = namedBody();
    body.joints.push_back({"camera", "root", Vec3(1.0, 1.0, 1.0), false, false});
    MovingBiped moving = still(body);
    const MovingBiped walk = walking(travel);
    moving.clip.endSeconds = 1.0;
    moving.clip.tracks = walk.clip.tracks;
    const NodeIndex node = moving.node.at(key);
    const Vec3 rest = moving.scene.nodes[at(node)].rest.translation;
    moving.clip.tracks.emplace_back(
        vectorTrack(node, Channel::translation, Interpolation::linear, {{0.0, rest}, {1.0, rest + way}}));
    return travelOf(moving).has_value();
  };
  CHECK(goesOn("camera", travel));
  CHECK(goesOn("camera", Vec3(0.0)));
  CHECK_FALSE(goesOn("camera", 0.5 * travel));
  CHECK_FALSE(goesOn("head", -travel)); // it stays where it was, in the world
}

TEST_CASE("without hips a clip that travels does not loop, and one that stands does") {
  const auto withoutHips = [](MovingBiped moving) {
    moving.body.hips = NodeIndex::none;
    return travelOf(moving);
  };
  CHECK_FALSE(withoutHips(walking(Vec3(0.0, 0.0, 1.4))));
  CHECK(withoutHips(walking(Vec3(0.0))));
}

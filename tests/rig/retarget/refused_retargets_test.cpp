// Clips that are not brought over: too long, stopped on the way, or to joints whose names say not which.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "rig/retarget/copy_tracks.h"
#include "rig/retarget/retarget.h"
#include "tests/support/refusal.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using test::MovingBiped;

TEST_CASE("A clip of more frames than anybody can look at is refused by its name") {
  MovingBiped moving = test::punchingBiped();
  const std::optional<Skeleton> skeleton = skeletonOf(moving.scene, moving.body);
  REQUIRE(skeleton);
  moving.clip.name = "eons";
  moving.clip.endSeconds = 1e7;
  const std::string refused = test::refusal(retarget(*skeleton, moving.clip, *skeleton));
  CHECK_THAT(refused, Catch::StartsWith("eons") && Catch::Contains("the clip is too long"));
}

TEST_CASE("Bringing a clip over is stopped wherever it has come to") {
  const MovingBiped moving = test::punchingBiped();
  const std::optional<Skeleton> skeleton = skeletonOf(moving.scene, moving.body);
  REQUIRE(skeleton);
  double told = 0.0;
  const auto until = [&](double share) {
    told = 0.0;
    return retarget(*skeleton, moving.clip, *skeleton, [&told, share](double done) {
      told = done;
      return done < share;
    });
  };
  for (const double share : {0.0, 0.2, 0.65, 0.85}) { // followed first, then posed
    CAPTURE(share);
    CHECK_THAT(test::refusal(until(share)), Catch::Contains("stopped before the clip was brought over"));
    CHECK(told >= share);
    CHECK(told < share + 0.4);
  }
  CHECK(until(2.0));
}

TEST_CASE(
    "A track of a name that two joints have goes to neither, one that a mesh has as well to the joint") {
  const MovingBiped moving = test::punchingBiped();
  const NodeIndex arm = moving.node.at("upperArm.l");
  const std::string name = moving.scene.nodes[at(arm)].name;
  MovingBiped other = test::still(test::namedBody());
  other.scene.nodes[at(other.node.at("hand.r"))].name = name;
  const CopiedTracks twice = copyTracks(moving.scene, moving.clip, other.scene);
  CHECK(twice.missing == std::vector<std::string>{name});
  CHECK(findTrack(twice.clip, other.node.at("upperArm.l"), Channel::rotation) < 0);
  CHECK(findTrack(twice.clip, other.node.at("hand.r"), Channel::rotation) < 0);
  MovingBiped beside = test::still(test::namedBody());
  Node mesh;
  mesh.name = name;
  beside.scene.nodes.push_back(mesh);
  const CopiedTracks once = copyTracks(moving.scene, moving.clip, beside.scene);
  CHECK(once.missing.empty());
  CHECK(findTrack(once.clip, beside.node.at("upperArm.l"), Channel::rotation) >= 0);
}

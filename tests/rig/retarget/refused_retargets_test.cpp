// Clips that are not brought over: too long, stopped on the way, or to joints whose names say not which.
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
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

namespace {

// Two persons with the same names. The clip moves the first one's left arm, and the other one likewise.
MovingBiped twoOfOneName() {
  test::SyntheticBiped two = test::namedBody();
  test::addOther(two, test::namedBody(), Vec3(3.0, 0.0, 0.0));
  MovingBiped both = test::still(two);
  for (const auto& [key, node] : both.node) {
    if (key.starts_with("other ")) {
      both.scene.nodes[at(node)].name = both.scene.nodes[at(both.node.at(key.substr(6)))].name;
    }
  }
  for (const char* const key : {"upperArm.l", "foreArm.l", "other upperArm.l", "other foreArm.l"}) {
    const double angle = std::string(key).starts_with("other") ? 0.3 : 0.6;
    both.clip.tracks.emplace_back(
        test::rotationTrack(both.node.at(key), Interpolation::linear,
                            {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {1.0, axisAngle(Vec3(0.0, 1.0, 0.0), angle)}}));
  }
  setEndsFromKeys(both.clip);
  return both;
}

} // namespace

TEST_CASE("Of two characters with the same names one gives its tracks, and the other one's nodes are named") {
  MovingBiped both = twoOfOneName();
  const MovingBiped to = test::still(test::namedBody());
  const auto copied = [&](const char* hips) {
    return copyTracks(both.scene, both.clip, to.scene, to.body.hips, both.node.at(hips));
  };
  for (const auto& [hips, source] : {std::pair("hips", 0), std::pair("other hips", 2)}) {
    CAPTURE(hips);
    const CopiedTracks one = copied(hips);
    REQUIRE(one.clip.tracks.size() == 2);
    CHECK(one.clip.tracks[0]->node == to.node.at("upperArm.l"));
    CHECK(one.clip.tracks[1]->node == to.node.at("foreArm.l"));
    CHECK(one.clip.tracks[0]->values == both.clip.tracks[at(source)]->values);
    CHECK(one.joints == 2);
    CHECK(one.missing.empty());
    CHECK(one.ofOthers.size() == 2);
  }
  both.clip.tracks.erase(both.clip.tracks.begin(), both.clip.tracks.begin() + 2);
  const CopiedTracks alone = copied("hips"); // who does not move
  REQUIRE(alone.clip.tracks.size() == 2);
  CHECK(alone.clip.tracks[0]->values == both.clip.tracks[0]->values);
  CHECK(alone.ofOthers.empty());
}

TEST_CASE("Two nodes of one character that have one name and move give their tracks to no node") {
  MovingBiped twice = test::punchingBiped();
  const MovingBiped to = test::still(test::namedBody());
  const std::string name = twice.scene.nodes[at(twice.node.at("upperArm.l"))].name;
  twice.scene.nodes[at(twice.node.at("foreArm.l"))].name = name;
  const CopiedTracks copied = copyTracks(twice.scene, twice.clip, to.scene, to.body.hips, twice.body.hips);
  CHECK(std::ranges::count(copied.missing, name) == 2);
  std::set<std::pair<NodeIndex, Channel>> taken;
  for (const CopyOnWrite<Track>& track : copied.clip.tracks) {
    CHECK(taken.emplace(track->node, track->channel).second);
  }
}

TEST_CASE("A node of another character is named once, however many of its channels move") {
  MovingBiped both = twoOfOneName();
  const NodeIndex upper = both.node.at("other upperArm.l");
  both.clip.tracks.emplace_back(test::vectorTrack(upper, Channel::translation, Interpolation::linear,
                                                  {{0.0, Vec3(0.0)}, {1.0, Vec3(0.1)}}));
  const MovingBiped to = test::still(test::namedBody());
  const CopiedTracks one = copyTracks(both.scene, both.clip, to.scene, to.body.hips, both.node.at("hips"));
  CHECK(one.ofOthers == std::vector<std::string>{both.scene.nodes[at(upper)].name,
                                                 both.scene.nodes[at(both.node.at("foreArm.l"))].name});
  CHECK(one.joints == 2);
}

TEST_CASE("A copied joint counts once, and one that is missing is named once: by its number without a name") {
  MovingBiped from = test::still(test::namedBody());
  MovingBiped to = test::still(test::namedBody());
  for (MovingBiped* const body : {&from, &to}) { // One node alone has no name.
    for (std::size_t i = 0; i < body->scene.nodes.size(); ++i) {
      Node& node = body->scene.nodes[i];
      node.name = node.name.empty() ? "node " + std::to_string(i) : node.name;
    }
    body->scene.nodes[at(body->node.at("toe.l"))].name.clear();
  }
  for (const char* const key : {"upperArm.l", "foreArm.l", "toe.l", "hand.l"}) {
    const NodeIndex node = from.node.at(key);
    Track turns = test::rotationTrack(node, Interpolation::linear, {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}});
    turns.sourceChannel = 3;
    from.clip.tracks.emplace_back(turns);
    from.clip.tracks.emplace_back(
        test::vectorTrack(node, Channel::translation, Interpolation::linear, {{0.0, Vec3(0.1)}}));
  }
  setEndsFromKeys(from.clip);
  const auto nameOf = [&](const char* key) { return from.scene.nodes[at(from.node.at(key))].name; };
  to.scene.nodes[at(to.node.at("foreArm.l"))].name = "elsewhere";
  to.scene.nodes[at(to.node.at("hand.l"))].isBindLeaf = true; // It carries a stretch, and is no joint.
  const CopiedTracks copied = copyTracks(from.scene, from.clip, to.scene);
  CHECK(copied.joints == 1);
  CHECK(copied.missing == std::vector<std::string>{nameOf("foreArm.l"),
                                                   "#" + std::to_string(from.node.at("toe.l").value),
                                                   nameOf("hand.l")});
  REQUIRE(copied.clip.tracks.size() == 2);
  for (const CopyOnWrite<Track>& track : copied.clip.tracks) {
    CHECK(track->node == to.node.at("upperArm.l"));
    CHECK(track->sourceChannel == -1); // It is in no file yet, as its clip.
  }
  CHECK(copied.clip.sourceIndex == -1);
}

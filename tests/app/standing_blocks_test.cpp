// What a foot may stand on beside the floor.
#include <memory>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/standing_floor.h"
#include "rig/motion/evaluate.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/standing_leg.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::app;

namespace {

struct BlockNodes {
  NodeIndex holder;
  NodeIndex block;
};

/// The stepper beside a box of half a metre, which hangs on a node of its own.
Document besideBlock(BlockNodes& nodes) {
  Document document = test::stepper();
  Scene scene = *document.scene;
  Primitive box;
  for (const float x : {-0.25F, 0.25F}) {
    for (const float y : {0.0F, 0.5F}) {
      for (const float z : {-0.25F, 0.25F}) {
        box.positions.emplace_back(x, y, z);
      }
    }
  }
  box.indices = {0, 1, 2, 5, 6, 7};
  scene.meshes.push_back({"Box", {box}, {}});
  nodes.holder = test::addNode(scene, "Holder", NodeIndex::none, {0.0, 0.0, 1.0});
  nodes.block = test::addNode(scene, "Block", nodes.holder, {0.0, 0.0, 0.0});
  scene.nodes[at(nodes.block)].mesh = static_cast<int>(scene.meshes.size()) - 1;
  document.scene = std::make_shared<const Scene>(std::move(scene));
  return document;
}

Document withKeysOn(Document document, NodeIndex node) {
  std::vector<Clip> clips = *document.clips;
  Track track;
  track.node = node;
  track.times = {0.0F, 1.0F};
  track.values = {0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 2.0F};
  clips.front().tracks.emplace_back(track);
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  return document;
}

} // namespace

TEST_CASE("A foot stands on what holds a mesh and stands still, no skin bends and is no part of the body") {
  BlockNodes nodes;
  const Document document = besideBlock(nodes);
  const std::vector<Bounds> blocks = blocksOf(document, 0);
  REQUIRE(blocks.size() == 1);
  CHECK(blocks[0].low == Vec3(-0.25, 0.0, 0.75));
  CHECK(blocks[0].high == Vec3(0.25, 0.5, 1.25));
  CHECK(blocksOf(withKeysOn(document, nodes.block), 0).empty());
  CHECK(blocksOf(withKeysOn(document, nodes.holder), 0).empty());
  CHECK(blocksOf(withKeysOn(document, document.body.hips), 0).size() == 1);
  const int skin = GENERATE(0, 1);
  Document skinned = document;
  Scene scene = *document.scene;
  scene.nodes[at(nodes.block)].skin = skin;
  skinned.scene = std::make_shared<const Scene>(scene);
  CHECK(blocksOf(skinned, 0).empty());
  scene.nodes[at(nodes.block)].skin = -1;
  scene.nodes[at(nodes.block)].parent = document.body.hips;
  scene.nodes[at(nodes.holder)].children.clear();
  scene.nodes[at(document.body.hips)].children.push_back(nodes.block);
  Document worn = document;
  worn.scene = std::make_shared<const Scene>(scene);
  CHECK(blocksOf(worn, 0).empty());
  CHECK(blockTopUnder(blocks, Vec3(0.0, 2.0, 1.0)) == 0.5);
  CHECK_FALSE(blockTopUnder(blocks, Vec3(0.3, 2.0, 1.0)));
}

TEST_CASE("What a hand holds in a clip is nothing to stand on there, and in another clip it is") {
  BlockNodes nodes;
  Document document = besideBlock(nodes);
  rig::Prop prop;
  prop.node = GENERATE("Block", "Holder");
  CAPTURE(prop.node);
  for (const int clip : {0, 1}) {
    prop.clip = clip;
    document.holds.props = {prop};
    CHECK(blocksOf(document, 0).size() == (clip == 0 ? 0 : 1));
  }
  prop.clip = 0;
  prop.node = "Gone";
  document.holds.props = {prop};
  CHECK(blocksOf(document, 0).size() == 1);
}

TEST_CASE("A leg that is lifted stops at the block under its foot, and at the floor beside and above one") {
  BlockNodes nodes;
  Document document = besideBlock(nodes);
  const rig::Limb& leg = *findLimb(document, "left-leg");
  const double lifted = 25.0;
  const double floor = floorForLeg(document, 0, leg, lifted)->point.y;
  const Vec3 ankle = rig::endPosition(leg, rig::sampledFrame(*document.scene, clipOf(document, 0),
                                                             lifted / clipOf(document, 0).framesPerSecond));
  const double lowest = *standingFloor(document, 0, rig::bindPlaces(*document.scene)).floor;
  REQUIRE(ankle.y > lowest + 0.1);
  const auto floorWith = [&](const Vec3& topOfBlock) {
    Scene scene = *document.scene;
    scene.nodes[at(nodes.holder)].rest.translation = topOfBlock - Vec3(0.0, 0.5, 0.0);
    Document moved = document;
    moved.scene = std::make_shared<const Scene>(std::move(scene));
    return floorForLeg(moved, 0, leg, lifted)->point.y;
  };
  const double top = 0.5 * (lowest + ankle.y);
  CHECK(floorWith({ankle.x, top, ankle.z}) == Approx(floor + top - lowest));
  CHECK(floorWith({ankle.x + 0.24, top, ankle.z - 0.24}) == Approx(floor + top - lowest));
  CHECK(floorWith({ankle.x + 0.6, top, ankle.z}) == Approx(floor));
  CHECK(floorWith({ankle.x, ankle.y + 0.05, ankle.z}) == Approx(floor));
  CHECK(floorWith({ankle.x, lowest - 0.2, ankle.z}) == Approx(floor));
}

TEST_CASE(
    "Legs whose ends stand at other heights stand on one floor, each as far above it as its own sole says") {
  Document document = test::boxer();
  test::addStandingLeg(document); // Its foot is at 0.
  Scene scene = *document.scene;
  rig::Limb paw = *findLimb(document, "left-leg");
  paw.id = "right-leg";
  paw.side = rig::LimbSide::right;
  const NodeIndex elbow = test::addNode(scene, "Elbow", paw.joints[0], {0.0, -0.4, 0.2});
  paw.joints[1] = elbow;
  paw.endNode = test::addNode(scene, "Wrist", elbow, {0.0, -0.35, 0.0}); // At 0.25.
  for (const auto& [node, lower] :
       {std::pair(findLimb(document, "left-leg")->endNode, -0.05F), std::pair(paw.endNode, -0.2F)}) {
    Primitive sole;
    sole.positions = {{0.0F, lower, 0.0F}, {0.1F, lower, 0.0F}, {0.0F, lower, 0.1F}};
    sole.indices = {0, 1, 2};
    scene.nodes[at(node)].mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back({"sole", {sole}, {}});
  }
  document.body.limbs.push_back(paw);
  document.scene = std::make_shared<const Scene>(std::move(scene));
  const rig::BindPlaces places = rig::bindPlaces(*document.scene);
  const StandingFloor standing = standingFloor(document, 0, places);
  REQUIRE(standing.floor);
  CHECK(*standing.floor == Approx(-0.05).margin(1e-6));
  CHECK(*standingEnd(document, paw, places, standing) == Approx(0.15).margin(1e-6)); // It stands on
                                                                                     // something.
  CHECK(*standingEnd(document, *findLimb(document, "left-leg"), places, standing) ==
        Approx(0.0).margin(1e-6));
  CHECK(floorForLeg(document, 0, paw, 5.0)->point.y == Approx(0.15).margin(1e-6));
  CHECK_FALSE(standingEnd(document, paw, places, StandingFloor{}));
}

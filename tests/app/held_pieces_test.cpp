#include "app/bind/held_pieces.h"

#include <memory>

#include <catch2/catch.hpp>

#include "tests/support/nodes.h"

using namespace stretch;

namespace {

/// A hand with two fingers of two joints each and a joint of a thing, and two strips beside each other: one 1
/// long, one 3; fingers reach 1 apart.
struct HandWithThings {
  app::Document document;
  app::SkeletonToBind skeleton;
  app::BodyToBind body;
  std::vector<skinning::Influences> rows;

  HandWithThings() {
    Scene scene;
    const NodeIndex arm = test::addNode(scene, "arm", NodeIndex::none, Vec3(0.0));
    const NodeIndex hand = test::addNode(scene, "hand", arm, Vec3(1.0, 0.0, 0.0));
    add(arm, Vec3(0.0), -1);
    add(hand, Vec3(1.0, 0.0, 0.0), 0);
    for (const double side : {0.0, 1.0}) {
      const int first = static_cast<int>(skeleton.nodes.size());
      add(test::addNode(scene, "finger", hand, Vec3(0.5, side, 0.0)), Vec3(1.5, side, 0.0), 1);
      add(test::addNode(scene, "tip", skeleton.nodes.back(), Vec3(0.5, 0.0, 0.0)), Vec3(2.0, side, 0.0),
          first);
    }
    add(test::addNode(scene, "thing", hand, Vec3(1.0)), Vec3(2.0, 1.0, 1.0), 1);
    document.scene = std::make_shared<const Scene>(scene);
    rig::Limb limb;
    limb.kind = rig::LimbKind::arm;
    limb.id = "left-arm";
    limb.joints = {arm};
    limb.endNode = hand;
    document.body.limbs = {limb};
    for (const float length : {1.0F, 3.0F}) {
      const auto first = static_cast<std::uint32_t>(body.positions.size());
      body.positions.insert(body.positions.end(),
                            {{2.0F, 0.0F, length}, {2.0F, 0.1F, length}, {2.0F, 0.0F, 2.0F * length}});
      body.triangles.push_back({first, first + 1, first + 2});
    }
    rows.resize(body.positions.size());
  }

  void follow(std::uint16_t joint, std::size_t first, std::size_t end) {
    for (std::size_t v = first; v < end; ++v) {
      rows[v] = {};
      rows[v].bones[0] = joint;
      rows[v].weights[0] = 1.0F;
    }
  }
  [[nodiscard]] std::vector<std::string> hold() { return app::holdPieces(document, skeleton, body, rows); }

private:
  void add(NodeIndex node, const Vec3& place, int parent) {
    skeleton.nodes.push_back(node);
    skeleton.joints.push_back({place, parent});
  }
};

constexpr std::uint16_t armJoint = 0;
constexpr std::uint16_t handJoint = 1;
constexpr std::uint16_t tip = 3;
constexpr std::uint16_t thing = 6;

} // namespace

TEST_CASE("A long piece of the mesh that follows fingers follows the hand instead, and that is told") {
  HandWithThings held;
  held.follow(tip, 0, 6);
  const std::vector<std::string> told = held.hold();
  REQUIRE(told.size() == 1);
  CHECK(told.front() == "a thing of 3 vertices that the left-arm holds follows \"hand\" as one piece");
  for (std::size_t v = 3; v < 6; ++v) {
    CHECK(held.rows[v].bones[0] == handJoint);
    CHECK(held.rows[v].weights[0] == 1.0F);
  }
  // A piece no longer than fingers reach may be a finger.
  CHECK(held.rows[0].bones[0] == tip);
}

TEST_CASE("A hand without a name is told by its place in the file") {
  HandWithThings held;
  Scene scene = *held.document.scene;
  scene.nodes[1].name.clear();
  held.document.scene = std::make_shared<const Scene>(std::move(scene));
  held.follow(tip, 0, 6);
  const std::vector<std::string> told = held.hold();
  REQUIRE(told.size() == 1);
  CHECK(told.front() == "a thing of 3 vertices that the left-arm holds follows \"#1\" as one piece");
}

TEST_CASE("A mesh that follows fingers alone is held as a whole, its short pieces with it") {
  HandWithThings held;
  held.body.meshes.push_back({});
  held.follow(tip, 0, 6);
  const std::vector<std::string> told = held.hold();
  REQUIRE(told.size() == 1);
  CHECK(told.front() == "a thing of 6 vertices that the left-arm holds follows \"hand\" as one piece");
  CHECK(held.rows[0].bones[0] == handJoint);
}

TEST_CASE("A piece that the arm moves too, or that has a joint of its own, is no thing that fingers hold") {
  for (const std::uint16_t joint : {armJoint, thing}) {
    INFO(joint);
    HandWithThings held;
    held.follow(tip, 0, 6);
    held.follow(joint, joint == armJoint ? 5 : 3, 6);
    CHECK(held.hold().empty());
    CHECK(held.rows[5].bones[0] == joint);
  }
}

TEST_CASE("A piece of which no more than the half follows fingers, or as long as two hands, is not held") {
  HandWithThings half;
  half.body.meshes.push_back({}); // as a whole six vertices
  half.follow(tip, 0, 3);
  half.follow(handJoint, 3, 6);
  CHECK(half.hold().empty());
  HandWithThings longAsTwo;
  longAsTwo.follow(tip, 0, 6);
  longAsTwo.body.positions[3].z = longAsTwo.body.positions[4].z = 12.0F;
  longAsTwo.body.positions[5].z = 14.0F;
  CHECK(longAsTwo.hold().empty());
  longAsTwo.body.positions[5].z = 14.01F;
  CHECK(longAsTwo.hold().size() == 1);
}

// Which nodes may be joints, and which skeletons stand in one another's place.
#include "rig/body/evidence/skeletons.h"

#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "rig/body/evidence/body_view.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::rig::body;

namespace {

Skin skinOf(const std::vector<NodeIndex>& joints) {
  Skin skin;
  skin.joints = joints;
  return skin;
}

/// Two joints of a skin two units apart, and a node between them that none lists.
struct ShinRow {
  Scene scene;
  NodeIndex below;
  NodeIndex between;
  NodeIndex above;

  explicit ShinRow(double height) {
    below = test::addNode(scene, "Shin", NodeIndex::none, Vec3(0.0));
    between = test::addNode(scene, "Knee", below, {0.0, height, 0.0});
    above = test::addNode(scene, "Foot", between, {0.0, 2.0 - height, 0.0});
    scene.skins.push_back(skinOf({below, above}));
  }
  [[nodiscard]] std::vector<bool> possible(Candidates candidates = Candidates::skinJoints) const {
    const BindPose bindPose = placeBindPose(scene);
    return possibleNodes(scene, bindPose, candidates, vertexClouds(scene, bindPose, RigidMeshes::bodyParts));
  }
};

bool isBetweenTaken(const ShinRow& row) {
  return row.possible()[at(row.between)];
}

} // namespace

TEST_CASE(
    "A bone between two joints of a skin is one as well where it stands apart from both and shows no mesh") {
  CHECK(isBetweenTaken(ShinRow(1.0)));
  CHECK(isBetweenTaken(ShinRow(0.05)));
  CHECK_FALSE(isBetweenTaken(ShinRow(0.03))); // A pivot.
  CHECK_FALSE(isBetweenTaken(ShinRow(1.97)));
  ShinRow shown(1.0);
  shown.scene.nodes[at(shown.between)].mesh = 0;
  shown.scene.meshes.push_back({"Guard", {}, {}});
  CHECK_FALSE(isBetweenTaken(shown));
}

TEST_CASE("What several rows of joints hang from is a joint where all of them begin about it") {
  for (const double away : {0.3, 0.4}) {
    Scene scene;
    const NodeIndex hips = test::addNode(scene, "Hips", NodeIndex::none, Vec3(0.0));
    std::vector<NodeIndex> joints;
    for (const double way : {-1.0, 1.0}) {
      joints.push_back(test::addNode(scene, "Thigh", hips, {0.0, way * away, 0.0}));
      joints.push_back(test::addNode(scene, "Shin", joints.back(), {0.0, way * (0.5 - away), 0.0}));
    }
    scene.skins.push_back(skinOf(joints)); // They reach from -0.5 to 0.5.
    const BindPose bindPose = placeBindPose(scene);
    const auto clouds = vertexClouds(scene, bindPose, RigidMeshes::bodyParts);
    CHECK(possibleNodes(scene, bindPose, Candidates::skinJoints, clouds)[at(hips)] == (away < 0.35));
    scene.skins.front().joints.resize(2); // One row alone.
    CHECK_FALSE(possibleNodes(scene, bindPose, Candidates::skinJoints, clouds)[at(hips)]);
  }
}

TEST_CASE("Joints that deform are those called DEF- and those that move a mesh") {
  ShinRow row(1.0);
  CHECK_FALSE(hasDeformJoints(row.scene));
  row.scene.nodes[at(row.below)].name = "DEF-shin";
  CHECK(hasDeformJoints(row.scene));
  CHECK(row.possible(Candidates::deformJoints) == std::vector<bool>{true, false, false});
  Primitive skin;
  skin.positions = {{0.0F, 2.0F, 0.0F}};
  skin.influences.resize(1);
  skin.influences.front().joints[0] = 1; // The foot.
  skin.influences.front().weights[0] = 1.0F;
  row.scene.meshes.push_back({"Shoe", {skin}, {}});
  const NodeIndex shoe = test::addNode(row.scene, "Shoe", NodeIndex::none, Vec3(0.0));
  row.scene.nodes[at(shoe)].mesh = 0;
  row.scene.nodes[at(shoe)].skin = 0;
  CHECK(row.possible(Candidates::deformJoints) == std::vector<bool>{true, false, true, false});
  CHECK(row.possible(Candidates::skinJoints) == std::vector<bool>{true, true, true, false});
}

TEST_CASE("A skeleton is a copy where half of its joints stand in the places of another's, or as many as "
          "those are") {
  const auto copies = [](std::size_t inPlace, std::size_t joints) {
    Scene scene;
    std::vector<NodeIndex> own;
    std::vector<NodeIndex> all;
    for (const bool isOwn : {true, false}) {
      NodeIndex above;
      for (std::size_t i = 0; i < (isOwn ? 6 : joints); ++i) {
        const bool isAside = !isOwn && i >= inPlace;
        const Vec3 place(isAside ? 5.0 : 0.0, static_cast<double>(i), 0.0);
        const Vec3 before = above.exists()
                                ? Vec3(!isOwn && i > inPlace ? 5.0 : 0.0, static_cast<double>(i) - 1.0, 0.0)
                                : Vec3(0.0);
        above = test::addNode(scene, "Joint", above, place - before);
        all.push_back(above);
        if (isOwn) {
          own.push_back(above);
        }
      }
    }
    scene.skins.push_back(skinOf(all));
    return copiesOf(scene, placeBindPose(scene), own).size();
  };
  CHECK(copies(6, 6) == 1);
  CHECK(copies(3, 6) == 1);
  CHECK(copies(2, 6) == 0);
  CHECK(copies(3, 12) == 1); // Half of its six.
  CHECK(copies(2, 12) == 0);
  CHECK(copies(0, 6) == 0);
}

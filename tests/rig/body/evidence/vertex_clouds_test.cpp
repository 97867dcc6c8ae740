// Which vertices follow which joint, and which rigid meshes are parts of a body.
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "rig/body/evidence/body_view.h"
#include "tests/support/nodes.h"

using namespace stretch;
using namespace stretch::rig::body;

namespace {

/// Four joints one above the other, a skin of three vertices on them, and rigid meshes.
struct SkinnedColumn {
  Scene scene;
  std::vector<NodeIndex> joints;

  SkinnedColumn() {
    Skin skin;
    for (int i = 0; i < 4; ++i) {
      const NodeIndex above = joints.empty() ? NodeIndex::none : joints.back();
      joints.push_back(test::addNode(scene, "joint", above, Vec3(0.0, i == 0 ? 0.0 : 1.0, 0.0)));
      skin.joints.push_back(joints.back());
      skin.inverseBind.push_back(glm::translate(Mat4(1.0), Vec3(0.0, -static_cast<double>(i), 0.0)));
    }
    scene.skins.push_back(skin);
    Primitive flesh;
    flesh.positions = {{0.1F, 0.5F, 0.0F}, {0.2F, 0.5F, 0.0F}, {0.3F, 0.5F, 0.0F}};
    flesh.influences.resize(3);
    flesh.influences[0].joints = {0, 1};
    flesh.influences[0].weights = {0.4F, 0.6F};
    flesh.influences[2].joints = {9}; // no joint of the skin; the second vertex follows none
    flesh.influences[2].weights = {1.0F};
    const NodeIndex holder = test::addNode(scene, "flesh", NodeIndex::none, Vec3(0.0));
    scene.nodes[at(holder)].skin = 0;
    scene.nodes[at(holder)].mesh = 0;
    scene.meshes.push_back({"flesh", {flesh}, {}});
  }

  NodeIndex hang(std::size_t joint) {
    Primitive plate;
    plate.positions = {{0.0F, 0.0F, 0.5F}};
    const NodeIndex part = test::addNode(scene, "plate", joints[joint], Vec3(0.25, 0.0, 0.0));
    scene.nodes[at(part)].mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back({"plate", {plate}, {}});
    return part;
  }

  [[nodiscard]] std::vector<std::vector<Vec3>> clouds(RigidMeshes rigid) const {
    return vertexClouds(scene, placeBindPose(scene), rigid);
  }
};

} // namespace

TEST_CASE("A vertex of a skin is with the joint of its greatest weight, and with none where it has no joint "
          "or weight") {
  SkinnedColumn column;
  column.hang(3);
  const std::vector<std::vector<Vec3>> clouds = column.clouds(RigidMeshes::none);
  REQUIRE(clouds.size() == column.scene.nodes.size());
  for (std::size_t node = 0; node < clouds.size(); ++node) {
    CAPTURE(node);
    CHECK(clouds[node].size() == (node == at(column.joints[1]) ? 1 : 0));
  }
  REQUIRE(clouds[at(column.joints[1])].size() == 1);
  CHECK(glm::distance(clouds[at(column.joints[1])].front(), Vec3(0.1, 0.5, 0.0)) < 1e-6);
}

TEST_CASE("Of a skinned body rigid meshes are parts on two joints in a row that move no vertices of a skin") {
  SkinnedColumn column;
  const NodeIndex prop = column.hang(3);
  CHECK(column.clouds(RigidMeshes::bodyParts)[at(prop)].empty()); // alone: it is held
  const NodeIndex worn = column.hang(1);
  CHECK(column.clouds(RigidMeshes::bodyParts)[at(worn)].empty());
  CHECK(column.clouds(RigidMeshes::bodyParts)[at(prop)].empty());
  const NodeIndex next = column.hang(2);
  const std::vector<std::vector<Vec3>> parts = column.clouds(RigidMeshes::bodyParts);
  REQUIRE(parts[at(prop)].size() == 1);
  REQUIRE(parts[at(next)].size() == 1);
  CHECK(parts[at(worn)].empty()); // over flesh
  CHECK(glm::distance(parts[at(prop)].front(), Vec3(0.25, 3.0, 0.5)) < 1e-6);
  CHECK(glm::distance(parts[at(next)].front(), Vec3(0.25, 2.0, 0.5)) < 1e-6);
  const std::vector<std::vector<Vec3>> all = column.clouds(RigidMeshes::all);
  for (const NodeIndex part : {prop, worn, next}) {
    CHECK(all[at(part)].size() == 1);
  }
}

TEST_CASE("Two joints beside each other that carry a rigid mesh each hold two things") {
  SkinnedColumn column;
  const NodeIndex left = column.hang(3);
  const NodeIndex other = test::addNode(column.scene, "joint", column.joints[2], Vec3(0.5, 1.0, 0.0));
  column.joints.push_back(other);
  column.scene.skins.front().joints.push_back(other);
  column.scene.skins.front().inverseBind.push_back(glm::translate(Mat4(1.0), Vec3(-0.5, -3.0, 0.0)));
  const NodeIndex right = column.hang(4);
  CHECK(column.clouds(RigidMeshes::bodyParts)[at(left)].empty());
  CHECK(column.clouds(RigidMeshes::bodyParts)[at(right)].empty());
}

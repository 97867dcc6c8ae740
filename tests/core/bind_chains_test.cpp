#include <catch2/catch.hpp>

#include <glm/geometric.hpp>

#include "core/anim/frame_state.h"
#include "core/scene/bind_chains.h"

using namespace stretch;

namespace {

constexpr int joint = 1;
constexpr int leaf = 2;

// A joint below a root, with a leaf in its slot of the skin and itself once more behind it. One vertex hangs
// on the slot.
Scene withRepeatedJoint(std::uint16_t slot) {
  Scene scene;
  scene.nodes.resize(4);
  scene.roots = {NodeIndex(0)};
  for (int child = 1; child <= leaf; ++child) {
    scene.nodes[at(child)].parent = NodeIndex(child - 1);
    scene.nodes[at(child - 1)].children = {NodeIndex(child)};
  }
  scene.nodes[at(leaf)].isBindLeaf = true;
  scene.skins.push_back({"skin", {NodeIndex(leaf), NodeIndex(joint)}, {Mat4(1.0), Mat4(1.0)}});
  VertexInfluences vertex;
  vertex.joints[0] = slot;
  vertex.weights[0] = 1.0F;
  Primitive primitive;
  primitive.positions = {glm::vec3(0.0F)};
  primitive.influences = {vertex};
  scene.meshes.push_back({"mesh", {primitive}, {}});
  scene.nodes[3].mesh = 0;
  scene.nodes[3].skin = 0;
  scene.roots.emplace_back(3);
  foldBindLeaves(scene);
  return scene;
}

} // namespace

TEST_CASE("A joint that stands behind the slot of its leaf is dropped, where no vertex hangs on it") {
  CHECK(withRepeatedJoint(0).skins[0].joints == std::vector{NodeIndex(joint)});
  CHECK(withRepeatedJoint(0).skins[0].inverseBind.size() == 1);
  CHECK(withRepeatedJoint(1).skins[0].joints == std::vector{NodeIndex(joint), NodeIndex(joint)});
}

namespace {

// A joint with four corners behind it in the skin; the vertex hangs on the joint and two of them. `stray`:
// what another program did to the last corner.
Scene withCorners(const Vec3& stray = Vec3(0.0), bool isShownTwice = false) {
  Scene scene;
  scene.nodes.resize(7);
  scene.roots = {NodeIndex(0), NodeIndex(6)};
  scene.nodes[0].children = {NodeIndex(1)};
  scene.nodes[1].parent = NodeIndex(0);
  const std::vector<Vec3> places{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(-1, -1, -1)};
  scene.skins.push_back({"skin", {NodeIndex(1)}, {Mat4(2.0)}});
  scene.skins[0].inverseBind[0][3] = Vec4(0.5, 0.0, 0.0, 1.0);
  for (std::size_t k = 0; k < places.size(); ++k) {
    Node& corner = scene.nodes[2 + k];
    corner.parent = NodeIndex(1);
    corner.isBindLeaf = true;
    corner.isBindCorner = true;
    corner.rest.translation = places[k] + (k == 3 ? stray : Vec3(0.0));
    scene.nodes[1].children.emplace_back(2 + k);
    Mat4 inverseBind = scene.skins[0].inverseBind[0];
    inverseBind[3] -= Vec4(places[k], 0.0);
    scene.skins[0].joints.emplace_back(2 + k);
    scene.skins[0].inverseBind.push_back(inverseBind);
  }
  VertexInfluences vertex;
  vertex.joints = {1, 0, 4};
  vertex.weights = {0.5F, 0.25F, 0.25F};
  Primitive primitive;
  primitive.positions = {glm::vec3(0.1F)};
  primitive.influences = {vertex};
  scene.meshes.push_back({"mesh", {primitive}, {}});
  scene.nodes[6].mesh = 0;
  scene.nodes[6].skin = 0;
  if (isShownTwice) {
    scene.skins.push_back(scene.skins[0]);
    scene.nodes[0].mesh = 0;
    scene.nodes[0].skin = 1;
  }
  foldBindLeaves(scene);
  return scene;
}

} // namespace

TEST_CASE("What hangs on corners follows their joint again, and their translations tell its stretch") {
  const Scene scene = withCorners();
  REQUIRE(scene.bindChains.size() == 1);
  CHECK(scene.bindChains[0].joint == NodeIndex(1));
  CHECK(scene.bindChains[0].corners.size() == 4);
  CHECK(scene.bindChains[0].corners[2].slotOf.at(0) == 3);
  CHECK(scene.skins[0].joints == std::vector{NodeIndex(1)});
  const VertexInfluences& vertex = scene.meshes[0].primitives[0].influences[0];
  CHECK(vertex.joints[0] == 0);
  CHECK(vertex.weights[0] == Approx(1.0));
  CHECK(vertex.weights[1] == 0.0F);
  const Mat3 atRest = stretchOf(scene, restPose(scene), scene.bindChains[0]);
  CHECK(glm::length(atRest[0] - Vec3(1, 0, 0)) + glm::length(atRest[1] - Vec3(0, 1, 0)) < 1e-8);
  const Mat3 stretch(Vec3(3.0, 0.1, 0.0), Vec3(0.1, 0.5, 0.0), Vec3(0.0, 0.0, 0.7));
  Pose pose = restPose(scene);
  for (const BindCorner& corner : scene.bindChains[0].corners) {
    pose.locals[at(corner.node)].translation = stretch * corner.place;
  }
  const Mat3 told = stretchOf(scene, pose, scene.bindChains[0]);
  for (int column = 0; column < 3; ++column) {
    CHECK(glm::length(told[column] - stretch[column]) < 1e-6);
  }
}

TEST_CASE("Corners that another program moved are ordinary joints") {
  const Scene scene = withCorners(Vec3(0.2, 0.0, 0.0));
  CHECK(scene.bindChains.empty());
  CHECK(scene.skins[0].joints.size() == 5);
  CHECK(scene.meshes[0].primitives[0].influences[0].joints[0] == 1);
}

TEST_CASE(
    "Corners of a mesh that two skins move are ordinary joints, the first mesh of a file as any other") {
  const Scene scene = withCorners(Vec3(0.0), true);
  CHECK(scene.bindChains.empty());
  CHECK(scene.skins[0].joints.size() == 5);
  CHECK(scene.skins[1].joints.size() == 5);
  CHECK(scene.meshes[0].primitives[0].influences[0].joints[0] == 1);
}

TEST_CASE("One end of a bone tells how long it is, and leaves its thickness alone") {
  Scene scene = withCorners();
  scene.bindChains[0].corners.resize(1);
  Pose pose = restPose(scene);
  pose.locals[2].translation = Vec3(2.5, 0.0, 0.0);
  const Mat3 told = stretchOf(scene, pose, scene.bindChains[0]);
  CHECK(glm::length(told[0] - Vec3(2.5, 0, 0)) < 1e-6);
  CHECK(glm::length(told[1] - Vec3(0, 1, 0)) < 1e-6);
  CHECK(glm::length(told[2] - Vec3(0, 0, 1)) < 1e-6);
}

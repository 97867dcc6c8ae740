#include "skinning/linear_blend_skinning.h"

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "tests/support/nodes.h"

using namespace stretch;
using skinning::NormalMatrix;

namespace {

constexpr float half = 0.5F;

VertexInfluences following(std::initializer_list<std::pair<int, float>> joints) {
  VertexInfluences influences;
  std::size_t i = 0;
  for (const auto& [joint, weight] : joints) {
    influences.joints[i] = static_cast<std::uint16_t>(joint);
    influences.weights[i++] = weight;
  }
  return influences;
}

/// Nodes "a" at (10, 0, 0) and "b" 5 above it; "skinned" shows a mesh of three vertices that follow a, b and
/// both, "prop" hangs on b and shows a mesh of one vertex with a morph target.
struct Stage {
  Stage() {
    a = test::addNode(scene, "a", NodeIndex::none, Vec3(10.0, 0.0, 0.0));
    b = test::addNode(scene, "b", a, Vec3(0.0, 5.0, 0.0));
    skinned = test::addNode(scene, "skinned", NodeIndex::none, Vec3(100.0, 0.0, 0.0));
    prop = test::addNode(scene, "prop", b, Vec3(0.0, 0.0, 1.0));
    Primitive three;
    three.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    three.normals.assign(3, glm::vec3(0, 0, 1));
    three.influences = {following({{0, 1.0F}}), following({{0, 0.25F}, {1, 0.75F}}),
                        following({{0, half}, {1, half}})};
    three.indices = {0, 1, 2, 2, 1, 0};
    scene.meshes.push_back({"three", {three}, {}});
    Primitive one;
    one.positions = {{1, 2, 3}};
    one.normals = {{1, 0, 0}};
    one.indices = {0, 0, 0};
    one.morphTargets = {{{{0, 0, 4}}, {{0, 2, 0}}}, {{}, {}}};
    scene.meshes.push_back({"one", {one}, {0.5F, 1.0F}});
    scene.nodes[at(skinned)].mesh = 0;
    scene.nodes[at(skinned)].skin = 0;
    scene.nodes[at(prop)].mesh = 1;
    scene.skins.push_back({"skin", {a, b}, {Mat4(1.0), Mat4(1.0)}, 0});
    pose = restPose(scene);
  }

  FrameState frame() const { return frameOf(scene, pose, 0.0); }
  std::vector<Vec3> places() const { return skinning::skinnedPositions(scene, frame()); }
  std::vector<Vec3> normals(NormalMatrix by = NormalMatrix::inverseTranspose) const {
    return skinning::skinnedNormals(scene, frame(), by);
  }

  Scene scene;
  NodeIndex a;
  NodeIndex b;
  NodeIndex skinned;
  NodeIndex prop;
  Pose pose;
};

void checkNear(const Vec3& is, const Vec3& wanted) {
  INFO(is.x << " " << is.y << " " << is.z << " instead of " << wanted.x << " " << wanted.y << " "
            << wanted.z);
  CHECK(glm::length(is - wanted) < 1e-6);
}

} // namespace

TEST_CASE("Skinned vertices follow their joints by weight and not their node, rigid ones their node") {
  Stage stage;
  std::vector<Vec3> places = stage.places();
  REQUIRE(places.size() == 4);
  checkNear(places[0], Vec3(10.0, 0.0, 0.0));
  checkNear(places[1], Vec3(11.0, 3.75, 0.0));
  checkNear(places[2], Vec3(10.0, 2.5, 1.0));
  checkNear(places[3], Vec3(11.0, 7.0, 6.0)); // with half of the target's 4
  stage.pose.locals[at(stage.b)].rotation = glm::angleAxis(glm::radians(90.0), Vec3(0.0, 0.0, 1.0));
  places = stage.places();
  checkNear(places[1], Vec3(10.0 + 0.25 * 1.0, 3.75 + 0.75 * 1.0, 0.0));
  checkNear(places[3], Vec3(8.0, 6.0, 6.0));
  stage.pose.weights[at(stage.prop)] = {-1.0F}; // the clip's instead of the mesh's
  checkNear(stage.places()[3], Vec3(8.0, 6.0, 0.0));
}

TEST_CASE(
    "A joint that the skin does not have moves nothing, and a mesh without influences follows its node") {
  Stage stage;
  stage.scene.meshes[0].primitives[0].influences[1] = following({{0, 0.25F}, {7, 0.75F}});
  checkNear(stage.places()[1], Vec3(2.75, 0.0, 0.0));
  stage.scene.meshes[0].primitives[0].influences.clear();
  checkNear(stage.places()[1], Vec3(101.0, 0.0, 0.0));
  stage.scene.nodes[at(stage.skinned)].skin = -1;
  checkNear(stage.places()[2], Vec3(100.0, 0.0, 1.0));
}

TEST_CASE("The eighth influence of a vertex counts as the first") {
  Stage stage;
  VertexInfluences influences;
  influences.joints.fill(0);
  influences.joints[7] = 1;
  influences.weights[7] = 1.0F;
  stage.scene.meshes[0].primitives[0].influences[0] = influences;
  checkNear(stage.places()[0], Vec3(10.0, 5.0, 0.0));
  CHECK(skinning::strongestNodes(stage.scene)[0] == stage.b);
}

TEST_CASE(
    "Normals stay upright on a surface that is scaled unevenly, turned and mirrored, with unit length") {
  Stage stage;
  Transform& a = stage.pose.locals[at(stage.a)];
  stage.scene.meshes[0].primitives[0].normals[0] = glm::vec3(1, 1, 0);
  a.scale = Vec3(2.0, 1.0, 1.0);
  checkNear(stage.normals()[0], glm::normalize(Vec3(0.5, 1.0, 0.0)));
  checkNear(stage.normals(NormalMatrix::plain)[0], glm::normalize(Vec3(2.0, 1.0, 0.0)));
  a.scale = Vec3(-1.0, 1.0, 1.0);
  checkNear(stage.normals()[0], glm::normalize(Vec3(-1.0, 1.0, 0.0)));
  a = {a.translation, glm::angleAxis(glm::radians(90.0), Vec3(0.0, 0.0, 1.0)), Vec3(1.0)};
  checkNear(stage.normals()[0], glm::normalize(Vec3(-1.0, 1.0, 0.0)));
  // Flattened to nothing in one direction there is still one that is upright, in all there is none: up.
  a = {a.translation, Quat(1.0, 0.0, 0.0, 0.0), Vec3(1.0, 0.0, 1.0)};
  checkNear(stage.normals()[0], Vec3(0.0, 1.0, 0.0));
  checkNear(stage.normals(NormalMatrix::plain)[0], Vec3(1.0, 0.0, 0.0));
  a.scale = Vec3(0.0);
  checkNear(stage.normals()[0], Vec3(0.0, 1.0, 0.0));
  checkNear(stage.normals(NormalMatrix::plain)[0], Vec3(0.0, 1.0, 0.0));
}

TEST_CASE("Rigid normals take the right matrix either way, and move by their targets") {
  Stage stage;
  stage.pose.locals[at(stage.prop)].scale = Vec3(1.0, 4.0, 1.0);
  // (1, 0, 0) and half of (0, 2, 0), by the inverse of the scale.
  const Vec3 wanted = glm::normalize(Vec3(1.0, 0.25, 0.0));
  checkNear(stage.normals()[3], wanted);
  checkNear(stage.normals(NormalMatrix::plain)[3], wanted);
}

TEST_CASE("Meshes of the default scene are drawn, each node once, in the order of the file") {
  Stage stage;
  CHECK(skinning::drawnMeshNodes(stage.scene) == std::vector<NodeIndex>{stage.skinned, stage.prop});
  stage.scene.roots = {stage.skinned, stage.a, stage.skinned};
  CHECK(skinning::drawnMeshNodes(stage.scene) == std::vector<NodeIndex>{stage.skinned, stage.prop});
  stage.scene.roots = {stage.a};
  CHECK(skinning::drawnMeshNodes(stage.scene) == std::vector<NodeIndex>{stage.prop});
  CHECK(stage.places().size() == 1);
  stage.scene.roots.clear();
  CHECK(skinning::drawnMeshNodes(stage.scene).empty());
}

TEST_CASE("The strongest node of a vertex is its heaviest joint, of a rigid mesh the node, and none that is "
          "not there") {
  Stage stage;
  CHECK(skinning::strongestNodes(stage.scene) ==
        std::vector<NodeIndex>{stage.a, stage.b, stage.a, stage.prop});
  stage.scene.meshes[0].primitives[0].influences[1] = following({{0, 0.25F}, {2, 0.75F}});
  CHECK(skinning::strongestNodes(stage.scene)[1] == NodeIndex::none);
  stage.scene.nodes[at(stage.skinned)].skin = -1;
  CHECK(skinning::strongestNodes(stage.scene)[1] == stage.skinned);
}

TEST_CASE("Triangles of all that is drawn count the vertices before them") {
  Stage stage;
  stage.scene.meshes[0].primitives.push_back(stage.scene.meshes[1].primitives[0]);
  CHECK(skinning::drawnTriangles(stage.scene) ==
        std::vector<Triangle>{{0, 1, 2}, {2, 1, 0}, {3, 3, 3}, {4, 4, 4}});
}

TEST_CASE("Engines turn nothing by a stretch that is told by translations") {
  Stage stage;
  FrameState frame = stage.frame();
  const Mat3 longer(2.0);
  frame.stretch.assign(4, longer);
  const auto turnedBy = [&](bool newToo) {
    std::vector<bool> kept;
    for (const Mat3& stretch : skinning::turningFrame(stage.scene, frame, newToo).stretch) {
      CHECK((stretch == longer || stretch == Mat3(1.0)));
      kept.push_back(stretch == longer);
    }
    return kept;
  };
  CHECK(turnedBy(false) == std::vector<bool>{true, true, true, true});
  CHECK(turnedBy(true) == std::vector<bool>{false, false, false, false});
  BindChain ofLeaf;
  ofLeaf.joint = stage.a;
  BindChain ofCorners;
  ofCorners.joint = stage.b;
  ofCorners.corners.emplace_back();
  stage.scene.bindChains = {ofLeaf, ofCorners};
  CHECK(turnedBy(false) == std::vector<bool>{true, false, true, true});
  CHECK(turnedBy(true) == std::vector<bool>{true, false, false, false});
  frame.stretch.clear();
  CHECK(skinning::turningFrame(stage.scene, frame).stretch.empty());
}

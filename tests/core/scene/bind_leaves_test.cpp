#include <functional>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/anim/frame_state.h"
#include "core/scene/bind_chains.h"
#include "tests/support/matrices.h"

using namespace stretch;

namespace {

constexpr NodeIndex joint(1);
constexpr NodeIndex leaf(2);
constexpr NodeIndex endLeaf(3);
constexpr NodeIndex other(4);

Quat turnAbout(const Vec3& axis, double degrees) {
  return glm::angleAxis(glm::radians(degrees), axis);
}

/// A root with a joint, a leaf turned by 30 degrees below it and a second one below that which turns back by
/// 10; a node beside the joint; a skin of the second leaf and that node.
Scene twoLeaves() {
  Scene scene;
  scene.nodes.resize(5);
  scene.roots = {NodeIndex(0)};
  const auto hang = [&](NodeIndex child, NodeIndex parent) {
    scene.nodes[at(child)].parent = parent;
    scene.nodes[at(parent)].children.push_back(child);
  };
  hang(joint, NodeIndex(0));
  hang(leaf, joint);
  hang(endLeaf, leaf);
  hang(other, NodeIndex(0));
  for (const NodeIndex one : {leaf, endLeaf}) {
    scene.nodes[at(one)].isBindLeaf = true;
  }
  scene.nodes[at(leaf)].rest.rotation = turnAbout({0, 0, 1}, 30.0);
  scene.nodes[at(endLeaf)].rest.rotation = turnAbout({0, 0, 1}, -10.0);
  Mat4 bind(1.0);
  bind[3] = Vec4(1.0, 2.0, 3.0, 1.0);
  scene.skins.push_back({"skin", {endLeaf, other}, {bind, Mat4(3.0)}, 0});
  Primitive primitive;
  primitive.positions = {glm::vec3(0.0F)};
  scene.meshes.push_back({"prop", {primitive}, {}});
  return scene;
}

Scene folded(const std::function<void(Scene&)>& change = [](Scene&) {}) {
  Scene scene = twoLeaves();
  change(scene);
  foldBindLeaves(scene);
  return scene;
}

} // namespace

TEST_CASE("Two leaves below a joint are its chain, and the skin follows the joint as it followed the last of "
          "them") {
  const Scene scene = folded();
  REQUIRE(scene.bindChains.size() == 1);
  const BindChain& chain = scene.bindChains[0];
  CHECK(chain.joint == joint);
  CHECK(chain.leaf == leaf);
  CHECK(chain.endLeaf == endLeaf);
  CHECK(chain.lastLeaf() == endLeaf);
  CHECK(chain.nodes() == std::vector{leaf, endLeaf});
  CHECK(std::abs(glm::dot(chain.restTurn, turnAbout({0, 0, 1}, 20.0))) == Approx(1.0));
  CHECK(scene.skins[0].joints == std::vector{joint, other});
  const Scene before = twoLeaves();
  const Mat4 turn = glm::mat4_cast(turnAbout({0, 0, 1}, 20.0));
  CHECK(test::largestDifference(scene.skins[0].inverseBind[0], turn * before.skins[0].inverseBind[0]) <
        1e-12);
  CHECK(scene.skins[0].inverseBind[1] == before.skins[0].inverseBind[1]);
  CHECK(findBindChain(scene, joint) == &chain);
  CHECK(findBindChain(scene, other) == nullptr);
  CHECK(findBindChain(scene, leaf) == nullptr);
}

TEST_CASE("One leaf alone is a chain of its own turn") {
  const Scene scene = folded([](Scene& made) {
    made.nodes[at(leaf)].children.clear();
    made.nodes[at(endLeaf)].parent = NodeIndex(0);
    made.nodes[at(endLeaf)].isBindLeaf = false;
    made.skins[0].joints[0] = leaf;
  });
  REQUIRE(scene.bindChains.size() == 1);
  CHECK_FALSE(scene.bindChains[0].endLeaf.exists());
  CHECK(scene.bindChains[0].lastLeaf() == leaf);
  CHECK(scene.bindChains[0].nodes() == std::vector{leaf});
  CHECK(std::abs(glm::dot(scene.bindChains[0].restTurn, turnAbout({0, 0, 1}, 30.0))) == Approx(1.0));
  CHECK(scene.skins[0].joints[0] == joint);
}

TEST_CASE("A rigid mesh on the last leaf comes to the joint") {
  const Scene scene = folded([](Scene& made) { made.nodes[at(endLeaf)].mesh = 0; });
  CHECK(scene.bindChains.size() == 1);
  CHECK(scene.nodes[at(joint)].mesh == 0);
  CHECK(scene.nodes[at(endLeaf)].mesh == -1);
}

TEST_CASE("Leaves that another program changed are ordinary nodes") {
  const std::vector<std::pair<const char*, std::function<void(Scene&)>>> changes{
      {"the first is moved", [](Scene& made) { made.nodes[at(leaf)].rest.translation.y = 0.1; }},
      {"the first has a matrix", [](Scene& made) { made.nodes[at(leaf)].matrix = Mat4(1.0); }},
      {"the first has no parent", [](Scene& made) { made.nodes[at(leaf)].parent = NodeIndex::none; }},
      {"the first has two children", [](Scene& made) { made.nodes[at(leaf)].children.push_back(other); }},
      {"the second is unmarked", [](Scene& made) { made.nodes[at(endLeaf)].isBindLeaf = false; }},
      {"the second is moved", [](Scene& made) { made.nodes[at(endLeaf)].rest.translation.x = -0.1; }},
      {"the second has a matrix", [](Scene& made) { made.nodes[at(endLeaf)].matrix = Mat4(1.0); }},
      {"the second has a child", [](Scene& made) { made.nodes[at(endLeaf)].children.push_back(other); }},
      {"the second is a corner", [](Scene& made) { made.nodes[at(endLeaf)].isBindCorner = true; }},
      {"its mesh has a skin",
       [](Scene& made) { made.nodes[at(endLeaf)].mesh = made.nodes[at(endLeaf)].skin = 0; }},
      {"the joint has a mesh, too",
       [](Scene& made) { made.nodes[at(endLeaf)].mesh = made.nodes[at(joint)].mesh = 0; }},
      {"its mesh has morph targets",
       [](Scene& made) {
         made.nodes[at(endLeaf)].mesh = 0;
         made.meshes[0].primitives[0].morphTargets.emplace_back();
       }},
  };
  for (const auto& [said, change] : changes) {
    INFO(said);
    const Scene scene = folded(change);
    CHECK(scene.bindChains.empty());
    CHECK(scene.skins[0].joints == std::vector{endLeaf, other});
    CHECK(scene.skins[0].inverseBind[0] == twoLeaves().skins[0].inverseBind[0]);
  }
}

TEST_CASE("A joint has one chain, that of its first leaf") {
  const Scene scene = folded([](Scene& made) {
    made.nodes[at(other)].parent = joint;
    made.nodes[at(other)].isBindLeaf = true;
  });
  REQUIRE(scene.bindChains.size() == 1);
  CHECK(scene.bindChains[0].leaf == leaf);
  CHECK(scene.skins[0].joints == std::vector{joint, other});
}

TEST_CASE("The stretch of a chain is what its leaves scale, in the joint's own axes") {
  const Scene scene = folded();
  Pose pose = restPose(scene);
  const BindChain& chain = scene.bindChains[0];
  CHECK(test::largestDifference(stretchOf(scene, pose, chain), Mat3(1.0)) < 1e-12);
  pose.locals[at(leaf)].scale = Vec3(2.0, 0.5, 1.0);
  // Along the axes of the first leaf, turned by 30 degrees.
  const Mat3 axes = glm::mat3_cast(turnAbout({0, 0, 1}, 30.0));
  const Mat3 wanted =
      axes * Mat3(Vec3(2.0, 0.0, 0.0), Vec3(0.0, 0.5, 0.0), Vec3(0.0, 0.0, 1.0)) * glm::transpose(axes);
  CHECK(test::largestDifference(stretchOf(scene, pose, chain), wanted) < 1e-12);
  const FrameState frame = frameOf(scene, pose, 0.25);
  CHECK(frame.timeSeconds == 0.25);
  REQUIRE(frame.stretch.size() == 5);
  CHECK(test::largestDifference(frame.stretch[at(joint)], wanted) < 1e-12);
  CHECK(frame.stretch[at(other)] == Mat3(1.0));
  CHECK(test::largestDifference(meshMatrix(frame, joint), frame.worlds[at(joint)] * Mat4(wanted)) < 1e-12);
}

TEST_CASE("Weights of one joint come together in the place of the first, and those of nothing go") {
  VertexInfluences vertex;
  vertex.joints = {4, 2, 4, 9, 2, 7, 7, 1};
  vertex.weights = {0.25F, 0.125F, 0.125F, 0.0F, 0.25F, 0.0F, 0.125F, 0.125F};
  const VertexInfluences once = withoutRepeats(vertex);
  CHECK(once.joints == std::array<std::uint16_t, 8>{4, 2, 7, 1, 0, 0, 0, 0});
  CHECK(once.weights == std::array<float, 8>{0.375F, 0.375F, 0.125F, 0.125F, 0, 0, 0, 0});
  VertexInfluences apart;
  for (std::size_t i = 0; i < VertexInfluences::capacity; ++i) {
    apart.joints[i] = static_cast<std::uint16_t>(8 - i);
    apart.weights[i] = 0.125F;
  }
  CHECK(withoutRepeats(apart).joints == apart.joints);
  CHECK(withoutRepeats(apart).weights == apart.weights);
  CHECK(withoutRepeats(VertexInfluences{}).weights == VertexInfluences{}.weights);
}

TEST_CASE("A joint that takes its leaf's slot at the end of a skin's list stays there") {
  const Scene scene = folded([](Scene& made) { made.skins[0].joints = {other, endLeaf}; });
  CHECK(scene.bindChains.size() == 1);
  CHECK(scene.skins[0].joints == std::vector{other, joint});
  CHECK(scene.skins[0].inverseBind.size() == 2);
}

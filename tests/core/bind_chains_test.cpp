#include <catch2/catch.hpp>

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

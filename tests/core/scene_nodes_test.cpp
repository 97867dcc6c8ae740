#include <catch2/catch.hpp>

#include "core/scene/scene.h"
#include "tests/support/nodes.h"

using namespace stretch;
using test::addNode;

namespace {

/// Two trees: a over b and c, c over d; e over f. The nodes stand in the order b, a, d, c, f, e.
struct Forest {
  Scene scene;
  NodeIndex b{0};
  NodeIndex a{1};
  NodeIndex d{2};
  NodeIndex c{3};
  NodeIndex f{4};
  NodeIndex e{5};

  Forest() {
    scene.nodes.resize(6);
    scene.roots = {a, e};
    for (const auto& [child, parent] : {std::pair(b, a), {c, a}, {d, c}, {f, e}}) {
      scene.nodes[at(child)].parent = parent;
      scene.nodes[at(parent)].children.push_back(child);
    }
  }
};

} // namespace

TEST_CASE("Parents come before what hangs on them, in whichever order a file has its nodes") {
  const Forest forest;
  CHECK(parentsFirst(forest.scene) ==
        std::vector<NodeIndex>{forest.a, forest.e, forest.b, forest.c, forest.f, forest.d});
}

TEST_CASE("What two nodes hang on together is the lowest node above both, none where they have none") {
  const Forest forest;
  const Scene& scene = forest.scene;
  CHECK(commonAncestor(scene, forest.b, forest.d) == forest.a);
  CHECK(commonAncestor(scene, forest.d, forest.b) == forest.a);
  CHECK(commonAncestor(scene, forest.d, forest.c) == forest.c);
  CHECK(commonAncestor(scene, forest.c, forest.d) == forest.c);
  CHECK(commonAncestor(scene, forest.d, forest.d) == forest.d);
  CHECK(commonAncestor(scene, forest.d, forest.a) == forest.a);
  CHECK_FALSE(commonAncestor(scene, forest.d, forest.f).exists());
  CHECK_FALSE(commonAncestor(scene, forest.e, forest.b).exists());
  CHECK(isAncestorOrSelf(scene, forest.a, forest.d));
  CHECK(isAncestorOrSelf(scene, forest.d, forest.d));
  CHECK_FALSE(isAncestorOrSelf(scene, forest.d, forest.a));
  CHECK_FALSE(isAncestorOrSelf(scene, forest.e, forest.d));
  CHECK_FALSE(isAncestorOrSelf(scene, forest.b, forest.d));
}

TEST_CASE("Nodes with all that hangs on them stand each once, in the file's order") {
  const Forest forest;
  CHECK(withSubtrees(forest.scene, {forest.c}) == std::vector<NodeIndex>{forest.d, forest.c});
  CHECK(withSubtrees(forest.scene, {forest.e, forest.c, forest.d}) ==
        std::vector<NodeIndex>{forest.d, forest.c, forest.f, forest.e});
  CHECK(withSubtrees(forest.scene, {forest.b}) == std::vector<NodeIndex>{forest.b});
  CHECK(withSubtrees(forest.scene, {}).empty());
}

TEST_CASE("Bones, cameras, joints and vertices of a scene are found by what they are") {
  Forest forest;
  Scene& scene = forest.scene;
  scene.humanoid = {{"hips", forest.a}, {"head", NodeIndex(6)}, {"chest", NodeIndex::none}};
  CHECK(humanoidNode(scene, "hips") == forest.a);
  CHECK_FALSE(humanoidNode(scene, "head").exists()); // no node of the file
  CHECK_FALSE(humanoidNode(scene, "chest").exists());
  CHECK_FALSE(humanoidNode(scene, "jaw").exists());
  SceneCamera first;
  first.name = "Shot";
  first.node = forest.b;
  SceneCamera second;
  second.name = "Front";
  second.node = forest.f;
  scene.cameras = {first, second};
  REQUIRE(cameraNamed(scene, "Front") != nullptr);
  CHECK(cameraNamed(scene, "Front")->node == forest.f);
  CHECK(cameraNamed(scene, "Back") == nullptr);
  scene.skins = {{"one", {forest.c, forest.a}, {Mat4(1.0), Mat4(1.0)}},
                 {"two", {forest.a, forest.f}, {Mat4(1.0), Mat4(1.0)}}};
  CHECK(skinJoints(scene) == std::set<NodeIndex>{forest.a, forest.c, forest.f});
  CHECK(vertexCount(scene) == 0);
  Primitive three;
  three.positions.resize(3);
  Primitive five;
  five.positions.resize(5);
  scene.meshes = {{"mesh", {three, five}, {}}, {"other", {three}, {}}};
  CHECK(vertexCount(scene) == 11);
}

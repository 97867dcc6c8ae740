// When corners are taken for what this program wrote, and when they are another program's nodes.
#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/scene/bind_chains.h"
#include "tests/support/nodes.h"

using namespace stretch;

namespace {

constexpr std::size_t jointOfCorners = 1;
constexpr std::size_t lastCorner = 5;

VertexInfluences hangingOn(std::uint16_t slot, std::uint16_t otherSlot) {
  VertexInfluences vertex;
  vertex.joints = {slot, otherSlot};
  vertex.weights = {0.5F, 0.5F};
  return vertex;
}

/// A joint below a root with four corners behind it in the skin, whose matrix puts the joint `far` away. Of
/// the first part of the mesh one vertex hangs on corners and one on the joint, of the second part none does.
Scene fourCorners(double far = 0.5) {
  Scene scene;
  const NodeIndex root = test::addNode(scene, "root", NodeIndex::none, Vec3(0.0));
  const NodeIndex bone = test::addNode(scene, "bone", root, Vec3(0.0));
  Mat4 bind(1.0);
  bind[3] = Vec4(far, 0.0, 0.0, 1.0);
  scene.skins.push_back({"skin", {bone}, {bind}});
  for (const Vec3& place : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(-1, -1, -1)}) {
    const NodeIndex corner = test::addNode(scene, "corner", bone, place);
    scene.nodes[at(corner)].isBindLeaf = scene.nodes[at(corner)].isBindCorner = true;
    scene.skins[0].joints.push_back(corner);
    scene.skins[0].inverseBind.push_back(bind);
    scene.skins[0].inverseBind.back()[3] -= Vec4(place, 0.0);
  }
  Primitive first;
  first.positions.resize(2);
  first.influences = {hangingOn(1, 2), hangingOn(0, 0)};
  Primitive second;
  second.positions.resize(1);
  second.influences = {hangingOn(0, 0)};
  scene.meshes = {{"body", {first, second}, {}}, {"prop", {second}, {}}};
  const NodeIndex body = test::addNode(scene, "body", NodeIndex::none, Vec3(0.0));
  scene.nodes[at(body)].mesh = scene.nodes[at(body)].skin = 0;
  return scene;
}

Scene withCornersFolded(const std::function<void(Scene&)>& change, double far = 0.5) {
  Scene scene = fourCorners(far);
  change(scene);
  foldBindLeaves(scene);
  return scene;
}

} // namespace

TEST_CASE("Corners that another program changed are ordinary joints, whatever it changed") {
  const std::vector<std::pair<const char*, std::function<void(Scene&)>>> changes{
      {"turned", [](Scene& made) { made.nodes[lastCorner].rest.rotation = Quat(0.0, 1.0, 0.0, 0.0); }},
      {"scaled", [](Scene& made) { made.nodes[lastCorner].rest.scale.z = 2.0; }},
      {"given a matrix", [](Scene& made) { made.nodes[lastCorner].matrix = Mat4(1.0); }},
      {"given a mesh", [](Scene& made) { made.nodes[lastCorner].mesh = 1; }},
      {"given a child", [](Scene& made) { test::addNode(made, "hair", NodeIndex(lastCorner), Vec3(0.0)); }},
      {"bound with a turn",
       [](Scene& made) {
         std::swap(made.skins[0].inverseBind.back()[0], made.skins[0].inverseBind.back()[1]);
       }},
      {"taken out of the skin",
       [](Scene& made) {
         made.skins[0].joints.pop_back();
         made.skins[0].inverseBind.pop_back();
       }},
      {"hung on a leaf", [](Scene& made) { made.nodes[jointOfCorners].isBindLeaf = true; }},
  };
  for (const auto& [said, change] : changes) {
    INFO(said);
    Scene before = fourCorners();
    change(before);
    const Scene scene = withCornersFolded(change);
    CHECK(scene.bindChains.empty());
    CHECK(scene.skins[0].joints == before.skins[0].joints);
    CHECK(scene.meshes[0].primitives[0].influences[0].joints[0] == 1);
    CHECK(scene.meshes[0].primitives[0].onCorners.empty());
  }
}

TEST_CASE(
    "A part of a mesh that hangs on corners keeps what the file has of all its vertices, others nothing") {
  const bool isTurnedAround = GENERATE(false, true);
  CAPTURE(isTurnedAround);
  const Scene scene = withCornersFolded([&](Scene& made) {
    if (isTurnedAround) {
      std::ranges::reverse(made.meshes[0].primitives[0].influences);
    }
  });
  REQUIRE(scene.bindChains.size() == 1);
  const Primitive& first = scene.meshes[0].primitives[0];
  const std::size_t onCorners = isTurnedAround ? 1 : 0;
  REQUIRE(first.onCorners.size() == 2);
  CHECK(first.onCorners[onCorners].joints[0] == 1);
  CHECK(first.onCorners[onCorners].joints[1] == 2);
  CHECK(first.onCorners[1 - onCorners].joints[1] == 0);
  for (const VertexInfluences& vertex : first.influences) {
    CHECK(vertex.joints[0] == 0);
    CHECK(vertex.weights[0] == 1.0F);
    CHECK(vertex.weights[1] == 0.0F);
  }
  CHECK(scene.meshes[0].primitives[1].onCorners.empty());
}

TEST_CASE("A corner may miss its joint by what single precision rounds, which is more where that is far") {
  const auto isFolded = [](double far, double miss) {
    return withCornersFolded([&](Scene& made) { made.skins[0].inverseBind.back()[3].x += miss; }, far)
               .bindChains.size() == 1;
  };
  CHECK(isFolded(0.0, 1e-5));
  CHECK_FALSE(isFolded(0.0, 1e-4));
  CHECK(isFolded(1000.0, 5e-3));
  CHECK_FALSE(isFolded(1000.0, 2e-2));
}

// Corners of joints that several clips stretch, and of meshes that several nodes show.
#include "rig/corners/bind_corners.h"

#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

/// Flesh of a bone along x, some of it behind the joint.
const std::vector<glm::vec3> boneFlesh{
    {-0.1F, 0.02F, 0.0F}, {0.1F, -0.03F, 0.01F}, {0.3F, 0.02F, -0.04F}, {0.2F, 0.0F, 0.03F}};

/// Joint 0, and node 1 that shows the flesh on a skin of that joint.
Scene fleshedBone() {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[1].mesh = 0;
  scene.nodes[1].skin = 0;
  scene.roots = {NodeIndex(0), NodeIndex(1)};
  scene.skins.push_back({"skin", {NodeIndex(0)}, {Mat4(1.0)}});
  VertexInfluences whole;
  whole.weights[0] = 1.0F;
  Primitive primitive;
  primitive.positions = boneFlesh;
  primitive.influences.assign(boneFlesh.size(), whole);
  scene.meshes.push_back({"mesh", {primitive}, {}});
  return scene;
}

StretchKeys stretchedBone(const Vec3& factors, const Quat& axes = Quat(1, 0, 0, 0)) {
  StretchKeys keys;
  keys.node = NodeIndex(0);
  keys.times = {0.0F, 1.0F};
  keys.axes = {axes};
  keys.scales = {Vec3(1.0), factors};
  return keys;
}

std::size_t cornersFor(const std::vector<ClipStretches>& clips) {
  gltf::Edits edits;
  return addBindCorners(fleshedBone(), clips, {}, edits).corners;
}

const gltf::AddedNode& addedNode(const Scene& scene, const gltf::Edits& edits, NodeIndex node) {
  return edits.addedNodes.at(at(node) - scene.nodes.size());
}

} // namespace

TEST_CASE(
    "A bone that only lengthens has two ends, and one that changes in a direction across has four corners") {
  CHECK(cornersFor({{0, {stretchedBone(Vec3(2.0, 1.0, 1.0))}}}) == 2);
  CHECK(cornersFor({{0, {stretchedBone(Vec3(2.0, 1.0, 0.6))}}}) == 4);
  CHECK(cornersFor({{0, {stretchedBone(Vec3(2.0, 0.6, 1.0))}}}) == 4);
}

TEST_CASE("A bone that two clips lengthen has ends where both do so along one line") {
  const StretchKeys along = stretchedBone(Vec3(2.0, 1.0, 1.0));
  const auto besides = [&](const Quat& axes) {
    return cornersFor({{0, {along}}, {1, {stretchedBone(Vec3(3.0, 1.0, 1.0), axes)}}});
  };
  CHECK(besides(Quat(1, 0, 0, 0)) == 2);
  CHECK(besides(axisAngle(Vec3(0, 0, 1), pi)) == 2); // the same line, seen from its other end
  CHECK(besides(axisAngle(Vec3(0, 0, 1), 0.3)) == 4);
}

TEST_CASE(
    "The corners of a joint do for all clips that stretch it, and each clip moves them in its own way") {
  const Scene scene = fleshedBone();
  const StretchKeys lengthened = stretchedBone(Vec3(2.0, 1.0, 1.0));
  const StretchKeys thinned = stretchedBone(Vec3(3.0, 0.5, 0.5));
  std::vector<ClipStretches> clips{{2, {lengthened}}, {5, {thinned}}};
  if (GENERATE(false, true)) {
    std::swap(clips[0], clips[1]);
  }
  gltf::Edits edits;
  CHECK(addBindCorners(scene, clips, {}, edits).corners == 4);
  REQUIRE(edits.clips.size() == 2);
  for (std::size_t i = 0; i < clips.size(); ++i) {
    CHECK(edits.clips[i].clip == clips[i].clip);
    CHECK(edits.clips[i].tracks.size() == 4);
    for (const Track& track : edits.clips[i].tracks) {
      const Vec3 wanted =
          clips[i].stretches[0].scales.back() * addedNode(scene, edits, track.node).rest.translation;
      REQUIRE(track.values.size() == 6);
      CHECK(glm::length(Vec3(track.values[3], track.values[4], track.values[5]) - wanted) < 1e-6);
    }
  }
}

TEST_CASE("Nodes that show one mesh on one skin follow the same corners, each by itself") {
  Scene scene = fleshedBone();
  const Node shown = scene.nodes[1];
  scene.nodes.push_back(shown);
  scene.roots.emplace_back(2);
  gltf::Edits edits;
  const CornerFit fit = addBindCorners(scene, {{0, {stretchedBone(Vec3(2.0, 0.6, 0.6))}}}, {}, edits);
  CHECK(fit.corners == 4);
  CHECK(fit.vertices == boneFlesh.size());
  CHECK(edits.addedSlots.size() == 4);
  REQUIRE(edits.boundMeshes.size() == 2);
  CHECK(edits.boundMeshes[0].node == NodeIndex(1));
  CHECK(edits.boundMeshes[1].node == NodeIndex(2));
  CHECK(edits.boundMeshes[1].skin == 0);
  CHECK(edits.boundMeshes[1].influences.size() == 1);
}

TEST_CASE("A rigid mesh that two stretched joints carry gets corners and a skin for each of them") {
  Scene scene = fleshedBone();
  scene.skins.clear();
  for (Node& node : scene.nodes) {
    node.mesh = 0;
    node.skin = -1;
  }
  const StretchKeys first = stretchedBone(Vec3(2.0, 0.6, 0.6));
  StretchKeys second = first;
  second.node = NodeIndex(1);
  gltf::Edits edits;
  const CornerFit fit = addBindCorners(scene, {{0, {first, second}}}, {}, edits);
  CHECK(fit.joints == 2);
  CHECK(fit.corners == 8);
  REQUIRE(edits.addedSkins.size() == 2);
  REQUIRE(edits.boundMeshes.size() == 2);
  for (const int joint : {0, 1}) {
    CHECK(edits.addedSkins[at(joint)].joints.front() == NodeIndex(joint));
    CHECK(edits.boundMeshes[at(joint)].skin == joint);
    CHECK(addedNode(scene, edits, edits.boundMeshes[at(joint)].node).meshFrom == NodeIndex(joint));
  }
}

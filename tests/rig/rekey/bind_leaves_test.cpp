#include "rig/rekey/bind_leaves.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

const Quat axisOfTheFile = axisAngle(Vec3(0.0, 0.0, 1.0), 0.5);

// A skinned joint (node 0) that was stretched and saved before: the file has a leaf for it (node 1), and with
// `turnsBack` a second one below (node 2).
Scene stretchedBefore(bool turnsBack) {
  Scene scene;
  scene.nodes.resize(turnsBack ? 3 : 2);
  scene.nodes[0].children = {NodeIndex(1)};
  scene.nodes[1].parent = NodeIndex(0);
  scene.nodes[1].rest.rotation = axisOfTheFile;
  scene.nodes[1].isBindLeaf = true;
  scene.bindChains.emplace_back();
  scene.bindChains.back().joint = NodeIndex(0);
  scene.bindChains.back().leaf = NodeIndex(1);
  if (turnsBack) {
    scene.nodes[1].children = {NodeIndex(2)};
    scene.nodes[2].parent = NodeIndex(1);
    scene.nodes[2].rest.rotation = glm::inverse(axisOfTheFile);
    scene.nodes[2].isBindLeaf = true;
    scene.bindChains.back().endLeaf = NodeIndex(2);
  }
  scene.roots = {NodeIndex(0)};
  scene.skins.push_back({"skin", {NodeIndex(0)}, {Mat4(1.0)}});
  return scene;
}

StretchKeys stretchAlong(const Quat& axis, const Vec3& factors) {
  StretchKeys keys;
  keys.node = NodeIndex(0);
  keys.times = {0.0F, 0.5F};
  keys.axes = {axis};
  keys.scales = {Vec3(1.0), factors};
  return keys;
}

gltf::Edits saved(const Scene& scene, const StretchKeys& keys) {
  gltf::Edits edits;
  addBindLeaves(scene, {{0, {keys}}}, edits);
  return edits;
}

std::size_t countTracks(const gltf::Edits& edits, NodeIndex node, Channel channel) {
  std::size_t count = 0;
  for (const gltf::ClipTracks& clip : edits.clips) {
    count += static_cast<std::size_t>(
        std::count_if(clip.tracks.begin(), clip.tracks.end(),
                      [&](const Track& track) { return track.node == node && track.channel == channel; }));
  }
  return count;
}

bool same(const Quat& a, const Quat& b) {
  return angleBetween(a * Vec3(1, 0, 0), b * Vec3(1, 0, 0)) < 1e-6 &&
         angleBetween(a * Vec3(0, 1, 0), b * Vec3(0, 1, 0)) < 1e-6;
}

constexpr Vec3 thinner(2.0, 0.7, 0.7);

} // namespace

TEST_CASE("a stretch along the axis that a leaf has already is told by the leaf's scale alone") {
  const gltf::Edits edits = saved(stretchedBefore(false), stretchAlong(axisOfTheFile, thinner));
  CHECK(edits.addedNodes.empty());
  CHECK(edits.skinSlots.empty());
  CHECK(countTracks(edits, NodeIndex(1), Channel::scale) == 1);
  CHECK(countTracks(edits, NodeIndex(1), Channel::rotation) == 0);
}

TEST_CASE("a round stretch may lie turned about the leaf's axis, a flat one not") {
  const Quat turned = axisOfTheFile * axisAngle(Vec3(1.0, 0.0, 0.0), 0.8);
  CHECK(saved(stretchedBefore(false), stretchAlong(turned, thinner)).addedNodes.empty());
  CHECK(saved(stretchedBefore(false), stretchAlong(turned, Vec3(2.0, 0.9, 0.5))).addedNodes.size() == 1);
}

TEST_CASE("a stretch along another axis turns the leaf, and a second one turns back from its own axis") {
  const Quat other = axisAngle(Vec3(0.0, 1.0, 0.0), 1.0);
  const gltf::Edits edits = saved(stretchedBefore(false), stretchAlong(other, thinner));
  REQUIRE(edits.addedNodes.size() == 1);
  CHECK(edits.addedNodes.front().parent == NodeIndex(1));
  // At rest, where other clips have it, the chain does nothing: back from the axis of the file.
  CHECK(same(edits.addedNodes.front().rest.rotation, glm::inverse(axisOfTheFile)));
  CHECK(countTracks(edits, NodeIndex(1), Channel::rotation) == 1);
  CHECK(countTracks(edits, NodeIndex(2), Channel::rotation) == 1);
  REQUIRE(edits.skinSlots.size() == 1);
  CHECK(edits.skinSlots.front().node == NodeIndex(2));
}

TEST_CASE("two leaves that the file has stay two, and both are turned") {
  const gltf::Edits edits = saved(stretchedBefore(true), stretchAlong(axisOfTheFile, thinner));
  CHECK(edits.addedNodes.empty());
  CHECK(edits.skinSlots.empty());
  CHECK(countTracks(edits, NodeIndex(1), Channel::rotation) == 1);
  CHECK(countTracks(edits, NodeIndex(2), Channel::rotation) == 1);
}

TEST_CASE(
    "a leaf whose axis turns is keyed the short way, whichever of its two quaternions each key was told by") {
  StretchKeys keys = stretchAlong(axisOfTheFile, thinner);
  keys.times = {0.0F, 0.25F, 0.5F};
  keys.scales = {Vec3(1.0), thinner, Vec3(1.0)};
  keys.axes = {axisAngle(Vec3(0.0, 0.0, 1.0), 0.2), -axisAngle(Vec3(0.0, 0.0, 1.0), 0.4),
               axisAngle(Vec3(0.0, 0.0, 1.0), 0.6)};
  const gltf::Edits edits = saved(stretchedBefore(true), keys);
  int turning = 0;
  for (const Track& track : edits.clips.front().tracks) {
    for (std::size_t at = 4; track.channel == Channel::rotation && at < track.values.size(); at += 4) {
      double cosine = 0.0;
      for (std::size_t i = 0; i < 4; ++i) {
        cosine += static_cast<double>(track.values[at + i]) * static_cast<double>(track.values[at - 4 + i]);
      }
      CHECK(cosine > 0.9);
      ++turning;
    }
  }
  CHECK(turning == 4); // two steps of each leaf
}

TEST_CASE(
    "a joint that one of several clips stretches along another axis has leaves that turn in all of them") {
  Scene scene;
  scene.nodes.resize(1);
  scene.nodes[0].name = "arm";
  scene.skins.push_back({"skin", {NodeIndex(0)}, {Mat4(2.0)}});
  const StretchKeys along = stretchAlong(axisOfTheFile, thinner);
  const StretchKeys aside = stretchAlong(axisAngle(Vec3(0.0, 1.0, 0.0), 1.0), thinner);
  gltf::Edits edits;
  addBindLeaves(scene, {{0, {along}}, {3, {aside}}, {4, {along}}}, edits);
  REQUIRE(edits.addedNodes.size() == 2);
  CHECK(edits.addedNodes[0].name == "arm_bind");
  CHECK(edits.addedNodes[0].parent == NodeIndex(0));
  CHECK(same(edits.addedNodes[0].rest.rotation, axisOfTheFile));
  CHECK(edits.addedNodes[1].name == "arm_bind_end");
  CHECK(edits.addedNodes[1].parent == NodeIndex(1));
  CHECK(same(edits.addedNodes[1].rest.rotation, glm::inverse(axisOfTheFile)));
  REQUIRE(edits.skinSlots.size() == 1);
  CHECK(edits.skinSlots[0].node == NodeIndex(2));
  CHECK(edits.skinSlots[0].inverseBind == Mat4(2.0)); // the second leaf turns back
  REQUIRE(edits.clips.size() == 3);
  CHECK(edits.clips[1].clip == 3);
  CHECK(edits.clips[2].clip == 4);
  CHECK(countTracks(edits, NodeIndex(1), Channel::scale) == 3);
  CHECK(countTracks(edits, NodeIndex(1), Channel::rotation) == 3);
  CHECK(countTracks(edits, NodeIndex(2), Channel::rotation) == 3);
}

TEST_CASE(
    "a rigid mesh on a stretched joint moves to a leaf that turns back, a joint that moves none has none") {
  Scene scene;
  scene.nodes.resize(1);
  const StretchKeys along = stretchAlong(axisOfTheFile, thinner);
  CHECK(saved(scene, along).addedNodes.empty());
  CHECK(saved(scene, along).clips.empty());
  scene.nodes[0].mesh = 0;
  const gltf::Edits edits = saved(scene, along);
  REQUIRE(edits.addedNodes.size() == 2);
  CHECK_FALSE(edits.addedNodes[0].meshFrom.exists());
  CHECK(edits.addedNodes[1].meshFrom == NodeIndex(0));
  CHECK(same(edits.addedNodes[1].rest.rotation, glm::inverse(axisOfTheFile)));
  CHECK(countTracks(edits, NodeIndex(1), Channel::scale) == 1);
  CHECK(countTracks(edits, NodeIndex(1), Channel::rotation) == 0);
}

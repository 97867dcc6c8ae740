// Which nodes are sheared where by a clip: against matrices at each of the times that are looked at.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/anim/sampling.h"
#include "core/gltf/load/report.h"
#include "tests/support/nodes.h"

using namespace stretch;

namespace {

/// A parent that is scaled unequally, with a shown child that turns, a joint below that, and a node that
/// nothing shows.
Scene shearedScene() {
  Scene scene;
  const NodeIndex parent = test::addNode(scene, "parent", NodeIndex::none, Vec3(0.0));
  const NodeIndex child = test::addNode(scene, "child", parent, Vec3(0.0, 1.0, 0.0));
  const NodeIndex joint = test::addNode(scene, "joint", child, Vec3(0.0, 1.0, 0.0));
  test::addNode(scene, "hidden", parent, Vec3(0.0));
  const NodeIndex skinned = test::addNode(scene, "skinned", parent, Vec3(0.0));
  scene.nodes[at(parent)].rest.scale = Vec3(2.0, 1.0, 0.7);
  scene.nodes[3].rest.rotation = glm::angleAxis(0.7, Vec3(0.0, 0.0, 1.0));
  scene.nodes[at(skinned)].rest.rotation = glm::angleAxis(0.7, Vec3(0.0, 0.0, 1.0));
  scene.meshes.resize(1);
  scene.nodes[at(child)].mesh = 0;
  scene.nodes[at(skinned)].mesh = 0;
  scene.nodes[at(skinned)].skin = 0;
  Skin skin;
  skin.joints = {joint};
  skin.inverseBind = {Mat4(1.0)};
  scene.skins = {skin};
  return scene;
}

Track turning(int node, const std::vector<double>& times, const std::vector<double>& angles) {
  Track track;
  track.node = NodeIndex(node);
  track.channel = Channel::rotation;
  track.width = 4;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Quat turn = glm::angleAxis(angles[k], glm::normalize(Vec3(0.2, 0.3, 1.0)));
    track.times.push_back(static_cast<float>(times[k]));
    for (const double number : {turn.x, turn.y, turn.z, turn.w}) {
      track.values.push_back(static_cast<float>(number));
    }
  }
  return track;
}

double cosineAt(const Scene& scene, const Pose& pose, std::size_t node) {
  const Mat4 world = worldMatrices(scene, pose)[node];
  double most = 0.0;
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 2}}) {
    const Vec3 first(world[a]);
    const Vec3 second(world[b]);
    most = std::max(most, std::abs(glm::dot(first, second)) / glm::length(first) / glm::length(second));
  }
  return most;
}

} // namespace

TEST_CASE("Each shown node is told where a clip shears it most, at its keys in the order of time") {
  const Scene scene = shearedScene();
  Clip still;
  Clip clip; // of two tracks whose keys lie between each other
  clip.tracks.emplace_back(turning(1, {0.0, 0.8, 2.0}, {0.0, 0.5, 0.1}));
  clip.tracks.emplace_back(turning(2, {0.5, 1.5, 1.7}, {0.3, -0.9, 0.2}));
  const std::vector<gltf::Shear> found = gltf::residualShear(scene, {still, clip}, 0.01);
  REQUIRE(found.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t node = i + 1;
    CHECK(at(found[i].node) == node);
    double most = 0.0;
    double when = -1.0;
    for (const float time : {0.0F, 0.5F, 0.8F, 1.5F, 1.7F, 2.0F}) {
      const double cosine = cosineAt(scene, samplePose(scene, clip, static_cast<double>(time)), node);
      when = cosine > most ? static_cast<double>(time) : when;
      most = std::max(most, cosine);
    }
    CHECK(found[i].cosine == Approx(most));
    CHECK(found[i].timeSeconds == Approx(when));
    CHECK(found[i].clip == 1);
  }
  CHECK(gltf::residualShear(scene, {still, clip}, 0.999).empty());
}

TEST_CASE("Shear at rest is told without a clip, and no tolerance leaves out what is above it") {
  Scene scene = shearedScene();
  scene.nodes[1].rest.rotation = glm::angleAxis(0.4, Vec3(0.0, 0.0, 1.0));
  const std::vector<gltf::Shear> found = gltf::residualShear(scene, {}, 0.01);
  REQUIRE(found.size() == 2);
  CHECK(found[0].clip == -1);
  CHECK(found[0].timeSeconds == 0.0);
  const double cosine = cosineAt(scene, restPose(scene), 1);
  CHECK(found[0].cosine == Approx(cosine));
  const double most = std::max(cosine, cosineAt(scene, restPose(scene), 2));
  CHECK_FALSE(gltf::residualShear(scene, {}, most - 1e-9).empty());
  CHECK(gltf::residualShear(scene, {}, most + 1e-9).empty());
  // Axes that fall on one line are told with an angle, however their lengths are rounded.
  scene.nodes[0].rest.scale = Vec3(0.0, 0.1, 0.0);
  for (int i = 0; i < 60; ++i) {
    scene.nodes[0].rest.rotation = glm::angleAxis(0.1 * i, glm::normalize(Vec3(0.3, 0.8, 0.5)));
    scene.nodes[1].rest.rotation = glm::angleAxis(0.3 + 0.05 * i, glm::normalize(Vec3(0.2, 0.5, 0.7)));
    const std::vector<gltf::Shear> flat = gltf::residualShear(scene, {}, 0.01);
    REQUIRE_FALSE(flat.empty());
    CHECK(std::ranges::max(flat, {}, &gltf::Shear::cosine).cosine <= 1.0);
  }
  scene.nodes[0].rest.scale = Vec3(0.0); // without axes to compare
  CHECK(gltf::residualShear(scene, {}, 0.01).empty());
}

TEST_CASE("The second leaf of a stretched joint is told where the first one scales what it turns back") {
  Scene scene = shearedScene();
  scene.nodes[0].rest.scale = Vec3(1.0);
  const NodeIndex leaf = test::addNode(scene, "leaf", NodeIndex(2), Vec3(0.0));
  const NodeIndex end = test::addNode(scene, "end", leaf, Vec3(0.0));
  scene.nodes[at(leaf)].rest.rotation = glm::angleAxis(0.6, Vec3(0.0, 0.0, 1.0));
  scene.nodes[at(end)].rest.rotation = glm::angleAxis(-0.6, Vec3(0.0, 0.0, 1.0));
  scene.bindChains = {{NodeIndex(2), leaf, end}};
  CHECK(gltf::residualShear(scene, {}, 0.01).empty());
  scene.nodes[at(leaf)].rest.scale = Vec3(2.0, 0.7, 0.7);
  const std::vector<gltf::Shear> found = gltf::residualShear(scene, {}, 0.01);
  REQUIRE(found.size() == 1);
  CHECK(found[0].node == end);
  CHECK(found[0].cosine == Approx(cosineAt(scene, restPose(scene), at(end))));
  scene.bindChains = {{NodeIndex(2), leaf, NodeIndex::none}}; // one leaf alone is scaled along its own axes
  CHECK(gltf::residualShear(scene, {}, 0.01).empty());
}

TEST_CASE("Of a clip of very many keys 64 are looked at, evenly, the first among them") {
  const Scene scene = shearedScene();
  for (const std::size_t keys : {64U, 65U, 640U}) {
    for (const std::size_t sheared : {0U, 10U, 11U, 63U}) {
      std::vector<double> times;
      std::vector<double> angles(keys, 0.0);
      for (std::size_t k = 0; k < keys; ++k) {
        times.push_back(0.125 * static_cast<double>(k));
      }
      angles[sheared] = 0.6;
      Clip clip;
      clip.tracks.emplace_back(turning(1, times, angles));
      bool isLookedAt = false;
      for (std::size_t i = 0; i < 64; ++i) {
        isLookedAt = isLookedAt || i * keys / 64 == sheared;
      }
      CAPTURE(keys, sheared);
      CHECK(gltf::residualShear(scene, {clip}, 0.05).empty() == !isLookedAt);
    }
  }
}

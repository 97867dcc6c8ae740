#include "rig/limb.h"
#include "rig/rekey/mesh_reach.h"

#include <algorithm>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/rekeyed_clip.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr float swordLength = 1.5F;

int addMesh(Scene& scene, const std::vector<glm::vec3>& positions) {
  Primitive primitive;
  primitive.positions = positions;
  scene.meshes.push_back({"mesh", {primitive}, {}});
  return static_cast<int>(scene.meshes.size()) - 1;
}

// A long sword in the punching hand: a mesh without a skin.
MovingBiped swordsman() {
  MovingBiped moving = punchingBiped();
  const NodeIndex hand = moving.node.at("hand.l");
  moving.scene.nodes[at(hand)].mesh = addMesh(moving.scene, {{0.0F, 0.0F, 0.0F}, {0.0F, swordLength, 0.0F}});
  return moving;
}

Vec3 swordTip(const MovingBiped& moving, const FrameState& frame) {
  const auto hand = at(moving.node.at("hand.l"));
  return transformPoint(frame.worlds[hand], Vec3(0.0, swordLength, 0.0));
}

} // namespace

TEST_CASE("the mesh reaches as far as its vertices, by as much as they follow") {
  Scene scene;
  scene.nodes.resize(3);
  scene.nodes[0].mesh = addMesh(scene, {{0.0F, 2.0F, 0.0F}});
  scene.skins.push_back({"skin", {NodeIndex(1), NodeIndex(2)}, {Mat4(1.0), Mat4(1.0)}});
  scene.nodes[1].mesh = addMesh(scene, {{4.0F, 0.0F, 0.0F}});
  scene.nodes[1].skin = 0;
  VertexInfluences influences;
  influences.joints = {0, 1};
  influences.weights = {0.75F, 0.25F};
  scene.meshes[1].primitives.front().influences = {influences};
  CHECK(meshReach(scene) == std::vector<double>{2.0, 3.0, 1.0});
}

TEST_CASE("a skinned mesh reaches as far as it does from its joint in the bind pose") {
  Scene scene;
  scene.nodes.resize(2);
  Mat4 fromJoint(1.0);
  fromJoint[3] = Vec4(-5.0, 0.0, 0.0, 1.0); // the joint stands at x = 5
  scene.skins.push_back({"skin", {NodeIndex(1)}, {fromJoint}});
  scene.nodes[0].mesh = addMesh(scene, {{5.0F, 0.5F, 0.0F}});
  scene.nodes[0].skin = 0;
  VertexInfluences whole;
  whole.weights = {1.0F};
  scene.meshes[0].primitives.front().influences = {whole};
  CHECK(meshReach(scene) == std::vector<double>{0.0, 0.5});
}

TEST_CASE("the tip of a sword follows the exact motion as closely as the hand that holds it") {
  const MovingBiped moving = swordsman();
  const Rekeyed rekeyed = rekeyedOf(moving, {connectedTrail("left-arm", 0, 12, 3.0)});
  double worst = 0.0;
  for (int half = 0; half <= 48; ++half) {
    const double frame = 0.5 * half;
    const Vec3 written = swordTip(moving, poseOf(moving, rekeyed.clip, frame));
    worst = std::max(worst, glm::length(written - swordTip(moving, atFrame(moving, rekeyed.motion, frame))));
  }
  CHECK(worst < 1e-4 * moving.body.height);
}

TEST_CASE("a lance needs more keys than the hand that holds it, and its tip follows as closely") {
  constexpr float lanceLength = 12.0F;
  MovingBiped moving = punchingBiped();
  const auto hand = at(moving.node.at("hand.l"));
  Trail trail = connectedTrail("left-arm", 0, 12, 2.0);
  trail.settings.turnEnd = true;
  const auto keysOf = [&] {
    std::size_t count = 0;
    for (const Track& track : rekeyedOf(moving, {trail}).keys.tracks) {
      count += track.times.size();
    }
    return count;
  };
  const std::size_t withoutLance = keysOf();
  moving.scene.nodes[hand].mesh = addMesh(moving.scene, {{0.0F, lanceLength, 0.0F}});
  CHECK(keysOf() > withoutLance);
  const Rekeyed rekeyed = rekeyedOf(moving, {trail});
  double worst = 0.0;
  for (int half = 0; half <= 48; ++half) {
    const double frame = 0.5 * half;
    const Vec3 tip(0.0, lanceLength, 0.0);
    const Vec3 written = transformPoint(poseOf(moving, rekeyed.clip, frame).worlds[hand], tip);
    const Vec3 wanted = transformPoint(atFrame(moving, rekeyed.motion, frame).worlds[hand], tip);
    worst = std::max(worst, glm::length(written - wanted));
  }
  CHECK(worst < 1e-4 * moving.body.height);
}

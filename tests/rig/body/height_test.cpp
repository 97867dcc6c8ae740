#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "rig/body/reading/detection.h"
#include "rig/body/reading/planned_body.h"
#include "rig/plan/body_plan.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/rig/naming_schemes.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

const Vec3 alongX(1, 0, 0);
const Vec3 alongZ(0, 0, 1);

Clip turning(NodeIndex node, const Quat& first, const Quat& later) {
  Clip clip;
  clip.tracks.emplace_back(rotationTrack(node, Interpolation::linear, {{1.0, first}, {2.0, later}}));
  setEndsFromKeys(clip);
  return clip;
}

// A box of the size of a hand that hangs on a node, `away` from it.
void addBoxOn(Scene& scene, NodeIndex node, const Vec3& away) {
  Primitive box;
  for (int corner = 0; corner < 8; ++corner) {
    box.positions.emplace_back(
        Vec3(away.x + 0.02 * (corner & 1), away.y + 0.01 * (corner & 2), away.z + 0.005 * (corner & 4)));
  }
  Node carrier;
  carrier.name = "box";
  carrier.parent = node;
  carrier.mesh = static_cast<int>(scene.meshes.size());
  scene.nodes[at(node)].children.emplace_back(static_cast<int>(scene.nodes.size()));
  scene.nodes.push_back(carrier);
  scene.meshes.push_back({"box", {box}, {}});
}

// The same shape, half of it told by a morph target whose weight the nodes or the meshes give.
Scene halfByMorphs(Scene scene, bool byNodes) {
  for (Mesh& mesh : scene.meshes) {
    for (Primitive& primitive : mesh.primitives) {
      for (glm::vec3& position : primitive.positions) {
        position *= 0.5F;
      }
      primitive.morphTargets = {{primitive.positions, {}}};
    }
    mesh.morphWeights = {byNodes ? 0.0F : 1.0F};
  }
  for (Node& node : scene.nodes) {
    node.morphWeights = byNodes && node.mesh >= 0 ? std::vector<float>{1.0F} : std::vector<float>();
  }
  return scene;
}

} // namespace

TEST_CASE("A body is as large as its morph weights at rest make it") {
  SyntheticBiped body = makeNamedBody("Mixamo");
  body.rigid = GENERATE(false, true);
  const BuiltBiped built = build(body);
  const Body plain = detectBody(built.scene);
  for (const bool byNodes : {false, true}) {
    CAPTURE(body.rigid, byNodes);
    const Body found = detectBody(halfByMorphs(built.scene, byNodes));
    CHECK(found.height == Approx(plain.height));
    CHECK(found.size == Approx(plain.size));
  }
}

TEST_CASE("The height is that of the shown body where its clip begins, and the size that of its bind pose") {
  const BuiltBiped built = build(makeNamedBody("Mixamo"));
  const Body atRest = detectBody(built.scene);
  const NodeIndex arm = built.node.at("upperArm.l");
  const Quat raised = axisAngle(alongZ, pi / 2.0);
  const Clip reaching = turning(arm, raised, Quat(1, 0, 0, 0));
  const Clip reachesLater = turning(arm, Quat(1, 0, 0, 0), raised);
  const Body found = detectBody(built.scene, &reaching);
  // A shoulder at 1.43, fingers that are 0.65 from it and whose mesh goes on by 0.05; shoes 0.02 below the
  // floor.
  CHECK(found.height == Approx(1.43 + 0.65 + 0.05 + 0.02).margin(1e-3));
  CHECK(found.height > 1.05 * atRest.height);
  CHECK(found.size == Approx(atRest.size));
  CHECK(detectBody(built.scene, &reachesLater).height == Approx(atRest.height));
  CHECK(bodyAsPlan(built.scene, *planNamed("biped"), &reaching).height == Approx(found.height));
}

TEST_CASE("A clip that scales what carries the skeleton scales height and size of the character") {
  const BuiltBiped built = build(makeNamedBody("Mixamo"));
  const Body atRest = detectBody(built.scene);
  Clip grown;
  grown.tracks.emplace_back(vectorTrack(NodeIndex(0), Channel::scale, Interpolation::linear,
                                        {{0.0, Vec3(100.0)}, {1.0, Vec3(100.0)}}));
  setEndsFromKeys(grown);
  const Body found = detectBody(built.scene, &grown);
  CHECK(found.height == Approx(100.0 * atRest.height));
  CHECK(found.size == Approx(100.0 * atRest.size));
}

TEST_CASE(
    "Who lies where the clip begins is half as high as in the bind pose, not as high as a chest is thick") {
  const BuiltBiped built = build(makeNamedBody("Mixamo"));
  const Body atRest = detectBody(built.scene);
  for (const Vec3& axis : {alongX, alongZ}) {
    const Quat lying = axisAngle(axis, pi / 2.0);
    const Clip fallen = turning(built.node.at("hips"), lying, lying);
    const Body found = detectBody(built.scene, &fallen);
    CHECK(found.height >= 0.5 * atRest.height - 1e-9);
    CHECK(found.size == Approx(atRest.size));
  }
  const Quat onTheBack = axisAngle(alongX, -pi / 2.0);
  const Clip fallen = turning(built.node.at("hips"), onTheBack, onTheBack);
  CHECK(detectBody(built.scene, &fallen).height == Approx(0.5 * atRest.height));
}

TEST_CASE(
    "A helmet that hangs on the head counts into the height, a lance in a hand and a lamp beside do not") {
  const BuiltBiped built = build(makeNamedBody("Mixamo"));
  const double bare = detectBody(built.scene).height;
  Scene helmet = built.scene;
  addBoxOn(helmet, built.node.at("head"), {0, 0.5, 0});
  CHECK(detectBody(helmet).height == Approx(1.58 + 0.5 + 0.02 + 0.02).margin(0.02));
  CHECK(detectBody(helmet).height > bare + 0.2);
  CHECK(detectBody(helmet).size > bare + 0.2);
  Scene lance = built.scene;
  addBoxOn(lance, built.node.at("hand.r"), {0, 2.0, 0});
  CHECK(detectBody(lance).height == Approx(bare));
  Scene lamp = built.scene;
  addBoxOn(lamp, NodeIndex(0), {0, 5.0, 0});
  CHECK(detectBody(lamp).height == Approx(bare));
}

TEST_CASE("A mesh that the file holds and its scene does not show counts into no height") {
  const BuiltBiped built = build(makeNamedBody("Mixamo"));
  Scene scene = built.scene;
  Mesh unseen = scene.meshes.front();
  for (glm::vec3& position : unseen.primitives.front().positions) {
    position.y += 0.3F;
  }
  Node holder;
  holder.name = "left over";
  holder.mesh = static_cast<int>(scene.meshes.size());
  holder.skin = 0;
  scene.meshes.push_back(unseen);
  scene.nodes.push_back(holder);
  CHECK(detectBody(scene).height == Approx(detectBody(built.scene).height));
  scene.roots.emplace_back(scene.nodes.size() - 1);
  CHECK(detectBody(scene).height == Approx(detectBody(built.scene).height + 0.3));
}

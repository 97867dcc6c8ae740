#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "core/anim/sampling.h"
#include "rig/body/evidence/bind_pose.h"
#include "tests/support/matrices.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

// A chain of three joints along +Y under an armature: bound straight, resting bent.
Scene bentChain(const Transform& armature) {
  Scene scene;
  scene.nodes.resize(4);
  scene.nodes[0].rest = armature;
  Skin skin;
  for (int i = 1; i < 4; ++i) {
    Node& node = scene.nodes[static_cast<std::size_t>(i)];
    node.parent = NodeIndex(i - 1);
    node.rest.translation = Vec3(0, 1, 0);
    node.rest.rotation = i > 1 ? glm::angleAxis(0.7, Vec3(0, 0, 1)) : Quat(1, 0, 0, 0);
    scene.nodes[static_cast<std::size_t>(i - 1)].children.emplace_back(i);
    skin.joints.emplace_back(i);
    skin.inverseBind.push_back(glm::translate(Mat4(1.0), Vec3(0, -i, 0)));
  }
  scene.skins.push_back(skin);
  return scene;
}

} // namespace

TEST_CASE("the bind pose is what the inverse bind matrices say, not the rest pose") {
  const Scene scene = bentChain({});
  const std::vector<Mat4> worlds = bindPoseWorlds(scene);
  CHECK(glm::distance(positionOf(worlds[3]), Vec3(0, 3, 0)) < 1e-12);
  CHECK(glm::distance(positionOf(worldMatrices(scene, restPose(scene))[3]), Vec3(0, 3, 0)) > 0.1);
}

TEST_CASE("the bind pose stands in the world as the topmost joint does at rest") {
  const Transform armature{Vec3(5, 0, 0), glm::angleAxis(pi / 2.0, Vec3(1, 0, 0)), Vec3(0.01)};
  const Scene scene = bentChain(armature);
  const std::vector<Mat4> worlds = bindPoseWorlds(scene);
  const std::vector<Mat4> rest = worldMatrices(scene, restPose(scene));
  CHECK(largestDifference(worlds[1], rest[1]) < 1e-12);
  CHECK(glm::distance(positionOf(worlds[3]), Vec3(5, 0, 0.03)) < 1e-12);
}

TEST_CASE("nodes that no skin binds follow their parents") {
  Scene scene = bentChain({});
  scene.nodes.resize(5);
  scene.nodes[4].parent = NodeIndex(3);
  scene.nodes[4].rest.translation = Vec3(0, 0.5, 0);
  scene.nodes[3].children.emplace_back(4);
  CHECK(glm::distance(positionOf(bindPoseWorlds(scene)[4]), Vec3(0, 3.5, 0)) < 1e-12);
}

TEST_CASE("skins that share a skeleton share its bind pose, in whatever model space each was bound") {
  Scene scene = bentChain({});
  // Quantised meshes carry their scale in the inverse bind matrices.
  const Mat4 quantisation = glm::translate(Mat4(1.0), Vec3(0, -7, 0)) * glm::scale(Mat4(1.0), Vec3(100.0));
  Skin second;
  second.joints = {NodeIndex(2), NodeIndex(3)};
  for (const NodeIndex joint : second.joints) {
    second.inverseBind.push_back(scene.skins[0].inverseBind[at(joint) - 1] * quantisation);
  }
  const std::vector<Mat4> alone = bindPoseWorlds(scene);
  scene.skins.insert(scene.skins.begin(), second);
  const std::vector<Mat4> both = bindPoseWorlds(scene);
  for (std::size_t node = 0; node < both.size(); ++node) {
    CHECK(largestDifference(alone[node], both[node]) < 1e-9);
  }
}

TEST_CASE("inverse bind matrices that cannot be a bind pose are replaced by the rest transform") {
  Scene scene = bentChain({});
  scene.skins[0].inverseBind[2] = GENERATE(Mat4(0.0), Mat4(1.0), Mat4(std::nan("")));
  const std::vector<Mat4> worlds = bindPoseWorlds(scene);
  CHECK(glm::distance(positionOf(worlds[3]), Vec3(0, 3, 0)) < 1e-12);
}

TEST_CASE("helper joints that are bound alike where they rest apart stand as they rest, and what hangs on "
          "them as bound") {
  // Three joints up; between the lower two and above the highest hangs a helper, both with the identity.
  Scene scene = bentChain({});
  scene.nodes.resize(6);
  for (const std::size_t helper : {4U, 5U}) {
    const NodeIndex parent(helper == 4 ? 0 : 3);
    scene.nodes[helper].parent = parent;
    scene.nodes[helper].rest.translation = Vec3(0, helper == 4 ? 0.25 : 0.5, 0);
    scene.nodes[at(parent)].children.emplace_back(static_cast<int>(helper));
    scene.skins[0].joints.emplace_back(static_cast<int>(helper));
    scene.skins[0].inverseBind.emplace_back(1.0);
  }
  const std::vector<Mat4> worlds = bindPoseWorlds(scene);
  CHECK(glm::distance(positionOf(worlds[4]), Vec3(0, 0.25, 0)) < 1e-12);
  CHECK(glm::distance(positionOf(worlds[1]), Vec3(0, 1, 0)) < 1e-12);
  CHECK(glm::distance(positionOf(worlds[5]), Vec3(0, 3.5, 0)) < 1e-12);
  // One root with the identity, at the model's own origin, stays bound by it.
  Scene plain = bentChain({});
  plain.skins[0].joints.insert(plain.skins[0].joints.begin(), NodeIndex(0));
  plain.skins[0].inverseBind.insert(plain.skins[0].inverseBind.begin(), Mat4(1.0));
  plain.nodes[1].rest.translation = Vec3(0, 2, 0);
  CHECK(glm::distance(positionOf(bindPoseWorlds(plain)[1]), Vec3(0, 1, 0)) < 1e-12);
}

TEST_CASE("an identity above all joints that puts them in other units and axes says nothing") {
  // Bound in centimetres, Z up; the topmost joint, which nothing follows, has a matrix that was never set.
  Scene scene = bentChain({});
  const Mat4 centimetres = glm::scale(glm::rotate(Mat4(1.0), pi / 2.0, Vec3(1, 0, 0)), Vec3(0.01));
  const std::vector<Mat4> whole = bindPoseWorlds(scene);
  scene.nodes[2].rest.rotation = Quat(1, 0, 0, 0);
  for (Mat4& bind : scene.skins[0].inverseBind) {
    bind = bind * centimetres;
  }
  scene.skins[0].inverseBind[0] = Mat4(1.0);
  const std::vector<Mat4> worlds = bindPoseWorlds(scene);
  for (std::size_t node = 1; node < 4; ++node) {
    INFO(node);
    CHECK(largestDifference(worlds[node], whole[node]) < 1e-9);
  }
  // One that puts them in the scene's units does say where they stand, however the next one rests.
  scene = bentChain({});
  for (std::size_t i = 0; i < 3; ++i) {
    scene.skins[0].inverseBind[i] = glm::translate(Mat4(1.0), Vec3(0, -static_cast<double>(i), 0));
  }
  CHECK(glm::distance(positionOf(bindPoseWorlds(scene)[2]), Vec3(0, 2, 0)) < 1e-12);
}

TEST_CASE("an identity above joints that hang on it alone says where they stand, in whatever units") {
  Scene scene = bentChain({});
  scene.skins[0].joints.resize(2); // The root, and one in centimetres.
  scene.skins[0].inverseBind = {Mat4(1.0), glm::translate(Mat4(1.0), Vec3(0, -100, 0))};
  CHECK(glm::distance(positionOf(bindPoseWorlds(scene)[1]), Vec3(0, 1, 0)) < 1e-9);
}

TEST_CASE("a bind matrix that says nothing is seen through however many nodes that no skin binds") {
  Scene scene = bentChain({});
  constexpr int between = 200'000;
  scene.nodes.resize(4 + between);
  for (int i = 4; i < 4 + between; ++i) {
    Node& node = scene.nodes[static_cast<std::size_t>(i)];
    node.parent = NodeIndex(i - 1);
    node.rest.translation = Vec3(0, 1e-5, 0);
    scene.nodes[static_cast<std::size_t>(i - 1)].children.emplace_back(i);
  }
  scene.skins[0].joints.emplace_back(3 + between); // The last of all is bound by the identity.
  scene.skins[0].inverseBind.emplace_back(1.0);
  const std::vector<Mat4> worlds = bindPoseWorlds(scene);
  CHECK(glm::distance(positionOf(worlds.back()), Vec3(0, 5, 0)) < 1e-6);
}

TEST_CASE("a character with a long chain of nodes below its hand is read as the one without") {
  SyntheticBiped body = namedBody();
  const BuiltBiped built = build(body);
  Scene scene = built.scene;
  const std::size_t first = scene.nodes.size();
  constexpr std::size_t links = 100'000;
  scene.nodes.resize(first + links);
  NodeIndex above = built.node.at("hand.l");
  for (std::size_t i = first; i < first + links; ++i) {
    scene.nodes[i].parent = above;
    scene.nodes[i].rest.translation = Vec3(0, -1e-6, 0);
    scene.nodes[at(above)].children.emplace_back(i);
    above = NodeIndex(i);
  }
  const Body with = detectBody(scene);
  const Body without = detectBody(built.scene);
  REQUIRE(with.limbs.size() == without.limbs.size());
  for (std::size_t i = 0; i < with.limbs.size(); ++i) {
    CHECK(with.limbs[i].id == without.limbs[i].id);
    CHECK(with.limbs[i].joints == without.limbs[i].joints);
  }
}

TEST_CASE("rest length and estimated ends are in world units, whatever the armature's scale") {
  for (const double scale : {1.0, 0.01, 100.0}) {
    SyntheticBiped body = makeBody();
    body.armatureScale = scale;
    const BuiltBiped built = build(body);
    const Body biped = detectBody(built.scene);
    const Limb* arm = findLimb(biped, biped::leftArm);
    REQUIRE(arm != nullptr);
    CHECK(arm->restLength == Approx(std::hypot(0.27, 0.01) + std::hypot(0.25, 0.01)));
    CHECK(biped.height == Approx(1.84).margin(0.01));
  }
}

TEST_CASE("a character that lies down is as large as it is long, and at least half as high") {
  SyntheticBiped body = makeBody();
  for (SyntheticJoint& joint : body.joints) {
    joint.position = Vec3(joint.position.x, -joint.position.z, joint.position.y);
  }
  body.withMesh = false;
  const BuiltBiped built = build(body);
  const Body biped = detectBody(built.scene);
  CHECK(biped.isBiped);
  CHECK(biped.size > 1.5);
  CHECK(biped.height == Approx(0.5 * biped.size));
}

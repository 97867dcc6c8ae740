#include "tests/support/rig/boxed_biped.h"

#include <cmath>
#include <optional>
#include <utility>

#include <catch2/catch.hpp>
#include <glm/matrix.hpp>

#include "core/anim/sampling.h"
#include "core/math/rotation.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/character_file.h"

namespace stretch::test {

void addBox(MovingBiped& moving, const std::string& joint, const Vec3& middle, const Vec3& half) {
  const std::vector<Mat4> worlds = worldMatrices(moving.scene, restPose(moving.scene));
  const Mat4 toJoint = glm::inverse(worlds[at(moving.node.at(joint))]);
  Primitive box;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
    box.positions.emplace_back(transformPoint(toJoint, middle + half * corner));
    box.normals.emplace_back(0.0F, 1.0F, 0.0F);
  }
  box.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2,
                 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3};
  const NodeIndex part = addNode(moving.scene, "box of " + joint, moving.node.at(joint), Vec3(0.0));
  moving.scene.nodes[at(part)].mesh = static_cast<int>(moving.scene.meshes.size());
  moving.scene.meshes.push_back({"box", {box}, {}});
}

MovingBiped bareBiped(const SyntheticBiped& body) {
  MovingBiped moving = still(body);
  moving.scene.meshes.clear();
  for (Node& node : moving.scene.nodes) {
    node.mesh = -1;
    node.skin = -1;
  }
  return moving;
}

MovingBiped boxedBiped(const BoxedBody& sizes) {
  SyntheticBiped body = namedBody({.toes = false, .fingers = false});
  for (const std::string side : {".l", ".r"}) {
    const double shoulder = jointOf(body, "upperArm" + side).position.x;
    for (const char* joint : {"foreArm", "hand"}) {
      double& x = jointOf(body, joint + side).position.x;
      x = shoulder + sizes.armLength * (x - shoulder);
    }
  }
  MovingBiped moving = bareBiped(body);
  addBox(moving, "spine0", Vec3(0.0, 1.15, 0.0), sizes.trunk);
  addBox(moving, "head", Vec3(0.0, 1.68, 0.0), sizes.head);
  for (const std::string side : {".l", ".r"}) {
    const Vec3 elbow = jointOf(body, "foreArm" + side).position;
    const Vec3 wrist = jointOf(body, "hand" + side).position;
    const Vec3 middle = 0.5 * (elbow + wrist);
    addBox(moving, "foreArm" + side, middle, {0.4 * std::abs(wrist.x - elbow.x), 0.035, 0.035});
    addBox(moving, "hand" + side, wrist + Vec3(std::copysign(0.06, wrist.x), 0.0, 0.0), {0.06, 0.04, 0.03});
  }
  return moving;
}

rig::Skeleton skeletonOf(const MovingBiped& moving) {
  std::optional<rig::Skeleton> skeleton = rig::skeletonOf(moving.scene, moving.body);
  REQUIRE(skeleton);
  return *std::move(skeleton);
}

std::string crossingArms(const std::filesystem::path& file) {
  constexpr double crossed = 2.9; // radians
  const Quat across = axisAngle(Vec3(0.0, 1.0, 0.0), -crossed);
  MovingBiped moving = bareBiped(namedBody());
  moving.clip.tracks.emplace_back(
      rotationTrack(moving.node.at("upperArm.l"), Interpolation::linear,
                    {{0.0, Quat(1.0, 0.0, 0.0, 0.0)}, {0.5, across}, {1.0, across}}));
  setEndsFromKeys(moving.clip);
  characterFile(moving.scene, {moving.clip}).write(file);
  return file.string();
}

} // namespace stretch::test

#include "tests/support/rig/described_limbs.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "rig/body/evidence/bind_pose.h"

namespace stretch::test {

std::string keyOf(const BuiltBiped& built, NodeIndex node) {
  for (const auto& [key, index] : built.node) {
    if (index == node) {
      return key;
    }
  }
  return "estimated";
}

const rig::Limb* findLimb(const rig::Body& biped, const rig::LimbPlace& place) {
  const auto found =
      std::ranges::find_if(biped.limbs, [&](const rig::LimbPlace& limb) { return limb == place; });
  return found == biped.limbs.end() ? nullptr : &*found;
}

std::string describe(const BuiltBiped& built, const rig::Body& biped, const rig::LimbPlace& place) {
  const rig::Limb* limb = findLimb(biped, place);
  if (limb == nullptr) {
    return "none";
  }
  std::string text;
  for (const NodeIndex joint : limb->joints) {
    text += keyOf(built, joint) + " ";
  }
  return text + "-> " + keyOf(built, limb->endNode);
}

void checkArmsAndLegs(const BuiltBiped& built, const rig::Body& biped) {
  CHECK(biped.isBiped);
  CHECK(describe(built, biped, rig::biped::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, biped, rig::biped::rightArm) == "upperArm.r foreArm.r -> hand.r");
  CHECK(describe(built, biped, rig::biped::leftLeg) == "thigh.l shin.l -> foot.l");
  CHECK(describe(built, biped, rig::biped::rightLeg) == "thigh.r shin.r -> foot.r");
}

Vec3 endOf(const Scene& scene, const rig::Limb& limb) {
  const std::vector<Mat4> worlds = rig::bindPoseWorlds(scene);
  return limb.endNode.exists() ? positionOf(worlds[at(limb.endNode)])
                               : transformPoint(worlds[at(limb.joints.back())], limb.endOffset);
}

double innerAngle(const std::vector<Vec3>& points) {
  return angleBetween(points[0] - points[1], points[2] - points[1]);
}

bool warnsOf(const rig::Body& body, const std::string& words) {
  return std::ranges::any_of(
      body.warnings, [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
}

} // namespace stretch::test

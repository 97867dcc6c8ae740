#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "core/gltf/source.h"
#include "tests/support/rig/described_limbs.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

struct Expectation {
  std::string file;
  bool isBiped;
  std::vector<std::string> limbs; // "left-arm: joint joint -> end", nodes by name; a wiped name makes no
                                  // difference
};

const std::vector<Expectation> expectations{
    {"biped/CesiumMan.glb",
     true,
     {"left-arm: Skeleton_arm_joint_L__4_ Skeleton_arm_joint_L__3_ -> Skeleton_arm_joint_L__2_",
      "right-arm: Skeleton_arm_joint_R Skeleton_arm_joint_R__2_ -> Skeleton_arm_joint_R__3_",
      "left-leg: leg_joint_L_1 leg_joint_L_2 -> leg_joint_L_3",
      "right-leg: leg_joint_R_1 leg_joint_R_2 -> leg_joint_R_3",
      "spine: Skeleton_torso_joint_2 -> torso_joint_3",
      "neck: Skeleton_neck_joint_1 -> Skeleton_neck_joint_2"}},
    {"biped/robot.glb",
     true,
     {"left-arm: UpperArm.L LowerArm.L -> estimated", "right-arm: UpperArm.R LowerArm.R -> estimated",
      "left-leg: UpperLeg.L LowerLeg.L -> Foot.L", "right-leg: UpperLeg.R LowerLeg.R -> Foot.R",
      "spine: Abdomen -> Torso", "neck: Neck -> Head"}},
    {"biped/Knight.glb",
     true,
     {"left-arm: upperarm.l lowerarm.l -> wrist.l", "right-arm: upperarm.r lowerarm.r -> wrist.r",
      "left-leg: upperleg.l lowerleg.l -> foot.l", "right-leg: upperleg.r lowerleg.r -> foot.r",
      "spine: spine -> chest"}},
    {"biped/mannequiny-0.3.0.glb",
     true,
     {"left-arm: upperarm.l lowerarm.l -> hand.l", "right-arm: upperarm.r lowerarm.r -> hand.r",
      "left-leg: thigh.l calf.l -> foot.l", "right-leg: thigh.r calf.r -> foot.r",
      "spine: spine_01 -> spine_02", "neck: neck_01 -> head"}},
    {"biped/human-addon-animations.glb",
     true,
     {"left-arm: upperarm_l lowerarm_l -> hand_l", "right-arm: upperarm_r lowerarm_r -> hand_r",
      "left-leg: thigh_l calf_l -> foot_l", "right-leg: thigh_r calf_r -> foot_r",
      "spine: spine_01 spine_02 -> spine_03", "neck: neck_01 -> head"}},
    {"biped/rpg-lowpoly-skeleton.glb",
     true,
     {"left-arm: epaule_L_09 coude_L_010 -> poignet_L_011",
      "right-arm: epaule_R_016 coude_R_017 -> poignet_R_018",
      "left-leg: hanche_L_02 genou_L_03 -> cheville_L_04",
      "right-leg: hanche_R_023 genou_R_024 -> cheville_R_025", "spine: spine1_06 spine2_07 -> plexus_08",
      "neck: cou_013 -> tete_014"}},
    {"biped/boxman.glb",
     true,
     {"left-arm: arm_upper.L arm_lower.L -> estimated", "right-arm: arm_upper.R arm_lower.R -> estimated",
      "left-leg: leg_upper.L leg_lower.L -> estimated", "right-leg: leg_upper.R leg_lower.R -> estimated",
      "spine: body_lower -> body_upper"}},
    {"biped/kenney-platformer-character/character.glb",
     true,
     {"left-arm: arm-left -> estimated", "right-arm: arm-right -> estimated",
      "left-leg: leg-left -> estimated", "right-leg: leg-right -> estimated", "spine: torso -> estimated"}},
    {"vrm/cryptovoxels.vrm",
     true,
     {"left-arm: Left arm Left elbow -> Left wrist", "right-arm: Right arm Right elbow -> Right wrist",
      "left-leg: Left leg Left knee -> Left ankle", "right-leg: Right leg Right knee -> Right ankle",
      "spine: Spine -> Chest", "neck: Neck -> Head"}},
    {"vrm/debug_robot.vrm",
     true,
     {"left-arm: upper_arm.L lower_arm.L -> hand.L", "right-arm: upper_arm.R lower_arm.R -> hand.R",
      "left-leg: upper_leg.L lower_leg.L -> foot.L", "right-leg: upper_leg.R lower_leg.R -> foot.R",
      "spine: spine -> chest", "neck: neck -> head"}},
    {"vrm/test.vrma",
     true,
     {"left-arm: leftUpperArm leftLowerArm -> leftHand",
      "right-arm: rightUpperArm rightLowerArm -> rightHand",
      "left-leg: leftUpperLeg leftLowerLeg -> leftFoot",
      "right-leg: rightUpperLeg rightLowerLeg -> rightFoot", "spine: spine -> chest", "neck: neck -> head"}},
    {"quadruped/Fox.glb", false, {}},
};

std::filesystem::path dataFolder() {
  const char* folder = std::getenv("STRETCH_DATA");
  return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder);
}

std::string describe(const Scene& scene, const Limb& limb) {
  std::string text = limb.id + ":";
  for (const NodeIndex joint : limb.joints) {
    text += " " + scene.nodes[at(joint)].name;
  }
  return text + " -> " + (!limb.endNode.exists() ? "estimated" : scene.nodes[at(limb.endNode)].name);
}

std::vector<std::string> describeAll(const Scene& named, const Biped& biped) {
  std::vector<std::string> texts;
  for (const Limb& limb : biped.limbs) {
    texts.push_back(describe(named, limb));
  }
  return texts;
}

Scene withoutNames(Scene scene) {
  for (Node& node : scene.nodes) {
    node.name.clear();
  }
  scene.humanoid.clear();
  return scene;
}

} // namespace

TEST_CASE("real characters have the limbs that a person sees") {
  if (dataFolder().empty()) {
    WARN("STRETCH_DATA is not set: skipped");
    return;
  }
  for (const Expectation& expected : expectations) {
    DYNAMIC_SECTION(expected.file) {
      const auto loaded = gltf::load(dataFolder() / expected.file);
      REQUIRE(loaded.ok());
      const Biped biped = detectBiped(*loaded->scene);
      CHECK(biped.isBiped == expected.isBiped);
      if (expected.isBiped) {
        CHECK(describeAll(*loaded->scene, biped) == expected.limbs);
      }
    }
  }
}

TEST_CASE("real characters have the same limbs when their names are wiped") {
  if (dataFolder().empty()) {
    WARN("STRETCH_DATA is not set: skipped");
    return;
  }
  for (const Expectation& expected : expectations) {
    // A character of six rigid boxes is no biped to geometry alone.
    if (expected.file.find("kenney") != std::string::npos) {
      continue;
    }
    DYNAMIC_SECTION(expected.file) {
      const auto loaded = gltf::load(dataFolder() / expected.file);
      REQUIRE(loaded.ok());
      const Biped biped = detectBiped(withoutNames(*loaded->scene));
      CHECK(biped.isBiped == expected.isBiped);
      for (const Limb& limb : biped.limbs) {
        // What stands at the hips of the robot is named Hips and placed like a joint of the spine.
        const bool undecidable = expected.file == "biped/robot.glb" && limb.kind == LimbKind::spine;
        if (expected.isBiped && !undecidable) {
          CHECK_THAT(expected.limbs, Catch::VectorContains(describe(*loaded->scene, limb)));
        }
      }
    }
  }
}

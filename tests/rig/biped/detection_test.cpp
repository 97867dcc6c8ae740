#include "rig/biped/detection.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/rig/synthetic_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

const Limb* findLimb(const Biped& biped, LimbKind kind) {
  const auto found = std::ranges::find(biped.limbs, kind, &Limb::kind);
  return found == biped.limbs.end() ? nullptr : &*found;
}

// Keys of a limb's joints and its end, as the test names them: "upperArm.l foreArm.l -> hand.l".
std::string describe(const BuiltBiped& built, const Biped& biped, LimbKind kind) {
  const Limb* limb = findLimb(biped, kind);
  if (limb == nullptr) {
    return "none";
  }
  const auto keyOf = [&](int node) {
    for (const auto& [key, index] : built.node) {
      if (index == node) {
        return key;
      }
    }
    return std::string("estimated");
  };
  std::string text;
  for (const int joint : limb->joints) {
    text += keyOf(joint) + " ";
  }
  return text + "-> " + keyOf(limb->endNode);
}

void checkLimbs(const BuiltBiped& built, const std::string& spine, const std::string& neck) {
  const Biped biped = detectBiped(built.scene);
  CHECK(biped.isBiped);
  CHECK(describe(built, biped, LimbKind::leftArm) == "upperArm.l foreArm.l -> hand.l");
  CHECK(describe(built, biped, LimbKind::rightArm) == "upperArm.r foreArm.r -> hand.r");
  CHECK(describe(built, biped, LimbKind::leftLeg) == "thigh.l shin.l -> foot.l");
  CHECK(describe(built, biped, LimbKind::rightLeg) == "thigh.r shin.r -> foot.r");
  CHECK(describe(built, biped, LimbKind::spine) == spine);
  CHECK(describe(built, biped, LimbKind::neck) == neck);
}

const std::string threeSpines = "spine0 spine1 -> spine2";
const std::string oneNeck = "neck0 -> head";

const std::vector<NamingScheme> schemes{
    {"Mixamo",
     "Left",
     "Right",
     {{"hips", "mixamorig:Hips"},
      {"spine0", "mixamorig:Spine"},
      {"spine1", "mixamorig:Spine1"},
      {"spine2", "mixamorig:Spine2"},
      {"neck0", "mixamorig:Neck"},
      {"head", "mixamorig:Head"},
      {"clavicle", "mixamorig:%Shoulder"},
      {"upperArm", "mixamorig:%Arm"},
      {"foreArm", "mixamorig:%ForeArm"},
      {"hand", "mixamorig:%Hand"},
      {"thigh", "mixamorig:%UpLeg"},
      {"shin", "mixamorig:%Leg"},
      {"foot", "mixamorig:%Foot"},
      {"toe", "mixamorig:%ToeBase"},
      {"finger0a", "mixamorig:%HandThumb1"},
      {"finger1a", "mixamorig:%HandIndex1"},
      {"finger2a", "mixamorig:%HandRing1"}}},
    {"HumanIK with exporter numbers",
     "Left",
     "Right",
     {{"hips", "Hips_01"},
      {"spine0", "Spine_02"},
      {"spine1", "Spine1_03"},
      {"spine2", "Spine2_04"},
      {"neck0", "Neck_05"},
      {"head", "Head_06"},
      {"clavicle", "%Shoulder_011"},
      {"upperArm", "%Arm_012"},
      {"foreArm", "%ForeArm_013"},
      {"hand", "%Hand_014"},
      {"thigh", "%UpLeg_055"},
      {"shin", "%Leg_056"},
      {"foot", "%Foot_057"},
      {"toe", "%ToeBase_058"}}},
    {"Unreal",
     "l",
     "r",
     {{"hips", "pelvis"},
      {"spine0", "spine_01"},
      {"spine1", "spine_02"},
      {"spine2", "spine_03"},
      {"neck0", "neck_01"},
      {"head", "head"},
      {"clavicle", "clavicle_%"},
      {"upperArm", "upperarm_%"},
      {"foreArm", "lowerarm_%"},
      {"hand", "hand_%"},
      {"thigh", "thigh_%"},
      {"shin", "calf_%"},
      {"foot", "foot_%"},
      {"toe", "ball_%"},
      {"finger0a", "thumb_01_%"},
      {"finger1a", "index_01_%"}}},
    {"Rigify deform bones",
     "L",
     "R",
     {{"hips", "DEF-spine"},
      {"spine0", "DEF-spine.001"},
      {"spine1", "DEF-spine.002"},
      {"spine2", "DEF-spine.003"},
      {"neck0", "DEF-spine.004"},
      {"head", "DEF-spine.006"},
      {"clavicle", "DEF-shoulder.%"},
      {"upperArm", "DEF-upper_arm.%"},
      {"foreArm", "DEF-forearm.%"},
      {"hand", "DEF-hand.%"},
      {"thigh", "DEF-thigh.%"},
      {"shin", "DEF-shin.%"},
      {"foot", "DEF-foot.%"},
      {"toe", "DEF-toe.%"}}},
    {"Blender metarig",
     "L",
     "R",
     {{"hips", "spine"},
      {"spine0", "spine.001"},
      {"spine1", "spine.002"},
      {"spine2", "spine.003"},
      {"neck0", "spine.004"},
      {"head", "spine.006"},
      {"clavicle", "shoulder.%"},
      {"upperArm", "upper_arm.%"},
      {"foreArm", "forearm.%"},
      {"hand", "hand.%"},
      {"thigh", "thigh.%"},
      {"shin", "shin.%"},
      {"foot", "foot.%"},
      {"toe", "toe.%"}}},
    {"3ds Max Biped",
     "L",
     "R",
     {{"root", "Bip01"},
      {"hips", "Bip01 Pelvis"},
      {"spine0", "Bip01 Spine"},
      {"spine1", "Bip01 Spine1"},
      {"spine2", "Bip01 Spine2"},
      {"neck0", "Bip01 Neck"},
      {"head", "Bip01 Head"},
      {"clavicle", "Bip01 % Clavicle"},
      {"upperArm", "Bip01 % UpperArm"},
      {"foreArm", "Bip01 % Forearm"},
      {"hand", "Bip01 % Hand"},
      {"thigh", "Bip01 % Thigh"},
      {"shin", "Bip01 % Calf"},
      {"foot", "Bip01 % Foot"},
      {"toe", "Bip01 % Toe0"},
      {"finger0a", "Bip01 % Finger0"}}},
    {"VRoid",
     "L",
     "R",
     {{"hips", "J_Bip_C_Hips"},
      {"spine0", "J_Bip_C_Spine"},
      {"spine1", "J_Bip_C_Chest"},
      {"spine2", "J_Bip_C_UpperChest"},
      {"neck0", "J_Bip_C_Neck"},
      {"head", "J_Bip_C_Head"},
      {"clavicle", "J_Bip_%_Shoulder"},
      {"upperArm", "J_Bip_%_UpperArm"},
      {"foreArm", "J_Bip_%_LowerArm"},
      {"hand", "J_Bip_%_Hand"},
      {"thigh", "J_Bip_%_UpperLeg"},
      {"shin", "J_Bip_%_LowerLeg"},
      {"foot", "J_Bip_%_Foot"},
      {"toe", "J_Bip_%_ToeBase"}}},
    {"words with spaces",
     "Left",
     "Right",
     {{"hips", "Hips"},
      {"spine0", "Spine"},
      {"spine1", "Chest"},
      {"spine2", "Upper chest"},
      {"neck0", "Neck"},
      {"head", "Head"},
      {"clavicle", "% shoulder"},
      {"upperArm", "% arm"},
      {"foreArm", "% elbow"},
      {"hand", "% wrist"},
      {"thigh", "% leg"},
      {"shin", "% knee"},
      {"foot", "% ankle"},
      {"toe", "% toe"}}},
    {"SMPL",
     "L",
     "R",
     {{"hips", "Pelvis"},
      {"spine0", "Spine1"},
      {"spine1", "Spine2"},
      {"spine2", "Spine3"},
      {"neck0", "Neck"},
      {"head", "Head"},
      {"clavicle", "%_Collar"},
      {"upperArm", "%_Shoulder"},
      {"foreArm", "%_Elbow"},
      {"hand", "%_Wrist"},
      {"thigh", "%_Hip"},
      {"shin", "%_Knee"},
      {"foot", "%_Ankle"},
      {"toe", "%_Foot"}}},
    {"Daz",
     "l",
     "r",
     {{"hips", "hip"},
      {"spine0", "abdomenLower"},
      {"spine1", "abdomenUpper"},
      {"spine2", "chestLower"},
      {"neck0", "neckLower"},
      {"head", "head"},
      {"clavicle", "%Collar"},
      {"upperArm", "%ShldrBend"},
      {"foreArm", "%ForearmBend"},
      {"hand", "%Hand"},
      {"thigh", "%ThighBend"},
      {"shin", "%Shin"},
      {"foot", "%Foot"},
      {"toe", "%Toe"}}},
    {"Character Creator",
     "L",
     "R",
     {{"hips", "CC_Base_Hip"},
      {"spine0", "CC_Base_Waist"},
      {"spine1", "CC_Base_Spine01"},
      {"spine2", "CC_Base_Spine02"},
      {"neck0", "CC_Base_NeckTwist01"},
      {"head", "CC_Base_Head"},
      {"clavicle", "CC_Base_%_Clavicle"},
      {"upperArm", "CC_Base_%_Upperarm"},
      {"foreArm", "CC_Base_%_Forearm"},
      {"hand", "CC_Base_%_Hand"},
      {"thigh", "CC_Base_%_Thigh"},
      {"shin", "CC_Base_%_Calf"},
      {"foot", "CC_Base_%_Foot"},
      {"toe", "CC_Base_%_ToeBase"}}},
    {"glued lower case",
     "l",
     "r",
     {{"hips", "hips"},
      {"spine0", "spine1"},
      {"spine1", "spine2"},
      {"spine2", "chest"},
      {"neck0", "neck"},
      {"head", "head"},
      {"clavicle", "%collarbone"},
      {"upperArm", "%upperarm"},
      {"foreArm", "%lowerarm"},
      {"hand", "%hand"},
      {"thigh", "%upperleg"},
      {"shin", "%lowerleg"},
      {"foot", "%foot"},
      {"toe", "%toes"}}},
    {"French",
     "G",
     "D",
     {{"hips", "bassin"},
      {"spine0", "colonne1"},
      {"spine1", "colonne2"},
      {"spine2", "poitrine"},
      {"neck0", "cou"},
      {"head", "tête"},
      {"clavicle", "clavicule_%"},
      {"upperArm", "épaule_%"},
      {"foreArm", "coude_%"},
      {"hand", "poignet_%"},
      {"thigh", "hanche_%"},
      {"shin", "genou_%"},
      {"foot", "cheville_%"},
      {"toe", "pied_%"}}},
    {"German",
     "links",
     "rechts",
     {{"hips", "Becken"},
      {"spine0", "Wirbelsäule1"},
      {"spine1", "Wirbelsäule2"},
      {"spine2", "Brust"},
      {"neck0", "Hals"},
      {"head", "Kopf"},
      {"clavicle", "Schlüsselbein %"},
      {"upperArm", "Oberarm %"},
      {"foreArm", "Unterarm %"},
      {"hand", "Hand %"},
      {"thigh", "Oberschenkel %"},
      {"shin", "Unterschenkel %"},
      {"foot", "Fuß %"},
      {"toe", "Zehen %"}}},
    {"Spanish",
     "Izq",
     "Der",
     {{"hips", "Cadera"},
      {"spine0", "Columna1"},
      {"spine1", "Columna2"},
      {"spine2", "Pecho"},
      {"neck0", "Cuello"},
      {"head", "Cabeza"},
      {"clavicle", "Clavícula%"},
      {"upperArm", "Brazo%"},
      {"foreArm", "Antebrazo%"},
      {"hand", "Mano%"},
      {"thigh", "Muslo%"},
      {"shin", "Pantorrilla%"},
      {"foot", "Pie%"},
      {"toe", "Dedo%"}}},
    {"Japanese",
     "左",
     "右",
     {{"hips", "下半身"},
      {"spine0", "上半身"},
      {"spine1", "上半身2"},
      {"spine2", "上半身3"},
      {"neck0", "首"},
      {"head", "頭"},
      {"clavicle", "%肩"},
      {"upperArm", "%腕"},
      {"foreArm", "%ひじ"},
      {"hand", "%手首"},
      {"thigh", "%足"},
      {"shin", "%ひざ"},
      {"foot", "%足首"},
      {"toe", "%つま先"}}},
    {"Russian",
     "левая",
     "правая",
     {{"hips", "Таз"},
      {"spine0", "Позвоночник1"},
      {"spine1", "Позвоночник2"},
      {"spine2", "Грудь"},
      {"neck0", "Шея"},
      {"head", "Голова"},
      {"clavicle", "Ключица %"},
      {"upperArm", "Плечо %"},
      {"foreArm", "Предплечье %"},
      {"hand", "Кисть %"},
      {"thigh", "Бедро %"},
      {"shin", "Голень %"},
      {"foot", "Стопа %"},
      {"toe", "Носок %"}}},
    {"numbered limbs",
     "L",
     "R",
     {{"hips", "torso_joint_1"},
      {"spine0", "torso_joint_2"},
      {"spine1", "torso_joint_3"},
      {"spine2", "torso_joint_4"},
      {"neck0", "neck_joint_1"},
      {"head", "neck_joint_2"},
      {"clavicle", "arm_joint_%_1"},
      {"upperArm", "arm_joint_%_2"},
      {"foreArm", "arm_joint_%_3"},
      {"hand", "arm_joint_%_4"},
      {"thigh", "leg_joint_%_1"},
      {"shin", "leg_joint_%_2"},
      {"foot", "leg_joint_%_3"},
      {"toe", "leg_joint_%_5"}}},
    {"Blender's default names",
     "",
     "",
     {{"hips", "Bone"},
      {"spine0", "Bone.001"},
      {"spine1", "Bone.002"},
      {"spine2", "Bone.003"},
      {"neck0", "Bone.004"},
      {"head", "Bone.005"},
      {"clavicle", "Bone.010"},
      {"upperArm", "Bone.012"},
      {"foreArm", "Bone.013"},
      {"hand", "Bone.014"},
      {"thigh", "Bone.020"},
      {"shin", "Bone.021"}}},
    {"no names", "", "", {}},
};

} // namespace

TEST_CASE("a biped of any naming scheme has the limbs that its joints are") {
  for (const NamingScheme& scheme : schemes) {
    DYNAMIC_SECTION(scheme.title) {
      SyntheticBiped body = makeBody();
      applyNames(body, scheme);
      checkLimbs(build(body), threeSpines, oneNeck);
    }
    DYNAMIC_SECTION(
        scheme.title << " facing -Z, armature scale 0.01, nodes shuffled, rest pose not the bind pose") {
      SyntheticBiped body = makeBody({.tips = true});
      applyNames(body, scheme);
      body.facesBackwards = true;
      body.armatureScale = 0.01;
      body.shuffled = true;
      body.posedAtRest = true;
      checkLimbs(build(body), threeSpines, oneNeck);
    }
    DYNAMIC_SECTION(scheme.title << " without clavicles, fingers and mesh") {
      SyntheticBiped body = makeBody({.spineJoints = 2, .clavicles = false, .fingers = false});
      applyNames(body, scheme);
      body.withMesh = false;
      checkLimbs(build(body), "spine0 -> spine1", oneNeck);
    }
  }
}

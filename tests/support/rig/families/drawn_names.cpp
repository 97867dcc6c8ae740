#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/families/family_rig.h"
#include "tests/support/rig/naming_schemes.h"

namespace stretch::test {

namespace {

NamingScheme scheme(std::string title, std::string left, std::string right,
                    const std::vector<std::string>& names) {
  static const std::vector<std::string> keys{"hips",  "spine0",   "spine1",   "spine2",  "neck0",
                                             "head",  "clavicle", "upperArm", "foreArm", "hand",
                                             "thigh", "shin",     "foot",     "toe"};
  NamingScheme made{std::move(title), std::move(left), std::move(right), {}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) {
      made.names[keys[i]] = names[i];
    }
  }
  return made;
}

// Schemes beside those of naming_schemes.h.
std::vector<NamingScheme> moreSchemes() {
  return {
      scheme("KayKit", "l", "r",
             {"hips", "spine", "chest", "upperchest", "neck", "head", "clavicle.%", "upperarm.%",
              "lowerarm.%", "hand.%", "upperleg.%", "lowerleg.%", "foot.%", "toes.%"}),
      scheme("Quaternius", "L", "R",
             {"Hips", "Abdomen", "Torso", "Chest", "Neck", "Head", "Shoulder.%", "UpperArm.%", "LowerArm.%",
              "Fist.%", "UpperLeg.%", "LowerLeg.%", "Foot.%", "Toes.%"}),
      scheme("Synty", "L", "R",
             {"Hips", "Spine_01", "Spine_02", "Spine_03", "Neck", "Head", "Clavicle_%", "Shoulder_%",
              "Elbow_%", "Hand_%", "UpperLeg_%", "LowerLeg_%", "Ankle_%", "Ball_%"}),
      scheme("AdvancedSkeleton", "L", "R",
             {"Root_M", "Spine1_M", "Spine2_M", "Chest_M", "Neck_M", "Head_M", "Scapula_%", "Shoulder_%",
              "Elbow_%", "Wrist_%", "Hip_%", "Knee_%", "Ankle_%", "Toes_%"}),
      scheme("Roblox", "Left", "Right",
             {"LowerTorso", "", "", "UpperTorso", "", "Head", "", "%UpperArm", "%LowerArm", "%Hand",
              "%UpperLeg", "%LowerLeg", "%Foot", ""}),
      scheme("Valve", "L", "R",
             {"ValveBiped.Bip01_Pelvis", "ValveBiped.Bip01_Spine", "ValveBiped.Bip01_Spine1",
              "ValveBiped.Bip01_Spine2", "ValveBiped.Bip01_Neck1", "ValveBiped.Bip01_Head1",
              "ValveBiped.Bip01_%_Clavicle", "ValveBiped.Bip01_%_UpperArm", "ValveBiped.Bip01_%_Forearm",
              "ValveBiped.Bip01_%_Hand", "ValveBiped.Bip01_%_Thigh", "ValveBiped.Bip01_%_Calf",
              "ValveBiped.Bip01_%_Foot", "ValveBiped.Bip01_%_Toe0"}),
      scheme("Maya joints", "lf", "rt",
             {"hip_jnt", "spine1_jnt", "spine2_jnt", "spine3_jnt", "neck_jnt", "head_jnt", "%_clavicle_jnt",
              "%_shoulder_jnt", "%_elbow_jnt", "%_wrist_jnt", "%_hip_jnt", "%_knee_jnt", "%_ankle_jnt",
              "%_ball_jnt"}),
      scheme("upper case", "L", "R",
             {"PELVIS", "SPINE1", "SPINE2", "CHEST", "NECK", "HEAD", "CLAVICLE_%", "ARM_%", "FOREARM_%",
              "HAND_%", "LEG_%", "KNEE_%", "FOOT_%", "TOE_%"}),
      scheme("arm and leg by number", "L", "R",
             {"Hip", "Spine1", "Spine2", "Spine3", "Neck", "Head", "Arm1.%", "Arm2.%", "Arm3.%", "Hand.%",
              "Leg1.%", "Leg2.%", "Foot.%", "Toe.%"}),
      scheme("side in front", "l", "r",
             {"body", "belly", "spine", "chest", "neck", "head", "%_shoulder", "%_arm_upper", "%_arm_lower",
              "%_hand", "%_leg_upper", "%_leg_lower", "%_foot", "%_toes"}),
      scheme("Italian", "SX", "DX",
             {"Bacino", "Colonna1", "Colonna2", "Torace", "Collo", "Testa", "Clavicola_%", "Braccio_%",
              "Avambraccio_%", "Mano_%", "Coscia_%", "Polpaccio_%", "Piede_%", "Punta_%"}),
      scheme("Portuguese", "Esq", "Dir",
             {"Quadril", "Coluna1", "Coluna2", "Peito", "Pescoco", "Cabeca", "Clavicula.%", "Braco.%",
              "Antebraco.%", "Mao.%", "Coxa.%", "Canela.%", "Pe.%", "Dedos.%"}),
      scheme("Chinese", "左", "右",
             {"骨盆", "脊椎1", "脊椎2", "胸", "脖子", "头", "%锁骨", "%上臂", "%前臂", "%手", "%大腿",
              "%小腿", "%脚踝", "%脚趾"}),
      scheme("Korean", "왼쪽", "오른쪽",
             {"골반", "척추1", "척추2", "가슴", "목", "머리", "%쇄골", "%위팔", "%아래팔", "%손", "%허벅지",
              "%종아리", "%발목", "%발가락"}),
      scheme("Polish", "lewa", "prawa",
             {"miednica", "kregoslup1", "kregoslup2", "klatka", "szyja", "glowa", "obojczyk_%", "ramie_%",
              "przedramie_%", "dlon_%", "udo_%", "lydka_%", "stopa_%", "palce_%"}),
      scheme("Turkish", "sol", "sag",
             {"kalca", "omurga1", "omurga2", "gogus", "boyun", "kafa", "omuz_%", "ustkol_%", "altkol_%",
              "el_%", "uyluk_%", "baldir_%", "ayak_%", "parmak_%"}),
  };
}

std::string uuid(Row& row) {
  std::string text;
  for (const int length : {8, 4, 4, 4, 12}) {
    text += text.empty() ? "" : "-";
    for (int i = 0; i < length; ++i) {
      text += "0123456789abcdef"[row.below(16)];
    }
  }
  return text;
}

bool hasSide(const std::string& key) {
  return key.size() > 2 && (key.ends_with(".l") || key.ends_with(".r"));
}

} // namespace

DrawnNames drawNames(SyntheticBiped& body, Row& row) {
  body.names.clear();
  switch (row.below(12)) {
  case 0:
    return {"no names", false};
  case 1:
    for (std::size_t i = 0; i < body.joints.size(); ++i) {
      body.names[body.joints[i].key] = fmt::format("Bone.{:03}", i);
    }
    return {"Bone.NNN", false};
  case 2:
    for (const SyntheticJoint& joint : body.joints) {
      body.names[joint.key] = uuid(row);
    }
    return {"UUIDs", false};
  default:
    break;
  }
  std::vector<NamingScheme> all = namingSchemes();
  // "numbered limbs" calls the head a neck, which is no fair question where there is none.
  std::erase_if(all, [&](const NamingScheme& one) {
    const bool hasNeck =
        std::ranges::find(body.joints, std::string("neck0"), &SyntheticJoint::key) != body.joints.end();
    return one.left.empty() || (one.title == "numbered limbs" && !hasNeck);
  });
  std::ranges::move(moreSchemes(), std::back_inserter(all));
  const NamingScheme& drawn = row.oneOf(all);
  applyNames(body, drawn);
  return {drawn.title, true};
}

void nameOthers(SyntheticBiped& body, const DrawnNames& names, Row& row) {
  const bool dotted = row.once(2);
  for (std::size_t i = 0; i < body.joints.size(); ++i) {
    const std::string& key = body.joints[i].key;
    if (body.names.contains(key) || names.title == "no names") {
      continue;
    }
    if (!names.tell) {
      body.names[key] = names.title == "UUIDs" ? uuid(row) : fmt::format("Bone.{:03}", i);
      continue;
    }
    std::string name = key;
    if (hasSide(key) && dotted) {
      name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
      name.back() = name.back() == 'l' ? 'L' : 'R';
    } else if (hasSide(key)) {
      name[name.size() - 2] = '_';
    }
    body.names[key] = name;
  }
}

namespace {

bool isBelow(const SyntheticBiped& body, const SyntheticJoint& joint, const std::string& above) {
  const SyntheticJoint* here = &joint;
  while (here->key != above) {
    const auto parent = std::ranges::find(body.joints, here->parent, &SyntheticJoint::key);
    if (parent == body.joints.end()) {
      return false;
    }
    here = &*parent;
  }
  return true;
}

} // namespace

void turnBelow(SyntheticBiped& body, const std::string& key, const Quat& turn) {
  const Vec3 about = jointOf(body, key).position;
  for (SyntheticJoint& joint : body.joints) {
    if (isBelow(body, joint, key)) {
      joint.position = about + turn * (joint.position - about);
      joint.flesh = turn * joint.flesh;
    }
  }
}

void moveEachJoint(SyntheticBiped& body, double degrees, Row& row) {
  std::vector<std::string> keys;
  for (const SyntheticJoint& joint : body.joints) {
    if (!joint.parent.empty()) {
      keys.push_back(joint.key);
    }
  }
  for (const std::string& key : keys) {
    const Vec3 axis = row.vector(1.0) + Vec3(1e-3);
    turnBelow(body, key, axisAngle(axis, row.around(degrees) * pi / 180.0));
  }
}

void moveBelow(SyntheticBiped& body, const std::string& key, const Vec3& offset) {
  for (SyntheticJoint& joint : body.joints) {
    joint.position += isBelow(body, joint, key) ? offset : Vec3(0.0);
  }
}

void standOn(SyntheticBiped& body, double height) {
  double lowest = 1e9;
  for (const SyntheticJoint& joint : body.joints) {
    lowest =
        joint.movesMesh ? std::min({lowest, joint.position.y, joint.position.y + joint.flesh.y}) : lowest;
  }
  for (SyntheticJoint& joint : body.joints) {
    joint.position.y += joint.key == "root" ? 0.0 : height - lowest;
  }
}

} // namespace stretch::test

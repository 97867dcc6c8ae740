#include "rig/body/evidence/name_evidence.h"
#include "rig/body/evidence/name_text.h"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace stretch::rig::body;

namespace {

struct Reading {
  const char* name;
  Role role;
  Side side;
};

} // namespace

TEST_CASE("joint names tell role and side in any spelling") {
  const auto [name, role, side] = GENERATE(values<Reading>({
      {"mixamorig:LeftForeArm", Role::foreArm, Side::left},
      {"upperarm_l", Role::upperArm, Side::left},
      {"thigh.r.l", Role::thigh, Side::left},
      {"thigh.r.r", Role::thigh, Side::right},
      {"thigh.f.r", Role::thigh, Side::right},
      {"Bip01 R UpperArm", Role::upperArm, Side::right},
      {"ValveBiped.Bip01_L_Calf", Role::shin, Side::left},
      {"J_Bip_R_LowerLeg", Role::shin, Side::right},
      {"DEF-upper_arm.L.001", Role::upperArm, Side::left},
      {"b_RightForeArm_07", Role::foreArm, Side::right},
      {"arm_lower.L", Role::foreArm, Side::left},
      {"lForearmBend", Role::foreArm, Side::left},
      {"rThigh", Role::thigh, Side::right},
      {"LARM", Role::upperArm, Side::left},
      {"hipR", Role::thigh, Side::right},
      {"cheville_L_04", Role::ankle, Side::left},
      {"main1_R_019", Role::wrist, Side::right},
      {"Main.G", Role::wrist, Side::left},
      {"Oberschenkel_rechts", Role::thigh, Side::right},
      {"左ひじ", Role::foreArm, Side::left},
      {"右足首", Role::ankle, Side::right},
      {"Предплечье_левое", Role::foreArm, Side::left},
      {"Ｈｅａｄ", Role::head, Side::none},
      {"Hips", Role::hips, Side::none},
      {"upper body", Role::spine, Side::none},
      {"Armature|Neck_01", Role::neck, Side::none},
  }));
  CAPTURE(name);
  const NameEvidence evidence = readName(name);
  CHECK(evidence.side == side);
  CHECK(evidence.role(role) >= 0.5);
  for (const double fit : evidence.roles) {
    CHECK(fit <= evidence.role(role));
  }
}

TEST_CASE("names of handles, tips, fingers, twists and props are told from limb joints") {
  CHECK(readName("kneeIK.l").control);
  CHECK(readName("IK-foot.l").control);
  CHECK(readName("ikfoot_l").control);
  CHECK(readName("PoleTarget.L").control);
  CHECK(readName("control-toe-roll.l").control);
  CHECK(readName("左足ＩＫ").control);
  CHECK(readName("ball_leaf_l").end);
  CHECK(readName("HeadTop_End").end);
  CHECK(readName("Bip01 HeadNub").end);
  CHECK(readName("LeftHandThumb1").finger);
  CHECK(readName("index_01_l").finger);
  CHECK(readName("Palm2.L").palm);
  CHECK(readName("lowerarm_twist_01_l").twist);
  CHECK(readName("左腕捩").twist);
  CHECK(readName("handslot.l").accessory);
  CHECK(readName("LeftEye").accessory);
  CHECK_FALSE(readName("spine_middle").finger);
  CHECK(readName("handslot.l").role(Role::wrist) == 0.0);
}

TEST_CASE("words that only contain another word say nothing, and broken text does no harm") {
  for (const char* name : {"", "Bone.012", "charm", "armor_plate", "4770a6aa35bf411daa075147df8a0cc0",
                           "\xff\xfe\x80", "____", "Object_7"}) {
    CAPTURE(name);
    for (const double fit : readName(name).roles) {
      CHECK(fit == 0.0);
    }
  }
  CHECK(readName(std::string(100000, 'l')).side == Side::none);
}

TEST_CASE("of words of two letters only upper, lower and controls are read where they are run together with "
          "others") {
  const auto isArm = [](const std::string& name) {
    return readName(name).role(Role::upperArm) >= 0.5 || readName(name).role(Role::foreArm) >= 0.5;
  };
  CHECK(readName("uparm.L").role(Role::upperArm) >= 0.6);
  CHECK(readName("armup.L").role(Role::upperArm) >= 0.6);
  CHECK(readName("loarm.L").role(Role::foreArm) >= 0.6);
  CHECK(readName("armlo.L").role(Role::foreArm) >= 0.6);
  for (const std::string control : {"ik", "fk"}) {
    CAPTURE(control);
    CHECK(readName("hand" + control).control == readName("hand_" + control).control);
    CHECK(readName(control + "hand").control == readName(control + "_hand").control);
  }
  for (const std::string word : {"lf", "rt", "sx", "dx", "pe", "bn", "sk", "jt", "cc"}) {
    CAPTURE(word);
    CHECK(isArm("lower_arm_" + word)); // by itself it spoils nothing
    CHECK_FALSE(isArm("lowerarm" + word));
    CHECK_FALSE(isArm(word + "lowerarm"));
  }
}

TEST_CASE("the names of a mirrored pair share their key") {
  CHECK(readName("Left arm").key == readName("Right arm").key);
  CHECK(readName("mixamorig:LeftArm").key == readName("mixamorig:RightArm").key);
  CHECK(readName("hand.L.001").key == readName("hand.R.001").key);
  CHECK(readName("hand.L.001").key != readName("hand.R.002").key);
}

TEST_CASE("numbers in names tell the joints of a row apart, whichever digits they have") {
  const std::vector<std::string> names{"leg.L",   "leg0.L",  "leg1.L",  "leg9.L",  "leg10.L",
                                       "leg19.L", "leg90.L", "leg01.L", "leg1_0.L"};
  for (const std::string& name : names) {
    for (const std::string& other : names) {
      CAPTURE(name, other);
      CHECK((readName(name).key == readName(other).key) == (name == other));
    }
    std::string mirrored = name;
    mirrored.back() = 'R';
    CHECK(readName(mirrored).key == readName(name).key);
  }
}

TEST_CASE("parts of a limb's name make the joint in any order") {
  const auto [name, role, side] = GENERATE(values<Reading>({
      {"upper arm left", Role::upperArm, Side::left},
      {"left arm upper", Role::upperArm, Side::left},
      {"lower arm left", Role::foreArm, Side::left},
      {"left arm lower", Role::foreArm, Side::left},
      {"fore arm left", Role::foreArm, Side::left},
      {"right leg upper", Role::thigh, Side::right},
      {"upper leg right", Role::thigh, Side::right},
      {"right leg lower", Role::shin, Side::right},
      {"lower leg right", Role::shin, Side::right},
      {"front leg left", Role::upperArm, Side::left},
      {"front foot right", Role::wrist, Side::right},
  }));
  CAPTURE(name);
  const NameEvidence evidence = readName(name);
  CHECK(evidence.side == side);
  CHECK(evidence.role(role) >= 0.6);
  for (const double fit : evidence.roles) {
    CHECK(fit <= evidence.role(role));
  }
  CHECK(readName("upper body").role(Role::hips) == Approx(0.0).margin(1e-12));
  CHECK(readName("lower body").role(Role::hips) == 1.0);
}

TEST_CASE("a limb joint without a side is half as sure, a trunk joint with one is none") {
  CHECK(readName("left thigh").role(Role::thigh) == 1.0);
  CHECK(readName("thigh").role(Role::thigh) == 0.5);
  CHECK(readName("left leg").role(Role::shin) == Approx(0.55));
  CHECK(readName("leg").role(Role::shin) == Approx(0.275));
  CHECK(readName("neck").role(Role::neck) == 1.0);
  CHECK(readName("left neck").role(Role::neck) == 0.0);
  CHECK(readName("hip").role(Role::hips) == 1.0);
  CHECK(readName("hip").role(Role::thigh) == 0.0);
  CHECK(readName("left hip").role(Role::thigh) == Approx(0.85));
  CHECK(readName("left right thigh").side == Side::none);
}

TEST_CASE("the words of a name stay apart in what a mirrored pair shares") {
  CHECK(readName("hand_foot.L").key == readName("hand_foot.R").key);
  CHECK(readName("back_fin.L").key != readName("back.L").key);
  CHECK(readName("a_bc.L").key != readName("ab_c.L").key);
  CHECK(readName("left_fin_a").key == readName("fin_right_a").key);
}

TEST_CASE("a letter of which a name has the first byte alone ends it, whatever stands behind the name") {
  const std::string cutOff = "arm\xC3\xA9"
                             "e";
  const std::vector<NameChunk> chunks = nameChunks(std::string_view(cutOff).substr(0, 4));
  REQUIRE(chunks.size() == 1);
  CHECK(chunks.front().whole == "arm");
}

TEST_CASE("letters are folded and told large from small up to the first and the last of their alphabet") {
  const auto partsOf = [](const char* name) {
    const std::vector<NameChunk> chunks = nameChunks(name);
    return chunks.size() == 1 ? chunks.front().parts : std::vector<std::string>();
  };
  using Parts = std::vector<std::string>;
  CHECK(partsOf("brasÀile") == Parts{"bras", "aile"});
  CHECK(partsOf("brasÞa") == Parts{"bras", "ta"}); // the last that is large
  CHECK(partsOf("brasßa") == Parts{"brasssa"});
  CHECK(partsOf("armeſ") == Parts{"armes"});
  CHECK(partsOf("АркаЯма") == Parts{"арка", "яма"});
  CHECK(partsOf("ногаЁлка") == Parts{"нога", "елка"});
}

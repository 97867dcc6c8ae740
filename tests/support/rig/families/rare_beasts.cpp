#include "tests/support/rig/families/beast.h"

#include <algorithm>
#include <cmath>

namespace stretch::test {

namespace {

void nameLegs(Beast& beast, const std::vector<std::pair<std::string, std::string>>& names) {
  for (const SyntheticJoint& joint : beast.body.joints) {
    for (const auto& [key, name] : names) {
      if (joint.key == key) {
        beast.body.names[key] = name;
      }
      for (const auto& [side, letter] : {std::pair(".l", "L"), std::pair(".r", "R")}) {
        if (joint.key == key + side) {
          std::string sided = name;
          sided.replace(sided.find('%'), 1, letter);
          beast.body.names[joint.key] = sided;
        }
      }
    }
  }
}

using JointNames = std::vector<std::pair<std::string, std::string>>;

const std::vector<JointNames> namesOfQuadrupeds{{{"root", "Bip01"},
                                                 {"hips", "Bip01 Pelvis"},
                                                 {"spine1", "Bip01 Spine"},
                                                 {"spine2", "Bip01 Spine1"},
                                                 {"spine3", "Bip01 Spine2"},
                                                 {"neck1", "Bip01 Neck"},
                                                 {"neck2", "Bip01 Neck1"},
                                                 {"neck3", "Bip01 Neck2"},
                                                 {"head", "Bip01 Head"},
                                                 {"scapula", "Bip01 % Clavicle"},
                                                 {"frontUpper", "Bip01 % UpperArm"},
                                                 {"frontLower", "Bip01 % Forearm"},
                                                 {"frontFoot", "Bip01 % Hand"},
                                                 {"frontToe", "Bip01 % Finger0"},
                                                 {"hindUpper", "Bip01 % Thigh"},
                                                 {"hindLower", "Bip01 % Calf"},
                                                 {"hindHock", "Bip01 % HorseLink"},
                                                 {"hindFoot", "Bip01 % Foot"},
                                                 {"hindToe", "Bip01 % Toe0"},
                                                 {"tail1", "Bip01 Tail"},
                                                 {"tail2", "Bip01 Tail1"},
                                                 {"tail3", "Bip01 Tail2"}},
                                                {{"hips", "spine"},
                                                 {"spine1", "spine.001"},
                                                 {"spine2", "spine.002"},
                                                 {"spine3", "spine.003"},
                                                 {"neck1", "spine.006"},
                                                 {"neck2", "spine.007"},
                                                 {"neck3", "spine.008"},
                                                 {"head", "spine.009"},
                                                 {"scapula", "shoulder.%"},
                                                 {"frontUpper", "front_thigh.%"},
                                                 {"frontLower", "front_shin.%"},
                                                 {"frontAnkle", "front_foot.%.001"},
                                                 {"frontFoot", "front_foot.%"},
                                                 {"frontToe", "front_toe.%"},
                                                 {"hindUpper", "thigh.%"},
                                                 {"hindLower", "shin.%"},
                                                 {"hindAnkle", "foot.%.001"},
                                                 {"hindFoot", "foot.%"},
                                                 {"hindToe", "toe.%"}},
                                                {{"hips", "b_Hip_01"},
                                                 {"spine1", "b_Spine01_02"},
                                                 {"spine2", "b_Spine02_03"},
                                                 {"neck1", "b_Neck_04"},
                                                 {"head", "b_Head_05"},
                                                 {"frontUpper", "b_%UpperArm_09"},
                                                 {"frontLower", "b_%ForeArm_010"},
                                                 {"frontFoot", "b_%Hand_011"},
                                                 {"hindUpper", "b_%Leg01_015"},
                                                 {"hindLower", "b_%Leg02_016"},
                                                 {"hindAnkle", "b_%Foot01_017"},
                                                 {"hindFoot", "b_%Foot02_018"},
                                                 {"tail1", "b_Tail01_012"},
                                                 {"tail2", "b_Tail02_013"},
                                                 {"tail3", "b_Tail03_014"}},
                                                {{"hips", "Body"},
                                                 {"spine1", "Spine"},
                                                 {"spine2", "Chest"},
                                                 {"neck1", "Neck"},
                                                 {"head", "Head"},
                                                 {"frontUpper", "FrontUpLeg.%"},
                                                 {"frontLower", "FrontLowLeg.%"},
                                                 {"frontFoot", "FrontFoot.%"},
                                                 {"hindUpper", "BackUpLeg.%"},
                                                 {"hindLower", "BackLowLeg.%"},
                                                 {"hindFoot", "BackFoot.%"}}};

Beast namedHorse(Row& row) {
  Beast beast = quadruped(row);
  nameLegs(beast, row.oneOf(namesOfQuadrupeds));
  return beast;
}

Beast dragon(Row& row) {
  Beast beast = quadruped(row);
  const double height = jointOf(beast.body, "spine2").position.y;
  beast.rowsOfBoth("wing", "spine2", {0.1, height + 0.15, 0.1},
                   {row.between(0.3, 0.6), row.between(0.0, 0.25), -0.05},
                   3 + static_cast<int>(row.below(3)));
  beast.wantBoth("%-wing", {"wing1%|wing2%", "wing2%", "wing3%|wing4%|wing5%|estimated"});
  return beast;
}

Beast centaur(Row& row) {
  Beast beast = quadruped(row);
  const Vec3 chest = jointOf(beast.body, "head").position;
  beast.rowOf("torso", beast.has("neck1") ? "neck1" : "spine2", {0, chest.y, chest.z - 0.3}, {0, 0.25, 0}, 2);
  jointOf(beast.body, "head").parent = "torso2";
  jointOf(beast.body, "head").position = {0, chest.y + 0.7, chest.z - 0.3};
  beast.rowsOfBoth("arm", "torso2", {0.18, chest.y + 0.25, chest.z - 0.3}, {0.06, -0.25, 0.04}, 3);
  beast.wanted.erase("tail");
  return beast;
}

Beast frog(Row& row) {
  Beast beast{"quadruped", {}, {}, row};
  const double height = row.between(0.25, 0.4);
  addLyingTrunk(beast, height, 0.5, 2, 0, 0.12);
  beast.both("frontUpper", "spine2", {0.12, height, 0.2});
  beast.both("frontLower", "frontUpper%", {0.22, 0.6 * height, 0.15});
  beast.both("frontFoot", "frontLower%", {0.2, 0.02, 0.28}, {0, -0.015, 0.08});
  beast.both("hindUpper", "hips", {0.1, height, -0.25});
  beast.both("hindLower", "hindUpper%", {0.3, 0.9 * height, 0.05});
  beast.both("hindAnkle", "hindLower%", {0.22, 0.15 * height, -0.25});
  beast.both("hindFoot", "hindAnkle%", {0.3, 0.02, 0.0}, {0, -0.015, 0.12});
  beast.wantBoth("front-%-leg", {"frontUpper%", "frontLower%", ends("front")});
  beast.wantBoth("hind-%-leg", {"hindUpper%", "hindLower%", ends("hind")});
  return beast;
}

Beast elephant(Row& row) {
  Beast beast = quadruped(row);
  const Vec3 head = jointOf(beast.body, "head").position;
  beast.rowOf("trunk", "head", head + Vec3(0, -0.05, 0.15), {0, -0.12 * head.y, 0.03}, 6);
  beast.rowsOfBoth("tusk", "head", head + Vec3(0.07, -0.1, 0.1), {0.01, -0.03, 0.1}, 2);
  return beast;
}

Beast penguin(Row& row) {
  Beast beast{"bird|biped", {}, {}, row};
  const double height = row.between(0.2, 0.35);
  beast.add("root", "", Vec3(0.0));
  beast.body.joints.back().movesMesh = false;
  beast.add("hips", "root", {0, height, 0});
  beast.add("spine1", "hips", {0, 2.2 * height, 0.01});
  beast.add("neck1", "spine1", {0, 3.4 * height, 0.02});
  beast.add("head", "neck1", {0, 4.0 * height, 0.04}, {0, 0.1, 0.15});
  beast.both("legUpper", "hips", {0.08, 0.8 * height, 0});
  beast.both("legLower", "legUpper%", {0.08, 0.4 * height, 0.02});
  beast.both("legFoot", "legLower%", {0.08, 0.08 * height, 0.0}, {0, -0.06 * height, 0.12});
  beast.rowsOfBoth("flipper", "spine1", {0.15, 3.0 * height, 0}, {0.05, -0.45 * height, 0}, 3);
  beast.wantBoth("%-leg", {"legUpper%", "legLower%", "legFoot%"});
  return beast;
}

Beast mech(Row& row) {
  Beast beast{"biped|bird", {}, {}, row};
  const double height = row.between(1.0, 2.5);
  beast.add("root", "", Vec3(0.0));
  beast.body.joints.back().movesMesh = false;
  beast.add("hips", "root", {0, height, 0});
  beast.add("torso1", "hips", {0, 1.2 * height, 0});
  beast.add("head", "torso1", {0, 1.5 * height, 0.1}, {0, 0.2, 0.1});
  beast.both("legUpper", "hips", {0.3, 0.95 * height, 0});
  beast.both("legLower", "legUpper%", {0.32, 0.6 * height, 0.25 * height});
  beast.both("legAnkle", "legLower%", {0.32, 0.3 * height, -0.2 * height});
  beast.both("legFoot", "legAnkle%", {0.32, 0.06 * height, 0.0}, {0, -0.05 * height, 0.2});
  beast.both("armUpper", "torso1", {0.5, 1.35 * height, 0});
  beast.both("armLower", "armUpper%", {0.55, 1.05 * height, 0});
  beast.both("armHand", "armLower%", {0.55, 1.0 * height, 0.35 * height}, {0, 0, 0.2});
  beast.wantBoth("%-leg", {"legUpper%", "legLower%", "legFoot%"});
  beast.wantBoth("%-arm", {"armUpper%", "armLower%", "armHand%|estimated"});
  return beast;
}

Beast scorpion(Row& row) {
  Beast beast = manyLegged(row, 4, false);
  beast.rowOf("tail", "abdomen", {0, 0.4, -0.7}, {0, 0.25, -0.05}, 5);
  beast.rowsOfBoth("claw", "thorax", {0.12, 0.3, 0.35}, {0.12, 0.02, 0.25}, 4);
  return beast;
}

Beast crab(Row& row) {
  Beast beast = manyLegged(row, 4, false);
  beast.rowsOfBoth("pincer", "thorax", {0.2, 0.3, 0.3}, {0.08, 0.0, 0.2}, 4);
  return beast;
}

Beast wyvern(Row& row) {
  Beast beast = bird(row);
  beast.rowOf("tailLong", "tail2", {0, 0.4, -0.7}, {0, -0.02, -0.25}, 4);
  return beast;
}

Beast ostrich(Row& row) {
  Beast beast{"bird", {}, {}, row};
  const double height = row.between(0.9, 1.3);
  addLyingTrunk(beast, height, 0.5, 2, 4, row.between(0.6, 0.9));
  addBirdLegs(beast, height, -0.05);
  beast.rowsOfBoth("wing", "spine2", {0.15, height + 0.05, 0.1}, {0.05, -0.03, -0.15}, 3);
  return beast;
}

Beast shark(Row& row) {
  Beast beast = fish(row);
  beast.rowsOfBoth("pelvic", "body3", {0.1, 0.5, -0.3}, {0.1, -0.05, -0.08}, 2);
  std::string last = "body4";
  for (const SyntheticJoint& joint : beast.body.joints) {
    last = joint.key.starts_with("body") ? joint.key : last;
  }
  const Vec3 end = jointOf(beast.body, last).position;
  beast.add("tailFinUp", last, end + Vec3(0, 0.25, -0.15), {0, 0.15, -0.1});
  beast.add("tailFinLow", last, end + Vec3(0, -0.12, -0.1), {0, -0.1, -0.1});
  beast.wanted["spine"].end += "|" + last;
  return beast;
}

Beast octopus(Row& row) {
  Beast beast{"spider|other", {}, {}, row};
  beast.add("root", "", {0, 0.5, 0});
  beast.add("head", "root", {0, 0.8, -0.1}, {0, 0.3, -0.2});
  for (int i = 0; i < 4; ++i) {
    const double angle = 0.4 + 0.78 * i;
    const Vec3 out(std::sin(angle), 0, std::cos(angle));
    beast.rowsOfBoth(fmt::format("tentacle{}_", i), "root", 0.15 * out + Vec3(0, 0.4, 0),
                     0.2 * out - Vec3(0, 0.09, 0), 5);
  }
  return beast;
}

Beast centipede(Row& row) {
  Beast beast{"other|spider|insect", {}, {}, row};
  const int count = 8 + static_cast<int>(row.below(10));
  beast.rowOf("segment", "", {0, 0.15, 1.0}, {0, 0, -2.0 / count}, count);
  for (int i = 1; i <= count; ++i) {
    const double z = 1.0 - 2.0 * (i - 1) / count;
    const std::string stem = fmt::format("leg{}_", i);
    beast.both(stem + "a", fmt::format("segment{}", i), {0.06, 0.14, z});
    beast.both(stem + "b", stem + "a%", {0.2, 0.2, z});
    beast.both(stem + "c", stem + "b%", {0.26, 0.01, z});
  }
  return beast;
}

const std::vector<BeastKind> rare{{"named quadruped", namedHorse},
                                  {"dragon", dragon},
                                  {"centaur", centaur},
                                  {"frog", frog},
                                  {"elephant", elephant},
                                  {"penguin", penguin},
                                  {"digitigrade mech", mech},
                                  {"scorpion", scorpion},
                                  {"crab", crab},
                                  {"wyvern", wyvern},
                                  {"ostrich", ostrich},
                                  {"shark", shark},
                                  {"octopus", octopus},
                                  {"centipede", centipede}};

} // namespace

const std::vector<BeastKind>& rareKinds() {
  return rare;
}

} // namespace stretch::test

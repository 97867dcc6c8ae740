#include "tests/support/rig/creatures.h"

namespace stretch::test {

namespace {

void add(SyntheticBiped& body, const std::string& key, const std::string& parent, const Vec3& place) {
  body.joints.push_back({key, parent, place});
}

struct SideJoint {
  std::string key;
  std::string parent; // with "%" where the side stands
  Vec3 place;         // on the left
};

void addBothSides(SyntheticBiped& body, const std::vector<SideJoint>& joints) {
  for (const auto& [side, sign] : {std::pair(std::string(".l"), 1.0), std::pair(std::string(".r"), -1.0)}) {
    for (const SideJoint& joint : joints) {
      std::string parent = joint.parent;
      if (const std::size_t mark = parent.find('%'); mark != std::string::npos) {
        parent.replace(mark, 1, side);
      }
      add(body, joint.key + side, parent, {sign * joint.place.x, joint.place.y, joint.place.z});
    }
  }
}

void addHindQuarters(SyntheticBiped& body) {
  add(body, "hips", "", {0.0, 1.3, -0.7});
  add(body, "tail0", "hips", {0.0, 1.3, -0.9});
  add(body, "tail1", "tail0", {0.0, 1.0, -1.05});
  add(body, "tail2", "tail1", {0.0, 0.7, -1.1});
  addBothSides(body, {{"thigh", "hips", {0.2, 1.2, -0.7}},
                      {"calf", "thigh%", {0.2, 0.85, -0.5}},
                      {"hock", "calf%", {0.2, 0.5, -0.8}},
                      {"pastern", "hock%", {0.2, 0.18, -0.75}},
                      {"hoof", "pastern%", {0.2, 0.05, -0.7}}});
}

void addFrontLegs(SyntheticBiped& body) {
  addBothSides(body, {{"scapula", "spine1", {0.15, 1.4, 0.35}},
                      {"forearmLeg", "scapula%", {0.2, 1.0, 0.55}},
                      {"frontKnee", "forearmLeg%", {0.2, 0.6, 0.45}},
                      {"frontPastern", "frontKnee%", {0.2, 0.2, 0.45}},
                      {"frontHoof", "frontPastern%", {0.2, 0.05, 0.5}}});
}

} // namespace

SyntheticBiped makeHorse() {
  SyntheticBiped body;
  addHindQuarters(body);
  add(body, "spine0", "hips", {0.0, 1.35, -0.3});
  add(body, "spine1", "spine0", {0.0, 1.35, 0.1});
  add(body, "neck0", "spine1", {0.0, 1.5, 0.5});
  add(body, "neck1", "neck0", {0.0, 1.75, 0.7});
  add(body, "head", "neck1", {0.0, 2.0, 0.85});
  add(body, "jaw", "head", {0.0, 1.85, 1.1});
  addBothSides(body, {{"ear", "head", {0.08, 2.12, 0.85}}});
  addFrontLegs(body);
  return body;
}

SyntheticBiped makeManyLegged(int rows) {
  SyntheticBiped body;
  add(body, "body", "", {0.0, 0.4, -0.1});
  add(body, "thorax", "body", {0.0, 0.4, 0.1});
  add(body, "head", "thorax", {0.0, 0.4, 0.45});
  add(body, "tail0", "body", {0.0, 0.4, -0.35});
  add(body, "tail1", "tail0", {0.0, 0.42, -0.7});
  add(body, "tail2", "tail1", {0.0, 0.35, -0.95});
  addBothSides(body, {{"antenna0", "head", {0.08, 0.5, 0.55}},
                      {"antenna1", "antenna0%", {0.2, 0.6, 0.8}},
                      {"antenna2", "antenna1%", {0.3, 0.55, 1.0}}});
  for (int row = 0; row < rows; ++row) {
    const std::string number = std::to_string(row);
    const double share = rows > 1 ? static_cast<double>(row) / (rows - 1) : 0.0;
    const double z = 0.3 - 0.45 * share;
    const double reach = 0.8 - 1.6 * share;
    addBothSides(body, {{"coxa" + number, "thorax", {0.15, 0.4, z}},
                        {"femur" + number, "coxa" + number + "%", {0.3, 0.45, z + 0.1 * reach}},
                        {"tibia" + number, "femur" + number + "%", {0.7, 0.75, z + 0.5 * reach}},
                        {"tarsus" + number, "tibia" + number + "%", {1.0, 0.02, z + 0.9 * reach}}});
  }
  return body;
}

SyntheticBiped makeSnake() {
  SyntheticBiped body;
  std::string parent;
  for (int i = 0; i < 16; ++i) {
    const std::string key = "segment" + std::to_string(i);
    add(body, key, parent, {0.0, 0.06, -1.0 + 0.14 * i});
    parent = key;
  }
  add(body, "head", parent, {0.0, 0.1, 1.3});
  return body;
}

SyntheticBiped makeFish() {
  SyntheticBiped body;
  std::string parent;
  for (int i = 0; i < 8; ++i) {
    const std::string key = "back" + std::to_string(i);
    add(body, key, parent, {0.0, 1.0, 0.8 - 0.25 * i});
    parent = key;
  }
  addBothSides(body,
               {{"pectoral0", "back1", {0.12, 0.9, 0.5}}, {"pectoral1", "pectoral0%", {0.4, 0.8, 0.35}}});
  return body;
}

SyntheticBiped makeBird() {
  SyntheticBiped body;
  add(body, "hips", "", {0.0, 0.8, 0.0});
  add(body, "spine0", "hips", {0.0, 0.85, 0.25});
  add(body, "spine1", "spine0", {0.0, 0.9, 0.5});
  add(body, "neck0", "spine1", {0.0, 1.0, 0.7});
  add(body, "neck1", "neck0", {0.0, 1.15, 0.85});
  add(body, "head", "neck1", {0.0, 1.25, 1.0});
  add(body, "tail0", "hips", {0.0, 0.8, -0.25});
  add(body, "tail1", "tail0", {0.0, 0.8, -0.55});
  addBothSides(body, {{"wing0", "spine1", {0.15, 0.95, 0.45}},
                      {"wing1", "wing0%", {0.5, 1.0, 0.35}},
                      {"wing2", "wing1%", {0.95, 1.0, 0.4}},
                      {"wing3", "wing2%", {1.4, 1.0, 0.2}},
                      {"thigh", "hips", {0.14, 0.7, 0.0}},
                      {"calf", "thigh%", {0.16, 0.45, 0.12}},
                      {"ankle", "calf%", {0.16, 0.2, -0.08}},
                      {"toe", "ankle%", {0.16, 0.03, 0.05}},
                      {"claw", "toe%", {0.16, 0.01, 0.15}}});
  return body;
}

SyntheticBiped makeCentaur() {
  SyntheticBiped body = makeHorse();
  std::erase_if(body.joints, [](const SyntheticJoint& joint) {
    return joint.key == "jaw" || joint.key.starts_with("ear");
  });
  jointOf(body, "neck0").position = {0.0, 1.8, 0.4};
  jointOf(body, "neck1").position = {0.0, 2.1, 0.4};
  jointOf(body, "head").position = {0.0, 2.4, 0.4};
  addBothSides(body, {{"upperArm", "neck1", {0.25, 2.1, 0.4}},
                      {"foreArm", "upperArm%", {0.6, 2.1, 0.4}},
                      {"hand", "foreArm%", {0.95, 2.1, 0.4}}});
  return body;
}

std::vector<Creature> creatures() {
  std::vector<Creature> all{{"horse", "quadruped", makeHorse()},     {"insect", "insect", makeManyLegged(3)},
                            {"spider", "spider", makeManyLegged(4)}, {"snake", "serpent", makeSnake()},
                            {"fish", "serpent", makeFish()},         {"bird", "bird", makeBird()},
                            {"centaur", "other", makeCentaur()}};
  for (Creature& creature : all) {
    nameByKeys(creature.body);
  }
  return all;
}

void nameByKeys(SyntheticBiped& body) {
  for (const SyntheticJoint& joint : body.joints) {
    body.names[joint.key] = joint.key;
  }
}

} // namespace stretch::test

#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/families/biped_draft.h"
#include "tests/support/rig/families/family_rig.h"
#include "tests/support/rig/families/whole_rigs.h"

namespace stretch::test {

namespace {

// Proportions from a child's to a giant's, with large heads and short or long limbs.
void drawProportions(Draft& draft) {
  SyntheticBiped& body = draft.body;
  Row& row = draft.row;
  const double legs = row.once(3) ? row.between(0.45, 0.8) : row.between(0.85, 1.25);
  const double arms = row.once(4) ? row.between(1.1, 1.5) : row.between(0.7, 1.1);
  for (const std::string& side : bothSides) {
    for (const auto& [key, parent] : {std::pair("foot", "shin"), std::pair("shin", "thigh")}) {
      if (draft.has(key + side)) {
        moveBelow(body, key + side, (legs - 1.0) * (draft.at(key + side) - draft.at(parent + side)));
      }
    }
    for (const auto& [key, parent] : {std::pair("hand", "foreArm"), std::pair("foreArm", "upperArm")}) {
      if (draft.has(key + side)) {
        moveBelow(body, key + side, (arms - 1.0) * (draft.at(key + side) - draft.at(parent + side)));
      }
    }
  }
  const double head = row.once(3) ? row.between(0.35, 0.7) : row.between(0.2, 0.28);
  jointOf(body, "head").flesh = {0.0, head, 0.3 * head};
}

std::string drawPose(Draft& draft) {
  Row& row = draft.row;
  const Poser poser{draft};
  const Vec3 x(1, 0, 0);
  switch (row.below(9)) {
  case 0:
    return "T-pose";
  case 1:
    poser.arms(45, 0, 5);
    return "A-pose";
  case 2:
    poser.arms(row.between(65, 82), 0, 8);
    return "arms down";
  case 3:
    poser.arms(60, 15, 40);
    poser.legs(-85, 85, 0);
    return "sitting";
  case 4:
    poser.arms(50, 20, 60);
    poser.legs(-55, 90, -35);
    return "crouched";
  case 5:
    poser.arms(20, 75, 15);
    return "arms forward";
  case 6:
    poser.arms(70, 0, 30);
    poser.turn("upperArm.l", Vec3(0, 0, 1), 110);
    return "one arm up";
  case 7:
    poser.arms(55, 10, 70);
    poser.turn("thigh.l", x, -35);
    poser.turn("thigh.r", x, 30);
    poser.turn("shin.r", x, 40);
    return "stride";
  default: {
    const double down = row.between(20, 60); // drawn one by one: a call may draw in any order
    const double forward = row.around(20);
    poser.arms(down, forward, row.between(0, 30));
    return "arms somewhere";
  }
  }
}

// Traits: what makes a family. Each adds to a posed body or says how it hangs.

void legsBesideHips(Draft& draft) {
  draft.body.joints.insert(std::ranges::find(draft.body.joints, std::string("hips"), &SyntheticJoint::key),
                           {"body", "root", draft.at("hips") - Vec3(0, 0.03, 0)});
  jointOf(draft.body, "hips").parent = "body";
  draft.moved = {{"thigh.l", "body"}, {"thigh.r", "body"}};
  if (draft.wanted.contains("spine")) {
    draft.wanted["spine"].first = "hips|spine0"; // a joint called hips that carries the torso alone
  }
}

void feetOnTheRoot(Draft& draft) {
  if (!draft.has("foot.l")) {
    return;
  }
  for (const std::string& side : bothSides) {
    draft.moved.emplace_back("foot" + side, "root");
    SyntheticJoint& last = jointOf(draft.body, jointOf(draft.body, "foot" + side).parent);
    last.flesh = 0.92 * (draft.at("foot" + side) - last.position);
  }
}

void packRig(Draft& draft) {
  legsBesideHips(draft);
  feetOnTheRoot(draft);
  for (const std::string& side : bothSides) {
    draft.add("pole_target" + side, "root", draft.at("shin" + side) + Vec3(0, 0, 0.5), false);
  }
}

void controlsInTheSkin(Draft& draft) {
  const char* const ik = draft.row.oneOf(std::vector<const char*>{"ik_", "IK.", "target_", "ctrl_"});
  for (const std::string& side : bothSides) {
    for (const auto& [stem, on] : {std::pair("hand", "hand"), std::pair("foot", "foot")}) {
      if (draft.has(on + side)) {
        draft.add(std::string(ik) + stem + side, "root", draft.at(on + side), false);
      }
    }
    draft.add("pole_knee" + side, "root", draft.at("shin" + side) + Vec3(0, 0, 0.4), false);
    draft.add("pole_elbow" + side, "root", draft.at("foreArm" + side) - Vec3(0, 0, 0.4), false);
  }
}

void twistsInARow(Draft& draft) {
  const int count = 1 + static_cast<int>(draft.row.below(3));
  const std::vector<std::string> words{"twist", "roll", "_00"};
  const std::string word = draft.row.oneOf(words);
  for (const std::string& side : bothSides) {
    for (const auto& [key, child] : {std::pair("upperArm", "foreArm"), std::pair("foreArm", "hand"),
                                     std::pair("thigh", "shin"), std::pair("shin", "foot")}) {
      std::string above = key + side;
      for (int i = 0; i < count && draft.has(child + side); ++i) {
        const std::string twist = fmt::format("{}{}{}{}", key, word, i + 1, side);
        addTwist(draft.body, twist, above, child + side, 1.0 / (count + 1 - i), true);
        draft.names[twist] = key;
        above = twist;
      }
    }
  }
}

void twistsBeside(Draft& draft) {
  const int count = 1 + static_cast<int>(draft.row.below(3));
  for (const std::string& side : bothSides) {
    for (const auto& [key, child] : {std::pair("upperArm", "foreArm"), std::pair("foreArm", "hand"),
                                     std::pair("thigh", "shin"), std::pair("shin", "foot")}) {
      for (int i = 0; i < count && draft.has(child + side); ++i) {
        const std::string twist = fmt::format("{}_twist_0{}{}", key, i + 1, side);
        addTwist(draft.body, twist, key + side, child + side, (i + 1.0) / (count + 1.0), false);
      }
    }
  }
}

void skirt(Draft& draft) {
  const std::string word = draft.row.oneOf(std::vector<std::string>{"skirt", "robe", "coat", "hem", "cloth"});
  const double length = draft.row.between(0.3, 0.95);
  const double leg = draft.at("hips").y;
  for (const std::string& side : bothSides) {
    for (int i = 0; i < 3; ++i) {
      const double angle = (i - 1) * 1.05;
      const Vec3 out(signOf(side) * 0.15 * std::cos(angle), 0.0, 0.15 * std::sin(angle));
      draft.addRow(fmt::format("{}{}_", word, i + 1), side, "hips", draft.at("hips") + out - Vec3(0, 0.04, 0),
                   (0.6 * out - Vec3(0, length * leg, 0)) / 3.0, 4);
    }
  }
}

void cape(Draft& draft) {
  const std::string word = draft.row.oneOf(std::vector<std::string>{"cape", "cloak", "scarf"});
  const Vec3 from = draft.at(draft.chest()) + Vec3(0, 0.1, -0.12);
  const double down = from.y * draft.row.between(0.6, 0.95);
  draft.addRow(word + "_", "", draft.chest(), from, {0, -down / 4, -0.02}, 5);
  for (const std::string& side : bothSides) {
    draft.addRow(word + "_", side, draft.chest(), from + Vec3(0.12 * signOf(side), 0, 0),
                 {0.02 * signOf(side), -down / 4, -0.02}, 5);
  }
}

void hair(Draft& draft) {
  const std::string word = draft.row.oneOf(std::vector<std::string>{"hair", "braid", "ponytail", "ears"});
  const Vec3 from = draft.at("head") + Vec3(0, 0.15, -0.08);
  const double length = draft.row.between(0.1, 0.8);
  draft.addRow(word + "_back", "", "head", from, {0, -length / 4, -0.03}, 5);
  for (const std::string& side : bothSides) {
    draft.addRow(word + "_", side, "head", from + Vec3(0.1 * signOf(side), 0, 0.08),
                 {0.01 * signOf(side), -length / 4, 0.0}, 5);
  }
}

void tail(Draft& draft) {
  const double rise = draft.row.around(0.1);
  draft.addRow("tail", "", "hips", draft.at("hips") + Vec3(0, -0.02, -0.1), {0, rise - 0.06, -0.14}, 6);
  std::erase(draft.absent, "tail");
  draft.wanted["tail"] = {"tail1", "", "tail6|estimated"};
}

void weapons(Draft& draft) {
  const std::string hand = draft.has("hand.r") ? "hand.r" : "foreArm.r";
  const std::string word = draft.row.oneOf(std::vector<std::string>{"sword", "staff", "gun", "axe"});
  const Vec3 way = draft.row.once(2) ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
  draft.add(word, hand, draft.at(hand) + Vec3(0, 0, 0.05));
  draft.add(word + "_tip", word, draft.at(hand) + draft.row.between(0.3, 1.2) * way);
  if (draft.row.once(2)) {
    draft.add("shield", "foreArm.l", draft.at("foreArm.l") + Vec3(0.05, 0, 0.1));
  }
}

void wings(Draft& draft) {
  for (const std::string& side : bothSides) {
    draft.addRow("wing", side, draft.chest(),
                 draft.at(draft.chest()) + Vec3(0.06 * signOf(side), 0.05, -0.12),
                 {0.3 * signOf(side), draft.row.between(-0.05, 0.15), -0.12}, 4);
  }
}

void face(Draft& draft) {
  const Vec3 head = draft.at("head");
  draft.add("jaw", "head", head + Vec3(0, 0.03, 0.08));
  draft.add("nose", "head", head + Vec3(0, 0.1, 0.13));
  for (const std::string& side : bothSides) {
    for (const char* const part : {"eye", "brow", "lip", "cheek", "ear"}) {
      draft.add(part + side, "head", head + Vec3((part[0] == 'e' ? 0.05 : 0.03) * signOf(side), 0.1, 0.1));
    }
  }
}

void manyFingers(Draft& draft) {
  for (const std::string& side : bothSides) {
    if (!draft.has("hand" + side)) {
      continue;
    }
    const Vec3 along = glm::normalize(draft.at("hand" + side) - draft.at("foreArm" + side));
    int i = 0;
    for (const char* const finger : {"thumb", "index", "middle", "ring", "pinky"}) {
      draft.addRow(finger, side, "hand" + side,
                   draft.at("hand" + side) + 0.08 * along + Vec3(0, 0, 0.02 * (2 - i++)), 0.03 * along, 3);
    }
  }
}

void oneArm(Draft& draft) {
  const std::string side = draft.row.oneOf(bothSides);
  const std::string from =
      (draft.has("clavicle" + side) && draft.row.once(2) ? "clavicle" : "upperArm") + side;
  SyntheticBiped& body = draft.body;
  std::vector<std::string> gone{from};
  for (std::size_t i = 0; i < gone.size(); ++i) {
    for (const SyntheticJoint& joint : body.joints) {
      if (joint.parent == gone[i]) {
        gone.push_back(joint.key);
      }
    }
  }
  std::erase_if(body.joints, [&](const SyntheticJoint& joint) {
    return std::ranges::find(gone, joint.key) != gone.end();
  });
  draft.wanted.erase(idOf(side, "arm"));
  draft.absent.push_back(idOf(side, "arm"));
}

void oneHandless(Draft& draft) {
  const std::string side = draft.row.oneOf(bothSides);
  if (!draft.has("hand" + side)) {
    return;
  }
  jointOf(draft.body, "foreArm" + side).flesh = draft.at("hand" + side) - draft.at("foreArm" + side);
  std::vector<std::string> gone{"hand" + side};
  for (std::size_t i = 0; i < gone.size(); ++i) {
    for (const SyntheticJoint& joint : draft.body.joints) {
      if (joint.parent == gone[i]) {
        gone.push_back(joint.key);
      }
    }
  }
  std::erase_if(draft.body.joints, [&](const SyntheticJoint& joint) {
    return std::ranges::find(gone, joint.key) != gone.end();
  });
  draft.wanted[idOf(side, "arm")].end = "estimated";
}

void thighsUnderTheSpine(Draft& draft) {
  // As 3ds Max hangs them.
  if (draft.has("spine0")) {
    draft.moved = {{"thigh.l", "spine0"}, {"thigh.r", "spine0"}};
    draft.wanted["spine"].first = "spine0|spine1"; // the joint that carries the legs may be the hips
  }
}

void pelvisBeside(Draft& draft) {
  draft.add("pelvis_joint", "hips", draft.at("hips") - Vec3(0, 0.04, 0));
  draft.moved = {{"thigh.l", "pelvis_joint"}, {"thigh.r", "pelvis_joint"}};
}

void pelvisHalves(Draft& draft) {
  for (const std::string& side : bothSides) {
    draft.add("pelvis" + side, "hips", draft.at("hips") + Vec3(0.02 * signOf(side), 0, 0));
    draft.moved.emplace_back("thigh" + side, "pelvis" + side);
  }
}

void armour(Draft& draft) {
  for (const std::string& side : bothSides) {
    const double sign = signOf(side);
    draft.add("pauldron" + side, draft.chest(), draft.at("upperArm" + side) + Vec3(0.03 * sign, 0.06, 0));
    draft.add("pouch" + side, "hips", draft.at("hips") + Vec3(0.15 * sign, -0.03, 0.02));
    draft.add("breast" + side, draft.chest(), draft.at(draft.chest()) + Vec3(0.07 * sign, 0, 0.12));
    draft.add("buttock" + side, "hips", draft.at("hips") + Vec3(0.07 * sign, -0.05, -0.1));
  }
  draft.add("backpack", draft.chest(), draft.at(draft.chest()) + Vec3(0, 0, -0.2));
}

void tips(Draft& draft) {
  for (const std::string& side : bothSides) {
    const std::string hand = (draft.has("hand.l") ? "hand" : "foreArm") + side;
    const std::string foot = (draft.has("toe.l") ? "toe" : draft.has("foot.l") ? "foot" : "shin") + side;
    draft.add(draft.row.once(2) ? "hand_end" + side : "handTip" + side, hand,
              draft.at(hand) + Vec3(0.1 * signOf(side), 0, 0), false);
    draft.add("toe_end" + side, foot, draft.at(foot) + Vec3(0, 0, 0.1), false);
  }
  draft.add("head_end", "head", draft.at("head") + Vec3(0, 0.2, 0), false);
}

void horns(Draft& draft) {
  for (const std::string& side : bothSides) {
    draft.addRow("horn", side, "head", draft.at("head") + Vec3(0.08 * signOf(side), 0.15, 0.02),
                 {0.08 * signOf(side), 0.1, 0.0}, 3);
    draft.addRow("beard", side, "head", draft.at("head") + Vec3(0.03 * signOf(side), 0.0, 0.1),
                 {0, -0.1, 0.01}, 3);
  }
}

void upright(Draft& /*draft*/) {}

void twoTraits(Draft& draft) {
  using Trait = void (*)(Draft&);
  const std::vector<Trait> hanging{legsBesideHips, feetOnTheRoot, packRig, pelvisHalves, thighsUnderTheSpine};
  const std::vector<Trait> jointed{twistsInARow, twistsBeside, controlsInTheSkin, face, tips};
  const std::vector<Trait> worn{skirt, cape, hair, tail, weapons, wings, armour, horns, manyFingers};
  if (draft.row.once(2)) {
    draft.row.oneOf(worn)(draft);
    draft.row.oneOf(jointed)(draft);
  } else {
    draft.row.oneOf(jointed)(draft);
    draft.row.oneOf(hanging)(draft);
    draft.row.oneOf(worn)(draft);
  }
}

struct Family {
  const char* title;
  void (*trait)(Draft& draft);
  bool poses = true;
};

const std::vector<Family> families{{"plain", upright},
                                   {"legs beside the hips", legsBesideHips},
                                   {"feet on the root", feetOnTheRoot, false},
                                   {"legs beside, feet on the root, poles", packRig, false},
                                   {"controls in the skin", controlsInTheSkin},
                                   {"twist joints in a row", twistsInARow},
                                   {"twist joints beside", twistsBeside},
                                   {"skirt or robe", skirt, false},
                                   {"cape", cape, false},
                                   {"long hair", hair, false},
                                   {"tail", tail, false},
                                   {"weapons", weapons},
                                   {"wings", wings, false},
                                   {"face", face},
                                   {"five fingers", manyFingers},
                                   {"one arm", oneArm},
                                   {"one hand", oneHandless},
                                   {"thighs under the spine", thighsUnderTheSpine},
                                   {"a pelvis joint", pelvisBeside},
                                   {"halves of a pelvis", pelvisHalves},
                                   {"armour and soft parts", armour},
                                   {"end joints", tips},
                                   {"horns and beard", horns},
                                   {"several at once", twoTraits, false}};

FamilyRig drawRig(const Family& family, Row& row) {
  const BodyOptions options = drawOptions(row);
  Draft draft{makeBody(options), row};
  wantLimbs(draft, options);
  giveFlesh(draft, options);
  drawProportions(draft);
  const std::string pose = family.poses || row.once(2) ? drawPose(draft) : "T-pose";
  standOn(draft.body, 0.0);
  family.trait(draft);
  for (const auto& [joint, parent] : draft.moved) {
    jointOf(draft.body, joint).parent = parent;
  }
  const DrawnNames names = drawNames(draft.body, row);
  for (const auto& [key, like] : draft.names) {
    if (names.tell && draft.body.names.contains(like + key.substr(key.size() - 2))) {
      const std::string bone = draft.body.names[like + key.substr(key.size() - 2)];
      draft.body.names[key] = bone + key.substr(like.size(), key.size() - 2 - like.size());
    }
  }
  if (names.tell && options.neckJoints == 2 && draft.body.names.contains("neck0")) {
    std::string second = draft.body.names["neck0"]; // the number that its scheme has next
    second.back() = std::isdigit(static_cast<unsigned char>(second.back())) != 0
                        ? static_cast<char>(second.back() + 1)
                        : 'b';
    draft.body.names["neck1"] = second;
  }
  nameOthers(draft.body, names, row);
  SyntheticBiped& body = draft.body;
  body.tubes = true;
  body.shuffled = row.once(3);
  body.size = row.once(3) ? row.oneOf(std::vector<double>{0.01, 0.1, 60.0, 100.0}) : 1.0;
  body.armatureScale = row.once(3) ? row.oneOf(std::vector<double>{0.001, 0.01, 100.0, 2000.0}) : 1.0;
  body.posedAtRest = row.once(4);
  const bool endsNeedMesh = !options.hands || !options.feet || family.title == std::string("one hand");
  body.withMesh = endsNeedMesh || !row.once(12);
  body.rigid = body.withMesh && row.once(8);
  body.withSkin = !body.rigid;
  body.posedAtRest = body.posedAtRest && !body.rigid;
  const std::uint32_t faces = row.below(8);
  body.facesBackwards = faces == 0;
  body.turn = faces == 1 ? axisAngle(Vec3(0, 1, 0), pi / 2.0) : Quat(1, 0, 0, 0);
  const std::string title = fmt::format(
      "{}, {}{}, spine {}, neck {}{}{}{}{}{}", names.title, pose,
      faces == 0   ? ", faces -Z"
      : faces == 1 ? ", faces X"
                   : "",
      options.spineJoints, options.neckJoints, options.clavicles ? "" : ", no clavicles",
      options.hands ? "" : ", no hands", options.feet ? options.toes ? "" : ", no toes" : ", no feet",
      options.fingers ? ", fingers" : "",
      !body.withMesh ? ", no mesh"
      : body.rigid   ? ", rigid parts"
                     : "");
  return {family.title, title, "biped", std::move(body), std::move(draft.wanted), std::move(draft.absent)};
}

// A rig with its program's own names and helpers, of any proportions in any pose.
FamilyRig drawWhole(const WholeRig& rig, Row& row) {
  BodyOptions options = optionsOf(rig);
  options.toes = options.toes && !row.once(5);
  Draft draft{makeBody(options), row};
  wantLimbs(draft, options);
  giveFlesh(draft, options);
  drawProportions(draft);
  const std::string pose = drawPose(draft);
  standOn(draft.body, 0.0);
  addHelpers(draft.body, rig);
  SyntheticBiped& body = draft.body;
  body.tubes = true;
  body.shuffled = row.once(3);
  body.armatureScale = row.once(3) ? row.oneOf(std::vector<double>{0.01, 100.0}) : 1.0;
  body.withMesh = !row.once(8);
  const bool facesBack = row.once(6);
  body.facesBackwards = facesBack;
  const bool lies = row.once(8);
  body.turn = lies ? axisAngle(Vec3(1, 0, 0), -pi / 2.0) : Quat(1, 0, 0, 0);
  const std::string title = fmt::format("{}, {}{}{}{}", rig.scheme.title, pose, facesBack ? ", faces -Z" : "",
                                        lies ? ", lies" : "", body.withMesh ? "" : ", no mesh");
  return {"whole rigs of programs", title, "biped", std::move(body), std::move(draft.wanted),
          std::move(draft.absent)};
}

} // namespace

std::vector<FamilyRig> wholeBipeds(int each) {
  std::vector<FamilyRig> rigs;
  Row row(4711);
  for (const WholeRig& rig : wholeRigs()) {
    for (int i = 0; i < each; ++i) {
      rigs.push_back(drawWhole(rig, row));
    }
  }
  return rigs;
}

std::vector<FamilyRig> bipedFamilies(int each) {
  std::vector<FamilyRig> rigs;
  std::uint32_t seed = 1;
  for (const Family& family : families) {
    Row row(seed++);
    for (int i = 0; i < each; ++i) {
      rigs.push_back(drawRig(family, row));
    }
  }
  return rigs;
}

} // namespace stretch::test

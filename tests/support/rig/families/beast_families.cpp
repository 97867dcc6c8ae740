#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/rig/families/beast.h"

namespace stretch::test {

namespace {} // namespace

void addLyingTrunk(Beast& beast, double height, double length, int spine, int neck, double rise) {
  const bool rooted = beast.row.once(2);
  if (rooted) {
    beast.add("root", "", Vec3(0.0));
    beast.body.joints.back().movesMesh = false;
  }
  beast.add("hips", rooted ? "root" : "", {0, height, -length / 2});
  beast.rowOf("spine", "hips", {0, height + 0.02, -length / 2 + length / (spine + 0.5)},
              {0, 0, length / (spine + 0.5)}, spine);
  const std::string chest = fmt::format("spine{}", spine);
  beast.rowOf("neck", chest, {0, height + 0.1 * rise, length / 2 + 0.12},
              {0, rise / (neck + 1), 0.3 / (neck + 1)}, neck);
  beast.add("head", neck > 0 ? fmt::format("neck{}", neck) : chest, {0, height + rise, length / 2 + 0.4},
            {0, -0.03, 0.25});
}

namespace {

void addHead(Beast& beast) {
  const Vec3 head = std::ranges::find(beast.body.joints, std::string("head"), &SyntheticJoint::key)->position;
  if (beast.row.once(2)) {
    beast.add("jaw", "head", head + Vec3(0, -0.06, 0.08), {0, 0, 0.12});
  }
  if (beast.row.once(2)) {
    beast.rowsOfBoth("ear", "head", head + Vec3(0.06, 0.08, -0.02), {0.03, 0.08, 0},
                     1 + static_cast<int>(beast.row.below(2)));
  }
  if (beast.row.once(4)) {
    beast.rowsOfBoth("antler", "head", head + Vec3(0.05, 0.1, -0.02), {0.12, 0.15, -0.03}, 3);
  }
}

// Legs in bones from a height to the ground; a knee that bends forward or back.
struct LegShape {
  std::string stem;
  std::string parent;
  Vec3 hip; // from the floor
  int bones = 2;
  double bend = 0.0;
};

void addLeg(Beast& beast, const LegShape& leg) {
  std::string above = leg.parent;
  const std::string& stem = leg.stem;
  const auto [x, top, z] = std::tuple(leg.hip.x, leg.hip.y, leg.hip.z);
  static const std::vector<std::vector<std::string>> parts{{"Upper", "Lower", "Foot"},
                                                           {"Upper", "Lower", "Ankle", "Foot"},
                                                           {"Upper", "Lower", "Hock", "Ankle", "Foot"}};
  const std::vector<std::string>& names = parts[static_cast<std::size_t>(leg.bones - 2)];
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(names.size() - 1);
    const double out = i == 0 || i + 1 == names.size() ? 0.0 : (i % 2 == 1 ? leg.bend : -leg.bend);
    const bool last = i + 1 == names.size();
    beast.both(stem + names[i], above, {x, top * (1.0 - share) + (last ? 0.04 * top : 0.0), z + out * top},
               last ? Vec3(0, -0.04 * top, 0.12 * top) : Vec3(0.0));
    above = stem + names[i] + "%";
  }
  if (beast.row.once(3)) {
    beast.both(stem + "Toe", above, {x, 0.01 * top, z + 0.14 * top}, {0, 0, 0.06 * top});
  }
}

} // namespace

std::string ends(const std::string& stem) {
  return stem + "Foot%|" + stem + "Toe%|" + stem + "Ankle%";
}

Beast quadruped(Row& row) {
  Beast beast{"quadruped", {}, {}, row};
  const double height = row.between(0.35, 1.3);
  const double length = row.between(0.7, 1.6);
  const int spine = 2 + static_cast<int>(row.below(3));
  const int neck = 1 + static_cast<int>(row.below(3));
  addLyingTrunk(beast, height, length, spine, neck, row.between(0.0, 0.8));
  addHead(beast);
  const bool beside = row.once(5);
  const std::string chest = fmt::format("spine{}", spine);
  const double x = row.between(0.1, 0.25);
  std::string shoulder = beside ? "hips" : chest;
  const bool scapula = row.once(3);
  if (scapula) {
    beast.both("scapula", shoulder, {0.6 * x, 1.08 * height, length / 2 - 0.05});
    shoulder = "scapula%";
  }
  const int frontBones = 2 + static_cast<int>(row.below(3));
  addLeg(beast, {"front", shoulder, {x, 0.95 * height, length / 2}, frontBones, 0.08});
  const int hindBones = 2 + static_cast<int>(row.below(3));
  addLeg(beast, {"hind", "hips", {x, 0.95 * height, -length / 2}, hindBones, 0.12});
  const int tail = static_cast<int>(row.below(6));
  if (tail > 1) {
    beast.rowOf("tail", "hips", {0, height, -length / 2 - 0.12}, {0, -0.05, -0.12}, tail);
    beast.wanted["tail"] = {"tail1", "", fmt::format("tail{}|estimated", tail)};
  }
  beast.wantBoth("front-%-leg", {"scapula%|frontUpper%", "frontLower%", ends("front")});
  beast.wantBoth("hind-%-leg", {"hindUpper%", "hindLower%", ends("hind")});
  if (row.once(4)) { // feet for inverse kinematics
    for (const char* const stem : {"front", "hind"}) {
      for (const std::string& side : bothSides) {
        SyntheticJoint& foot = jointOf(beast.body, stem + std::string("Foot") + side);
        SyntheticJoint& last = jointOf(beast.body, foot.parent);
        last.flesh = 0.92 * (foot.position - last.position);
        foot.parent = beast.has("root") ? "root" : "";
      }
    }
  }
  return beast;
}

namespace {

Beast lizard(Row& row) {
  Beast beast{"quadruped", {}, {}, row};
  const double height = row.between(0.14, 0.25);
  const double length = row.between(0.7, 1.1);
  addLyingTrunk(beast, height, length, 3, 1, row.around(0.05));
  addHead(beast);
  for (const auto& [stem, parent, z] :
       {std::tuple("front", "spine3", length / 2), std::tuple("hind", "hips", -length / 2)}) {
    const std::string name = stem;
    beast.both(name + "Upper", parent, {0.08, height, z});
    beast.both(name + "Lower", name + "Upper%", {0.26, 1.05 * height, z - 0.04});
    beast.both(name + "Foot", name + "Lower%", {0.34, 0.02, z + 0.02}, {0.03, -0.015, 0.08});
    beast.wantBoth(name + "-%-leg", {name + "Upper%", name + "Lower%", ends(name)});
  }
  beast.rowOf("tail", "hips", {0, 0.9 * height, -length / 2 - 0.15}, {0, -0.015, -0.17}, 5);
  beast.wanted["tail"] = {"tail1", "", "tail5|estimated"};
  return beast;
}

} // namespace

void addBirdLegs(Beast& beast, double height, double z) {
  const bool backwards = beast.row.once(2);
  beast.both("legUpper", "hips", {0.12, 0.9 * height, z});
  beast.both("legLower", "legUpper%", {0.13, 0.55 * height, z + 0.15 * height});
  if (backwards) {
    beast.both("legAnkle", "legLower%", {0.13, 0.25 * height, z - 0.1 * height});
  }
  beast.both("legFoot", backwards ? "legAnkle%" : "legLower%", {0.13, 0.04 * height, z + 0.02},
             {0, -0.03 * height, 0.1});
  beast.wantBoth("%-leg", {"legUpper%", "legLower%", "legFoot%"});
}

Beast bird(Row& row) {
  Beast beast{"bird", {}, {}, row};
  const double height = row.between(0.3, 0.9);
  const double length = row.between(0.4, 0.7);
  const int neck = static_cast<int>(row.below(3));
  addLyingTrunk(beast, height, length, 2, neck, row.between(0.1, 0.4));
  addBirdLegs(beast, height, -0.1);
  if (row.once(2)) {
    beast.add("beak", "head", jointOf(beast.body, "head").position + Vec3(0, -0.02, 0.15), {0, 0, 0.1});
  }
  beast.rowsOfBoth("wing", "spine2", {0.12, height + 0.05, 0.15}, {row.between(0.25, 0.45), 0.01, -0.04}, 4);
  beast.rowOf("tail", "hips", {0, height, -0.45}, {0, -0.01, -0.15}, 2);
  beast.wantBoth("%-wing", {"wing1%", "wing2%", "wing4%|wing3%|estimated"});
  return beast;
}

namespace {

Beast dinosaur(Row& row) {
  Beast beast{"bird", {}, {}, row};
  const double height = row.between(0.7, 1.2);
  const int spine = 2 + static_cast<int>(row.below(2));
  const int neck = 1 + static_cast<int>(row.below(2));
  addLyingTrunk(beast, height, 0.7, spine, neck, row.between(0.1, 0.4));
  addHead(beast);
  addBirdLegs(beast, height, -0.3);
  const std::string chest = beast.has("spine3") ? "spine3" : "spine2";
  beast.both("armUpper", chest, {0.15, height - 0.1, 0.4});
  beast.both("armLower", "armUpper%", {0.16, height - 0.22, 0.42});
  beast.both("armHand", "armLower%", {0.15, height - 0.26, 0.52}, {0, 0, 0.05});
  beast.rowOf("tail", "hips", {0, height, -0.55}, {0, -0.03, -0.25}, 5);
  beast.wanted["tail"] = {"tail1", "", "tail5|estimated"};
  beast.wantBoth("%-arm", {"armUpper%", "armLower%", "armHand%"});
  return beast;
}

} // namespace

Beast manyLegged(Row& row, int rows, bool flies) {
  Beast beast{rows == 3 ? "insect" : "spider", {}, {}, row};
  const double height = row.between(0.2, 0.45);
  beast.add("root", "", Vec3(0, 0, 0));
  beast.body.joints.back().movesMesh = false;
  beast.add("thorax", "root", {0, height, 0});
  beast.add("abdomen", "thorax", {0, height, -0.2}, {0, 0, -0.5});
  beast.add("head", "thorax", {0, height, 0.3}, {0, 0, 0.2});
  for (int i = 0; i < rows; ++i) {
    const std::string stem = fmt::format("leg{}_", i + 1);
    const double share = rows > 1 ? static_cast<double>(i) / (rows - 1) : 0.0;
    const double z = 0.2 - 0.4 * share;
    const double fan = 0.7 - 1.4 * share;
    const double reach = flies ? 0.25 : row.between(0.5, 0.9);
    std::string parent = "thorax";
    if (row.once(3)) {
      beast.both(stem + "coxa", "thorax", {0.06, height, 0.8 * z});
      parent = stem + "coxa%";
    }
    beast.both(stem + "upper", parent, {0.12, height, z});
    beast.both(stem + "middle", stem + "upper%",
               {0.12 + 0.5 * reach, flies ? height - 0.05 : 1.5 * height, z + 0.4 * fan * reach});
    beast.both(stem + "tip", stem + "middle%",
               {0.12 + reach, flies ? height - 0.2 : 0.02, z + 0.8 * fan * reach},
               flies ? Vec3(0, -0.04, 0) : Vec3(0.02, -0.02, 0));
    const std::string id = i == 0 ? "%-leg" : fmt::format("%-leg-{}", i + 1);
    beast.wantBoth(id, {stem + "coxa%|" + stem + "upper%", stem + "middle%", stem + "tip%|estimated"});
  }
  if (flies || row.once(4)) {
    beast.rowsOfBoth("wing", "thorax", {0.1, height + 0.1, 0.0}, {0.35, 0.05, -0.1},
                     2 + static_cast<int>(row.below(2)));
  }
  if (row.once(2)) {
    beast.rowsOfBoth("antenna", "head", {0.06, height + 0.08, 0.42}, {0.05, 0.06, 0.12}, 3);
  } else if (row.once(2)) {
    beast.rowsOfBoth("mandible", "head", {0.06, height - 0.02, 0.5}, {0.0, 0.0, 0.08}, 2);
  }
  return beast;
}

namespace {

Beast insect(Row& row) {
  return manyLegged(row, 3, false);
}
Beast flyingInsect(Row& row) {
  return manyLegged(row, 3, true);
}
Beast spider(Row& row) {
  return manyLegged(row, 4, false);
}

Beast snake(Row& row) {
  Beast beast{"serpent", {}, {}, row};
  const int count = 8 + static_cast<int>(row.below(20));
  const double bend = row.once(2) ? row.between(0.1, 0.3) : 0.0;
  const double rise = row.once(3) ? 0.4 : 0.0;
  std::string above;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    const std::string key = i + 1 == count ? "head" : fmt::format("body{}", i + 1);
    beast.add(
        key, above,
        {bend * std::sin(7.0 * share), 0.05 + rise * std::max(0.0, share - 0.7) * 3.0, -1.0 + 2.0 * share},
        i + 1 == count ? Vec3(0, 0, 0.1) : Vec3(0.0));
    above = key;
  }
  if (row.once(2)) {
    beast.add("jaw", "head", jointOf(beast.body, "head").position + Vec3(0, -0.02, 0.04), {0, 0, 0.06});
  }
  beast.wanted["spine"] = {"body1|body2", "body4", fmt::format("head|body{}|jaw|estimated", count - 1)};
  return beast;
}

} // namespace

Beast fish(Row& row) {
  Beast beast{"serpent", {}, {}, row};
  const int count = 5 + static_cast<int>(row.below(5));
  const double length = 2.0;
  std::string above;
  for (int i = 0; i < count; ++i) {
    const std::string key = i == 0 ? "head" : fmt::format("body{}", i);
    beast.add(key, above, {0, 0.6, 1.0 - length * i / (count - 1)}, i == 0 ? Vec3(0, 0, 0.2) : Vec3(0.0));
    above = key;
  }
  beast.rowsOfBoth("fin", "body1", {0.15, 0.5, 0.5}, {0.2, -0.08, -0.1}, 2);
  if (row.once(2)) {
    beast.add("dorsal", "body2", {0, 0.8, 0.0}, {0, 0.2, -0.1});
  }
  beast.wanted["spine"] = {"head|body1", "body2", fmt::format("body{}|estimated", count - 1)};
  return beast;
}

namespace {

const std::vector<BeastKind> kinds{{"quadruped", quadruped},
                                   {"lizard", lizard},
                                   {"bird", bird},
                                   {"two-legged dinosaur", dinosaur},
                                   {"insect", insect},
                                   {"flying insect", flyingInsect},
                                   {"spider", spider},
                                   {"snake", snake},
                                   {"fish", fish}};

FamilyRig drawBeast(const BeastKind& kind, Row& row) {
  Beast beast = kind.make(row);
  SyntheticBiped& body = beast.body;
  body.tubes = true;
  DrawnNames names{"names by parts", true};
  const std::map<std::string, std::string> given = body.names;
  if (row.once(3)) {
    names = drawNames(body, row);
    if (names.tell) {
      body.names = given;
      names.title = "names by parts";
    }
  }
  nameOthers(body, names, row);
  body.shuffled = row.once(3);
  body.size = row.once(3) ? row.oneOf(std::vector<double>{0.01, 100.0}) : 1.0;
  body.armatureScale = row.once(3) ? row.oneOf(std::vector<double>{0.01, 2000.0}) : 1.0;
  body.posedAtRest = row.once(4);
  body.withMesh = !row.once(12);
  body.facesBackwards = row.once(5);
  const std::string title =
      fmt::format("{}{}{}, {} joints", names.title, body.facesBackwards ? ", faces -Z" : "",
                  body.withMesh ? "" : ", no mesh", body.joints.size());
  return {kind.title, title, beast.plan, std::move(body), std::move(beast.wanted), {}};
}

std::vector<FamilyRig> drawAll(const std::vector<BeastKind>& of, std::uint32_t seed, int each) {
  std::vector<FamilyRig> rigs;
  for (const BeastKind& kind : of) {
    Row row(seed++);
    for (int i = 0; i < each; ++i) {
      rigs.push_back(drawBeast(kind, row));
    }
  }
  return rigs;
}

} // namespace

std::vector<FamilyRig> beastFamilies(int each) {
  return drawAll(kinds, 101, each);
}

std::vector<FamilyRig> rareBeasts(int each) {
  return drawAll(rareKinds(), 501, each);
}

} // namespace stretch::test

// Drawn rigs as other exporters and riggers would have them: the same body, other joints around it.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "rig/body/reading/detection.h"
#include "tests/support/recorded.h"
#include "tests/support/rig/described_limbs.h"
#include "tests/support/rig/families/family_table.h"
#include "tests/support/rig/naming_schemes.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

struct Change {
  std::string title;
  std::function<void(SyntheticBiped&, Row&)> make;
};

SyntheticJoint* find(SyntheticBiped& body, const std::string& key) {
  const auto found = std::ranges::find(body.joints, key, &SyntheticJoint::key);
  return found == body.joints.end() ? nullptr : &*found;
}

bool isOfTrunk(const SyntheticJoint& joint) {
  return std::ranges::any_of(
      std::array{"hips", "spine", "chest", "neck", "clavicle", "scapula", "thorax", "body"},
      [&](const char* stem) { return joint.key.starts_with(stem); });
}

void unlistTrunk(SyntheticBiped& body, Row& row) {
  for (SyntheticJoint& joint : body.joints) {
    if (isOfTrunk(joint) && row.once(3)) {
      joint.isJoint = joint.movesMesh = false;
    }
  }
}

void weighNothing(SyntheticBiped& body, Row& row) {
  for (SyntheticJoint& joint : body.joints) {
    joint.movesMesh = joint.movesMesh && !(isOfTrunk(joint) && row.once(2));
  }
}

void hangTrunkFrom(SyntheticBiped& body, const std::string& parent) {
  SyntheticJoint* const spine = find(body, "spine0");
  if (spine != nullptr && (parent.empty() || find(body, parent) != nullptr)) {
    spine->parent = parent;
  }
}

void putHelpers(SyntheticBiped& body, Row& /*row*/) {
  for (const char* const limb : {"thigh.l", "thigh.r", "upperArm.l", "upperArm.r"}) {
    SyntheticJoint* const joint = find(body, limb);
    if (joint == nullptr || joint->parent.empty()) {
      continue;
    }
    const std::string key = std::string("helper ") + limb;
    const SyntheticJoint helper{key, joint->parent,
                                0.5 * (jointOf(body, joint->parent).position + joint->position)};
    joint->parent = key;
    body.names[key] = "bone";
    body.joints.push_back(helper);
  }
}

void putRoots(SyntheticBiped& body, Row& /*row*/) {
  for (SyntheticJoint& joint : body.joints) {
    joint.parent = joint.parent.empty() ? "motion" : joint.parent;
  }
  body.joints.insert(body.joints.begin(),
                     {{"global", "", Vec3(0.0), true, false}, {"motion", "global", Vec3(0.0), true, false}});
  body.names["global"] = "global";
  body.names["motion"] = "motion";
}

void addIdleCopy(SyntheticBiped& body, Row& /*row*/) {
  SyntheticBiped copy = body;
  for (SyntheticJoint& joint : copy.joints) {
    joint.movesMesh = false;
  }
  addOther(body, copy, Vec3(0.0));
}

// A row of joints that hangs from one that the body has, as offsets and steps of its height.
void hangRow(SyntheticBiped& body, const std::string& parent, const Vec3& start, const Vec3& step,
             int count) {
  const auto [lowest, highest] =
      std::ranges::minmax(body.joints, {}, [](const SyntheticJoint& joint) { return joint.position.y; });
  const double height = highest.position.y - lowest.position.y;
  std::string above = parent;
  for (int i = 0; i < count; ++i) {
    const std::string key = fmt::format("{} row {}", parent, i);
    const Vec3 place = jointOf(body, above).position + height * (i == 0 ? start : step);
    body.joints.push_back({key, above, place});
    body.names[key] = fmt::format("Bone.{:03}", 200 + i);
    above = key;
  }
}

void putPonytail(SyntheticBiped& body, Row& /*row*/) {
  if (find(body, "head") != nullptr) {
    hangRow(body, "head", {0.0, 0.06, -0.06}, {0.0, -0.07, -0.01}, 8);
  }
}

void putBackpack(SyntheticBiped& body, Row& /*row*/) {
  std::string chest;
  for (const SyntheticJoint& joint : body.joints) {
    chest = joint.key.starts_with("spine") ? std::max(chest, joint.key) : chest;
  }
  if (!chest.empty()) {
    hangRow(body, chest, {0.0, 0.0, -0.1}, {0.0, 0.15, -0.02}, 3);
  }
}

const std::vector<Change>& changes() {
  static const std::vector<Change> all{
      {"bones of the trunk that no skin lists, since no vertex follows them", unlistTrunk},
      {"bones of the trunk that no vertex follows", weighNothing},
      {"trunk that hangs from nothing", [](SyntheticBiped& body, Row&) { hangTrunkFrom(body, ""); }},
      {"trunk that hangs from the root", [](SyntheticBiped& body, Row&) { hangTrunkFrom(body, "root"); }},
      {"joints between the trunk and the limbs", putHelpers},
      {"two roots more", putRoots},
      {"another skeleton in the same place that moves nothing", addIdleCopy},
      {"one name for all",
       [](SyntheticBiped& body, Row&) {
         for (auto& [key, name] : body.names) {
           name = "joint";
         }
       }},
      {"a ponytail", putPonytail},
      {"a backpack", putBackpack},
      {"no mesh", [](SyntheticBiped& body, Row&) { body.withMesh = false; }},
      {"an armature of another scale",
       [](SyntheticBiped& body, Row&) {
         body.armatureScale = 0.01;
         body.size = 37.0;
       }},
  };
  return all;
}

} // namespace

TEST_CASE("Of drawn rigs that are read rightly others of the same body are read or doubted as often as was "
          "counted") {
  constexpr int each = 2; // of each family
  std::vector<FamilyRig> rigs = wholeBipeds(each);
  std::ranges::move(bipedFamilies(each), std::back_inserter(rigs));
  std::ranges::move(beastFamilies(each), std::back_inserter(rigs));
  Calibration limbs;
  std::erase_if(rigs, [&](const FamilyRig& rig) { return !judge(rig, limbs).right; });
  std::string text;
  for (const Change& change : changes()) {
    Row row(78);
    std::vector<FamilyRig> changed = rigs;
    for (FamilyRig& rig : changed) {
      change.make(rig.body, row);
      rig.family = change.title;
    }
    text += familiesTable(changed, limbs, nullptr);
  }
  const std::string difference = differenceFromRecord("changed-rigs", text);
  INFO(difference);
  CHECK(difference.empty());
}

TEST_CASE("A skeleton in the place of another one that moves a mesh as well is told, and one beside it not") {
  const bool isBeside = GENERATE(false, true);
  SyntheticBiped body = makeNamedBody("Mixamo");
  addOther(body, makeNamedBody("Mixamo"), {isBeside ? 1.3 : 0.0, 0.0, 0.0});
  CHECK(warnsOf(detectBody(build(body).scene), "more than one skeleton in the same place") != isBeside);
}

TEST_CASE("A copy of the upper body that moves hair is told, and one that moves nothing not") {
  const bool moves = GENERATE(true, false);
  SyntheticBiped body = makeNamedBody("Mixamo");
  SyntheticBiped hair = makeNamedBody("Mixamo");
  std::erase_if(hair.joints,
                [](const SyntheticJoint& joint) { return joint.key.find('.') != std::string::npos; });
  for (SyntheticJoint& joint : hair.joints) {
    joint.movesMesh = moves && joint.key == "head";
  }
  addOther(body, hair, Vec3(0.0));
  CHECK(warnsOf(detectBody(build(body).scene), "more than one skeleton in the same place") == moves);
}

#include "rig/body/locators/locator_plans.h"

#include <algorithm>

#include <fmt/format.h>

namespace stretch::rig {

namespace {

using Joints = std::vector<LocatorJoint>;

// The same limb on the left and on the right: names get their sides, and so do parents that are of the limb.
void addPair(LocatorPlan& plan, const Joints& limb) {
  for (const auto& [side, word] :
       {std::pair{LimbSide::left, std::string("left")}, std::pair{LimbSide::right, std::string("right")}}) {
    for (LocatorJoint joint : limb) {
      const bool isOnLimb = std::ranges::find(limb, joint.parent, &LocatorJoint::name) != limb.end();
      joint.name = word + joint.name;
      joint.parent = (isOnLimb ? word : "") + joint.parent;
      joint.limb.side = side;
      plan.joints.push_back(joint);
    }
  }
}

// A row of joints, each below the one before it.
Joints row(const std::string& parent, const std::vector<std::pair<std::string, double>>& names,
           const LimbPlace& limb, bool isNeeded = true, bool facesUp = true) {
  Joints joints;
  for (const auto& [name, along] : names) {
    joints.push_back({name, joints.empty() ? parent : joints.back().name, isNeeded, limb, along, facesUp});
  }
  return joints;
}

// Faces as the body does; its last joint, the foot, faces up.
Joints leg(const std::string& parent, const std::vector<std::pair<std::string, double>>& names, int place) {
  Joints joints = row(parent, names, {LimbKind::leg, LimbSide::left, place}, true, false);
  joints.back().facesUp = true;
  return joints;
}

void add(LocatorPlan& plan, const Joints& joints) {
  plan.joints.insert(plan.joints.end(), joints.begin(), joints.end());
}

// Named as VRM's table of humanoid bones names them.
LocatorPlan bipedLocators() {
  LocatorPlan plan{"biped", {}, {"UpperArm", "UpperLeg"}, true};
  plan.joints = {{"hips", ""},
                 {"spine", "hips"},
                 {"chest", "spine", false},
                 {"upperChest", "chest", false},
                 {"neck", "upperChest", false},
                 {"head", "neck"}};
  addPair(plan, {{"Shoulder", "upperChest", false},
                 {"UpperArm", "Shoulder"},
                 {"LowerArm", "UpperArm"},
                 {"Hand", "LowerArm"}});
  addPair(plan, {{"UpperLeg", "hips"},
                 {"LowerLeg", "UpperLeg"},
                 {"Foot", "LowerLeg", true, {}, 0.0, true},
                 {"Toes", "Foot", false, {}, 0.0, true}});
  return plan;
}

// From the hips to the head.
void addTrunk(LocatorPlan& plan) {
  add(plan, row("", {{"hips", 0.0}, {"spine", 0.5}, {"chest", 1.0}}, biped::spine));
  add(plan, row("chest", {{"neck", 0.25}, {"head", 0.6}}, biped::neck));
}

const LimbPlace tail{LimbKind::tail};
const LimbPlace wing{LimbKind::wing, LimbSide::left};

LocatorPlan quadrupedLocators() {
  LocatorPlan plan{"quadruped", {}, {"Shoulder", "Hip"}};
  addTrunk(plan);
  add(plan, row("hips", {{"tail1", 0.15}, {"tail2", 0.4}, {"tail3", 0.7}, {"tail4", 1.0}}, tail, false));
  addPair(plan, leg("chest", {{"Shoulder", 0.0}, {"Elbow", 0.42}, {"Wrist", 0.75}, {"FrontPaw", 0.9}}, 1));
  addPair(plan, leg("hips", {{"Hip", 0.0}, {"Knee", 0.33}, {"Hock", 0.6}, {"HindPaw", 0.88}}, 2));
  addPair(plan, row("chest", {{"Wing1", 0.0}, {"Wing2", 0.3}, {"Wing3", 0.6}, {"Wing4", 1.0}}, wing, false));
  return plan;
}

LocatorPlan birdLocators() {
  LocatorPlan plan{"bird", {}, {"Hip"}};
  addTrunk(plan);
  add(plan, row("hips", {{"tail1", 0.15}, {"tail2", 0.5}, {"tail3", 1.0}}, tail, false));
  addPair(plan, leg("hips", {{"Hip", 0.0}, {"Knee", 0.22}, {"Ankle", 0.44}, {"Foot", 0.75}}, 1));
  addPair(plan, row("chest", {{"Wing1", 0.0}, {"Wing2", 0.3}, {"Wing3", 0.6}, {"Wing4", 1.0}}, wing, false));
  addPair(plan, row("chest", {{"UpperArm", 0.0}, {"LowerArm", 0.45}, {"Hand", 0.85}},
                    {LimbKind::arm, LimbSide::left}, false));
  return plan;
}

LocatorPlan manyLegs(const std::string& id, int rows) {
  LocatorPlan plan{id, {}, {"Leg1Base"}};
  add(plan, row("", {{"thorax", 0.5}}, biped::spine));
  add(plan, row("thorax", {{"head", 0.3}}, biped::neck));
  add(plan, row("thorax", {{"abdomen1", 0.25}, {"abdomen2", 1.0}}, tail, false));
  for (int place = 1; place <= rows; ++place) {
    const std::string name = fmt::format("Leg{}", place);
    addPair(plan,
            leg("thorax",
                {{name + "Base", 0.0}, {name + "Knee", 0.33}, {name + "Ankle", 0.66}, {name + "Foot", 1.0}},
                place));
  }
  addPair(plan, row("thorax", {{"Wing1", 0.0}, {"Wing2", 0.5}, {"Wing3", 1.0}}, wing, false));
  addPair(plan, row("head", {{"Feeler1", 0.0}, {"Feeler2", 0.5}, {"Feeler3", 1.0}},
                    {LimbKind::feeler, LimbSide::left}, false));
  return plan;
}

} // namespace

const std::vector<LocatorPlan>& locatorPlans() {
  static const std::vector<LocatorPlan> plans{bipedLocators(), quadrupedLocators(), birdLocators(),
                                              manyLegs("insect", 3), manyLegs("spider", 4)};
  return plans;
}

const LocatorPlan* locatorPlan(std::string_view id) {
  const auto found = std::ranges::find(locatorPlans(), id, &LocatorPlan::id);
  return found == locatorPlans().end() ? nullptr : &*found;
}

std::vector<std::string> locatorPlanIds() {
  std::vector<std::string> ids;
  for (const LocatorPlan& plan : locatorPlans()) {
    ids.push_back(plan.id);
  }
  return ids;
}

const LocatorJoint* findJoint(const LocatorPlan& plan, std::string_view name) {
  const auto found = std::ranges::find(plan.joints, name, &LocatorJoint::name);
  return found == plan.joints.end() ? nullptr : &*found;
}

} // namespace stretch::rig

#include "rig/controllers/controller.h"

#include <algorithm>
#include <set>

#include "rig/body/detection.h"
#include "rig/controllers/finger_joints.h"

namespace stretch::rig {

namespace {

bool isArmKind(LimbKind kind) {
  return kind == LimbKind::leftArm || kind == LimbKind::rightArm;
}

// Of the left leg, else of the right one: lengths of what has no limb.
double bodyLength(const std::vector<Limb>& limbs) {
  for (const LimbKind kind : {LimbKind::leftLeg, LimbKind::rightLeg, LimbKind::spine}) {
    if (const Limb* const limb = limbOfKind(limbs, kind)) {
      return limb->restLength;
    }
  }
  return limbs.empty() ? 1.0 : limbs.front().restLength;
}

void addSpine(const Limb& spine, ControllerList& list) {
  const NodeIndex chest = spine.endNode;
  const NodeIndex middle = spine.joints[spine.joints.size() / 2];
  list.controllers.push_back(
      {"spine-low", ControllerKind::spineLow, spine.joints.front(), spine.id, true, false, spine.restLength});
  list.controllers.push_back(
      {"spine-mid", ControllerKind::spineMiddle, middle, spine.id, true, false, spine.restLength});
  list.controllers.push_back(
      {"spine-top", ControllerKind::spineTop, chest, spine.id, true, true, spine.restLength});
}

ControllerKind endKind(LimbKind kind) {
  if (kind == LimbKind::neck) {
    return ControllerKind::head;
  }
  return isArmKind(kind) ? ControllerKind::hand : ControllerKind::foot;
}

void addEnd(const Limb& limb, ControllerList& list) {
  list.controllers.push_back({endController(limb.kind), endKind(limb.kind), limb.endNode, limb.id, true,
                              limb.endNode.exists(), limb.restLength});
}

void addPole(const Limb& limb, ControllerList& list) {
  if (limb.joints.size() > 1) {
    list.controllers.push_back({poleController(limb.kind), ControllerKind::pole, limb.joints[1], limb.id,
                                true, false, limb.restLength});
  }
}

void addAttributes(const Scene& scene, const Limb& limb, ControllerList& list) {
  list.attributes.push_back({limb.id + ".stretch", AttributeKind::stretch, limb.id, 0.0, 1.0, 1.0});
  list.attributes.push_back({limb.id + ".volume", AttributeKind::volume, limb.id, 0.0, 1.0, 1.0});
  if (limb.kind != LimbKind::spine) {
    list.attributes.push_back(
        {limb.id + ".follow", AttributeKind::follow, limb.id, 0.0, 1.0, isLeg(limb) ? 0.0 : 1.0});
  }
  if (isArmKind(limb.kind) && !fingerJoints(scene, limb).empty()) {
    list.attributes.push_back(
        {endController(limb.kind) + ".curl", AttributeKind::curl, limb.id, -0.2, 1.0, 0.0});
  }
  if (isLeg(limb) && limb.endNode.exists()) {
    list.attributes.push_back(
        {endController(limb.kind) + ".roll", AttributeKind::roll, limb.id, -1.0, 1.0, 0.0});
  }
}

// The joints that other controllers move.
std::set<NodeIndex> takenJoints(const std::vector<Limb>& limbs, NodeIndex hips) {
  std::set<NodeIndex> taken{hips};
  for (const Limb& limb : limbs) {
    if (limb.kind != LimbKind::chain) {
      taken.insert(limb.joints.begin(), limb.joints.end());
      taken.insert(limb.endNode);
    }
  }
  taken.erase(NodeIndex::none);
  return taken;
}

Controller onJoint(const std::string& id, NodeIndex joint, const std::vector<Limb>& limbs) {
  return {id, ControllerKind::joint, joint, "", false, true, bodyLength(limbs)};
}

std::string jointId(const Scene& scene, NodeIndex joint) {
  const std::string& name = scene.nodes[at(joint)].name;
  const Result<NodeIndex> named = jointByName(scene, name);
  return named && *named == joint ? name : "#" + std::to_string(joint.value);
}

std::string controllerNames(const ControllerList& list) {
  std::string names;
  for (const Controller& controller : list.controllers) {
    names += (names.empty() ? "" : ", ") + controller.id;
  }
  return names.empty() ? "none" : names;
}

} // namespace

const Controller* ControllerList::controller(const std::string& id) const {
  const auto found = std::ranges::find(controllers, id, &Controller::id);
  return found == controllers.end() ? nullptr : &*found;
}

const Attribute* ControllerList::attribute(const std::string& id) const {
  const auto found = std::ranges::find(attributes, id, &Attribute::id);
  return found == attributes.end() ? nullptr : &*found;
}

const Limb* limbOfKind(const std::vector<Limb>& limbs, LimbKind kind) {
  const auto found = std::ranges::find_if(
      limbs, [&](const Limb& limb) { return limb.kind == kind && !limb.joints.empty(); });
  return found == limbs.end() ? nullptr : &*found;
}

std::string endController(LimbKind kind) {
  switch (kind) {
  case LimbKind::leftArm:
    return "left-hand";
  case LimbKind::rightArm:
    return "right-hand";
  case LimbKind::leftLeg:
    return "left-foot";
  case LimbKind::rightLeg:
    return "right-foot";
  case LimbKind::neck:
    return "head";
  case LimbKind::spine:
  case LimbKind::chain:
    break;
  }
  return {};
}

std::string poleController(LimbKind kind) {
  switch (kind) {
  case LimbKind::leftArm:
    return "left-elbow";
  case LimbKind::rightArm:
    return "right-elbow";
  case LimbKind::leftLeg:
    return "left-knee";
  case LimbKind::rightLeg:
    return "right-knee";
  case LimbKind::neck:
  case LimbKind::spine:
  case LimbKind::chain:
    break;
  }
  return {};
}

ControllerList controllersOf(const Scene& scene, const std::vector<Limb>& limbs, NodeIndex hips) {
  ControllerList list;
  const double length = bodyLength(limbs);
  if (hips.exists()) {
    list.controllers.push_back({"body", ControllerKind::body, NodeIndex::none, "", true, true, length});
    list.controllers.push_back({"hips", ControllerKind::hips, hips, "", true, true, length});
  }
  if (const Limb* const spine = limbOfKind(limbs, LimbKind::spine)) {
    addSpine(*spine, list);
  }
  for (const LimbKind kind :
       {LimbKind::neck, LimbKind::leftArm, LimbKind::rightArm, LimbKind::leftLeg, LimbKind::rightLeg}) {
    if (const Limb* const limb = limbOfKind(limbs, kind)) {
      addEnd(*limb, list);
    }
  }
  for (const LimbKind kind : {LimbKind::leftArm, LimbKind::rightArm, LimbKind::leftLeg, LimbKind::rightLeg}) {
    if (const Limb* const limb = limbOfKind(limbs, kind)) {
      addPole(*limb, list);
    }
  }
  for (const LimbKind kind : {LimbKind::leftArm, LimbKind::rightArm, LimbKind::leftLeg, LimbKind::rightLeg,
                              LimbKind::spine, LimbKind::neck}) {
    if (const Limb* const limb = limbOfKind(limbs, kind)) {
      addAttributes(scene, *limb, list);
    }
  }
  return list;
}

Result<Controller> controllerNamed(const Scene& scene, const std::vector<Limb>& limbs, NodeIndex hips,
                                   const ControllerList& list, const std::string& id) {
  if (const Controller* const known = list.controller(id)) {
    return *known;
  }
  const Result<NodeIndex> joint = jointByName(scene, id);
  if (!joint) {
    return Error{"the character has no controller '" + id + "'", "controller",
                 "give a joint by its name or #index, or one of: " + controllerNames(list)};
  }
  if (takenJoints(limbs, hips).contains(*joint)) {
    return Error{"the joint '" + id + "' belongs to a limb or to the hips", "controller",
                 "move it by one of: " + controllerNames(list)};
  }
  return onJoint(id, *joint, limbs);
}

std::vector<Controller> jointControllers(const Scene& scene, const std::vector<Limb>& limbs, NodeIndex hips) {
  const std::set<NodeIndex> taken = takenJoints(limbs, hips);
  std::set<NodeIndex> joints;
  for (const Skin& skin : scene.skins) {
    joints.insert(skin.joints.begin(), skin.joints.end());
  }
  std::vector<Controller> controllers;
  for (const NodeIndex joint : joints) {
    if (hips.exists() && isAncestorOrSelf(scene, hips, joint) && !taken.contains(joint)) {
      controllers.push_back(onJoint(jointId(scene, joint), joint, limbs));
    }
  }
  return controllers;
}

} // namespace stretch::rig

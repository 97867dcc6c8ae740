#include "rig/controllers/controller.h"

#include <algorithm>
#include <set>

#include "rig/body/reading/detection.h"
#include "rig/controllers/finger_joints.h"

namespace stretch::rig {

namespace {

// Lengths of whatever has no limb are measured by the left leg, else by the right one.
double bodyLength(const std::vector<Limb>& limbs) {
  for (const LimbKind kind : {LimbKind::leg, LimbKind::spine}) {
    if (const auto limb = std::ranges::find(limbs, kind, &Limb::kind); limb != limbs.end()) {
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

ControllerKind endKind(const Limb& limb) {
  switch (limb.kind) {
  case LimbKind::neck:
    return ControllerKind::head;
  case LimbKind::arm:
    return ControllerKind::hand;
  case LimbKind::leg:
    return ControllerKind::foot;
  default:
    return ControllerKind::tip;
  }
}

void addEnd(const Limb& limb, ControllerList& list) {
  list.controllers.push_back({endController(limb), endKind(limb), limb.endNode, limb.id, true,
                              limb.endNode.exists(), limb.restLength});
}

void addPole(const Limb& limb, ControllerList& list) {
  if (hasElbowOrKnee(limb) && limb.joints.size() > 1) {
    list.controllers.push_back(
        {poleController(limb), ControllerKind::pole, limb.joints[1], limb.id, true, false, limb.restLength});
  }
}

void addAttributes(const Scene& scene, const Limb& limb, ControllerList& list) {
  list.attributes.push_back({limb.id + ".stretch", AttributeKind::stretch, limb.id, 0.0, 1.0, 1.0});
  list.attributes.push_back({limb.id + ".volume", AttributeKind::volume, limb.id, 0.0, 1.0, 1.0});
  if (limb.kind != LimbKind::spine) {
    list.attributes.push_back(
        {limb.id + ".follow", AttributeKind::follow, limb.id, 0.0, 1.0, isLeg(limb) ? 0.0 : 1.0});
  }
  if (hasElbowOrKnee(limb)) {
    list.attributes.push_back(
        {limb.id + ".softness", AttributeKind::softness, limb.id, 0.0, mostSoftness, 0.0});
  }
  if (isArm(limb) && !fingerJoints(scene, limb).empty()) {
    list.attributes.push_back({endController(limb) + ".curl", AttributeKind::curl, limb.id, -0.2, 1.0, 0.0});
  }
  if (isLeg(limb) && limb.endNode.exists()) {
    list.attributes.push_back({endController(limb) + ".roll", AttributeKind::roll, limb.id, -1.0, 1.0, 0.0});
  }
}

// "left-hand" of "left-arm", "front-left-foot-2" of "front-left-leg-2".
std::string withWord(std::string id, std::string_view word, std::string_view by) {
  const std::size_t found = id.rfind(word);
  return found == std::string::npos ? id + "-" + std::string(by) : id.replace(found, word.size(), by);
}

std::vector<const Limb*> outerLimbs(const std::vector<Limb>& limbs) {
  std::vector<const Limb*> outer;
  for (const Limb& limb : limbs) {
    if (reachesOut(limb) && !limb.joints.empty()) {
      outer.push_back(&limb);
    }
  }
  return outer;
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

std::string endController(const Limb& limb) {
  switch (limb.kind) {
  case LimbKind::arm:
    return withWord(limb.id, "arm", "hand");
  case LimbKind::leg:
    return withWord(limb.id, "leg", "foot");
  case LimbKind::neck:
    return "head";
  case LimbKind::tail:
  case LimbKind::wing:
  case LimbKind::fin:
  case LimbKind::feeler:
    return limb.id + "-tip";
  case LimbKind::spine:
  case LimbKind::chain:
    break;
  }
  return {};
}

std::string poleController(const Limb& limb) {
  switch (limb.kind) {
  case LimbKind::arm:
    return withWord(limb.id, "arm", "elbow");
  case LimbKind::leg:
    return withWord(limb.id, "leg", "knee");
  case LimbKind::wing:
    return limb.id + "-elbow";
  default:
    return {};
  }
}

ControllerList controllersOf(const Scene& scene, const std::vector<Limb>& limbs, NodeIndex hips) {
  ControllerList list;
  const double length = bodyLength(limbs);
  const std::vector<const Limb*> outer = outerLimbs(limbs);
  if (hips.exists()) {
    list.controllers.push_back({"body", ControllerKind::body, NodeIndex::none, "", true, true, length});
    list.controllers.push_back({"hips", ControllerKind::hips, hips, "", true, true, length});
  }
  if (const Limb* const spine = limbAt(limbs, biped::spine)) {
    addSpine(*spine, list);
  }
  if (const Limb* const neck = limbAt(limbs, biped::neck)) {
    addEnd(*neck, list);
  }
  for (const Limb* const limb : outer) {
    addEnd(*limb, list);
  }
  for (const Limb* const limb : outer) {
    addPole(*limb, list);
  }
  for (const Limb& limb : limbs) {
    if (limb.kind != LimbKind::chain) {
      addAttributes(scene, limb, list);
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

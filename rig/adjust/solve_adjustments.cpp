#include "rig/adjust/solve_adjustments.h"

#include <algorithm>
#include <set>
#include <utility>

#include "rig/reach/limb_riders.h"

namespace stretch::rig {

namespace {

Quat bindRotation(const AdjustedBody& body, NodeIndex node) {
  return node.exists() ? rotationOf(body.places.worlds[at(node)]) : Quat(1.0, 0.0, 0.0, 0.0);
}

LimbControls controlsOf(const Limb& limb) {
  const std::string end = endController(limb);
  return {
      end,           poleController(limb), limb.id + ".follow",  limb.id + ".stretch", limb.id + ".volume",
      end + ".roll", end + ".curl",        limb.id + ".softness"};
}

// The highest nodes that carry limbs and do not hang on the hips, which do not hang on them either.
std::vector<NodeIndex> besideHips(const AdjustmentGround& ground) {
  std::vector<NodeIndex> bases;
  for (const Limb& limb : ground.limbs) {
    if (!limb.joints.empty() && !isAncestorOrSelf(ground.scene, ground.hips, limb.joints.front())) {
      bases.push_back(limb.joints.front());
    }
  }
  return highestCarriers(ground.scene, bases, {ground.hips});
}

std::vector<NodeIndex> detachedNodes(const Scene& scene, const AdjustedLimb& reaching) {
  const NodeIndex base = reaching.limb.joints.front();
  const bool hangsOnCarrier = isAncestorOrSelf(scene, reaching.carrier, base);
  const NodeIndex carrier = hangsOnCarrier ? reaching.carrier : base;
  std::vector<NodeIndex> nodes = reaching.limb.joints;
  nodes.push_back(reaching.limb.endNode);
  nodes.insert(nodes.end(), reaching.topology.companions.begin(), reaching.topology.companions.end());
  std::erase_if(nodes, [&](NodeIndex node) {
    return !node.exists() || !carrier.exists() || isAncestorOrSelf(scene, carrier, node);
  });
  return nodes;
}

// Front legs hang on the chest of a body with several rows of them.
bool hangsOnHips(const Scene& scene, const Limb& limb, NodeIndex chest) {
  const bool isFrontLeg =
      isLeg(limb) && limb.row > 0 && chest.exists() && isAncestorOrSelf(scene, chest, limb.joints.front());
  return (isLeg(limb) && !isFrontLeg) || limb.kind == LimbKind::tail;
}

AdjustedLimb adjustedLimb(const AdjustmentGround& ground, const AdjustedBody& body, const Limb& limb) {
  AdjustedLimb adjusted;
  static_cast<ReachingLimb&>(adjusted) =
      reachingLimb({ground.scene, ground.clip, ground.limbs, body.places}, limb);
  adjusted.controls = controlsOf(limb);
  const NodeIndex base = limb.joints.front();
  const bool isBesideHips = std::ranges::find(body.besideHips, base) != body.besideHips.end();
  adjusted.carrier = isBesideHips ? body.hips : ground.scene.nodes[at(base)].parent;
  adjusted.detached = detachedNodes(ground.scene, adjusted);
  adjusted.baseBind = bindRotation(body, limb.joints.front());
  if (isArm(limb)) {
    adjusted.fingers = handCurl(ground.scene, limb, body.places);
  }
  adjusted.hangsOnHips = hangsOnHips(ground.scene, limb, body.chest);
  if (isLeg(limb)) {
    adjusted.roll = footRoll(ground.scene, limb, adjusted.topology, body.places);
  }
  return adjusted;
}

// The highest nodes with all of the character below them: what carries every limb, or each root.
std::vector<NodeIndex> rootsOf(const AdjustmentGround& ground) {
  std::vector<NodeIndex> members{ground.hips};
  for (const Limb& limb : ground.limbs) {
    members.insert(members.end(), limb.joints.begin(), limb.joints.end());
    members.push_back(limb.endNode);
  }
  std::erase(members, NodeIndex::none);
  std::set<NodeIndex> roots;
  for (const NodeIndex member : members) {
    NodeIndex node = member;
    const auto carriesAll = [&](NodeIndex above) {
      return std::ranges::all_of(members,
                                 [&](NodeIndex m) { return isAncestorOrSelf(ground.scene, above, m); });
    };
    while (!carriesAll(node) && ground.scene.nodes[at(node)].parent.exists()) {
      node = ground.scene.nodes[at(node)].parent;
    }
    roots.insert(node);
  }
  return {roots.begin(), roots.end()};
}

OffsetCurves curvesOf(const AdjustmentInput& input, const AdjustedBody& body,
                      std::vector<AdjustedJoint>& joints) {
  const AdjustmentGround& ground = input.ground;
  OffsetCurves curves;
  for (const Adjustment& adjustment : input.adjustments) {
    const std::string& id = adjustment.controller;
    const Attribute* const attribute = body.list.attribute(id);
    const Result<Controller> controller =
        attribute != nullptr ? Result<Controller>(Controller{})
                             : controllerNamed(ground.scene, ground.limbs, ground.hips, body.list, id);
    if (!controller || adjustment.keys.empty()) {
      continue;
    }
    const bool isJoint = attribute == nullptr && controller->kind == ControllerKind::joint;
    if (isJoint && !curves.contains(id)) {
      joints.push_back(
          {id, controller->node, bindRotation(body, ground.scene.nodes[at(controller->node)].parent)});
    }
    const double standard = attribute != nullptr ? attribute->standard : 0.0;
    curves[id].emplace_back(adjustment, standard, ground.clip.framesPerSecond);
  }
  return curves;
}

std::vector<std::string> idsOfLimb(const ControllerList& list, const Limb& limb) {
  std::vector<std::string> ids;
  for (const Controller& controller : list.controllers) {
    if (controller.limb == limb.id) {
      ids.push_back(controller.id);
    }
  }
  for (const Attribute& attribute : list.attributes) {
    if (attribute.limb == limb.id) {
      ids.push_back(attribute.id);
    }
  }
  return ids;
}

// Whether the limb goes along with its carrier as one piece, so that nothing of it changes when the carrier
// moves.
bool rides(const Scene& scene, const SolvedAdjustments& solved, const AdjustedLimb& adjusted,
           NodeIndex carrier) {
  const Limb& limb = adjusted.limb;
  return !isLeg(limb) && carrier.exists() && !solved.curves.contains(adjusted.controls.follow) &&
         isAncestorOrSelf(scene, carrier, limb.joints.front()) &&
         (!limb.endNode.exists() || isAncestorOrSelf(scene, carrier, limb.endNode));
}

AdjustedPart partOf(const Scene& scene, const SolvedAdjustments& solved, const AdjustedLimb& adjusted) {
  const Limb& limb = adjusted.limb;
  const AdjustedBody& body = *solved.body;
  AdjustedPart part;
  part.nodes = touchedNodes(limb, adjusted.topology);
  part.boneLength = limb.restLength / static_cast<double>(limb.joints.size());
  part.ids = idsOfLimb(body.list, limb);
  for (const FingerJoint& finger : adjusted.fingers) {
    part.nodes.push_back(finger.node);
  }
  if (adjusted.roll.toes.exists()) {
    part.nodes.push_back(adjusted.roll.toes);
  }
  if (!rides(scene, solved, adjusted, body.hips)) {
    part.ids.emplace_back("hips");
  }
  if (body.spine && limb.kind != LimbKind::spine && !adjusted.hangsOnHips &&
      !rides(scene, solved, adjusted, body.chest)) {
    const std::vector<std::string> inner = idsOfLimb(body.list, body.spine->limb);
    part.ids.insert(part.ids.end(), inner.begin(), inner.end());
  }
  for (const AdjustedJoint& joint : solved.joints) {
    if (isAncestorOrSelf(scene, joint.node, limb.joints.front())) {
      part.ids.push_back(joint.id);
    }
  }
  std::ranges::sort(part.nodes);
  part.nodes.erase(std::unique(part.nodes.begin(), part.nodes.end()), part.nodes.end());
  return part;
}

bool isKeyed(const OffsetCurves& curves, const AdjustedPart& part) {
  return std::ranges::any_of(part.ids, [&](const std::string& id) { return curves.contains(id); });
}

void addParts(const Scene& scene, SolvedAdjustments& solved) {
  const AdjustedBody& body = *solved.body;
  solved.parts.push_back({body.roots, 0.0, {"body"}});
  if (body.hips.exists()) {
    std::vector<NodeIndex> carried{body.hips};
    carried.insert(carried.end(), body.besideHips.begin(), body.besideHips.end());
    solved.parts.push_back({std::move(carried), 0.0, {"hips"}});
  }
  std::set<NodeIndex> nodes{body.chest, body.hips};
  nodes.insert(body.besideHips.begin(), body.besideHips.end());
  const auto addLimb = [&](const AdjustedLimb& limb) {
    const AdjustedPart& part = solved.parts.emplace_back(partOf(scene, solved, limb));
    if (isKeyed(solved.curves, part)) {
      solved.moved.push_back(limb.limb);
      nodes.insert(part.nodes.begin(), part.nodes.end());
    }
  };
  for (const std::optional<AdjustedLimb>* limb : {&body.spine, &body.neck}) {
    if (*limb) {
      addLimb(**limb);
    }
  }
  std::for_each(body.limbs.begin(), body.limbs.end(), addLimb);
  for (const AdjustedJoint& joint : solved.joints) {
    solved.parts.push_back({{joint.node}, 0.0, {joint.id}});
  }
  nodes.insert(body.roots.begin(), body.roots.end());
  for (const AdjustedJoint& joint : solved.joints) {
    nodes.insert(joint.node);
  }
  nodes.erase(NodeIndex::none);
  solved.nodes.assign(nodes.begin(), nodes.end());
}

} // namespace

Offset offsetAt(const OffsetCurves& curves, const std::string& id, double timeSeconds, double standard) {
  Offset sum;
  sum.value = standard;
  const auto found = curves.find(id);
  if (found == curves.end()) {
    return sum;
  }
  for (const OffsetCurve& curve : found->second) {
    if (curve.covers(timeSeconds)) {
      const Offset offset = curve.at(timeSeconds);
      sum.move += offset.move;
      sum.turn += offset.turn;
      sum.value = offset.value;
    }
  }
  return sum;
}

AdjustedBody adjustedBody(const AdjustmentGround& ground) {
  AdjustedBody body;
  body.list = controllersOf(ground.scene, ground.limbs, ground.hips);
  body.jointControllers = jointControllers(ground.scene, ground.limbs, ground.hips);
  body.places = bindPlaces(ground.scene);
  body.forward = facingInBind(ground.limbs, body.places);
  body.hips = ground.hips;
  body.roots = rootsOf(ground);
  body.besideHips = besideHips(ground);
  const Limb* const spine = limbAt(ground.limbs, biped::spine);
  const Limb* const neck = limbAt(ground.limbs, biped::neck);
  body.chest =
      spine == nullptr ? ground.hips : (spine->endNode.exists() ? spine->endNode : spine->joints.back());
  body.hipsBind = bindRotation(body, body.hips);
  body.chestBind = bindRotation(body, body.chest);
  if (spine != nullptr) {
    body.spine = adjustedLimb(ground, body, *spine);
  }
  if (neck != nullptr) {
    body.neck = adjustedLimb(ground, body, *neck);
  }
  for (const Limb& limb : ground.limbs) {
    if (reachesOut(limb) && !limb.joints.empty()) {
      body.limbs.push_back(adjustedLimb(ground, body, limb));
    }
  }
  return body;
}

SolvedAdjustments solveAdjustments(const AdjustmentInput& input) {
  SolvedAdjustments solved;
  if (input.adjustments.empty()) {
    return solved;
  }
  solved.body =
      input.body != nullptr ? input.body : std::make_shared<const AdjustedBody>(adjustedBody(input.ground));
  solved.curves = curvesOf(input, *solved.body, solved.joints);
  if (!solved.empty()) {
    addParts(input.ground.scene, solved);
  }
  return solved;
}

} // namespace stretch::rig

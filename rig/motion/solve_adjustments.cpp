#include "rig/motion/solve_adjustments.h"

#include <algorithm>
#include <set>

namespace stretch::rig {

namespace {

// What is solved on the way, once for the whole character.
struct Workshop {
  const AdjustmentInput& input;
  BindPlaces places;
  ControllerList list;
};

Quat bindRotation(const Workshop& shop, NodeIndex node) {
  return node.exists() ? rotationOf(shop.places.worlds[at(node)]) : Quat(1.0, 0.0, 0.0, 0.0);
}

AdjustedLimb adjustedLimb(const Workshop& shop, const Limb& limb) {
  const AdjustmentInput& input = shop.input;
  AdjustedLimb adjusted{reachingLimb({input.scene, input.clip, input.limbs, shop.places}, limb)};
  adjusted.baseBind = bindRotation(shop, limb.joints.front());
  if (limb.kind == LimbKind::leftArm || limb.kind == LimbKind::rightArm) {
    adjusted.fingers = handCurl(shop.input.scene, limb, shop.places);
  }
  if (isLeg(limb)) {
    adjusted.roll = footRoll(shop.input.scene, limb, adjusted.topology, shop.places);
  }
  return adjusted;
}

// The highest nodes with all of the character below them: what carries every limb, or each root.
std::vector<NodeIndex> rootsOf(const AdjustmentInput& input) {
  std::vector<NodeIndex> members{input.hips};
  for (const Limb& limb : input.limbs) {
    members.insert(members.end(), limb.joints.begin(), limb.joints.end());
    members.push_back(limb.endNode);
  }
  std::erase(members, NodeIndex::none);
  std::set<NodeIndex> roots;
  for (const NodeIndex member : members) {
    NodeIndex node = member;
    const auto carriesAll = [&](NodeIndex above) {
      return std::ranges::all_of(members,
                                 [&](NodeIndex m) { return isAncestorOrSelf(input.scene, above, m); });
    };
    while (!carriesAll(node) && input.scene.nodes[at(node)].parent.exists()) {
      node = input.scene.nodes[at(node)].parent;
    }
    roots.insert(node);
  }
  return {roots.begin(), roots.end()};
}

OffsetCurves curvesOf(const Workshop& shop, std::vector<AdjustedJoint>& joints) {
  const AdjustmentInput& input = shop.input;
  OffsetCurves curves;
  for (const Adjustment& adjustment : input.adjustments) {
    const std::string& id = adjustment.controller;
    const Attribute* const attribute = shop.list.attribute(id);
    const Result<Controller> controller =
        attribute != nullptr ? Result<Controller>(Controller{})
                             : controllerNamed(input.scene, input.limbs, input.hips, shop.list, id);
    if (!controller || adjustment.keys.empty()) {
      continue;
    }
    const bool isJoint = attribute == nullptr && controller->kind == ControllerKind::joint;
    if (isJoint && !curves.contains(id)) {
      joints.push_back(
          {id, controller->node, bindRotation(shop, input.scene.nodes[at(controller->node)].parent)});
    }
    const double standard = attribute != nullptr ? attribute->standard : 0.0;
    curves[id].emplace_back(adjustment, standard, input.clip.framesPerSecond);
  }
  return curves;
}

std::vector<std::string> idsOfLimb(const Workshop& shop, const Limb& limb) {
  std::vector<std::string> ids;
  for (const Controller& controller : shop.list.controllers) {
    if (controller.limb == limb.id) {
      ids.push_back(controller.id);
    }
  }
  for (const Attribute& attribute : shop.list.attributes) {
    if (attribute.limb == limb.id) {
      ids.push_back(attribute.id);
    }
  }
  return ids;
}

// Whether the limb goes along with its carrier as one piece, so that nothing of it changes when the carrier
// moves.
bool rides(const Workshop& shop, const SolvedAdjustments& solved, const AdjustedLimb& adjusted,
           NodeIndex carrier) {
  const Limb& limb = adjusted.limb;
  return !isLeg(limb) && carrier.exists() && !solved.curves.contains(limb.id + ".follow") &&
         isAncestorOrSelf(shop.input.scene, carrier, limb.joints.front()) &&
         (!limb.endNode.exists() || isAncestorOrSelf(shop.input.scene, carrier, limb.endNode));
}

AdjustedPart partOf(const Workshop& shop, const SolvedAdjustments& solved, const AdjustedLimb& adjusted) {
  const Limb& limb = adjusted.limb;
  AdjustedPart part;
  part.nodes = touchedNodes(limb, adjusted.topology);
  part.boneLength = limb.restLength / static_cast<double>(limb.joints.size());
  part.ids = idsOfLimb(shop, limb);
  for (const FingerJoint& finger : adjusted.fingers) {
    part.nodes.push_back(finger.node);
  }
  if (adjusted.roll.toes.exists()) {
    part.nodes.push_back(adjusted.roll.toes);
  }
  if (!rides(shop, solved, adjusted, solved.hips)) {
    part.ids.emplace_back("hips");
  }
  if (solved.spine && limb.kind != LimbKind::spine && !isLeg(limb) &&
      !rides(shop, solved, adjusted, solved.chest)) {
    const std::vector<std::string> inner = idsOfLimb(shop, solved.spine->limb);
    part.ids.insert(part.ids.end(), inner.begin(), inner.end());
  }
  for (const AdjustedJoint& joint : solved.joints) {
    if (isAncestorOrSelf(shop.input.scene, joint.node, limb.joints.front())) {
      part.ids.push_back(joint.id);
    }
  }
  std::ranges::sort(part.nodes);
  part.nodes.erase(std::unique(part.nodes.begin(), part.nodes.end()), part.nodes.end());
  return part;
}

void addParts(const Workshop& shop, SolvedAdjustments& solved) {
  solved.parts.push_back({solved.roots, 0.0, {"body"}});
  if (solved.hips.exists()) {
    solved.parts.push_back({{solved.hips}, 0.0, {"hips"}});
  }
  for (const std::optional<AdjustedLimb>* limb : {&solved.spine, &solved.neck}) {
    if (*limb) {
      solved.parts.push_back(partOf(shop, solved, **limb));
    }
  }
  for (const AdjustedLimb& limb : solved.limbs) {
    solved.parts.push_back(partOf(shop, solved, limb));
  }
  for (const AdjustedJoint& joint : solved.joints) {
    solved.parts.push_back({{joint.node}, 0.0, {joint.id}});
  }
  std::set<NodeIndex> nodes{solved.chest};
  for (const AdjustedPart& part : solved.parts) {
    nodes.insert(part.nodes.begin(), part.nodes.end());
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

SolvedAdjustments solveAdjustments(const AdjustmentInput& input) {
  SolvedAdjustments solved;
  if (input.adjustments.empty()) {
    return solved;
  }
  const Workshop shop{input, bindPlaces(input.scene), controllersOf(input.scene, input.limbs, input.hips)};
  solved.curves = curvesOf(shop, solved.joints);
  if (solved.empty()) {
    return solved;
  }
  solved.hips = input.hips;
  solved.roots = rootsOf(input);
  const Limb* const spine = limbOfKind(input.limbs, LimbKind::spine);
  const Limb* const neck = limbOfKind(input.limbs, LimbKind::neck);
  solved.chest =
      spine == nullptr ? input.hips : (spine->endNode.exists() ? spine->endNode : spine->joints.back());
  solved.hipsBind = bindRotation(shop, solved.hips);
  solved.chestBind = bindRotation(shop, solved.chest);
  if (spine != nullptr) {
    solved.spine = adjustedLimb(shop, *spine);
  }
  if (neck != nullptr) {
    solved.neck = adjustedLimb(shop, *neck);
  }
  for (const LimbKind kind : {LimbKind::leftArm, LimbKind::rightArm, LimbKind::leftLeg, LimbKind::rightLeg}) {
    if (const Limb* const limb = limbOfKind(input.limbs, kind)) {
      solved.limbs.push_back(adjustedLimb(shop, *limb));
    }
  }
  addParts(shop, solved);
  return solved;
}

} // namespace stretch::rig

#include "app/edits/body/limb_edits.h"

#include <algorithm>
#include <utility>

#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/prop_file_edits.h"
#include "rig/body/evidence/bind_pose.h"
#include "rig/body/reading/planned_body.h"
#include "rig/controllers/controller.h"

namespace stretch::app {

namespace {

Status validateJoints(const Document& document, const rig::Limb& limb) {
  const NodeIndex past(document.scene->nodes.size());
  const bool known =
      std::ranges::all_of(limb.joints, [&](NodeIndex joint) { return joint.exists() && joint < past; });
  if (limb.joints.empty() || !known || limb.endNode >= past) {
    return Error{"the limb names joints that the character does not have", limb.id, "pick its joints again"};
  }
  return Success{};
}

// Everything that names a limb or a controller that the character does not have.
void dropWhatIsWithoutLimb(Document& document) {
  const auto isMissing = [&](const std::string& limb) { return findLimb(document, limb) == nullptr; };
  const rig::ControllerList list = controllersOf(document);
  std::erase_if(document.trails, [&](const rig::Trail& trail) { return isMissing(trail.limb); });
  std::erase_if(document.weights, [&](const WeightedLimb& entry) { return isMissing(entry.limb); });
  std::erase_if(document.adjustments, [&](const rig::Adjustment& adjustment) {
    return list.attribute(adjustment.controller) == nullptr &&
           !rig::controllerNamed(*document.scene, document.body.limbs, document.body.hips, list,
                                 adjustment.controller);
  });
  rig::Holds& holds = document.holds;
  std::erase_if(holds.pins, [&](const rig::Pin& pin) { return isMissing(pin.limb); });
  std::erase_if(holds.grips,
                [&](const rig::Grip& grip) { return isMissing(grip.leader) || isMissing(grip.follower); });
  std::erase_if(holds.props, [&](const rig::Prop& prop) {
    return std::ranges::any_of(prop.hands, [&](const rig::PropHand& hand) { return isMissing(hand.limb); });
  });
}

// A chain that the user picked may be a limb of the other body: one limb has one id.
Document withBody(Document document, rig::Body body) {
  document.body = std::move(body);
  std::erase_if(document.chains, [&](const rig::Limb& chain) {
    return std::ranges::find(document.body.limbs, chain.id, &rig::Limb::id) != document.body.limbs.end();
  });
  dropWhatIsWithoutLimb(document);
  return document;
}

} // namespace

Result<Document> changePlan(const Document& document, const std::string& plan) {
  const rig::BodyPlan* const wanted = rig::planNamed(plan);
  if (wanted == nullptr) {
    return Error{"there is no body plan '" + plan + "'", "plan", "give one of: " + rig::planIds()};
  }
  Document changed = withBody(document, bodyOfSource(document, *wanted));
  changed.limbsCorrected = true;
  return changed;
}

Document detectLimbsAgain(const Document& document) {
  Document changed = withBody(document, bodyOfSource(document));
  changed.limbsCorrected = false;
  return changed;
}

Result<Document> correctLimb(const Document& document, rig::Limb limb) {
  if (limb.kind == rig::LimbKind::chain) {
    return Error{"a chain is not a limb of the body", limb.id, "add it as a chain"};
  }
  if (const Status valid = validateJoints(document, limb); !valid) {
    return valid.error();
  }
  Document changed = document;
  changed.limbsCorrected = true;
  if (const rig::PlannedLimb* const planned = plannedLimb(planOf(document.body), limb)) {
    limb.id = planned->id;
  }
  limb.confidence = 1.0;
  limb.reasons = {"set by hand"};
  auto& limbs = changed.body.limbs;
  const rig::LimbPlace& wanted = limb;
  const auto place =
      std::find_if(limbs.begin(), limbs.end(), [&](const rig::LimbPlace& other) { return other >= wanted; });
  if (place != limbs.end() && static_cast<const rig::LimbPlace&>(*place) == wanted) {
    *place = std::move(limb);
  } else {
    limbs.insert(place, std::move(limb));
  }
  rig::setLeadingEnds(rig::bindPoseWorlds(*document.scene), changed.body);
  return changed;
}

Result<Document> addChain(const Document& document, rig::Limb chain) {
  if (const Status valid = validateJoints(document, chain); !valid) {
    return valid.error();
  }
  if (findLimb(document, chain.id) != nullptr) {
    return Error{"this chain is there already", chain.id, "select it"};
  }
  Document changed = document;
  changed.chains.push_back(std::move(chain));
  return changed;
}

} // namespace stretch::app

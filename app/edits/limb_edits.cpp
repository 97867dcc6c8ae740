#include "app/edits/limb_edits.h"

#include <algorithm>

#include "rig/body/planned_body.h"

namespace stretch::app {

namespace {

Status validateJoints(const Document& document, const rig::Limb& limb) {
  const NodeIndex past(document.scene->nodes.size());
  const bool known = std::all_of(limb.joints.begin(), limb.joints.end(),
                                 [&](NodeIndex joint) { return joint.exists() && joint < past; });
  if (limb.joints.empty() || !known || limb.endNode >= past) {
    return Error{"the limb names joints that the character does not have", limb.id, "pick its joints again"};
  }
  return Success{};
}

} // namespace

Result<Document> correctLimb(const Document& document, rig::Limb limb) {
  if (limb.kind == rig::LimbKind::chain) {
    return Error{"a chain is not a limb of the body", limb.id, "add it as a chain"};
  }
  if (const Status valid = validateJoints(document, limb); !valid) {
    return valid.error();
  }
  Document changed = document;
  changed.limbsCorrected = true;
  if (const rig::PlannedLimb* const planned = plannedLimb(planOf(document.biped), limb)) {
    limb.id = planned->id;
  }
  limb.confidence = 1.0;
  limb.reasons = {"set by hand"};
  auto& limbs = changed.biped.limbs;
  const rig::LimbPlace& wanted = limb;
  const auto place =
      std::find_if(limbs.begin(), limbs.end(), [&](const rig::LimbPlace& other) { return other >= wanted; });
  if (place != limbs.end() && static_cast<const rig::LimbPlace&>(*place) == wanted) {
    *place = std::move(limb);
  } else {
    limbs.insert(place, std::move(limb));
  }
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

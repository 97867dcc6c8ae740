#include <algorithm>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/needs.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/document.h"
#include "app/edits/trail/weight_edits.h"

namespace stretch::app {

namespace {

bool viewsClip(const Session& session) {
  const int clip = session.view().clip;
  return clip >= 0 && static_cast<std::size_t>(clip) < session.document().clips->size();
}

bool hasTargets(const Session& session) {
  return viewsClip(session) && !targetLimbs(session).empty();
}

bool isOn(const Session& session, const std::string& limb) {
  const WeightedLimb* const entry = findWeight(session.document(), limb, session.view().clip);
  return entry != nullptr && entry->on;
}

bool allTargetsHaveWeightOn(const Session& session) {
  const std::vector<std::string> limbs = targetLimbs(session);
  return hasTargets(session) &&
         std::ranges::all_of(limbs, [&](const std::string& limb) { return isOn(session, limb); });
}

Status toggleWeight(Session& session) {
  const std::vector<std::string> limbs = targetLimbs(session);
  if (!hasTargets(session)) {
    return Error{"no limb is selected", "", "select one first"};
  }
  const bool allOn = allTargetsHaveWeightOn(session);
  return finish(session, switchWeight(session.document(), limbs, session.view().clip, !allOn),
                allOn ? "Switch weight off" : "Give weight");
}

bool targetsHaveWeight(const Session& session) {
  const std::vector<std::string> limbs = targetLimbs(session);
  return viewsClip(session) && std::any_of(limbs.begin(), limbs.end(), [&](const std::string& limb) {
           return findWeight(session.document(), limb, session.view().clip) != nullptr;
         });
}

Status takeWeightAway(Session& session) {
  if (!targetsHaveWeight(session)) {
    return Error{"the selected limb has no weight in this clip", "", "give it weight first"};
  }
  Document changed = session.document();
  for (const std::string& limb : targetLimbs(session)) {
    changed = removeWeight(changed, limb, session.view().clip);
  }
  return finish(session, changed, "Take the weight away");
}

/// "arms and legs", "legs and tail": of the limbs that are none of the trunk's.
std::string outerKinds(const Session& session) {
  const std::vector<rig::Limb>& limbs = session.document().body.limbs;
  std::vector<std::string> kinds;
  for (const rig::Limb& limb : limbs) {
    const bool isOne = std::ranges::count(limbs, limb.kind, &rig::Limb::kind) == 1;
    const std::string kind = std::string(kindName(limb.kind)) + (isOne ? "" : "s");
    if (!isTrunk(limb) && std::ranges::find(kinds, kind) == kinds.end()) {
      kinds.push_back(kind);
    }
  }
  return kinds.empty() ? "arms and legs" : listed(kinds);
}

Status weightForAll(Session& session) {
  std::vector<std::string> limbs;
  for (const rig::Limb& limb : session.document().body.limbs) {
    if (!isTrunk(limb)) {
      limbs.push_back(limb.id);
    }
  }
  if (!viewsClip(session) || limbs.empty()) {
    return Error{"there is no clip, or no limb beside the trunk", "", "open a character with an animation"};
  }
  return finish(session, switchWeight(session.document(), limbs, session.view().clip, true),
                "Give all limbs weight");
}

} // namespace

std::vector<DocumentCommand> weightCommands() {
  return {
      ticked(entry(command::weightToggle, "Weight",
                   "Lets the selected limbs sag, squash and stretch by their own load, or stops that.", {},
                   {hasTargets, "select a limb first"}, toggleWeight),
             allTargetsHaveWeightOn),
      labelled(entry(command::weightAll, "Weight for arms and legs",
                     "Lets all limbs of this clip but the trunk's sag, squash and stretch by their own load.",
                     {}, clipNeeded(), weightForAll),
               [](const Session& session) { return "Weight for " + outerKinds(session); }),
      entry(command::weightRemove, "Take the weight away",
            "Takes the weight of the selected limbs away, with its settings.", {},
            {targetsHaveWeight, "select a limb that has weight"}, takeWeightAway),
  };
}

} // namespace stretch::app

#include "app/commands/table/selection.h"

#include "app/locators/locator_edits.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "app/commands/table/frames.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/place_trails.h"
#include "rig/body/reading/planned_body.h"

namespace stretch::app {

namespace {

bool contains(const rig::Trail& trail, double frame) {
  return trail.settings.startFrame <= frame && frame <= trail.settings.endFrame;
}

std::vector<const rig::Trail*> trailsOfLimb(const Session& session, const std::string& limbId) {
  std::vector<const rig::Trail*> trails;
  for (const rig::Trail& trail : session.document().trails) {
    if (trail.limb == limbId && trail.clip == session.view().clip) {
      trails.push_back(&trail);
    }
  }
  return trails;
}

/// The limb's trail at the playhead; 0 for none.
int trailAtPlayhead(const Session& session, const std::string& limbId) {
  for (const rig::Trail* trail : trailsOfLimb(session, limbId)) {
    if (contains(*trail, session.view().frame)) {
      return trail->id;
    }
  }
  return 0;
}

/// The trail at the playhead, else the limb's only one; 0 for none.
int nearestTrail(const Session& session, const std::string& limbId) {
  if (const int here = trailAtPlayhead(session, limbId); here != 0) {
    return here;
  }
  const std::vector<const rig::Trail*> trails = trailsOfLimb(session, limbId);
  return trails.size() == 1 ? trails.front()->id : 0;
}

/// Of another limb: the one that was made with this trail, else one that shares time with it.
const rig::Trail* trailBeside(const Session& session, const rig::Trail& selected, const std::string& limbId) {
  for (const int id : groupMembers(session.document(), selected.id)) {
    const rig::Trail* const member = findTrail(session.document(), id);
    if (member->limb == limbId) {
      return member;
    }
  }
  return overlappingTrail(session.document(), limbId, selected.clip, selected.settings.startFrame,
                          selected.settings.endFrame);
}

} // namespace

void selectLimb(Session& session, const std::string& limbId, bool add) {
  clearControllers(session);
  ViewState& view = session.view();
  const bool wasSelected = isSelected(session, limbId);
  std::vector<std::string>& limbs = view.selection.editTrails().limbs;
  if (!add) {
    limbs = {limbId};
  } else if (wasSelected) {
    std::erase(limbs, limbId);
    std::erase_if(view.selection.editTrails().beside,
                  [&](int id) { return findTrail(session.document(), id)->limb == limbId; });
  } else {
    limbs.push_back(limbId);
  }
  view.selection.dropSpheres();
  const rig::Trail* trail = selectedTrail(session);
  const bool leavesTrail = trail != nullptr && wasSelected && trail->limb == limbId;
  if (!add || view.selection.trail() == 0 || leavesTrail) {
    view.selection.editTrails().trail = limbs.empty() ? 0 : trailAtPlayhead(session, limbs.back());
    view.selection.editTrails().beside.clear();
  }
  session.followSelection();
}

void selectTrail(Session& session, int trailId) {
  ViewState& view = session.view();
  const rig::Trail* trail = findTrail(session.document(), trailId);
  if (view.selection.trail() != trailId) {
    view.selection.dropSpheres();
  }
  if (trail == nullptr) {
    view.selection.dropTrail();
    session.followSelection();
    return;
  }
  TrailSelection& selection = view.selection.editTrails();
  const auto added = std::ranges::find(selection.beside, trailId);
  if (added != selection.beside.end()) {
    *added = selection.trail; // It leads now, and the others stay.
  } else if (selection.trail != trailId) {
    selection.beside.clear();
  }
  selection.trail = trailId;
  session.followSelection();
  const auto& limbs = view.selection.limbs();
  if (std::find(limbs.begin(), limbs.end(), trail->limb) == limbs.end()) {
    view.selection.editTrails().limbs = {trail->limb};
  }
}

void selectTrailInList(Session& session, int trailId, bool add) {
  const rig::Trail* const trail = findTrail(session.document(), trailId);
  const rig::Trail* const leading = selectedTrail(session);
  if (trail == nullptr) {
    return;
  }
  clearControllers(session);
  TrailSelection& selection = session.view().selection.editTrails();
  if (!add || leading == nullptr) {
    selection.limbs = {trail->limb};
    selection.beside.clear();
    selectTrail(session, trailId);
  } else if (trail->id != leading->id) {
    const std::vector<int> targets = targetTrails(session);
    selection.beside.assign(targets.begin() + 1, targets.end());
    const auto present = std::ranges::find(selection.beside, trailId);
    if (present == selection.beside.end()) {
      selection.beside.push_back(trailId);
    } else {
      selection.beside.erase(present);
    }
    const bool isMeant = trail->limb == leading->limb || std::ranges::any_of(selection.beside, [&](int id) {
                           return findTrail(session.document(), id)->limb == trail->limb;
                         });
    if (!isMeant) {
      std::erase(selection.limbs, trail->limb);
    } else if (!isSelected(session, trail->limb)) {
      selection.limbs.push_back(trail->limb);
    }
  }
}

void selectGroup(Session& session, int trailId) {
  const std::vector<int> members = groupMembers(session.document(), trailId);
  if (!members.empty()) {
    session.view().selection.editTrails().limbs.clear();
    session.view().selection.editTrails().beside.clear();
  }
  for (const int id : members) {
    session.view().selection.editTrails().limbs.push_back(findTrail(session.document(), id)->limb);
  }
  selectTrail(session, trailId);
}

std::vector<int> targetTrails(const Session& session) {
  const rig::Trail* selected = selectedTrail(session);
  std::vector<int> targets;
  if (selected != nullptr) {
    targets.push_back(selected->id);
    std::ranges::copy_if(session.view().selection.trailsBeside(), std::back_inserter(targets), [&](int id) {
      const rig::Trail* const trail = findTrail(session.document(), id);
      return trail != nullptr && trail->clip == selected->clip && isSelected(session, trail->limb);
    });
  }
  const std::size_t named = targets.size();
  for (const std::string& limbId : session.view().selection.limbs()) {
    const bool isNamed =
        std::any_of(targets.begin(), targets.begin() + static_cast<std::ptrdiff_t>(named),
                    [&](int id) { return findTrail(session.document(), id)->limb == limbId; });
    if (isNamed) {
      continue;
    }
    const rig::Trail* beside = selected == nullptr ? nullptr : trailBeside(session, *selected, limbId);
    const int id = selected != nullptr ? (beside == nullptr ? 0 : beside->id) : nearestTrail(session, limbId);
    if (id != 0) {
      targets.push_back(id);
    }
  }
  return targets;
}

std::vector<int> targetsOfRange(const Session& session) {
  std::vector<int> targets = targetTrails(session);
  const rig::Trail* const selected = findTrail(session.atBegin(), session.view().selection.trail());
  std::erase_if(targets, [&](int id) {
    const rig::Trail* const other = findTrail(session.atBegin(), id);
    return other == nullptr || selected == nullptr ||
           other->settings.startFrame != selected->settings.startFrame ||
           other->settings.endFrame != selected->settings.endFrame;
  });
  return targets;
}

std::vector<std::string> targetLimbs(const Session& session) {
  std::vector<std::string> limbs = session.view().selection.limbs();
  const rig::Trail* const trail = selectedTrail(session);
  if (limbs.empty() && trail != nullptr) {
    limbs.push_back(trail->limb);
  }
  return limbs;
}

const rig::Trail* selectedTrail(const Session& session) {
  const rig::Trail* trail = findTrail(session.document(), session.view().selection.trail());
  return trail != nullptr && trail->clip == session.view().clip ? trail : nullptr;
}

const rig::SolvedTrail* solvedTrail(Session& session, int trailId) {
  if (!hasClip(session.document(), session.view().clip)) {
    return nullptr;
  }
  const auto place = rig::placeOfTrail(session.motion(), trailId);
  return place ? &session.motion().trails[*place] : nullptr;
}

std::vector<PlacedSphere> placedSpheres(Session& session, int trailId) {
  const Document& document = session.document();
  if (!hasClip(document, session.view().clip)) {
    return {};
  }
  const rig::MotionState& motion = session.motion();
  const auto place = rig::placeOfTrail(motion, trailId);
  if (!place) {
    return {};
  }
  const rig::DrawnTrail drawn = rig::pathsAt(*document.scene, clipOf(document, session.view().clip), motion,
                                             *place, motion.trails[*place].controlFrames);
  std::vector<PlacedSphere> spheres;
  for (std::size_t i = 0; i < drawn.frames.size(); ++i) {
    spheres.push_back({drawn.frames[i], drawn.exaggerated[i]});
  }
  return spheres;
}

std::vector<std::string> limbsByKey(const Document& document) {
  std::vector<std::string> ids;
  const rig::BodyPlan& plan = planOf(document.body);
  for (const rig::PlannedLimb& limb : plan.limbs) {
    if (limb.usual || findLimb(document, limb.id) != nullptr) {
      ids.push_back(limb.id);
    }
  }
  for (const rig::Limb& limb : document.body.limbs) {
    if (plannedLimb(plan, limb.id) == nullptr) {
      ids.push_back(limb.id);
    }
  }
  return ids;
}

std::string limbTitle(const Document& document, const std::string& limbId) {
  const rig::Limb* limb = findLimb(document, limbId);
  const bool isPlanned = plannedLimb(planOf(document.body), limbId) != nullptr;
  if (limb == nullptr ? !isPlanned : limb->kind == rig::LimbKind::chain) {
    return limbId;
  }
  std::string title = limbId;
  std::replace(title.begin(), title.end(), '-', ' ');
  return title;
}

std::string limbTitleOfKey(const Document& document, std::size_t key) {
  constexpr std::array<const char*, 9> ordinals{"first", "second",  "third",  "fourth", "fifth",
                                                "sixth", "seventh", "eighth", "ninth"};
  const std::vector<std::string> limbs = limbsByKey(document);
  return key < limbs.size() ? limbTitle(document, limbs[key]) : std::string(ordinals.at(key)) + " limb";
}

std::string trailTitle(const Document& document, const rig::Trail& trail) {
  return trail.name.empty() ? limbTitle(document, trail.limb) : trail.name;
}

std::string groupTitle(const Document& document, const std::vector<int>& members) {
  std::vector<std::string> limbs;
  for (const int id : members) {
    const rig::Trail& trail = *findTrail(document, id);
    if (!trail.groupName.empty()) {
      return trail.groupName;
    }
    limbs.push_back(limbTitle(document, trail.limb));
  }
  return listed(limbs);
}

std::vector<int> wholeGroupSelected(const Session& session) {
  const std::vector<int> members = groupMembers(session.document(), session.view().selection.trail());
  const bool all = std::all_of(members.begin(), members.end(), [&](int id) {
    return isSelected(session, findTrail(session.document(), id)->limb);
  });
  return all ? members : std::vector<int>{};
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

double nudgeUnits(const Document& document) {
  return document.body.height / 200.0;
}

bool hasSelectedTrail(const Session& session) {
  return selectedTrail(session) != nullptr;
}

bool isSelected(const Session& session, const std::string& limbId) {
  const std::vector<std::string>& limbs = session.view().selection.limbs();
  return std::find(limbs.begin(), limbs.end(), limbId) != limbs.end();
}

void selectController(Session& session, const std::string& id, bool add) {
  std::vector<std::string> ids = add ? session.view().selection.controllers() : std::vector<std::string>{};
  const auto selected = std::ranges::find(ids, id);
  if (selected != ids.end()) {
    ids.erase(selected);
  } else {
    ids.push_back(id);
  }
  selectControllers(session, std::move(ids));
}

void selectControllers(Session& session, std::vector<std::string> ids) {
  session.view().selection.setControllers(std::move(ids));
  session.followSelection();
}

bool showsLocators(const Session& session) {
  return showsLocators(session.document(), session.view().showLocators);
}

void selectLocators(Session& session, std::vector<std::string> names) {
  session.view().selection.setLocators(std::move(names));
  session.followSelection();
}

void selectLocator(Session& session, const std::string& name, bool add) {
  std::vector<std::string> names = add ? session.view().selection.locators() : std::vector<std::string>{};
  const auto selected = std::ranges::find(names, name);
  if (selected != names.end()) {
    names.erase(selected);
  } else {
    names.push_back(name);
  }
  selectLocators(session, std::move(names));
}

void clearControllers(Session& session) {
  session.view().selection.dropHandles();
}

bool isControllerSelected(const Session& session, const std::string& id) {
  return std::ranges::find(session.view().selection.controllers(), id) !=
         session.view().selection.controllers().end();
}

bool hasControllers(const Session& session) {
  return !session.view().selection.controllers().empty();
}

std::string controllerTitle(const Document& document, const std::string& id) {
  const rig::ControllerList list = controllersOf(document);
  if (list.controller(id) == nullptr && list.attribute(id) == nullptr) {
    return id;
  }
  std::string title = id;
  std::ranges::replace_if(
      title, [](char c) { return c == '-' || c == '.'; }, ' ');
  return title;
}

} // namespace stretch::app

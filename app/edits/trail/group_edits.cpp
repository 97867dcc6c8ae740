#include "app/edits/trail/group_edits.h"

#include <algorithm>

#include "app/edits/trail/trail_edits.h"

namespace stretch::app {

std::vector<int> groupMembers(const Document& document, int trailId) {
  const rig::Trail* const trail = findTrail(document, trailId);
  std::vector<int> members;
  for (const rig::Trail& other : document.trails) {
    if (trail != nullptr && trail->group > 0 && other.group == trail->group && other.clip == trail->clip) {
      members.push_back(other.id);
    }
  }
  return members.size() > 1 ? members : std::vector<int>{};
}

int freeGroup(const Document& document) {
  int last = 0;
  for (const rig::Trail& trail : document.trails) {
    last = std::max(last, trail.group);
  }
  return last + 1;
}

Result<Document> groupTrails(const Document& document, std::span<const int> trailIds) {
  if (trailIds.size() < 2) {
    return Error{"a group needs two trails or more", "", "select several limbs with trails"};
  }
  Document changed = document;
  const int group = freeGroup(document);
  std::vector<const rig::Trail*> members;
  for (const int id : trailIds) {
    rig::Trail* const trail = findTrail(changed, id);
    if (trail == nullptr) {
      return missingTrail(id);
    }
    const bool fits = std::all_of(members.begin(), members.end(), [&](const rig::Trail* other) {
      return other->clip == trail->clip && other->limb != trail->limb;
    });
    if (!fits) {
      return Error{"a group holds one trail of each limb, all of one clip", trail->limb,
                   "leave one of them out"};
    }
    trail->group = group;
    trail->groupName.clear();
    members.push_back(trail);
  }
  return changed;
}

Document takeApart(const Document& document, std::span<const int> trailIds) {
  Document changed = document;
  for (const int id : trailIds) {
    for (const int member : groupMembers(document, id)) {
      findTrail(changed, member)->group = 0;
      findTrail(changed, member)->groupName.clear();
    }
  }
  return changed;
}

} // namespace stretch::app

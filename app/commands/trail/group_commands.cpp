#include <algorithm>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/edits/trail/group_edits.h"

namespace stretch::app {

namespace {

bool isInGroup(const Session& session) {
  const rig::Trail* const trail = selectedTrail(session);
  return trail != nullptr && !groupMembers(session.document(), trail->id).empty();
}

bool canGroup(const Session& session) {
  const std::vector<int> targets = targetTrails(session);
  const std::vector<int> members =
      targets.empty() ? std::vector<int>{} : groupMembers(session.document(), targets.front());
  const bool isGroup = members.size() == targets.size() &&
                       std::is_permutation(members.begin(), members.end(), targets.begin());
  return targets.size() > 1 && !isGroup;
}

bool isPartOfGroup(const Session& session) {
  return isInGroup(session) && targetTrails(session).size() <
                                   groupMembers(session.document(), session.view().selection.trail()).size();
}

Status group(Session& session) {
  return finish(session, groupTrails(session.document(), targetTrails(session)), "Group the trails");
}

Status takeGroupApart(Session& session) {
  session.edit(takeApart(session.document(), targetTrails(session)), "Take the group apart");
  return Success{};
}

Status selectWholeGroup(Session& session) {
  selectGroup(session, session.view().selection.trail());
  return Success{};
}

} // namespace

std::vector<DocumentCommand> groupCommands() {
  return {
      entry(command::trailGroup, "Group the trails",
            "Makes one group of the trails of the selected limbs: they are listed, chosen and changed "
            "together.",
            {"Ctrl+G"}, {canGroup, "select limbs with trails that are no group yet"}, group),
      entry(command::trailTakeApart, "Take the group apart",
            "Lets every trail of the group stand alone again; the trails stay as they are.", {"Ctrl+Shift+G"},
            {isInGroup, "select a trail of a group"}, takeGroupApart),
      entry(command::trailSelectGroup, "Select the whole group",
            "Selects the trail with all others of its group, so that what is set is set for all of them.",
            {"Shift+G"}, {isPartOfGroup, "select a trail of a group"}, selectWholeGroup),
  };
}

} // namespace stretch::app

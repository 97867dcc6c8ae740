#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/commands/body/selection_sets.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/edits/pose/selection_set_edits.h"

namespace stretch::app {

namespace {

const SelectionSet* selectedSet(const Session& session) {
  return setOfSelection(session.document(), session.view().selection);
}

bool canKeep(const Session& session) {
  const Selection& selection = session.view().selection;
  return (!selection.limbs().empty() || !selection.controllers().empty()) && selectedSet(session) == nullptr;
}

/// "left hand, right hand", or how many there are.
std::string nameOfSelection(const Session& session) {
  constexpr std::size_t mostNamed = 2;
  const std::vector<std::string>& limbs = session.view().selection.limbs();
  const std::vector<std::string>& ids = limbs.empty() ? session.view().selection.controllers() : limbs;
  if (ids.size() > mostNamed) {
    return fmt::format("{} {}", ids.size(), limbs.empty() ? "controllers" : "limbs");
  }
  std::string name;
  for (const std::string& id : ids) {
    name += (name.empty() ? "" : ", ") +
            (limbs.empty() ? controllerTitle(session.document(), id) : limbTitle(session.document(), id));
  }
  return name;
}

Status keep(Session& session) {
  const std::string name = nameOfSelection(session);
  return finish(session, keepSelectionSet(session.document(), session.view().selection, name),
                "Keep a selection set");
}

bool canSelect(const Session& session, const SelectionSet& set) {
  return !presentIn(session.document(), set).empty();
}

bool canSelectAny(const Session& session) {
  return std::ranges::any_of(session.document().selectionSets,
                             [&](const SelectionSet& set) { return canSelect(session, set); });
}

/// The set after the one that is selected; the first where none is, or after the last. Passes over sets of
/// which the character has nothing.
void selectNext(Session& session) {
  const std::vector<SelectionSet>& sets = session.document().selectionSets;
  const SelectionSet* const now = selectedSet(session);
  std::size_t next = now == nullptr ? 0 : static_cast<std::size_t>(now - sets.data()) + 1;
  while (!canSelect(session, sets[next % sets.size()])) {
    ++next;
  }
  selectSet(session, sets[next % sets.size()], false);
}

} // namespace

void selectSet(Session& session, const SelectionSet& set, bool add) {
  const SelectionSet present = presentIn(session.document(), set);
  if (!present.controllers.empty()) {
    std::vector<std::string> ids = add ? session.view().selection.controllers() : std::vector<std::string>{};
    std::ranges::copy_if(present.controllers, std::back_inserter(ids),
                         [&](const std::string& id) { return std::ranges::find(ids, id) == ids.end(); });
    selectControllers(session, std::move(ids));
    return;
  }
  bool addsNext = add;
  for (const std::string& id : present.limbs) {
    if (!addsNext || !isSelected(session, id)) {
      selectLimb(session, id, addsNext);
      addsNext = true;
    }
  }
}

std::vector<DocumentCommand> selectionSetCommands() {
  const Need setNeeded{[](const Session& session) { return selectedSet(session) != nullptr; },
                       "select just what a selection set holds"};
  return {
      entry(command::selectionKeep, "Keep the selection as a set",
            "Keeps the selected limbs or controllers under a name, with the file.", {},
            {canKeep, "select limbs or controllers that no set holds yet"}, keep),
      entry(command::selectionNext, "Select the next set", "Selects what the next selection set holds.", {},
            {canSelectAny, "keep a selection as a set first"}, doing(selectNext)),
      entry(command::selectionForget, "Forget the selection set",
            "Takes the set that is selected away; what it holds stays as it is.", {}, setNeeded,
            [](Session& session) {
              const std::string name = selectedSet(session)->name;
              return finish(session, removeSelectionSet(session.document(), name), "Forget a selection set");
            }),
  };
}

} // namespace stretch::app

#include "app/edits/pose/selection_set_edits.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/edits/trail/name_edits.h"
#include "app/named.h"

namespace stretch::app {

namespace {

bool holdSame(const std::vector<std::string>& one, const std::vector<std::string>& other) {
  return std::ranges::is_permutation(one, other);
}

bool isTaken(const Document& document, const std::string& name) {
  return std::ranges::find(document.selectionSets, name, &SelectionSet::name) != document.selectionSets.end();
}

std::string freeName(const Document& document, const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; isTaken(document, name); ++number) {
    name = fmt::format("{} {}", wanted, number);
  }
  return name;
}

} // namespace

SelectionSet presentIn(const Document& document, const SelectionSet& set) {
  const rig::ControllerList list = controllersOf(document);
  SelectionSet present = set;
  std::erase_if(present.limbs, [&](const std::string& id) { return findLimb(document, id) == nullptr; });
  std::erase_if(present.controllers,
                [&](const std::string& id) { return !findController(document, list, id).ok(); });
  return present;
}

const SelectionSet* setOfSelection(const Document& document, const Selection& selection) {
  const auto found = std::ranges::find_if(document.selectionSets, [&](const SelectionSet& set) {
    const SelectionSet present = presentIn(document, set);
    return !present.empty() && holdSame(present.limbs, selection.limbs()) &&
           holdSame(present.controllers, selection.controllers());
  });
  return found == document.selectionSets.end() ? nullptr : &*found;
}

Result<Document> keepSelectionSet(const Document& document, const Selection& selection,
                                  const std::string& name) {
  SelectionSet set{"", selection.limbs(), selection.controllers()};
  if (set.empty()) {
    return Error{"no limb and no controller is selected", "", "select what the set is to hold"};
  }
  if (const SelectionSet* const known = setOfSelection(document, selection)) {
    return Error{"the set '" + known->name + "' holds just this", "",
                 "select something else, or rename the set"};
  }
  set.name = freeName(document, name);
  Document kept = document;
  kept.selectionSets.push_back(std::move(set));
  return kept;
}

Result<Document> renameSelectionSet(const Document& document, const std::string& name,
                                    const std::string& newName) {
  Document renamed = document;
  const auto set = std::ranges::find(renamed.selectionSets, name, &SelectionSet::name);
  if (set == renamed.selectionSets.end()) {
    return Error{"there is no selection set '" + name + "'", "", "keep one first"};
  }
  const std::string kept = keptName(newName);
  if (kept.empty() || (kept != name && isTaken(document, kept))) {
    return Error{kept.empty() ? "a set needs a name" : "another set is called '" + kept + "'", "",
                 "give a name that no other set has"};
  }
  set->name = kept;
  return renamed;
}

Document removeSelectionSet(Document document, const std::string& name) {
  std::erase_if(document.selectionSets, [&](const SelectionSet& set) { return set.name == name; });
  return document;
}

} // namespace stretch::app

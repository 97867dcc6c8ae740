#include "tests/support/ui_driver/kept_state.h"

#include <map>
#include <vector>

#include "app/commands/table/selection.h"
#include "app/reference/reference_edits.h"

namespace stretch::ui {

namespace {

/// Names in their order, with a blank between them.
template <typename Named>
std::string namesOf(const std::vector<Named>& all) {
  std::string text;
  for (const Named& one : all) {
    text += text.empty() ? "" : " ";
    text += one.name;
  }
  return text;
}

std::string yesOrNo(bool is) {
  return is ? "yes" : "no";
}

/// What the user called the selected trail's group.
std::string groupName(const app::Session& session) {
  const rig::Trail* const trail = app::selectedTrail(session);
  return trail == nullptr ? "" : trail->groupName;
}

} // namespace

std::optional<std::string> keptState(const Shell& shell, std::string_view name) {
  const app::Session& session = *shell.open.character();
  const app::Reference reference = app::referenceOf(session.document(), session.view().clip);
  const std::map<std::string_view, std::string> states{
      {"selection-sets", namesOf(shell.open.character()->document().selectionSets)},
      {"group.name", groupName(*shell.open.character())},
      {"poses", namesOf(shell.ui.body.library.poses)},
      {"pose-library-open", yesOrNo(shell.ui.body.library.open)},
      {"reference-open", yesOrNo(shell.ui.dialogs.reference.open)},
      {"reference-images", std::filesystem::path(reference.images.file).filename().string()},
      {"reference-sound", std::filesystem::path(reference.sound.file).filename().string()},
      {"reference-shown", yesOrNo(shell.viewport.look.reference.has_value())},
      {"pose-picture", yesOrNo(shell.beside.library.picture != nullptr)},
  };
  const auto found = states.find(name);
  return found == states.end() ? std::nullopt : std::optional(found->second);
}

} // namespace stretch::ui

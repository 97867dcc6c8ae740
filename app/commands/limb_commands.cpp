#include <array>

#include "app/commands/command_ids.h"
#include "app/commands/document_commands.h"
#include "app/commands/selection.h"
#include "app/commands/tables.h"
#include "app/edits/prop_file_edits.h"

namespace stretch::app {

namespace {

struct LimbKey {
  const char* id;
  const char* title;
  const char* key;
};

constexpr std::array<LimbKey, 6> limbKeys{{{"left-arm", "left arm", "1"},
                                           {"right-arm", "right arm", "2"},
                                           {"left-leg", "left leg", "3"},
                                           {"right-leg", "right leg", "4"},
                                           {"spine", "spine", "5"},
                                           {"neck", "neck", "6"}}};

DocumentCommand selectCommand(const LimbKey& limb, bool add) {
  const std::string id = limb.id;
  const std::string title = limb.title;
  DocumentCommand command;
  command.id = "limb." + id + (add ? "-add" : "");
  command.label = (add ? "Add " : "Select ") + title;
  command.help = add ? "Adds the " + title + " to the selection, or takes it away."
                     : "Selects the " + title + ", with its trail at the playhead.";
  command.keys = {(add ? "Shift+" : "") + std::string(limb.key)};
  command.needs = "this character has no " + title;
  command.enabled = [id](const Session& session) { return findLimb(session.document(), id) != nullptr; };
  command.checked = [id](const Session& session) { return isSelected(session, id); };
  command.run = [id, title, add](Session& session) -> Status {
    if (findLimb(session.document(), id) == nullptr) {
      return Error{"this character has no " + title, "", "correct the limbs in the rig panel"};
    }
    selectLimb(session, id, add);
    return Success{};
  };
  return command;
}

bool hasSelection(const Session& session) {
  return !session.view().selectedLimbs.empty() || session.view().selectedTrail != 0 ||
         hasControllers(session);
}

Status selectNone(Session& session) {
  clearControllers(session);
  session.view().selectedLimbs.clear();
  session.view().selectedSpheres.clear();
  session.view().selectedTrail = 0;
  return Success{};
}

/// The first limb that is selected already leads, and its trail stays.
Status selectAllLimbs(Session& session) {
  clearControllers(session);
  std::vector<std::string>& selected = session.view().selectedLimbs;
  for (const rig::Limb& limb : allLimbs(session.document())) {
    if (!isSelected(session, limb.id)) {
      selected.push_back(limb.id);
    }
  }
  return Success{};
}

Status detectAgain(Session& session) {
  Document changed = session.document();
  changed.biped = bodyOfSource(changed);
  changed.limbsCorrected = false;
  return finish(session, changed, "Find the limbs again");
}

} // namespace

std::vector<DocumentCommand> limbCommands() {
  std::vector<DocumentCommand> commands;
  commands.reserve(limbKeys.size());

  for (const LimbKey& limb : limbKeys) {
    commands.push_back(selectCommand(limb, false));
  }
  for (const LimbKey& limb : limbKeys) {
    commands.push_back(selectCommand(limb, true));
  }
  commands.push_back(entry(command::selectNone, "Select nothing",
                           "Takes limbs, trail, spheres and controllers out of the selection.", {"0"},
                           {hasSelection, "nothing is selected"}, selectNone));
  commands.push_back(entry(
      command::selectAllLimbs, "Select every limb", "Selects all limbs, so that E exaggerates them as one.",
      {"Ctrl+Shift+A"},
      {[](const Session& session) { return !allLimbs(session.document()).empty(); }, "no limb was found"},
      selectAllLimbs));
  commands.push_back(entry(command::detectAgain, "Find the limbs again",
                           "Forgets corrections made by hand and looks for arms, legs, spine and neck anew.",
                           {}, {always}, detectAgain));
  return commands;
}

} // namespace stretch::app

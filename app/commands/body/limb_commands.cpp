#include <array>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/edits/body/limb_edits.h"
#include "rig/plan/body_plan.h"

namespace stretch::app {

namespace {

/// What the limbs of the keys are called where no character is open: those of a biped.
constexpr std::array<const char*, 9> slotTitles{"left arm",     "right arm",   "left leg",
                                                "right leg",    "spine",       "neck",
                                                "seventh limb", "eighth limb", "ninth limb"};

/// Empty where the character has fewer limbs.
std::string limbOfSlot(const Session& session, std::size_t slot) {
  const std::vector<std::string> ids = limbsByKey(session.document());
  return slot < ids.size() ? ids[slot] : std::string();
}

bool hasLimbOfSlot(const Session& session, std::size_t slot) {
  return findLimb(session.document(), limbOfSlot(session, slot)) != nullptr;
}

std::string selectLabel(const std::string& title, bool add) {
  return (add ? "Add " : "Select ") + title;
}

std::string selectHelp(const std::string& title, bool add) {
  return add ? "Adds the " + title + " to the selection, or takes it away."
             : "Selects the " + title + ", with its trail at the playhead.";
}

DocumentCommand selectCommand(std::size_t slot, bool add) {
  const auto titleNow = [slot](const Session& session) { return limbTitleOfKey(session.document(), slot); };
  DocumentCommand command;
  command.id = std::string(command::limbSlots[slot]) + (add ? "-add" : "");
  command.label = selectLabel(slotTitles[slot], add);
  command.labelNow = [=](const Session& session) { return selectLabel(titleNow(session), add); };
  command.help = selectHelp(slotTitles[slot], add);
  command.helpNow = [=](const Session& session) { return selectHelp(titleNow(session), add); };
  command.keys = {(add ? "Shift+" : "") + std::to_string(slot + 1)};
  command.needsNow = [=](const Session& session) { return "this character has no " + titleNow(session); };
  command.enabled = [slot](const Session& session) { return hasLimbOfSlot(session, slot); };
  command.checked = [slot](const Session& session) { return isSelected(session, limbOfSlot(session, slot)); };
  command.run = [=](Session& session) -> Status {
    if (!hasLimbOfSlot(session, slot)) {
      return Error{"this character has no " + titleNow(session), "", "correct the limbs in the rig panel"};
    }
    selectLimb(session, limbOfSlot(session, slot), add);
    return Success{};
  };
  return command;
}

DocumentCommand planCommand(const rig::BodyPlan& plan) {
  const std::string id = plan.id;
  DocumentCommand command =
      entry(command::planPrefix, "Body plan: " + plan.title,
            "Reads the body as " + plan.title +
                ": which limbs it has. What was set up for limbs that it has no more goes with them.",
            {}, {always}, [id](Session& session) -> Status {
              if (session.document().body.plan == id) {
                return Success{};
              }
              Result<Document> changed = changePlan(session.document(), id);
              if (!changed) {
                return changed.error();
              }
              session.view().selection.editTrails().limbs.clear();
              return finish(session, *std::move(changed), "Change the body plan");
            });
  command.id = command::planPrefix + id;
  command.checked = [id](const Session& session) { return session.document().body.plan == id; };
  return command;
}

bool hasSelection(const Session& session) {
  return !session.view().selection.limbs().empty() || session.view().selection.trail() != 0 ||
         hasControllers(session) || !session.view().selection.locators().empty();
}

Status selectNone(Session& session) {
  session.view().selection = {};
  return Success{};
}

/// The first limb that is selected already leads, and its trail stays.
Status selectAllLimbs(Session& session) {
  std::vector<std::string>& selected = session.view().selection.editTrails().limbs;
  for (const rig::Limb& limb : allLimbs(session.document())) {
    if (!isSelected(session, limb.id)) {
      selected.push_back(limb.id);
    }
  }
  return Success{};
}

Status detectAgain(Session& session) {
  return finish(session, detectLimbsAgain(session.document()), "Find the limbs again");
}

} // namespace

std::vector<DocumentCommand> limbCommands() {
  std::vector<DocumentCommand> commands;
  for (const bool add : {false, true}) {
    for (std::size_t slot = 0; slot < slotTitles.size(); ++slot) {
      commands.push_back(selectCommand(slot, add));
    }
  }
  for (const rig::BodyPlan& plan : rig::bodyPlans()) {
    commands.push_back(planCommand(plan));
  }
  commands.push_back(entry(command::selectNone, "Select nothing",
                           "Takes limbs, trail, spheres and controllers out of the selection.", {"0"},
                           {hasSelection, "nothing is selected"}, selectNone));
  commands.push_back(entry(
      command::selectAllLimbs, "Select every limb", "Selects all limbs, so that E exaggerates them as one.",
      {"Ctrl+Shift+A"},
      {[](const Session& session) { return !allLimbs(session.document()).empty(); }, "no limb was found"},
      selectAllLimbs));
  commands.push_back(
      entry(command::detectAgain, "Find the limbs again",
            "Forgets corrections made by hand and looks for the body plan and its limbs anew. What "
            "was set up for limbs that are gone goes with them.",
            {}, {always}, detectAgain));
  return commands;
}

} // namespace stretch::app

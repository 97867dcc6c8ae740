#include <algorithm>
#include <array>
#include <iterator>

#include "app/commands/pose/held_controllers.h"
#include "app/commands/pose/posing.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/needs.h"
#include "app/commands/table/nudges.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/pose_edits.h"

namespace stretch::app {

namespace {

/// What the keys' controllers are called where no character is open: those of a biped.
constexpr std::array<const char*, 9> slotNames{"left arm", "right arm", "left leg",    "right leg", "spine",
                                               "head",     "hips",      "eighth limb", "ninth limb"};

/// The controllers that one key goes through: of a limb, and of the hips after the last one.
std::vector<std::string> controllersOfSlot(const Document& document, std::size_t slot) {
  const std::vector<std::string> limbs = limbsByKey(document);
  const rig::ControllerList list = controllersOf(document);
  std::vector<std::string> ids;
  for (const rig::Controller& controller : list.controllers) {
    const bool isOfLimb = slot < limbs.size() && controller.limb == limbs[slot];
    const bool isOfHips = slot == limbs.size() && controller.limb.empty();
    if (isOfLimb || isOfHips) {
      ids.push_back(controller.id);
    }
  }
  // The tip of the spine and the hips are what is posed first.
  const rig::Limb* const limb = slot < limbs.size() ? findLimb(document, limbs[slot]) : nullptr;
  if (limb == nullptr || isTrunk(*limb)) {
    std::ranges::reverse(ids);
  }
  return ids;
}

std::string nameOfSlot(const Document& document, std::size_t slot) {
  const std::vector<std::string> limbs = limbsByKey(document);
  const bool isNeck = slot < limbs.size() && limbs[slot] == "neck";
  return slot == limbs.size() ? "hips" : isNeck ? "head" : limbTitleOfKey(document, slot);
}

/// The one after the first that is selected, round and round.
Status selectNextOf(Session& session, std::size_t slot) {
  const std::vector<std::string> present = controllersOfSlot(session.document(), slot);
  const std::vector<std::string>& selected = session.view().selection.controllers();
  const auto last = selected.empty() ? present.end() : std::ranges::find(present, selected.back());
  const bool goesOn = last != present.end() && std::next(last) != present.end();
  selectController(session, goesOn ? *std::next(last) : present.front(), false);
  return Success{};
}

std::string slotLabel(const std::string& title, bool add) {
  return (add ? "Add controllers: " : "Controllers: ") + title;
}

std::string slotHelp(const std::string& title, bool add) {
  return add ? "Adds the first controller of the " + title + " to the selection, or takes it away."
             : "Selects the first controller of the " + title + "; again goes on to its next one.";
}

DocumentCommand slotCommand(std::size_t slot, bool add) {
  const auto nameNow = [slot](const Session& session) { return nameOfSlot(session.document(), slot); };
  DocumentCommand command;
  command.id = std::string(command::controllerSlots[slot]) + (add ? "-add" : "");
  command.label = slotLabel(slotNames[slot], add);
  command.labelNow = [=](const Session& session) { return slotLabel(nameNow(session), add); };
  command.help = slotHelp(slotNames[slot], add);
  command.helpNow = [=](const Session& session) { return slotHelp(nameNow(session), add); };
  command.keys = {(add ? "Shift+Alt+" : "Alt+") + std::to_string(slot + 1)};
  command.needsNow = [=](const Session& session) { return "this character has no " + nameNow(session); };
  command.enabled = [slot](const Session& session) {
    return !controllersOfSlot(session.document(), slot).empty();
  };
  command.checked = [slot](const Session& session) {
    return std::ranges::any_of(controllersOfSlot(session.document(), slot),
                               [&](const std::string& id) { return isControllerSelected(session, id); });
  };
  command.run = [slot, add](Session& session) -> Status {
    if (!add) {
      return selectNextOf(session, slot);
    }
    selectController(session, controllersOfSlot(session.document(), slot).front(), true);
    return Success{};
  };
  return command;
}

std::vector<std::string> allControllers(const Document& document) {
  std::vector<std::string> ids;
  for (const rig::Controller& controller : controllersOf(document).controllers) {
    ids.push_back(controller.id);
  }
  return ids;
}

Status stepController(Session& session, int step) {
  const std::vector<std::string> ids = allControllers(session.document());
  const std::vector<std::string>& selected = session.view().selection.controllers();
  const auto count = static_cast<std::ptrdiff_t>(ids.size());
  const std::ptrdiff_t found =
      selected.empty() ? count : std::ranges::find(ids, selected.back()) - ids.begin();
  const std::ptrdiff_t next = found == count ? (step > 0 ? 0 : count - 1) : (found + step + count) % count;
  selectController(session, ids[static_cast<std::size_t>(next)], false);
  return Success{};
}

/// The controllers that are adjusted in the viewed clip, by themselves or by an attribute that goes with
/// them.
std::vector<std::string> keyedControllers(const Session& session) {
  const Document& document = session.document();
  const rig::ControllerList list = controllersOf(document);
  const std::vector<std::string> adjusted = adjustedIds(document, session.view().clip);
  const auto isAdjusted = [&](const std::string& id) {
    return std::ranges::find(adjusted, id) != adjusted.end();
  };
  std::vector<std::string> keyed;
  for (const rig::Controller& controller : list.controllers) {
    const std::vector<rig::Attribute> held = attributesHeldBy(list, controller);
    if (isAdjusted(controller.id) || std::ranges::any_of(held, isAdjusted, &rig::Attribute::id)) {
      keyed.push_back(controller.id);
    }
  }
  std::ranges::copy_if(adjusted, std::back_inserter(keyed), [&](const std::string& id) {
    return list.controller(id) == nullptr && list.attribute(id) == nullptr;
  });
  return keyed;
}

bool hasMovable(const Session& session) {
  return clipNeeded().holds(session) &&
         std::ranges::any_of(selectedControllers(session), &rig::Controller::moves);
}

Status nudgeSelected(Session& session, const Chord& chord) {
  const ViewState& view = session.view();
  PullModal modal;
  modal.viewAxes = view.cameraAxes;
  modal.arrowsWorld = nudgeOf(chord, view.cameraAxes, nudgeUnits(session.document()));
  std::vector<rig::PlacedController> placed;
  std::vector<ControllerOffset> offsets;
  for (const rig::PlacedController& one : session.controllersAt(view.frame)) {
    if (isControllerSelected(session, one.id)) {
      placed.push_back(one);
      offsets.push_back(shownOffset(session, one.id));
    }
  }
  OffsetPose pose;
  pose.offsets = changedOffsets(modal, heldControllers(PullMotion::move, placed, offsets));
  return poseAll(session, pose, poseLabel(session.document(), "Nudge", view.selection.controllers()));
}

Need controllersFound() {
  return {[](const Session& session) { return !allControllers(session.document()).empty(); },
          "no limb was found that a controller could move"};
}

} // namespace

std::vector<DocumentCommand> controllerCommands() {
  std::vector<DocumentCommand> commands;
  for (const bool add : {false, true}) {
    for (std::size_t slot = 0; slot < slotNames.size(); ++slot) {
      commands.push_back(slotCommand(slot, add));
    }
  }
  commands.push_back(entry(command::controllerNext, "Next controller",
                           "Selects the next controller of the character.", {}, controllersFound(),
                           [](Session& session) { return stepController(session, 1); }));
  commands.push_back(entry(command::controllerPrevious, "Previous controller",
                           "Selects the controller before.", {}, controllersFound(),
                           [](Session& session) { return stepController(session, -1); }));
  commands.push_back(
      entry(command::controllersAll, "Select every controller",
            "Selects all controllers but those on single joints.", {}, controllersFound(),
            doing([](Session& session) { selectControllers(session, allControllers(session.document())); })));
  commands.push_back(
      entry(command::controllersKeyed, "Select what is keyed",
            "Selects every controller that has a key in this clip.", {"Shift+A"},
            {[](const Session& session) { return !keyedControllers(session).empty(); },
             "no controller has a key in this clip"},
            doing([](Session& session) { selectControllers(session, keyedControllers(session)); })));
  for (DocumentCommand& command : nudgeCommands({.idPrefix = controllerNudges,
                                  .words = "the selected controllers",
                                  .ownsKeys = false,
                                  .need = {hasMovable, "select a controller that moves"},
                                  .otherwisePrefix = {},
                                  .nudge = nudgeSelected})) {
    commands.push_back(std::move(command));
  }
  return commands;
}

} // namespace stretch::app

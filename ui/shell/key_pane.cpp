#include "ui/shell/key_pane.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/tables.h"
#include "ui/panels/rows/timeline_model.h"

namespace stretch::ui {

namespace {

using PaneCommand = app::Command<Shell>;

bool canPick(const Shell& shell) {
  return shell.open.character() != nullptr && app::hasPickedKeys(*shell.open.character());
}

PaneCommand paneCommand(const char* id, const char* label, const char* help, bool (*holds)(const Shell&),
                        const char* needs, std::function<Status(Shell&)> run) {
  PaneCommand command;
  command.id = id;
  command.label = label;
  command.help = help;
  command.enabled = holds;
  command.run = std::move(run);
  command.needs = [holds, needs](const Shell& shell) { return holds(shell) ? "" : needs; };
  return command;
}

Status runKeysTool(Shell& shell, app::KeysModal::Kind kind) {
  const KeyPane& pane = shell.ui.time.keys;
  app::KeysModal modal;
  modal.kind = kind;
  modal.valuesShown = pane.valuesShown;
  modal.wholeFrames = shell.ui.time.timeline.snapToFrames;
  modal.aboutFrame = shell.open.character()->view().frame;
  modal.aboutValue = pane.value;
  modal.valueStep = pane.valueStep;
  return startKeys(*shell.open.character(), shell.tool, modal);
}

void openRetime(Shell& shell) {
  const Span range = shownSpan(*shell.open.character());
  shell.ui.time.retime = {.open = true,
                          .firstFrame = std::round(range.start),
                          .lastFrame = std::round(range.end),
                          .newFrames = std::round(range.end) - std::round(range.start)};
}

Status askForFit(Shell& shell, bool picked) {
  shell.ui.time.graph.fitPending = true;
  shell.ui.time.graph.fitPicked = picked;
  if (!picked) {
    shell.ui.time.timeline.viewStart = 0.0;
    shell.ui.time.timeline.viewEnd = -1.0;
  }
  return Success{};
}

/// Shows a tab of the bottom pane.
PaneCommand tabCommand(const char* id, const char* label, const char* help, const char* key, BottomTab tab) {
  PaneCommand command = paneCommand(id, label, help, showsClip, "open a character with an animation first",
                                    app::doing([tab](Shell& shell) {
                                      shell.ui.time.tab = tab;
                                      shell.panes.bottomOpen = true;
                                    }));
  command.keys = {key};
  return command;
}

PaneCommand clipChoice() {
  PaneCommand command =
      paneCommand(command::clipChoose, "Choose a clip", "Lists the clips of the character, to be searched.",
                  showsClip, "open a character with an animation first", app::doing([](Shell& shell) {
                    shell.ui.dialogs.palette = {};
                    shell.ui.dialogs.palette.open = true;
                    shell.ui.dialogs.palette.clipsOnly = true;
                  }));
  command.keys = {"F4"};
  return command;
}

} // namespace

std::vector<PaneCommand> keyPaneCommands() {
  constexpr const char* pickFirst = "pick a key in the graph or the dope sheet first";
  constexpr const char* openFirst = "open a character with an animation first";
  std::vector<PaneCommand> commands{
      paneCommand(command::keysGrab, "Move keys",
                  "Moves the picked keys with the mouse, arrows or a typed number of frames; over graph and "
                  "dope sheet by the key of Grab.",
                  canPick, pickFirst,
                  [](Shell& shell) { return runKeysTool(shell, app::KeysModal::Kind::move); }),
      paneCommand(
          command::keysScale, "Scale keys",
          "Scales the times of the picked keys about the playhead, or (Y) their values; over graph and "
          "dope sheet by the key that sets a key elsewhere.",
          canPick, pickFirst, [](Shell& shell) { return runKeysTool(shell, app::KeysModal::Kind::scale); }),
      paneCommand(command::keysRetime, "Retime", "Makes a range of the clip or of a limb slower or faster.",
                  showsClip, openFirst,
                  [](Shell& shell) {
                    openRetime(shell);
                    return Status(Success{});
                  }),
      paneCommand(command::graphFit, "Fit the picked keys", "Shows the picked keys as large as they fit.",
                  canPick, pickFirst, [](Shell& shell) { return askForFit(shell, true); }),
      paneCommand(command::graphFitAll, "Fit all curves", "Shows the whole clip and every value.", showsClip,
                  openFirst, [](Shell& shell) { return askForFit(shell, false); }),
      paneCommand(command::graphIsolate, "Isolate curves",
                  "The graph shows only the curves that have picked keys.", showsClip, openFirst,
                  [](Shell& shell) {
                    shell.ui.time.graph.isolated = !shell.ui.time.graph.isolated;
                    return Status(Success{});
                  }),
  };
  commands.back().checked = [](const Shell& shell) { return shell.ui.time.graph.isolated; };
  commands.push_back(tabCommand(command::showTimeline, "Timeline",
                                "Shows the keys of the selection and trails over time.", "F5",
                                BottomTab::timeline));
  commands.push_back(tabCommand(command::showGraph, "Graph",
                                "Shows the curves of the selection, whose keys are edited there.", "F6",
                                BottomTab::graph));
  commands.push_back(tabCommand(command::showDopeSheet, "Dope sheet",
                                "Shows the keys of every limb and controller.", "F7", BottomTab::dopeSheet));
  commands.push_back(clipChoice());
  return commands;
}

namespace {

/// Commands whose keys mean another command over graph and dope sheet, and that command.
constexpr std::array<std::pair<std::string_view, const char*>, 13> meanings{
    {{command::editDelete, command::keysDelete},
     {command::poseDeleteKey, command::keysDelete},
     {command::copyTrail, command::keysCopy},
     {command::poseCopy, command::keysCopy},
     {command::pasteTrail, command::keysPaste},
     {command::posePaste, command::keysPaste},
     {command::sphereAll, command::keysAll},
     {command::controllersAll, command::keysAll},
     {command::sphereGrab, command::keysGrab},
     {command::poseKey, command::keysScale},
     {command::viewFrameSelection, command::graphFit},
     {command::viewFrameAll, command::graphFitAll},
     {command::sphereAdd, command::keysInsert}}};

} // namespace

std::vector<app::Chord> chordsOverKeys(const Shell& shell, std::string_view commandId) {
  std::vector<app::Chord> chords;
  for (const auto& [there, here] : meanings) {
    if (here == commandId && chords.empty()) {
      chords = shell.keymap.chordsOf(there);
    }
  }
  return chords;
}

std::string commandUnderMouse(const Shell& shell, const app::Chord& chord, const std::string& elsewhere) {
  if (!shell.ui.time.keys.hovered || shell.open.character() == nullptr) {
    return elsewhere;
  }
  for (const auto& [there, here] : meanings) {
    if (there == elsewhere) {
      return here;
    }
  }
  const bool isInsert = elsewhere.empty() && chord == app::Chord{app::Key{'I'}};
  return isInsert ? std::string(command::keysInsert) : elsewhere;
}

void moveKeysTool(Shell& shell) {
  if (shell.open.character() != nullptr && shell.ui.time.keys.hovered) {
    const Vec2 mouse(shell.ui.time.keys.frame, shell.ui.time.keys.value);
    tellProblem(shell, moveKeysMouse(*shell.open.character(), shell.tool, mouse));
  }
}

} // namespace stretch::ui

#include "ui/shell/shell_commands.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "app/commands/applied.h"
#include "app/commands/command_ids.h"
#include "app/commands/document_commands.h"
#include "app/commands/ranges.h"
#include "app/commands/selection.h"
#include "app/commands/tables.h"
#include "ui/shell/file_work.h"
#include "ui/shell/input.h"
#include "ui/shell/playback.h"
#include "ui/shell/sequence_work.h"
#include "ui/shell/stroke_news.h"

namespace stretch::ui {

namespace {

using ShellCommand = app::Command<Shell>;
using app::doing;

bool always(const Shell&) {
  return true;
}
bool hasFile(const Shell& shell) {
  return shell.open.character() != nullptr;
}
bool hasPicture(const Shell& shell) {
  return shell.open.character() != nullptr || shell.open.sequence() != nullptr;
}

/// What can be written: a character, or what a sequence was compressed to.
bool canExport(const Shell& shell) {
  const app::SequenceSession* const sequence = shell.open.sequence();
  return hasFile(shell) || (sequence != nullptr && sequence->document().result != nullptr);
}

/// A command of what is open as one of the shell.
ShellCommand fromDocument(const app::DocumentCommand& command) {
  return {command.id,
          command.label,
          command.help,
          command.keys,
          [command](const Shell& shell) { return app::isEnabled(command, shell.open); },
          [command](Shell& shell) { return app::run(command, shell.open); },
          command.needs,
          command.otherwise};
}

/// What a command shows or hides; null for a command that does something else.
template <typename AnyShell>
auto switchOf(AnyShell& shell, std::string_view id) -> decltype(&shell.nameAsked) {
  auto& overlays = shell.ui.overlays;
  auto& panes = shell.panes;
  const std::pair<std::string_view, decltype(&shell.nameAsked)> switches[] = {
      {command::timeEveryFrame, &shell.ui.timeline.everyFrame},
      {command::timeOnTwos, &shell.ui.timeline.onTwos},
      {command::viewGhosts, &overlays.ghosts},
      {command::viewSkeleton, &overlays.skeleton},
      {command::viewWire, &overlays.wire},
      {command::viewJointNames, &overlays.jointNames},
      {command::viewHeatMap, &overlays.heatMap},
      {command::viewGrid, &overlays.grid},
      {command::viewFrameNumbers, &overlays.trailFrameNumbers},
      {command::viewSideBySide, &overlays.sideBySide},
      {command::viewLeftPane, &panes.leftOpen},
      {command::viewBottomPane, &panes.bottomOpen},
      {command::viewRightPane, &panes.rightOpen},
  };
  const auto* const found = std::ranges::find(switches, id, [](const auto& entry) { return entry.first; });
  return found == std::end(switches) ? nullptr : found->second;
}

ShellCommand entry(std::string id, std::string label, std::string help, std::vector<std::string> keys,
                   std::function<bool(const Shell&)> enabled, std::function<Status(Shell&)> run) {
  return {std::move(id),
          std::move(label),
          std::move(help),
          std::move(keys),
          std::move(enabled),
          std::move(run),
          {},
          {}};
}

ShellCommand needing(const char* needs, ShellCommand command) {
  command.needs = needs;
  return command;
}

ShellCommand switchCommand(const char* id, const char* label, const char* help,
                           std::vector<std::string> keys) {
  return entry(id, label, help, std::move(keys), always, doing([id](Shell& shell) {
                 bool& shown = *switchOf(shell, id);
                 shown = !shown;
               }));
}

ShellCommand directionCommand(const char* id, const char* label, const char* help, const char* key,
                              ViewDirection direction) {
  return entry(id, label, help, {key}, hasPicture, doing([direction](Shell& shell) {
                 shell.viewport.camera =
                     lookFrom(shell.viewport.camera, direction, shell.viewport.facingYawRadians);
               }));
}

void toggleViewportOnly(Shell& shell) {
  const bool anyOpen = shell.panes.leftOpen || shell.panes.rightOpen || shell.panes.bottomOpen;
  shell.panes.leftOpen = !anyOpen;
  shell.panes.rightOpen = !anyOpen;
  shell.panes.bottomOpen = !anyOpen;
}

void togglePlay(Shell& shell) {
  shell.ui.timeline.playing = !shell.ui.timeline.playing;
  shell.playRemainder = 0.0;
  if (!shell.ui.timeline.playing) {
    snapPlayhead(shell);
  }
}

Status runGrab(Shell& shell) {
  GrabStart start;
  start.startPixels = shell.viewport.mousePixels;
  start.falloffRadius = shell.viewport.falloffRadius;
  return startGrab(*shell.open.character(), shell.tool, start);
}

} // namespace

namespace {

/// Where E works, if the playhead is to go there.
void goToTip(Shell& shell) {
  app::Session& session = *shell.open.character();
  if (const std::optional<double> tip = tipFrame(session, shell.tool); tip && shell.ui.exaggerateAtTip) {
    session.view().frame = *tip;
  }
}

} // namespace

Status startExaggerating(Shell& shell, app::OverlapChoice choice) {
  app::Session& session = *shell.open.character();
  const bool proposes = app::selectedTrail(session) == nullptr && !app::isRangeSet(session.view());
  const Status started = startExaggerate(session, shell.tool, choice);
  if (!started) {
    return started;
  }
  const auto& tool = std::get<ExaggerateTool>(shell.tool);
  if (const std::string text = proposes || tool.targets.madeLoop ? strokeNews(session, tool) : "";
      !text.empty()) {
    tell(shell, ToastKind::info, text);
  }
  goToTip(shell);
  return started;
}

namespace {

/// Asks first when it is not plain which trail is meant.
Status beginExaggerating(Shell& shell) {
  app::Session& session = *shell.open.character();
  shell.ui.rangeClash = app::rangeClash(session);
  return shell.ui.rangeClash ? Status(Success{}) : startExaggerating(shell, app::OverlapChoice::edit);
}

bool hasSpheres(const Shell& shell) {
  return hasFile(shell) && !shell.open.character()->view().selectedSpheres.empty();
}

bool hasLimb(const Shell& shell) {
  return hasFile(shell) && !shell.open.character()->view().selectedLimbs.empty();
}

void showOriginal(Shell& shell) {
  bool& shown = shell.open.character() != nullptr ? shell.open.character()->view().showOriginal
                                                  : shell.open.sequence()->view().showOriginal;
  shown = !shown;
}

void pickChain(Shell& shell) {
  shell.ui.jointPick = {};
  shell.ui.jointPick.open = true;
}

Status exportKeys(Shell& shell) {
  const std::filesystem::path path = app::configFolder() / "keys-exported.json";
  Status done = writeText(path, shell.keymap.toJson(true));
  if (done) {
    tell(shell, ToastKind::success, "The keys are in " + path.string());
  }
  return done;
}

bool hasTrail(const Shell& shell) {
  return hasFile(shell) && app::hasSelectedTrail(*shell.open.character());
}

void renameTrail(Shell& shell) {
  const rig::Trail& trail = *app::selectedTrail(*shell.open.character());
  shell.ui.rename = {true, trail.id, trail.name, false};
}

void openPalette(Shell& shell) {
  shell.ui.palette = {};
  shell.ui.palette.open = true;
}

void toggleNavigation(Shell& shell) {
  const bool maya = shell.ui.navigation == NavigationStyle::maya;
  shell.ui.navigation = maya ? NavigationStyle::blender : NavigationStyle::maya;
  tell(shell, ToastKind::info,
       maya ? "Navigation as in Blender: middle button" : "Navigation as in Maya: Alt and mouse");
}

const ShellCommand* findCommandOf(const Shell& shell, std::string_view id) {
  const auto found = std::find_if(shell.commands.begin(), shell.commands.end(),
                                  [&](const ShellCommand& command) { return command.id == id; });
  return found == shell.commands.end() ? nullptr : &*found;
}

void append(std::vector<ShellCommand>& all, std::vector<ShellCommand> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

auto askingFor(FilePurpose purpose) {
  return doing([purpose](Shell& shell) { askForFile(shell, purpose); });
}

} // namespace

std::vector<ShellCommand> fileCommands() {
  return {
      entry(command::fileOpen, "Open", "Opens a character (.glb, .gltf, .vrm) or a mesh sequence.",
            {"Ctrl+O"}, always, askingFor(FilePurpose::openModel)),
      entry(command::fileSave, "Save",
            "Saves the file with the work inside; the first time it asks for a name.", {"Ctrl+S"}, canExport,
            doing([](Shell& shell) { saveFile(shell); })),
      entry(command::fileSaveAs, "Save as", "Saves under another name.", {"Ctrl+Shift+S"}, canExport,
            askingFor(FilePurpose::saveModel)),
      entry(command::fileSaveIncremental, "Save incremental",
            "Saves under the next free number and leaves older files alone.", {"Ctrl+Alt+S"}, hasFile,
            doing([](Shell& shell) { saveIncremental(shell); })),
      entry(command::fileExportClean, "Export clean",
            "Writes a copy without the work: only what players and engines need.", {"Ctrl+E"}, canExport,
            askingFor(FilePurpose::exportClean)),
      entry(command::recipeSave, "Save a recipe",
            "Writes the clip's trails, to be replayed on another clip or character.", {}, hasFile,
            askingFor(FilePurpose::saveRecipe)),
      entry(command::recipeLoad, "Replay a recipe", "Adds the trails of a recipe to this character.", {},
            hasFile, askingFor(FilePurpose::openRecipe)),
      entry(command::fileQuit, "Quit", "Leaves the program; asks first when there is unsaved work.",
            {"Ctrl+Q"}, always, doing([](Shell& shell) { askToQuit(shell); })),
  };
}

std::vector<ShellCommand> toolCommands() {
  return {
      needing("select a limb first: click one, or press its number",
              entry(command::trailExaggerate, "Exaggerate",
                    "Makes the trail if there is none, exaggerates it and connects the limb; "
                    "type the scale, X Y Z switch axes, Enter keeps, Esc restores.",
                    {"E"}, hasLimb, beginExaggerating)),
      needing("select a control sphere first: click one, or go to it with Next sphere",
              entry(command::sphereGrab, "Grab",
                    "Moves the selected spheres with the mouse, an axis key or a typed number.", {"G"},
                    hasSpheres, runGrab)),
      entry(command::trailShowOriginal, "Show the original",
            "While the key is held the character moves as in the file.", {"`", "O"}, hasPicture,
            doing(showOriginal)),
      entry(command::pickChain, "Any chain", "Makes a limb of any chain, by its two joints.", {"J"}, hasFile,
            doing(pickChain)),
      needing("select a trail first",
              entry(command::trailRename, "Rename the trail", "Gives the selected trail a name of your own.",
                    {"F2"}, hasTrail, doing(renameTrail))),
      entry(command::timePlay, "Play", "Plays and stops.", {"Space"}, hasPicture, doing(togglePlay)),
      switchCommand(command::timeEveryFrame, "Every frame",
                    "Playing shows each frame, however long it takes; else time runs as it is.", {}),
      switchCommand(command::timeOnTwos, "On twos",
                    "Playing holds every second frame for two, as cartoons do.", {}),
      entry(command::history, "History", "Lists what was done, to go back to any of it.", {"Ctrl+H"},
            hasPicture, doing([](Shell& shell) { shell.ui.historyOpen = true; })),
  };
}

std::vector<ShellCommand> viewCommands() {
  return {
      switchCommand(command::viewGhosts, "Ghosts", "Shows the character at frames before and after.", {"H"}),
      switchCommand(command::viewSkeleton, "Skeleton", "Shows the joints over the character.", {"K"}),
      switchCommand(command::viewWire, "Wire", "Shows the edges of the mesh.", {"W"}),
      switchCommand(command::viewJointNames, "Joint names", "Writes the joints' names beside them.", {}),
      switchCommand(command::viewHeatMap, "Stretch colours", "Colours the mesh by how much it is stretched.",
                    {}),
      switchCommand(command::viewGrid, "Floor", "Shows the floor with its grid.", {}),
      switchCommand(command::viewFrameNumbers, "Frame numbers",
                    "Writes the frame beside every control sphere.", {}),
      switchCommand(command::viewSideBySide, "Side by side",
                    "Shows the original beside the exaggerated motion.", {}),
      entry(command::viewFrameSelection, "Frame the selection",
            "Moves the camera to the selected limb and trail.", {"F"}, hasPicture,
            doing([](Shell& shell) { shell.viewport.frameSelectionPending = true; })),
      entry(command::viewFrameAll, "Frame everything",
            "Moves the camera so that the whole character is seen.", {"A"}, hasPicture,
            doing([](Shell& shell) { shell.viewport.framePending = true; })),
      directionCommand(command::viewFront, "Front view", "Looks at the character's front.", "Numpad 1",
                       ViewDirection::front),
      directionCommand(command::viewSide, "Side view", "Looks at the character's side.", "Numpad 3",
                       ViewDirection::side),
      directionCommand(command::viewTop, "Top view", "Looks down on the character.", "Numpad 7",
                       ViewDirection::top),
      directionCommand(command::viewPerspective, "Perspective view",
                       "Looks with perspective, from the front and above.", "Numpad 5",
                       ViewDirection::threeQuarter),
      switchCommand(command::viewLeftPane, "Left pane", "Shows or folds rig and limbs.", {"Ctrl+1"}),
      switchCommand(command::viewBottomPane, "Bottom pane", "Shows or folds timeline and graph.", {"Ctrl+2"}),
      switchCommand(command::viewRightPane, "Right pane", "Shows or folds trails and settings.", {"Ctrl+3"}),
      entry(command::viewViewportOnly, "Viewport only", "Folds every pane, or brings them back.",
            {"Ctrl+Space"}, always, doing(toggleViewportOnly)),
      entry(command::viewNavigation, "Navigation of Maya or Blender", "Changes how the mouse turns the view.",
            {}, always, doing(toggleNavigation)),
  };
}

std::vector<ShellCommand> helpCommands() {
  return {
      entry(command::palette, "Find a command", "Lists every command with its key.", {"Ctrl+P", "F3"}, always,
            doing(openPalette)),
      entry(command::keys, "All keys", "Shows every key and lets it be changed.", {"?", "F1"}, always,
            doing([](Shell& shell) {
              shell.ui.keys = {};
              shell.ui.keys.open = true;
            })),
      entry(command::settings, "Settings", "Theme, size, navigation and what is drawn.", {}, always,
            doing([](Shell& shell) { shell.ui.settingsOpen = true; })),
      entry(command::about, "About", "What this program is.", {}, always,
            doing([](Shell& shell) { shell.ui.aboutOpen = true; })),
      entry(command::keysExport, "Export the keys",
            "Writes every key to a file in your configuration folder.", {}, always, exportKeys),
  };
}

std::vector<ShellCommand> editorCommands() {
  std::vector<ShellCommand> all = fileCommands();
  for (const app::DocumentCommand& command : app::documentCommands()) {
    all.push_back(fromDocument(command));
  }
  append(all, toolCommands());
  append(all, moduliCommands());
  append(all, viewCommands());
  append(all, helpCommands());
  return all;
}

bool isChecked(const Shell& shell, std::string_view id) {
  if (const bool* const shown = switchOf(shell, id)) {
    return *shown;
  }
  const app::Session* const character = shell.open.character();
  const app::SequenceSession* const sequence = shell.open.sequence();
  return (id == command::timePlay && shell.ui.timeline.playing) ||
         (id == command::clipLoop && character != nullptr &&
          app::isLooping(character->document(), character->view().clip)) ||
         (id == command::trailShowOriginal && character != nullptr && character->view().showOriginal) ||
         (id == command::sequenceOriginal && sequence != nullptr && sequence->view().showOriginal) ||
         (id == command::sequenceSkinned && sequence != nullptr && sequence->view().showSkinned);
}

bool hasCommand(const Shell& shell, std::string_view commandId) {
  return findCommandOf(shell, commandId) != nullptr;
}

namespace {

/// Keeps what a tool or a drag in a panel has made so far: one undo step, before anything else happens.
void finishWhatIsDragged(Shell& shell) {
  if (isRunning(shell.tool)) {
    finishTool(*shell.open.character(), shell.tool, true);
    shell.viewport.gesture = ViewportGesture::none;
  }
  if (std::exchange(shell.ui.panelDrag, false)) {
    shell.ui.panelDrag = shell.open.with(false, [](auto& session) {
      if (session.isDragging()) {
        session.commit();
      }
      return false;
    });
    ImGui::ClearActiveID();
  }
}

/// What answers in the middle of a tool or a drag too.
bool answersAlways(std::string_view id) {
  constexpr std::array<std::string_view, 6> always{
      command::fileSave, command::fileSaveAs, command::fileSaveIncremental,
      command::undo,     command::redo,       command::fileQuit};
  return std::find(always.begin(), always.end(), id) != always.end();
}

} // namespace

namespace {

std::string undoneLabel(Shell& shell, std::string_view commandId) {
  return shell.open.with(std::string(), [&](auto& session) {
    return commandId == command::undo   ? session.history().undoLabel()
           : commandId == command::redo ? session.history().redoLabel()
                                        : std::string();
  });
}

/// What undo or redo did; the last one takes the place of those before.
void tellUndone(Shell& shell, std::string_view commandId, const std::string& label) {
  constexpr std::string_view undone = "Undone: ";
  constexpr std::string_view redone = "Redone: ";
  std::erase_if(shell.ui.toasts, [&](const Toast& toast) {
    return toast.text.starts_with(undone) || toast.text.starts_with(redone);
  });
  tell(shell, ToastKind::info, std::string(commandId == command::undo ? undone : redone) + label);
}

/// The trails that a command is going to apply; none for any other command.
std::vector<int> trailsToApply(const Shell& shell, std::string_view commandId) {
  const app::Session* const session = shell.open.character();
  const bool one = commandId == command::trailApply;
  const bool all = commandId == command::trailApplyAll;
  return session == nullptr ? std::vector<int>()
         : one              ? app::targetTrails(*session)
         : all              ? app::waitingTrails(*session)
                            : std::vector<int>();
}

/// "Undo: Change the scale".
std::string labelNow(Shell& shell, const ShellCommand& command) {
  const std::string label = undoneLabel(shell, command.id);
  return label.empty() ? command.label : command.label + ": " + label;
}

} // namespace

void runCommand(Shell& shell, std::string_view commandId) {
  const ShellCommand* command = findCommandOf(shell, commandId);
  if (command == nullptr) {
    return;
  }
  finishWhatIsDragged(shell);
  if (!command->enabled(shell)) {
    tell(shell, ToastKind::info,
         command->label + ": " + (command->needs.empty() ? "nothing to do this with now" : command->needs));
    return;
  }
  const std::string undone = undoneLabel(shell, commandId);
  const std::vector<int> applied = trailsToApply(shell, commandId);
  const Status done = command->run(shell);
  tellProblem(shell, done);
  if (done && !undone.empty()) {
    tellUndone(shell, commandId, undone);
  }
  if (done && !applied.empty()) {
    tell(shell, ToastKind::success, "Applied: " + app::appliedText(*shell.open.character(), applied));
  }
}

void describeCommands(Shell& shell) {
  shell.commandInfos.clear();
  for (const ShellCommand& command : shell.commands) {
    const std::vector<app::Chord> chords = shell.keymap.chordsOf(command.id);
    shell.commandInfos.push_back({command.id, labelNow(shell, command), command.help,
                                  chords.empty() ? std::string() : shownChord(chords.front()),
                                  command.enabled(shell), isChecked(shell, command.id)});
  }
}

bool widgetsOwnKeys(const Shell& shell) {
  const UiState& ui = shell.ui;
  return ui.fileDialog.open || ui.palette.open || ui.keys.open || ui.settingsOpen || ui.aboutOpen ||
         ui.rename.open || ui.historyOpen || ui.jointPick.open || ui.navigationChoiceOpen ||
         ui.rangeClash.has_value() || shell.files.question().kind != app::FileQuestion::Kind::none;
}

namespace {

/// What only moves the camera and leaves a running tool alone.
bool looksOnly(std::string_view id) {
  return id == command::viewFrameSelection;
}

/// The command of the key, or the one that the key means while that is off.
std::string meantCommand(const Shell& shell, const app::Chord& chord) {
  const std::string id = shell.keymap.commandOf(chord);
  const ShellCommand* const command = findCommandOf(shell, id);
  const bool other = command != nullptr && !command->otherwise.empty() && !command->enabled(shell);
  return other ? command->otherwise : id;
}

/// A key of the tool; after one that took another stroke it is told where that is.
void pressKeyOfTool(Shell& shell, const app::KeyPress& press) {
  app::Session& session = *shell.open.character();
  const std::optional<double> tip = tipFrame(session, shell.tool);
  tellProblem(shell, pressToolKey(session, shell.tool, press));
  const auto* const tool = std::get_if<ExaggerateTool>(&shell.tool);
  if (tool == nullptr || app::typedLetter(press) != 'n') {
    return;
  }
  if (tip == tipFrame(session, shell.tool)) {
    tell(shell, ToastKind::info, "There is no other stroke that is free");
    return;
  }
  goToTip(shell);
  tell(shell, ToastKind::info, strokeReached(session, *tool));
}

} // namespace

void dispatchKey(Shell& shell, const KeyInput& input) {
  const app::Chord& chord = input.press.chord;
  if (!input.down) {
    if (chord.key == shell.heldKey && shell.open.character() != nullptr) {
      shell.open.character()->view().showOriginal = false;
      shell.heldKey = app::Key::none;
    }
    return;
  }
  if (isRunning(shell.tool) && looksOnly(shell.keymap.commandOf(chord))) {
    findCommandOf(shell, shell.keymap.commandOf(chord))->run(shell);
    return;
  }
  if (isRunning(shell.tool) && !answersAlways(shell.keymap.commandOf(chord))) {
    pressKeyOfTool(shell, input.press);
    return;
  }
  const std::string commandId = meantCommand(shell, chord);
  if (commandId == command::trailShowOriginal && shell.open.character() != nullptr) {
    shell.open.character()->view().showOriginal = true;
    shell.heldKey = chord.key;
  } else if (!commandId.empty()) {
    runCommand(shell, commandId);
  }
}

} // namespace stretch::ui

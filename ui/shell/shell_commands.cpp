#include "ui/shell/shell_commands.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "app/commands/command_ids.h"
#include "app/commands/document_commands.h"
#include "app/commands/frames.h"
#include "app/commands/ranges.h"
#include "app/commands/selection.h"
#include "app/commands/step_text.h"
#include "app/commands/tables.h"
#include "ui/panels/panel_support.h"
#include "ui/shell/file_work.h"
#include "ui/shell/input.h"
#include "ui/shell/playback.h"
#include "ui/shell/sequence_work.h"

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
          [command](const Shell& shell) { return app::isChecked(command, shell.open); },
          [command](const Shell& shell) { return app::labelNow(command, shell.open); },
          [command](const Shell& shell) { return app::whyOff(command, shell.open); }};
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

/// When a command of the window is on, and what to do first while it is off.
struct ShellNeed {
  bool (*holds)(const Shell&) = always;
  const char* otherwise = "";
};
constexpr ShellNeed nothingNeeded{};
constexpr ShellNeed characterNeeded{hasFile, "open a character first"};
constexpr ShellNeed pictureNeeded{hasPicture, "open a file first"};
constexpr ShellNeed exportNeeded{canExport, "open a character, or compress a sequence, first"};

ShellCommand entry(std::string id, std::string label, std::string help, std::vector<std::string> keys,
                   const ShellNeed& need, std::function<Status(Shell&)> run) {
  return {.id = std::move(id),
          .label = std::move(label),
          .help = std::move(help),
          .keys = std::move(keys),
          .enabled = need.holds,
          .run = std::move(run),
          .checked = nullptr,
          .labelNow = nullptr,
          .otherwise = [need](const Shell& shell) { return need.holds(shell) ? "" : need.otherwise; }};
}

ShellCommand switchCommand(const char* id, const char* label, const char* help,
                           std::vector<std::string> keys) {
  ShellCommand command = entry(id, label, help, std::move(keys), nothingNeeded, doing([id](Shell& shell) {
                                 bool& shown = *switchOf(shell, id);
                                 shown = !shown;
                               }));
  command.checked = [id](const Shell& shell) { return *switchOf(shell, id); };
  return command;
}

ShellCommand directionCommand(const char* id, const char* label, const char* help, const char* key,
                              ViewDirection direction) {
  return entry(id, label, help, {key}, pictureNeeded, doing([direction](Shell& shell) {
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

/// Where the limb rests at the playhead, E takes its nearest stroke: that is said.
std::string elsewhereText(const app::Session& session) {
  const app::ViewState& view = session.view();
  const rig::Trail* const trail = app::selectedTrail(session);
  if (trail == nullptr) {
    return {};
  }
  const rig::TrailSettings& settings = trail->settings;
  const bool here = settings.startFrame - 0.5 <= view.frame && view.frame <= settings.endFrame + 0.5;
  return here ? std::string()
              : fmt::format(
                    "At frame {:.4g} the {} rests: its nearest stroke, frames {:.4g} to {:.4g}, is taken",
                    view.frame, app::limbTitle(session.document(), trail->limb), settings.startFrame,
                    settings.endFrame);
}

} // namespace

Status startExaggerating(Shell& shell, app::OverlapChoice choice) {
  app::Session& session = *shell.open.character();
  const bool proposes = app::selectedTrail(session) == nullptr && !app::isRangeSet(session.view());
  const Status started = startExaggerate(session, shell.tool, choice);
  if (const std::string text = started && proposes ? elsewhereText(session) : ""; !text.empty()) {
    tell(shell, ToastKind::info, text);
  }
  if (const std::optional<double> tip = tipFrame(session, shell.tool);
      started && tip && shell.ui.exaggerateAtTip) {
    session.view().frame = *tip;
  }
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

bool viewsClip(const Shell& shell) {
  return hasFile(shell) &&
         app::hasClip(shell.open.character()->document(), shell.open.character()->view().clip);
}

bool canExaggerate(const Shell& shell) {
  return hasLimb(shell) && viewsClip(shell);
}

bool canPlay(const Shell& shell) {
  return shell.open.sequence() != nullptr || viewsClip(shell);
}

/// Whether the viewed clip has anything that a recipe holds.
bool hasWork(const Shell& shell) {
  if (!viewsClip(shell)) {
    return false;
  }
  const app::Document& document = shell.open.character()->document();
  const int clip = shell.open.character()->view().clip;
  return app::hasWeight(document, clip) ||
         std::ranges::any_of(document.trails, [&](const rig::Trail& trail) { return trail.clip == clip; });
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

/// Of the selected trail, or of its group while the whole of it is selected.
void rename(Shell& shell) {
  const app::Session& session = *shell.open.character();
  const rig::Trail& trail = *app::selectedTrail(session);
  const std::vector<int> group = app::wholeGroupSelected(session);
  shell.ui.rename = {.open = true, .trail = trail.id, .ofGroup = !group.empty()};
  shell.ui.rename.present = group.empty() ? trailHeading(session.document(), trail)
                                          : capitalised(app::groupTitle(session.document(), group));
  shell.ui.rename.typed = shell.ui.rename.present;
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
            {"Ctrl+O"}, nothingNeeded, askingFor(FilePurpose::openModel)),
      entry(command::fileSave, "Save",
            "Saves the file with the work inside; the first time it asks for a name.", {"Ctrl+S"},
            exportNeeded, doing([](Shell& shell) { saveFile(shell); })),
      entry(command::fileSaveAs, "Save as", "Saves under another name.", {"Ctrl+Shift+S"}, exportNeeded,
            askingFor(FilePurpose::saveModel)),
      entry(command::fileSaveIncremental, "Save incremental",
            "Saves under the next free number and leaves older files alone.", {"Ctrl+Alt+S"}, characterNeeded,
            doing([](Shell& shell) { saveIncremental(shell); })),
      entry(command::fileExportClean, "Export clean",
            "Writes a copy without the work: only what players and engines need.", {"Ctrl+E"}, exportNeeded,
            askingFor(FilePurpose::exportClean)),
      entry(command::recipeSave, "Save a recipe",
            "Writes the clip's trails, to be replayed on another clip or character.", {},
            {hasWork, "make a trail first"}, askingFor(FilePurpose::saveRecipe)),
      entry(command::recipeLoad, "Replay a recipe", "Adds the trails of a recipe to this character.", {},
            characterNeeded, askingFor(FilePurpose::openRecipe)),
      entry(command::fileQuit, "Quit", "Leaves the program; asks first when there is unsaved work.",
            {"Ctrl+Q"}, nothingNeeded, doing([](Shell& shell) { askToQuit(shell); })),
  };
}

namespace {

ShellCommand renameCommand() {
  ShellCommand command = entry(command::trailRename, "Rename the trail",
                               "Gives the selected trail, or the group that is selected, a name of your own.",
                               {"F2"}, {hasTrail, "select a trail first"}, doing(rename));
  command.labelNow = [](const Shell& shell) -> std::string {
    const app::Session* const session = shell.open.character();
    const bool isGroup = session != nullptr && !app::wholeGroupSelected(*session).empty();
    return isGroup ? "Rename the group" : "Rename the trail";
  };
  return command;
}

} // namespace

std::vector<ShellCommand> toolCommands() {
  return {
      entry(command::trailExaggerate, "Exaggerate",
            "Makes the trail if there is none, exaggerates it and connects the limb; "
            "type the scale, X Y Z switch axes, Enter keeps, Esc restores.",
            {"E"}, {canExaggerate, "select a limb first: 1 to 6, or click one"}, beginExaggerating),
      entry(command::sphereGrab, "Grab",
            "Moves the selected spheres with the mouse, an axis key or a typed number.", {"G"},
            {hasSpheres, "select a control sphere first: Tab, or click it"}, runGrab),
      entry(command::trailShowOriginal, "Show the original",
            "While the key is held the character moves as in the file.", {"`", "O"}, pictureNeeded,
            doing(showOriginal)),
      entry(command::pickChain, "Any chain", "Makes a limb of any chain, by its two joints.", {"J"},
            characterNeeded, doing(pickChain)),
      renameCommand(),
      entry(command::timePlay, "Play", "Plays and stops.", {"Space"},
            {canPlay, "open a file with a clip first"}, doing(togglePlay)),
      switchCommand(command::timeEveryFrame, "Every frame",
                    "Playing shows each frame, however long it takes; else time runs as it is.", {}),
      switchCommand(command::timeOnTwos, "On twos",
                    "Playing holds every second frame for two, as cartoons do.", {}),
      entry(command::history, "History", "Lists what was done, to go back to any of it.", {"Ctrl+H"},
            pictureNeeded, doing([](Shell& shell) { shell.ui.history = {.open = true}; })),
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
            "Moves the camera to the selected limb and trail.", {"F"}, pictureNeeded,
            doing([](Shell& shell) { shell.viewport.frameSelectionPending = true; })),
      entry(command::viewFrameAll, "Frame everything",
            "Moves the camera so that the whole character is seen.", {"A"}, pictureNeeded,
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
            {"Ctrl+Space"}, nothingNeeded, doing(toggleViewportOnly)),
      entry(command::viewNavigation, "Navigation of Maya or Blender", "Changes how the mouse turns the view.",
            {}, nothingNeeded, doing(toggleNavigation)),
  };
}

std::vector<ShellCommand> helpCommands() {
  return {
      entry(command::palette, "Find a command", "Lists every command with its key.", {"Ctrl+P", "F3"},
            nothingNeeded, doing(openPalette)),
      entry(command::keys, "All keys", "Shows every key and lets it be changed.", {"?", "F1"}, nothingNeeded,
            doing([](Shell& shell) {
              shell.ui.keys = {};
              shell.ui.keys.open = true;
            })),
      entry(command::settings, "Settings", "Theme, size, navigation and what is drawn.", {}, nothingNeeded,
            doing([](Shell& shell) { shell.ui.settingsOpen = true; })),
      entry(command::about, "About", "What this program is.", {}, nothingNeeded,
            doing([](Shell& shell) { shell.ui.aboutOpen = true; })),
      entry(command::keysExport, "Export the keys",
            "Writes every key to a file in your configuration folder.", {}, nothingNeeded, exportKeys),
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

namespace {

/// A switch of the window or of what is open, and what is done until it is ended.
bool isOn(const Shell& shell, const ShellCommand& command) {
  if (command.checked && command.checked(shell)) {
    return true;
  }
  const app::Session* const character = shell.open.character();
  const app::SequenceSession* const sequence = shell.open.sequence();
  const std::string_view id = command.id;
  return (id == command::timePlay && shell.ui.timeline.playing) ||
         (id == command::trailShowOriginal && character != nullptr && character->view().showOriginal) ||
         (id == command::sequenceOriginal && sequence != nullptr && sequence->view().showOriginal) ||
         (id == command::sequenceSkinned && sequence != nullptr && sequence->view().showSkinned);
}

} // namespace

bool isChecked(const Shell& shell, std::string_view id) {
  const ShellCommand* const command = findCommandOf(shell, id);
  return command != nullptr && isOn(shell, *command);
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

/// What undo or redo would do now; empty for other commands.
std::string undoneText(const Shell& shell, std::string_view commandId) {
  const auto textOf = [&](const auto& session) -> std::string {
    const auto& history = session.history();
    const bool undoes = commandId == command::undo && history.canUndo();
    if (!undoes && !(commandId == command::redo && history.canRedo())) {
      return {};
    }
    const std::size_t step = undoes ? history.position() : history.position() + 1;
    return app::stepText(undoes ? history.undoLabel() : history.redoLabel(), history.at(step - 1),
                         history.at(step));
  };
  if (const app::Session* const character = shell.open.character()) {
    return textOf(*character);
  }
  const app::SequenceSession* const sequence = shell.open.sequence();
  return sequence == nullptr ? std::string() : textOf(*sequence);
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

/// "Undo: Change the scale – left arm ×3", "Disconnect".
std::string labelNow(const Shell& shell, const ShellCommand& command) {
  const std::string undone = undoneText(shell, command.id);
  const std::string label = command.labelNow ? command.labelNow(shell) : command.label;
  return undone.empty() ? label : label + ": " + undone;
}

/// What to do first; empty while the command is on.
std::string reasonOf(const Shell& shell, const ShellCommand& command) {
  const std::string reason = command.enabled(shell) || !command.otherwise ? "" : command.otherwise(shell);
  return reason.empty() && !command.enabled(shell) ? "nothing to do this with now" : reason;
}

} // namespace

void runCommand(Shell& shell, std::string_view commandId) {
  const ShellCommand* command = findCommandOf(shell, commandId);
  if (command == nullptr) {
    return;
  }
  finishWhatIsDragged(shell);
  if (!command->enabled(shell)) {
    tell(shell, ToastKind::info, command->label + ": " + reasonOf(shell, *command));
    return;
  }
  const std::string undone = undoneText(shell, commandId);
  const Status done = command->run(shell);
  tellProblem(shell, done);
  if (done && !undone.empty()) {
    tellUndone(shell, commandId, undone);
  }
}

void describeCommands(Shell& shell) {
  shell.commandInfos.clear();
  for (const ShellCommand& command : shell.commands) {
    const std::vector<app::Chord> chords = shell.keymap.chordsOf(command.id);
    shell.commandInfos.push_back({command.id, labelNow(shell, command), command.help,
                                  chords.empty() ? std::string() : shownChord(chords.front()),
                                  command.enabled(shell), isOn(shell, command), reasonOf(shell, command),
                                  command.label});
  }
}

bool widgetsOwnKeys(const Shell& shell) {
  const UiState& ui = shell.ui;
  return ui.fileDialog.open || ui.palette.open || ui.keys.open || ui.settingsOpen || ui.aboutOpen ||
         ui.rename.open || ui.history.open || ui.jointPick.open || ui.navigationChoiceOpen ||
         ui.rangeClash.has_value() || shell.files.question().kind != app::FileQuestion::Kind::none;
}

void dispatchKey(Shell& shell, const KeyInput& input) {
  const app::Chord& chord = input.press.chord;
  if (!input.down) {
    if (chord.key == shell.heldKey && shell.open.character() != nullptr) {
      shell.open.character()->view().showOriginal = false;
      shell.heldKey = app::Key::none;
    }
    return;
  }
  if (isRunning(shell.tool) && !answersAlways(shell.keymap.commandOf(chord))) {
    tellProblem(shell, pressToolKey(*shell.open.character(), shell.tool, input.press));
    return;
  }
  const std::string commandId = shell.keymap.commandOf(chord);
  if (commandId == command::trailShowOriginal && shell.open.character() != nullptr) {
    shell.open.character()->view().showOriginal = true;
    shell.heldKey = chord.key;
  } else if (!commandId.empty()) {
    runCommand(shell, commandId);
  }
}

} // namespace stretch::ui

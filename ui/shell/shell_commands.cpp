#include "ui/shell/shell_commands.h"

#include <algorithm>
#include <iterator>

#include "app/commands/command_ids.h"
#include "app/commands/document_commands.h"
#include "ui/shell/file_work.h"
#include "ui/shell/input.h"
#include "ui/shell/playback.h"
#include "ui/shell/sequence_work.h"
#include "ui/viewport/viewport_scene.h"

namespace stretch::ui {

namespace {

using ShellCommand = app::Command<Shell>;

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
          [command](Shell& shell) { return app::run(command, shell.open); }};
}

/// A switch of the view.
ShellCommand switchCommand(const char* id, const char* label, const char* help, const char* key,
                           bool ViewportOverlays::*overlay) {
  std::vector<std::string> keys;
  if (key[0] != '\0') {
    keys.emplace_back(key);
  }
  return {id, label, help, std::move(keys), always, [overlay](Shell& shell) -> Status {
            shell.ui.overlays.*overlay = !(shell.ui.overlays.*overlay);
            return Success{};
          }};
}

ShellCommand paneCommand(const char* id, const char* label, const char* help, const char* key,
                         bool PaneSizes::*open) {
  return {id, label, help, {key}, always, [open](Shell& shell) -> Status {
            shell.panes.*open = !(shell.panes.*open);
            return Success{};
          }};
}

ShellCommand directionCommand(const char* id, const char* label, const char* help, const char* key,
                              ViewDirection direction) {
  return {id, label, help, {key}, hasPicture, [direction](Shell& shell) -> Status {
            shell.viewport.camera =
                lookFrom(shell.viewport.camera, direction, shell.viewport.facingYawRadians);
            return Success{};
          }};
}

Status toggleViewportOnly(Shell& shell) {
  const bool anyOpen = shell.panes.leftOpen || shell.panes.rightOpen || shell.panes.bottomOpen;
  shell.panes.leftOpen = !anyOpen;
  shell.panes.rightOpen = !anyOpen;
  shell.panes.bottomOpen = !anyOpen;
  return Success{};
}

Status togglePlay(Shell& shell) {
  shell.ui.timeline.playing = !shell.ui.timeline.playing;
  shell.playRemainder = 0.0;
  if (!shell.ui.timeline.playing) {
    snapPlayhead(shell);
  }
  return Success{};
}

Status runGrab(Shell& shell) {
  GrabStart start;
  start.startPixels = shell.viewport.mousePixels;
  start.falloffRadius = shell.viewport.falloffRadius;
  return startGrab(*shell.open.character(), shell.tool, start);
}

bool hasSpheres(const Shell& shell) {
  return hasFile(shell) && !shell.open.character()->view().selectedSpheres.empty();
}

bool hasLimb(const Shell& shell) {
  return hasFile(shell) && !shell.open.character()->view().selectedLimbs.empty();
}

Status showOriginal(Shell& shell) {
  bool& shown = shell.open.character() != nullptr ? shell.open.character()->view().showOriginal
                                                  : shell.open.sequence()->view().showOriginal;
  shown = !shown;
  return Success{};
}

Status pickChain(Shell& shell) {
  shell.ui.jointPick = {};
  shell.ui.jointPick.open = true;
  return Success{};
}

Status exportKeys(Shell& shell) {
  const std::filesystem::path path = app::configFolder() / "keys-exported.json";
  Status done = writeText(path, shell.keymap.toJson(true));
  if (done) {
    tell(shell, ToastKind::success, "The keys are in " + path.string());
  }
  return done;
}

Status openPalette(Shell& shell) {
  shell.ui.palette = {};
  shell.ui.palette.open = true;
  return Success{};
}

Status toggleNavigation(Shell& shell) {
  const bool maya = shell.ui.navigation == NavigationStyle::maya;
  shell.ui.navigation = maya ? NavigationStyle::blender : NavigationStyle::maya;
  tell(shell, ToastKind::info,
       maya ? "Navigation as in Blender: middle button" : "Navigation as in Maya: Alt and mouse");
  return Success{};
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
  return [purpose](Shell& shell) -> Status {
    askForFile(shell, purpose);
    return Success{};
  };
}

std::vector<ShellCommand> openingAndSavingCommands() {
  return {
      {command::fileOpen,
       "Open",
       "Opens a character (.glb, .gltf, .vrm) or a mesh sequence.",
       {"Ctrl+O"},
       always,
       askingFor(FilePurpose::openModel)},
      {command::fileSave,
       "Save",
       "Saves the file with the work inside; the first time it asks for a name.",
       {"Ctrl+S"},
       canExport,
       [](Shell& shell) -> Status {
         saveFile(shell);
         return Success{};
       }},
      {command::fileSaveAs,
       "Save as",
       "Saves under another name.",
       {"Ctrl+Shift+S"},
       canExport,
       askingFor(FilePurpose::saveModel)},
      {command::fileSaveIncremental,
       "Save incremental",
       "Saves under the next free number and leaves older files alone.",
       {"Ctrl+Alt+S"},
       hasFile,
       [](Shell& shell) -> Status {
         saveIncremental(shell);
         return Success{};
       }},
  };
}

std::vector<ShellCommand> exportingAndQuittingCommands() {
  return {
      {command::fileExportClean,
       "Export clean",
       "Writes a copy without the work: only what players and engines need.",
       {"Ctrl+E"},
       canExport,
       askingFor(FilePurpose::exportClean)},
      {command::recipeSave,
       "Save a recipe",
       "Writes the clip's trails, to be replayed on another clip or character.",
       {},
       hasFile,
       askingFor(FilePurpose::saveRecipe)},
      {command::recipeLoad,
       "Replay a recipe",
       "Adds the trails of a recipe to this character.",
       {},
       hasFile,
       askingFor(FilePurpose::openRecipe)},
      {command::fileQuit,
       "Quit",
       "Leaves the program; asks first when there is unsaved work.",
       {"Ctrl+Q"},
       always,
       [](Shell& shell) -> Status {
         askToQuit(shell);
         return Success{};
       }},
  };
}

} // namespace

std::vector<ShellCommand> fileCommands() {
  std::vector<ShellCommand> all = openingAndSavingCommands();
  append(all, exportingAndQuittingCommands());
  return all;
}

std::vector<ShellCommand> toolCommands() {
  return {
      {command::trailExaggerate,
       "Exaggerate",
       "Makes the trail if there is none, exaggerates it and connects the limb; "
       "type the scale, X Y Z switch axes, Enter keeps, Esc restores.",
       {"E"},
       hasLimb,
       [](Shell& shell) { return startExaggerate(*shell.open.character(), shell.tool); }},
      {command::sphereGrab,
       "Grab",
       "Moves the selected spheres with the mouse, an axis key or a typed number.",
       {"G"},
       hasSpheres,
       runGrab},
      {command::trailShowOriginal,
       "Show the original",
       "While the key is held the character moves as in the file.",
       {"`", "O"},
       hasPicture,
       showOriginal},
      {command::pickChain,
       "Any chain",
       "Makes a limb of any chain, by its two joints.",
       {"J"},
       hasFile,
       pickChain},
      {command::timePlay, "Play", "Plays and stops.", {"Space"}, hasPicture, togglePlay},
  };
}

namespace {

std::vector<ShellCommand> overlayCommands() {
  return {
      switchCommand(command::viewGhosts, "Ghosts", "Shows the character at frames before and after.", "H",
                    &ViewportOverlays::ghosts),
      switchCommand(command::viewSkeleton, "Skeleton", "Shows the joints over the character.", "K",
                    &ViewportOverlays::skeleton),
      switchCommand(command::viewWire, "Wire", "Shows the edges of the mesh.", "W", &ViewportOverlays::wire),
      switchCommand(command::viewJointNames, "Joint names", "Writes the joints' names beside them.", "",
                    &ViewportOverlays::jointNames),
      switchCommand(command::viewHeatMap, "Stretch colours", "Colours the mesh by how much it is stretched.",
                    "", &ViewportOverlays::heatMap),
      switchCommand(command::viewGrid, "Floor", "Shows the floor with its grid.", "",
                    &ViewportOverlays::grid),
      switchCommand(command::viewFrameNumbers, "Frame numbers",
                    "Writes the frame beside every control sphere.", "",
                    &ViewportOverlays::trailFrameNumbers),
      switchCommand(command::viewSideBySide, "Side by side",
                    "Shows the original beside the exaggerated motion.", "", &ViewportOverlays::sideBySide),
  };
}

std::vector<ShellCommand> cameraAndPaneCommands() {
  return {
      {command::viewFrameSelection,
       "Frame the selection",
       "Moves the camera to the selected limb and trail.",
       {"F"},
       hasPicture,
       [](Shell& shell) -> Status {
         shell.viewport.frameSelectionPending = true;
         return Success{};
       }},
      {command::viewFrameAll,
       "Frame everything",
       "Moves the camera so that the whole character is seen.",
       {"A"},
       hasPicture,
       [](Shell& shell) -> Status {
         shell.viewport.framePending = true;
         return Success{};
       }},
      directionCommand(command::viewFront, "Front view", "Looks at the character's front.", "Numpad 1",
                       ViewDirection::front),
      directionCommand(command::viewSide, "Side view", "Looks at the character's side.", "Numpad 3",
                       ViewDirection::side),
      directionCommand(command::viewTop, "Top view", "Looks down on the character.", "Numpad 7",
                       ViewDirection::top),
      directionCommand(command::viewPerspective, "Perspective view",
                       "Looks with perspective, from the front and above.", "Numpad 5",
                       ViewDirection::threeQuarter),
      paneCommand(command::viewLeftPane, "Left pane", "Shows or folds rig and limbs.", "Ctrl+1",
                  &PaneSizes::leftOpen),
      paneCommand(command::viewBottomPane, "Bottom pane", "Shows or folds timeline and graph.", "Ctrl+2",
                  &PaneSizes::bottomOpen),
      paneCommand(command::viewRightPane, "Right pane", "Shows or folds trails and settings.", "Ctrl+3",
                  &PaneSizes::rightOpen),
      {command::viewViewportOnly,
       "Viewport only",
       "Folds every pane, or brings them back.",
       {"Ctrl+Space"},
       always,
       toggleViewportOnly},
      {command::viewNavigation,
       "Navigation of Maya or Blender",
       "Changes how the mouse turns the view.",
       {},
       always,
       toggleNavigation},
  };
}

} // namespace

std::vector<ShellCommand> viewCommands() {
  std::vector<ShellCommand> all = overlayCommands();
  append(all, cameraAndPaneCommands());
  return all;
}

std::vector<ShellCommand> helpCommands() {
  return {
      {command::palette,
       "Find a command",
       "Lists every command with its key.",
       {"Ctrl+P", "F3"},
       always,
       openPalette},
      {command::keys,
       "All keys",
       "Shows every key and lets it be changed.",
       {"?", "F1"},
       always,
       [](Shell& shell) -> Status {
         shell.ui.keys = {};
         shell.ui.keys.open = true;
         return Success{};
       }},
      {command::settings,
       "Settings",
       "Theme, size, navigation and what is drawn.",
       {},
       always,
       [](Shell& shell) -> Status {
         shell.ui.settingsOpen = true;
         return Success{};
       }},
      {command::about,
       "About",
       "What this program is.",
       {},
       always,
       [](Shell& shell) -> Status {
         shell.ui.aboutOpen = true;
         return Success{};
       }},
      {command::keysExport,
       "Export the keys",
       "Writes every key to a file in your configuration folder.",
       {},
       always,
       exportKeys},
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
  const ViewportOverlays& overlays = shell.ui.overlays;
  const bool shownOriginal = shell.open.character() != nullptr && shell.open.character()->view().showOriginal;
  const std::pair<std::string_view, bool> switches[] = {
      {command::viewGhosts, overlays.ghosts},
      {command::viewSkeleton, overlays.skeleton},
      {command::viewWire, overlays.wire},
      {command::viewJointNames, overlays.jointNames},
      {command::viewHeatMap, overlays.heatMap},
      {command::viewGrid, overlays.grid},
      {command::viewFrameNumbers, overlays.trailFrameNumbers},
      {command::viewSideBySide, overlays.sideBySide},
      {command::timePlay, shell.ui.timeline.playing},
      {command::sequenceOriginal,
       shell.open.sequence() != nullptr && shell.open.sequence()->view().showOriginal},
      {command::sequenceSkinned,
       shell.open.sequence() != nullptr && shell.open.sequence()->view().showSkinned},
      {command::trailShowOriginal, shownOriginal},
      {command::viewLeftPane, shell.panes.leftOpen},
      {command::viewBottomPane, shell.panes.bottomOpen},
      {command::viewRightPane, shell.panes.rightOpen},
  };
  return std::any_of(std::begin(switches), std::end(switches),
                     [&](const auto& entry) { return entry.first == id && entry.second; });
}

bool hasCommand(const Shell& shell, std::string_view commandId) {
  return findCommandOf(shell, commandId) != nullptr;
}

void runCommand(Shell& shell, std::string_view commandId) {
  const ShellCommand* command = findCommandOf(shell, commandId);
  if (command == nullptr) {
    return;
  }
  if (isRunning(shell.tool)) {
    finishTool(*shell.open.character(), shell.tool, true);
  }
  if (!command->enabled(shell)) {
    tell(shell, ToastKind::info, command->label + ": nothing to do this with now");
    return;
  }
  tellProblem(shell, command->run(shell));
}

void describeCommands(Shell& shell) {
  shell.commandInfos.clear();
  for (const ShellCommand& command : shell.commands) {
    const std::vector<app::Chord> chords = shell.keymap.chordsOf(command.id);
    shell.commandInfos.push_back({command.id, command.label, command.help,
                                  chords.empty() ? std::string() : shownChord(chords.front()),
                                  command.enabled(shell), isChecked(shell, command.id)});
  }
}

bool widgetsOwnKeys(const Shell& shell) {
  const UiState& ui = shell.ui;
  return ui.fileDialog.open || ui.palette.open || ui.keys.open || ui.settingsOpen || ui.aboutOpen ||
         ui.jointPick.open || ui.navigationChoiceOpen ||
         shell.files.question().kind != app::FileQuestion::Kind::none;
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
  if (isRunning(shell.tool)) {
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

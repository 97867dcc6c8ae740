#include "ui/shell/shell_commands.h"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>

#include "app/bundled_files.h"
#include "app/commands/pose/hold.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/pose/offset_edits.h"
#include "app/edits/pose/selection_set_edits.h"
#include "ui/panels/context/panel_support.h"
#include "ui/shell/bind_work.h"
#include "ui/shell/file_work.h"
#include "ui/shell/fit_work.h"
#include "ui/shell/key_pane.h"
#include "ui/shell/playback.h"
#include "ui/shell/sequence_work.h"
#include "ui/shell/shell_command.h"
#include "ui/shell/stroke_news.h"
#include "ui/shell/style_work.h"
#include "ui/shell/tour.h"
#include "ui/shell/window/input.h"

namespace stretch::ui {

namespace {

using app::doing;

bool hasFile(const Shell& shell) {
  return shell.open.character() != nullptr;
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
          [command](const Shell& shell) { return app::whyOff(command, shell.open); },
          command.otherwise,
          [command](const Shell& shell) { return app::helpNow(command, shell.open); }};
}

/// What a command shows or hides; null for a command that does something else.
template <typename AnyShell>
auto switchOf(AnyShell& shell, std::string_view id) -> decltype(&shell.nameAsked) {
  auto& overlays = shell.ui.overlays;
  auto& panes = shell.panes;
  const std::pair<std::string_view, decltype(&shell.nameAsked)> switches[] = {
      {command::timeEveryFrame, &shell.ui.time.timeline.everyFrame},
      {command::timeOnTwos, &shell.ui.time.timeline.onTwos},
      {command::viewGhosts, &overlays.ghosts},
      {command::viewControllers, &overlays.controllers},
      {command::viewSkeleton, &overlays.skeleton},
      {command::viewWire, &overlays.wire},
      {command::viewJointNames, &overlays.jointNames},
      {command::viewHeatMap, &overlays.heatMap},
      {command::viewWeights, &overlays.weights},
      {command::viewGrid, &overlays.grid},
      {command::viewCube, &overlays.viewCube},
      {command::viewReference, &overlays.reference},
      {command::viewFrameNumbers, &overlays.trailFrameNumbers},
      {command::viewSafeFrame, &overlays.safeFrame},
      {command::viewSideBySide, &overlays.sideBySide},
      {command::viewLeftPane, &panes.leftOpen},
      {command::viewBottomPane, &panes.bottomOpen},
      {command::viewRightPane, &panes.rightOpen},
  };
  const auto* const found = std::ranges::find(switches, id, [](const auto& entry) { return entry.first; });
  return found == std::end(switches) ? nullptr : found->second;
}

constexpr ShellNeed nothingNeeded{};
constexpr ShellNeed characterNeeded{hasFile, "open a character first"};
constexpr ShellNeed pictureNeeded{hasPicture, "open a file first"};
constexpr ShellNeed exportNeeded{canExport, "open a character, or compress a sequence, first"};

ShellCommand switchCommand(const char* id, const char* label, const char* help,
                           std::vector<std::string> keys) {
  ShellCommand command =
      shellCommand(id, label, help, std::move(keys), nothingNeeded, doing([id](Shell& shell) {
                     bool& shown = *switchOf(shell, id);
                     shown = !shown;
                   }));
  command.checked = [id](const Shell& shell) { return *switchOf(shell, id); };
  return command;
}

ShellCommand directionCommand(const char* id, const char* label, const char* help, const char* key,
                              ViewDirection direction) {
  return shellCommand(id, label, help, {key}, pictureNeeded, doing([direction](Shell& shell) {
                        lookFreely(shell.viewport.look, shell.viewport.camera);
                        shell.viewport.camera =
                            lookFrom(shell.viewport.camera, direction, shell.viewport.look.facingYawRadians);
                      }));
}

void toggleViewportOnly(Shell& shell) {
  const bool anyOpen = shell.panes.leftOpen || shell.panes.rightOpen || shell.panes.bottomOpen;
  shell.panes.leftOpen = !anyOpen;
  shell.panes.rightOpen = !anyOpen;
  shell.panes.bottomOpen = !anyOpen;
}

void togglePlay(Shell& shell) {
  shell.ui.time.timeline.playing = !shell.ui.time.timeline.playing;
  shell.playRemainder = 0.0;
  if (shell.ui.time.timeline.playing) {
    hideNews(shell.ui);
  } else {
    snapPlayhead(shell);
  }
}

Status runGrab(Shell& shell) {
  GrabStart start;
  start.startPixels = shell.viewport.mousePixels;
  start.falloffRadius = shell.viewport.falloffRadius;
  return startGrab(*shell.open.character(), shell.tool, start);
}

Status runOnControllers(Shell& shell, app::PullMotion motion) {
  return startControllerTool(*shell.open.character(), shell.tool,
                             {motion, {}, shell.viewport.mousePixels, false});
}

} // namespace

void goToTip(Shell& shell) {
  app::Session& session = *shell.open.character();
  if (const std::optional<double> tip = tipFrame(session, shell.tool); tip && shell.ui.exaggerateAtTip) {
    session.view().frame = *tip;
  }
}

Status startExaggerating(Shell& shell, app::OverlapChoice choice) {
  app::Session& session = *shell.open.character();
  const bool proposes = app::selectedTrail(session) == nullptr && !app::isRangeSet(session.view());
  Status started = startExaggerate(session, shell.tool, choice);
  if (!started) {
    return started;
  }
  hideNews(shell.ui); // What was told of another limb would hide this one.
  const auto& tool = std::get<ExaggerateTool>(shell.tool);
  if ((proposes && makesNoStroke(session, tool)) || standsStill(session, tool)) {
    refuse(shell, stillNews(session, tool, [&](const std::string& id) {
             const std::vector<app::Chord> chords = shell.keymap.chordsOf(id);
             return chords.empty() ? std::string() : shell.keyboard.chordText(chords.front());
           }));
    finishTool(session, shell.tool, false);
    return Success{};
  }
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
  shell.ui.dialogs.rangeClash = app::rangeClash(session);
  return shell.ui.dialogs.rangeClash ? Status(Success{}) : startExaggerating(shell, app::OverlapChoice::edit);
}

bool hasSpheres(const Shell& shell) {
  return hasFile(shell) && !shell.open.character()->view().selection.spheres().empty();
}

bool hasLimb(const Shell& shell) {
  return hasFile(shell) && !shell.open.character()->view().selection.limbs().empty();
}

bool viewsClip(const Shell& shell) {
  return hasFile(shell) &&
         app::hasClip(shell.open.character()->document(), shell.open.character()->view().clip);
}

bool canPose(const Shell& shell) {
  return hasFile(shell) && ((app::hasControllers(*shell.open.character()) && viewsClip(shell)) ||
                            !shell.open.character()->view().selection.locators().empty());
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
  return app::hasWeight(document, clip) || !app::adjustedIds(document, clip).empty() ||
         !app::holdsOfClip(document.holds, clip).empty() ||
         std::ranges::any_of(document.trails, [&](const rig::Trail& trail) { return trail.clip == clip; });
}

void showOriginal(Shell& shell) {
  bool& shown = shell.open.character() != nullptr ? shell.open.character()->view().showOriginal
                                                  : shell.open.sequence()->view().showOriginal;
  shown = !shown;
}

void pickChain(Shell& shell) {
  shell.ui.body.jointPick = {};
  shell.ui.body.jointPick.open = true;
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
  shell.ui.trails.rename = {.open = true, .trail = trail.id, .ofGroup = !group.empty()};
  shell.ui.trails.rename.present = group.empty() ? trailHeading(session.document(), trail)
                                                 : capitalised(app::groupTitle(session.document(), group));
  shell.ui.trails.rename.typed = shell.ui.trails.rename.present;
}

const app::SelectionSet* selectedSet(const Shell& shell) {
  const app::Session* const session = shell.open.character();
  return session == nullptr ? nullptr : app::setOfSelection(session->document(), session->view().selection);
}

bool hasSelectedSet(const Shell& shell) {
  return selectedSet(shell) != nullptr;
}

void renameSet(Shell& shell) {
  const std::string name = selectedSet(shell)->name;
  shell.ui.trails.rename = {.open = true, .present = name, .typed = name};
}

void openPalette(Shell& shell) {
  shell.ui.dialogs.palette = {};
  shell.ui.dialogs.palette.open = true;
}

void toggleNavigation(Shell& shell) {
  const bool maya = shell.ui.navigation == NavigationStyle::maya;
  shell.ui.navigation = maya ? NavigationStyle::blender : NavigationStyle::maya;
  tell(shell, ToastKind::info,
       maya ? "Navigation as in Blender: middle button" : "Navigation as in Maya: Alt and mouse");
}

void append(std::vector<ShellCommand>& all, std::vector<ShellCommand> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

bool canTakeProp(const Shell& shell) {
  const app::Session* const session = shell.open.character();
  return session != nullptr && !app::handsForProp(*session).empty();
}

auto askingFor(FilePurpose purpose) {
  return doing([purpose](Shell& shell) { askForFile(shell, purpose); });
}

} // namespace

namespace {

ShellCommand bundledCommand(const app::BundledClip& clip) {
  return shellCommand(clip.commandId, std::string("Bundled clip: ") + clip.name, clip.line, {}, nothingNeeded,
                      [file = std::string(clip.file)](Shell& shell) { return openBundled(shell, file); });
}

} // namespace

std::vector<ShellCommand> fileCommands() {
  return {
      shellCommand(command::fileOpen, "Open",
                   "Opens a character (.glb, .gltf, .vrm, .fbx, .bvh, .dae) or a mesh sequence.", {"Ctrl+O"},
                   nothingNeeded, askingFor(FilePurpose::openModel)),
      shellCommand(command::fileSave, "Save",
                   "Saves the file with the work inside; the first time it asks for a name.", {"Ctrl+S"},
                   exportNeeded, doing([](Shell& shell) { saveFile(shell); })),
      shellCommand(command::fileSaveAs, "Save as", "Saves under another name.", {"Ctrl+Shift+S"},
                   exportNeeded, askingFor(FilePurpose::saveModel)),
      shellCommand(command::fileSaveIncremental, "Save incremental",
                   "Saves under the next free number and leaves older files alone.", {"Ctrl+Alt+S"},
                   characterNeeded, doing([](Shell& shell) { saveIncremental(shell); })),
      shellCommand(command::fileExportClean, "Export clean",
                   "Writes a copy without the work: only what players and engines need.", {"Ctrl+E"},
                   exportNeeded, askingFor(FilePurpose::exportClean)),
      shellCommand(
          command::fileFilm, "Playblast",
          "Draws the clip, or the range that was set, as the view shows it, as a video or as numbered "
          "pictures; the window goes on meanwhile.",
          {"Ctrl+Alt+P"}, {viewsClip, "open a character with a clip first"},
          askingFor(FilePurpose::saveFilm)),
      shellCommand(command::recipeSave, "Save a recipe",
                   "Writes the clip's poses, trails and weight, to be replayed on another clip or character.",
                   {}, {hasWork, "make a trail, pose a controller or pin a limb first"},
                   askingFor(FilePurpose::saveRecipe)),
      shellCommand(command::recipeLoad, "Replay a recipe",
                   "Adds the poses and trails of a recipe to this character.", {}, characterNeeded,
                   askingFor(FilePurpose::openRecipe)),
      shellCommand(
          command::clipImport, "Import a clip",
          "Adds a clip of another file to this character: copied where the skeleton is the same, else "
          "brought "
          "over limb by limb. It is saved with the character.",
          {}, characterNeeded, askingFor(FilePurpose::openClip)),
      shellCommand(
          command::propAdd, "Add a prop",
          "Puts the thing of another file into the selected hand, or into both, at the playhead: into the "
          "right one where none is selected. It is saved with the character.",
          {}, {canTakeProp, "open a character with arms and a clip"}, askingFor(FilePurpose::openProp)),
      shellCommand(command::fileQuit, "Quit", "Leaves the program; asks first when there is unsaved work.",
                   {"Ctrl+Q"}, nothingNeeded, doing([](Shell& shell) { askToQuit(shell); })),
  };
}

namespace {

ShellCommand renameCommand() {
  ShellCommand command =
      shellCommand(command::trailRename, "Rename the trail",
                   "Gives the selected trail, or the group that is selected, a name of your own.", {"F2"},
                   {hasTrail, "select a trail first"}, doing(rename));
  command.labelNow = [](const Shell& shell) -> std::string {
    const app::Session* const session = shell.open.character();
    const bool isGroup = session != nullptr && !app::wholeGroupSelected(*session).empty();
    return isGroup ? "Rename the group" : "Rename the trail";
  };
  command.otherwise = command::selectionRename;
  return command;
}

} // namespace

std::vector<ShellCommand> toolCommands() {
  constexpr ShellNeed controllerNeeded{canPose, "select a controller first"};
  ShellCommand grab = shellCommand(
      command::sphereGrab, "Grab",
      "Moves the selected spheres, or controllers, with the mouse, an axis key or a typed number.", {"G"},
      {hasSpheres, "select a control sphere or a controller first: click one"}, runGrab);
  grab.otherwise = command::controllerMove;
  return {
      shellCommand(command::trailExaggerate, "Exaggerate",
                   "Makes the trail if there is none, exaggerates it and connects the limb; "
                   "type the scale, X Y Z switch axes, Enter keeps, Esc restores.",
                   {"E"}, {canExaggerate, "select a limb first: click one, or press its number"},
                   beginExaggerating),
      grab,
      shellCommand(command::controllerMove, "Move the controllers",
                   "Moves the selected controllers with the mouse, an axis key or a typed number.", {},
                   controllerNeeded,
                   [](Shell& shell) { return runOnControllers(shell, app::PullMotion::move); }),
      shellCommand(
          command::controllerTurn, "Turn the controllers",
          "Turns the selected controllers, each about its own place, with the mouse, an axis key or typed "
          "degrees.",
          {"R"}, controllerNeeded,
          [](Shell& shell) { return runOnControllers(shell, app::PullMotion::turn); }),
      shellCommand(command::trailShowOriginal, "Show the original",
                   "While the key is held the character moves as in the file.", {"`", "O"}, pictureNeeded,
                   doing(showOriginal)),
      shellCommand(command::pickChain, "Any chain", "Makes a limb of any chain, by its two joints.", {"J"},
                   characterNeeded, doing(pickChain)),
      renameCommand(),
      shellCommand(command::selectionRename, "Rename the selection set",
                   "Gives the set that is selected another name; F2 does while no trail is selected.", {},
                   {hasSelectedSet, "select just what a selection set holds"}, doing(renameSet)),
      shellCommand(command::timePlay, "Play", "Plays and stops.", {"Space"},
                   {canPlay, "open a file with a clip first"}, doing(togglePlay)),
      switchCommand(command::timeEveryFrame, "Every frame",
                    "Playing shows each frame, however long it takes; else time runs as it is.", {}),
      switchCommand(command::timeOnTwos, "On twos",
                    "Playing holds every second frame for two, as cartoons do.", {}),
      shellCommand(command::history, "History", "Lists what was done, to go back to any of it.", {"Ctrl+H"},
                   pictureNeeded, doing([](Shell& shell) { shell.ui.dialogs.history = {.open = true}; })),
  };
}

ShellCommand shadeAsCommand() {
  ShellCommand command = shellCommand(
      command::viewShadeAs, "Shade as three.js and Godot",
      "Turns normals as these engines do, by the joints' own matrices: a stretch told by scale is shaded "
      "wrongly there.",
      {}, nothingNeeded, doing([](Shell& shell) {
        ShadeAs& shown = shell.ui.overlays.shadeAs;
        shown = shown == ShadeAs::exact ? ShadeAs::three : ShadeAs::exact;
      }));
  command.checked = [](const Shell& shell) { return shell.ui.overlays.shadeAs != ShadeAs::exact; };
  return command;
}

std::vector<ShellCommand> viewCommands() {
  return {
      switchCommand(command::viewGhosts, "Ghosts", "Shows the character at frames before and after.", {"H"}),
      switchCommand(command::viewControllers, "Controllers",
                    "Shows what the character is posed by; else only while a controller is selected.", {"P"}),
      switchCommand(command::viewSkeleton, "Skeleton", "Shows the joints over the character.", {"K"}),
      switchCommand(command::viewWire, "Wire", "Shows the edges of the mesh.", {"W"}),
      switchCommand(command::viewJointNames, "Joint names", "Writes the joints' names beside them.", {}),
      switchCommand(command::viewHeatMap, "Stretch colours", "Colours the mesh by how much it is stretched.",
                    {}),
      shadeAsCommand(),
      switchCommand(
          command::viewWeights, "Weights",
          "Colours the mesh by how much it follows one joint: the one that is clicked, or chosen in "
          "the panel Character.",
          {"Shift+W"}),
      switchCommand(command::viewGrid, "Floor", "Shows the floor with its grid.", {}),
      switchCommand(command::viewCube, "View cube",
                    "Shows the cube whose faces, edges and corners are looked from.", {}),
      switchCommand(command::viewReference, "Reference images",
                    "Shows the images that the clip is animated after.", {}),
      switchCommand(command::viewFrameNumbers, "Frame numbers",
                    "Writes the frame beside every control sphere.", {}),
      switchCommand(command::viewSafeFrame, "Safe frame",
                    "Outlines the nine tenths of the picture that every screen shows.", {}),
      switchCommand(command::viewSideBySide, "Side by side",
                    "Shows the original beside the exaggerated motion, to compare them.", {"Shift+O"}),
      shellCommand(command::viewFrameSelection, "Frame the selection",
                   "Moves the camera to the selected limb and trail.", {"F"}, pictureNeeded,
                   doing([](Shell& shell) { shell.viewport.frameSelectionPending = true; })),
      shellCommand(command::viewFrameAll, "Frame everything",
                   "Moves the camera so that the whole character is seen.", {"A"}, pictureNeeded,
                   doing([](Shell& shell) { shell.viewport.framePending = true; })),
      directionCommand(command::viewFront, "Front view", "Looks at the character's front.", "Ctrl+Numpad 1",
                       ViewDirection::front),
      directionCommand(command::viewSide, "Side view", "Looks at the character's side.", "Ctrl+Numpad 3",
                       ViewDirection::side),
      directionCommand(command::viewTop, "Top view", "Looks down on the character.", "Ctrl+Numpad 7",
                       ViewDirection::top),
      directionCommand(command::viewPerspective, "Perspective view",
                       "Looks with perspective, from the front and above.", "Ctrl+Numpad 5",
                       ViewDirection::threeQuarter),
      switchCommand(command::viewLeftPane, "Left pane", "Shows or folds rig and limbs.", {"Ctrl+Alt+1"}),
      switchCommand(command::viewBottomPane, "Bottom pane", "Shows or folds timeline and graph.",
                    {"Ctrl+Alt+2"}),
      switchCommand(command::viewRightPane, "Right pane", "Shows or folds trails and settings.",
                    {"Ctrl+Alt+3"}),
      shellCommand(command::viewViewportOnly, "Viewport only", "Folds every pane, or brings them back.",
                   {"Ctrl+Space"}, nothingNeeded, doing(toggleViewportOnly)),
      shellCommand(command::viewNavigation, "Navigation of Maya or Blender",
                   "Changes how the mouse turns the view.", {}, nothingNeeded, doing(toggleNavigation)),
  };
}

std::vector<ShellCommand> helpCommands() {
  return {
      shellCommand(command::palette, "Find a command", "Lists every command with its key.", {"Ctrl+P", "F3"},
                   nothingNeeded, doing(openPalette)),
      shellCommand(command::keys, "All keys", "Shows every key and lets it be changed.", {"?", "F1"},
                   nothingNeeded, doing([](Shell& shell) {
                     shell.ui.dialogs.keys = {};
                     shell.ui.dialogs.keys.open = true;
                   })),
      shellCommand(command::tour, "Tour", "Goes through the first punch step by step, on the bundled clip.",
                   {}, nothingNeeded, startTour),
      shellCommand(command::tourEnd, "End the tour", "Takes the tour's card away.", {},
                   {isOnTour, "the tour does not run"}, doing(endTour)),
      shellCommand(command::settings, "Settings", "Theme (dark, light), size, navigation and what is drawn.",
                   {}, nothingNeeded, doing([](Shell& shell) { shell.ui.dialogs.settingsOpen = true; })),
      shellCommand(command::about, "About", "What this program is.", {}, nothingNeeded,
                   doing([](Shell& shell) { shell.ui.dialogs.aboutOpen = true; })),
      shellCommand(command::keysExport, "Export the keys",
                   "Writes every key to a file in your configuration folder.", {}, nothingNeeded, exportKeys),
      bundledCommand(app::bundledClips()[0]),
      bundledCommand(app::bundledClips()[1]),
      bundledCommand(app::bundledClips()[2]),
  };
}

std::vector<ShellCommand> editorCommands() {
  std::vector<ShellCommand> all = fileCommands();
  for (const app::DocumentCommand& command : app::documentCommands()) {
    all.push_back(fromDocument(command));
  }
  fitBesideWindow(all);
  append(all, toolCommands());
  append(all, styleCommands());
  append(all, poseLibraryCommands());
  append(all, referenceCommands());
  append(all, sequenceFileCommands());
  append(all, bindCommands());
  append(all, stopCommands());
  append(all, keyPaneCommands());
  append(all, viewCommands());
  append(all, cameraCommands());
  append(all, helpCommands());
  return all;
}

} // namespace stretch::ui

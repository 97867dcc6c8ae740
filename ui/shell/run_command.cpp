#include "ui/shell/shell_commands.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "app/commands/pose/posing.h"
#include "app/commands/pose/step_text.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/past_end.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/applied.h"
#include "app/things/place.h"
#include "core/anim/frames.h"
#include "ui/panels/context/key_bar.h"
#include "ui/panels/context/panel_support.h"
#include "ui/shell/key_pane.h"
#include "ui/shell/playback.h"
#include "ui/shell/stroke_news.h"
#include "ui/shell/user_settings.h"
#include "ui/viewport/tools.h"

namespace stretch::ui {

namespace {

const app::Command<Shell>* findCommandOf(const Shell& shell, std::string_view id) {
  const auto found = std::ranges::find_if(
      shell.commands, [&](const app::Command<Shell>& command) { return command.id == id; });
  return found == shell.commands.end() ? nullptr : &*found;
}

/// A switch of the window or of what is open, and what is done until it is ended.
bool isOn(const Shell& shell, const app::Command<Shell>& command) {
  if (command.checked && command.checked(shell)) {
    return true;
  }
  const app::Session* const character = shell.open.character();
  const app::SequenceSession* const sequence = shell.open.sequence();
  const std::string_view id = command.id;
  return (id == command::timePlay && shell.ui.time.timeline.playing) ||
         (id == command::trailShowOriginal && character != nullptr && character->view().showOriginal) ||
         (id == command::sequenceOriginal && sequence != nullptr && sequence->view().showOriginal) ||
         (id == command::sequenceSkinned && sequence != nullptr && sequence->view().showSkinned);
}

} // namespace

bool isChecked(const Shell& shell, std::string_view id) {
  const app::Command<Shell>* const command = findCommandOf(shell, id);
  return command != nullptr && isOn(shell, *command);
}

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

namespace {

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
    const bool isPose = commandId == command::undo && app::isPosedWithoutKey(character->view());
    return isPose ? "the pose without a key" : textOf(*character);
  }
  const app::SequenceSession* const sequence = shell.open.sequence();
  return sequence == nullptr ? std::string() : textOf(*sequence);
}

/// What undo or redo did. News of before are about what has gone.
void tellUndone(Shell& shell, std::string_view commandId, const std::string& label) {
  hideNews(shell.ui);
  tell(shell, ToastKind::info, (commandId == command::undo ? "Undone: " : "Redone: ") + label);
}

/// What a command that holds something did, and over which frames; empty for other commands.
std::string heldText(const Shell& shell, std::string_view commandId) {
  constexpr std::array<std::string_view, 6> holding{command::holdPin,   command::holdPinFeet,
                                                    command::holdMatch, command::holdProp,
                                                    command::holdLetGo, command::holdRemove};
  const app::Session* const session = shell.open.character();
  return session != nullptr && std::find(holding.begin(), holding.end(), commandId) != holding.end()
             ? undoneText(shell, command::undo)
             : std::string();
}

/// The document in whose time a command is going to place holds; nothing for other commands.
std::optional<app::Document> documentToHoldIn(const Shell& shell, std::string_view commandId) {
  constexpr std::array<std::string_view, 4> placing{command::holdPin, command::holdPinFeet,
                                                    command::holdMatch, command::holdProp};
  return std::find(placing.begin(), placing.end(), commandId) == placing.end()
             ? std::nullopt
             : std::optional(shell.open.character()->document());
}

/// How far a pose reaches that was pasted at a first key without a range; empty for other commands.
std::string pastedText(const Shell& shell, std::string_view commandId) {
  const bool pastes = commandId == command::posePaste || commandId == command::posePasteMirrored;
  const app::Session* const session = shell.open.character();
  return session != nullptr && pastes ? app::heldPoseText(*session) : std::string();
}

/// What was copied; empty for other commands.
std::string copiedText(const Shell& shell, std::string_view commandId) {
  const app::Session* const session = shell.open.character();
  if (session == nullptr) {
    return {};
  }
  if (commandId == command::poseCopy) {
    return "Copied: the pose of " + app::chosenText(*session);
  }
  if (commandId == command::poseCopyOffsets) {
    return app::poseLabel(session->document(), "Copied: the offsets of",
                          session->view().selection.controllers());
  }
  if (commandId == command::copyTrail) {
    return "Copied: the trail of the " +
           app::limbTitle(session->document(), session->view().copiedTrail->limb);
  }
  return {};
}

/// Where the viewed clip ends, seconds; 0 without one.
double endOfClip(const Shell& shell) {
  const app::Session* const session = shell.open.character();
  return session == nullptr || !app::hasClip(session->document(), session->view().clip)
             ? 0.0
             : app::clipOf(session->document(), session->view().clip).endSeconds;
}

/// A clip whose last keys were deleted ends earlier, and what stands past that end has no effect.
void tellShorterClip(Shell& shell, std::string_view commandId, double endBefore) {
  if (commandId != command::keysDelete || endOfClip(shell) >= endBefore) {
    return;
  }
  const app::Session& session = *shell.open.character();
  const int clip = session.view().clip;
  const double rate = app::clipOf(session.document(), clip).framesPerSecond;
  const std::vector<std::string> past = app::standingPastEnd(session.document(), clip);
  tell(shell, past.empty() ? ToastKind::info : ToastKind::warning,
       fmt::format("The clip ends at frame {} now, not at {}{}", shortNumber(endOfClip(shell) * rate, 1),
                   shortNumber(endBefore * rate, 1),
                   past.empty() ? std::string() : ". Past that end: " + app::listed(past)));
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

/// "Undo: Change the scale – left arm ×3", "Disconnect".
std::string labelNow(const Shell& shell, const app::Command<Shell>& command) {
  const std::string undone = undoneText(shell, command.id);
  const std::string label = command.labelNow ? command.labelNow(shell) : command.label;
  return undone.empty() ? label : label + ": " + undone;
}

/// What to do first; empty while the command is on.
std::string reasonOf(const Shell& shell, const app::Command<Shell>& command) {
  const std::string reason = command.enabled(shell) || !command.needs ? "" : command.needs(shell);
  return reason.empty() && !command.enabled(shell) ? "nothing to do this with now" : reason;
}

bool isRefusalShown(const Shell& shell) {
  return std::ranges::find(shell.ui.toasts, shell.refused, &Toast::text) != shell.ui.toasts.end();
}

} // namespace

void tellGaveWay(Shell& shell, const app::Document& before) {
  for (const std::string& line : app::gaveWay(before, shell.open.character()->document())) {
    const std::size_t end = line.find(':'); // of the subject: a limb's id, or the name of something else
    const std::string subject = line.substr(0, end);
    const bool isLimb = end != std::string::npos && app::findLimb(before, subject) != nullptr;
    tell(shell, ToastKind::warning,
         capitalised(isLimb ? app::limbTitle(before, subject) + line.substr(end) : line));
  }
}

void runCommand(Shell& shell, std::string_view commandId) {
  const app::Command<Shell>* command = findCommandOf(shell, commandId);
  if (command == nullptr) {
    return;
  }
  finishWhatIsDragged(shell);
  if (!command->enabled(shell)) {
    // Enter that came too late for a refused tool says nothing new.
    if (commandId != command::trailApply || !isRefusalShown(shell)) {
      refuse(shell, command->label + ": " + reasonOf(shell, *command));
    }
    return;
  }
  if (shell.ui.time.timeline.playing && !commandId.starts_with("view.")) {
    snapPlayhead(shell);
  }
  const std::string undone = undoneText(shell, commandId);
  const std::vector<int> applied = trailsToApply(shell, commandId);
  const double endBefore = endOfClip(shell);
  const std::optional<app::Document> heldIn = documentToHoldIn(shell, commandId);
  const Status done = command->run(shell);
  tellProblem(shell, done);
  tellShorterClip(shell, commandId, endBefore);
  if (done && !undone.empty() && shell.open.character() != nullptr) {
    bringBackPicks(shell.ui.time, *shell.open.character());
  }
  if (done && !undone.empty()) {
    tellUndone(shell, commandId, undone);
  }
  for (const auto& toldText : {heldText, pastedText, copiedText}) {
    if (const std::string text = done ? toldText(shell, commandId) : std::string(); !text.empty()) {
      tell(shell, ToastKind::info, text);
    }
  }
  if (done && heldIn) {
    tellGaveWay(shell, *heldIn);
  }
  if (done && !applied.empty()) {
    tell(shell, ToastKind::success, "Applied: " + app::appliedText(*shell.open.character(), applied));
  }
}

namespace {

/// The first key of a command, else the one that runs it over graph and dope sheet, or while another command
/// is off.
std::string keyTextOf(const Shell& shell, const app::Command<Shell>& command) {
  std::vector<app::Chord> chords = shell.keymap.chordsOf(command.id);
  chords = chords.empty() ? chordsOverKeys(shell, command.id) : chords;
  for (const app::Command<Shell>& other : shell.commands) {
    if (chords.empty() && other.otherwise == command.id) {
      chords = shell.keymap.chordsOf(other.id);
    }
  }
  return chords.empty() ? std::string() : shell.keyboard.chordText(chords.front());
}

} // namespace

void describeCommands(Shell& shell) {
  shell.commandInfos.clear();
  for (const app::Command<Shell>& command : shell.commands) {
    shell.commandInfos.push_back({command.id, labelNow(shell, command),
                                  command.helpNow ? command.helpNow(shell) : command.help,
                                  keyTextOf(shell, command), command.enabled(shell), isOn(shell, command),
                                  reasonOf(shell, command), command.label});
  }
}

bool widgetsOwnKeys(const Shell& shell) {
  const UiState& ui = shell.ui;
  return ui.dialogs.file.open || ui.dialogs.palette.open || ui.dialogs.keys.open || ui.dialogs.settingsOpen ||
         ui.dialogs.aboutOpen || ui.trails.rename.open || ui.time.retime.open || ui.dialogs.history.open ||
         ui.body.jointPick.open || ui.dialogs.navigationChoiceOpen || ui.dialogs.rangeClash.has_value() ||
         !ui.dialogs.dropped.path.empty() || !ui.dialogs.lostFilm.empty() ||
         !ui.dialogs.clipPick.file.empty() || shell.files.question().kind != app::FileQuestion::Kind::none;
}

namespace {

/// What only moves the camera and leaves a running tool alone.
bool looksOnly(std::string_view id) {
  return id == command::viewFrameSelection;
}

/// The command of the key, or the first that the key means while that one is off.
std::string meantCommand(const Shell& shell, const app::Chord& chord) {
  const std::string id = commandUnderMouse(shell, chord, shell.keymap.commandOf(chord));
  const app::Command<Shell>* command = findCommandOf(shell, id);
  while (command != nullptr && !command->enabled(shell)) {
    command = findCommandOf(shell, command->otherwise);
  }
  return command == nullptr ? id : command->id;
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

namespace {

bool isEnabled(const Shell& shell, std::string_view commandId) {
  const app::Command<Shell>* const command = findCommandOf(shell, commandId);
  return command != nullptr && command->enabled(shell);
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
    tellProblem(shell, findCommandOf(shell, shell.keymap.commandOf(chord))->run(shell));
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
  } else if (!commandId.empty() && (commandId != command::workStop || isEnabled(shell, commandId))) {
    runCommand(shell, commandId);
  }
}

namespace {

/// Whose key was given to another command, and whether that one is left without any.
std::string clashText(const Shell& shell, const std::string& keyText, const std::string& loser) {
  return keyText + " was the key of \"" + findCommandOf(shell, loser)->label + "\", which has " +
         (shell.keymap.chordsOf(loser).empty() ? "none now." : "others.");
}

} // namespace

void takeKeyAnswers(Shell& shell) {
  UiAnswers& answers = shell.ui.answers;
  if (answers.keyChange) {
    const KeyChange change = *std::exchange(answers.keyChange, std::nullopt);
    const Result<std::string> loser = shell.keymap.rebind(change.commandId, app::parseChord(change.keyText));
    if (!loser) {
      shell.ui.dialogs.keys.clash = loser.error().line();
    } else {
      shell.ui.dialogs.keys.clash = loser->empty() ? "" : clashText(shell, change.keyText, *loser);
      tellProblem(shell, writeText(keysPath(), shell.keymap.toJson()));
    }
  }
  if (std::exchange(answers.resetKeys, false)) {
    shell.keymap.resetToDefaults();
    tellProblem(shell, writeText(keysPath(), shell.keymap.toJson()));
  }
}

} // namespace stretch::ui

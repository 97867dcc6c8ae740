#include "ui/shell/tour.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/bundled_files.h"
#include "app/commands/table/selection.h"
#include "ui/shell/file_work.h"
#include "ui/shell/window/input.h"

namespace stretch::ui {

namespace {

constexpr const char* tourLimb = "left-arm";

/// A step: what is asked for, by a command's key or by one that a running tool takes, and whether it is done.
struct TourStep {
  const char* title;
  const char* text;
  const char* commandId; ///< Null: `key`.
  const char* key;
  bool (*done)(const Shell& shell);
  bool inTool; ///< Done while E is on.
};

const app::Session& sessionOf(const Shell& shell) {
  return *shell.open.character();
}

const rig::Trail* punchTrail(const Shell& shell) {
  const auto& trails = sessionOf(shell).document().trails;
  const auto found =
      std::ranges::find_if(trails, [](const rig::Trail& trail) { return trail.limb == tourLimb; });
  return found == trails.end() ? nullptr : &*found;
}

bool picked(const Shell& shell) {
  const auto& limbs = sessionOf(shell).view().selection.limbs();
  return std::find(limbs.begin(), limbs.end(), tourLimb) != limbs.end();
}

bool exaggerating(const Shell& shell) {
  return isRunning(shell.tool) && punchTrail(shell) != nullptr;
}

bool threeTimes(const Shell& shell) {
  const rig::Trail* const trail = punchTrail(shell);
  return trail != nullptr && std::abs(trail->settings.scale - 3.0) < 1e-6;
}

bool notUpwards(const Shell& shell) {
  const rig::Trail* const trail = punchTrail(shell);
  return trail != nullptr && !trail->settings.axes[1];
}

bool kept(const Shell& shell) {
  return !isRunning(shell.tool) && punchTrail(shell) != nullptr;
}

bool played(const Shell& shell) {
  return shell.ui.time.timeline.playing;
}

bool applied(const Shell& shell) {
  const rig::Trail* const trail = punchTrail(shell);
  return trail != nullptr && trail->applied;
}

bool saved(const Shell& shell) {
  return !sessionOf(shell).savePath().empty() && !app::hasUnsavedWork(shell.open);
}

const std::array<TourStep, 8>& tourSteps() {
  static constexpr std::array<TourStep, 8> steps{{
      {"Pick a limb", "The left arm throws the punch. Press its key, or click the arm.",
       command::selectLeftArm, nullptr, picked, false},
      {"Exaggerate it", "The arm's strongest stroke gets a trail: the path of its hand, longer than it was.",
       command::trailExaggerate, nullptr, exaggerating, false},
      {"Three times as long", "Type how long the arm becomes. What is seen follows at once.", nullptr, "3",
       threeTimes, true},
      {"Not upwards", "X, Y and Z switch axes off and on. Without Y the fist keeps its height.", nullptr, "Y",
       notUpwards, true},
      {"Keep it", "Enter keeps what is seen; Esc would take it back.", nullptr, "Enter", kept, false},
      {"Watch it", "Play the clip, and stop it again with the same key.", command::timePlay, nullptr, played,
       false},
      {"Apply it", "The clip gets the new keys. The trail stays: it can be changed tomorrow.",
       command::trailApply, nullptr, applied, false},
      {"Save it", "The file plays in every viewer, and opens here as it was left.", command::fileSave,
       nullptr, saved, false},
  }};
  return steps;
}

/// The character that the tour goes through, wherever its file lies.
bool isFirstPunch(const Shell& shell) {
  const app::Session* const session = shell.open.character();
  return session != nullptr && !session->document().clips->empty() &&
         session->document().clips->front().name == app::bundledClips().front().name &&
         app::findLimb(session->document(), tourLimb) != nullptr;
}

void begin(Shell& shell) {
  shell.ui.tour = {.pending = false, .step = 0};
  shell.ui.answers.keepSettings = true;
}

std::string keyOf(const Shell& shell, const TourStep& step) {
  if (step.commandId == nullptr) {
    return step.key;
  }
  const std::vector<app::Chord> chords = shell.keymap.chordsOf(step.commandId);
  return chords.empty() ? std::string() : shell.keyboard.chordText(chords.front());
}

} // namespace

Status startTour(Shell& shell) {
  if (isFirstPunch(shell)) {
    begin(shell);
    return Success{};
  }
  shell.ui.tour.pending = true;
  return openBundled(shell, app::bundledClips().front().file);
}

void endTour(Shell& shell) {
  shell.ui.tour.step = -1;
}

bool isOnTour(const Shell& shell) {
  return shell.ui.tour.step >= 0;
}

void offerTour(Shell& shell) {
  if (shell.ui.tour.pending && isFirstPunch(shell)) {
    begin(shell);
  }
}

void updateTour(Shell& shell) {
  if (!isOnTour(shell) || !isFirstPunch(shell)) {
    return;
  }
  const auto& steps = tourSteps();
  int& step = shell.ui.tour.step;
  while (step < static_cast<int>(steps.size()) && steps[static_cast<std::size_t>(step)].done(shell)) {
    ++step;
  }
  if (step == static_cast<int>(steps.size())) {
    endTour(shell);
    tell(shell, ToastKind::success, "That was the first punch. Help has the tour again, and all keys.");
    return;
  }
  if (steps[static_cast<std::size_t>(step)].inTool && !isRunning(shell.tool)) {
    step = 1; // E was ended before its time.
  }
}

bool pressTourKey(Shell& shell, const app::KeyPress& press) {
  const bool meant = press.chord == app::Chord{app::Key::escape} && tourCard(shell) && !isRunning(shell.tool);
  if (meant) {
    endTour(shell);
  }
  return meant;
}

std::optional<TourCard> tourCard(const Shell& shell) {
  if (!isOnTour(shell) || !isFirstPunch(shell)) {
    return std::nullopt;
  }
  const auto& steps = tourSteps();
  const TourStep& step = steps[static_cast<std::size_t>(shell.ui.tour.step)];
  return TourCard{shell.ui.tour.step, static_cast<int>(steps.size()), step.title, step.text,
                  keyOf(shell, step)};
}

} // namespace stretch::ui

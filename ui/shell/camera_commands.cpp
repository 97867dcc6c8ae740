#include "ui/shell/shell_commands.h"

#include <fmt/core.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/commands/table/tables.h"
#include "app/evaluate/seen.h"
#include "ui/panels/context/panel_support.h"
#include "ui/shell/shell_command.h"

namespace stretch::ui {

namespace {

namespace command = app::command;

bool hasCameras(const Shell& shell) {
  const app::Session* const session = shell.open.character();
  return session != nullptr && !session->document().scene->cameras.empty();
}

bool hasSeenTrail(const Shell& shell) {
  return shell.open.character() != nullptr && app::hasSelectedTrail(*shell.open.character());
}

constexpr ShellNeed viewNeeded{hasPicture, "open a file first"};

/// From one camera of the file to the next, and after the last one back to the view's own.
void nextCamera(Shell& shell) {
  const std::vector<SceneCamera>& cameras = shell.open.character()->document().scene->cameras;
  std::size_t next = 0;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    next = cameras[i].name == shell.viewport.look.name ? i + 1 : next;
  }
  if (next == cameras.size()) {
    lookFreely(shell.viewport.look, shell.viewport.camera);
    tell(shell, ToastKind::info, "The view moves freely again");
    return;
  }
  shell.viewport.look.name = cameras[next].name;
  tell(shell, ToastKind::info,
       fmt::format("Through the camera '{}', {} of {}", cameras[next].name, next + 1, cameras.size()));
}

void showBest(Shell& shell) {
  app::Session& session = *shell.open.character();
  const rig::SolvedTrail* const trail = app::solvedTrail(session, session.view().selection.trail());
  if (trail == nullptr) {
    return;
  }
  const Vec3 eye = app::bestViewOf(session.document(), session.motion(), *trail);
  lookFreely(shell.viewport.look, shell.viewport.camera);
  shell.viewport.camera = lookingFrom(shell.viewport.camera, eye);
  shell.viewport.frameSelectionPending = true;
  tell(shell, ToastKind::info, "Seen best " + app::viewInWords(session.document(), session.view().clip, eye));
}

/// What a sentence says after a colon: the key of a command and what it does; empty where it has no key.
std::string keyText(const Shell& shell, const char* id, const char* does) {
  const std::vector<app::Chord> chords = shell.keymap.chordsOf(id);
  return chords.empty() ? std::string()
                        : fmt::format(": {} {}", shell.keyboard.chordText(chords.front()), does);
}

void keep(Shell& shell, std::size_t number) {
  shell.viewport.look.kept[number] = ViewBookmark{shell.viewport.camera, shell.viewport.look.name};
  tell(shell, ToastKind::success,
       fmt::format("View {} is kept{}", number + 1, keyText(shell, command::keptView[number], "goes there")));
}

/// The standard view of a key of the numpad, where no view is kept under its number.
std::optional<ViewDirection> standardOf(std::size_t number) {
  switch (number + 1) {
  case 1:
    return ViewDirection::front;
  case 3:
    return ViewDirection::side;
  case 5:
    return ViewDirection::threeQuarter;
  case 7:
    return ViewDirection::top;
  default:
    return std::nullopt;
  }
}

void show(Shell& shell, std::size_t number) {
  ViewportState& viewport = shell.viewport;
  const std::optional<ViewBookmark>& kept = viewport.look.kept[number];
  const std::optional<ViewDirection> standard = standardOf(number);
  if (kept) {
    viewport.look.through.reset();
    viewport.camera = kept->camera;
    viewport.look.name = kept->through;
  } else if (standard) {
    lookFreely(viewport.look, viewport.camera);
    viewport.camera = lookFrom(viewport.camera, *standard, viewport.look.facingYawRadians);
  } else {
    tell(shell, ToastKind::info,
         fmt::format("No view is kept as {}{}", number + 1,
                     keyText(shell, command::keepView[number], "keeps this one")));
  }
}

} // namespace

std::vector<ShellCommand> cameraCommands() {
  std::vector<ShellCommand> all{
      shellCommand(command::viewCamera, "Look through the next camera",
                   "Goes through the cameras of the file, and back to the view that moves freely.",
                   {"Numpad 0"}, {hasCameras, "open a file that has a camera first"}, app::doing(nextCamera)),
      shellCommand(command::viewBest, "Best view",
                   "Looks at the selected trail from where most of it is seen.", {},
                   {hasSeenTrail, "select a trail first"}, app::doing(showBest))};
  for (std::size_t i = 0; i < command::keepView.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    all.push_back(shellCommand(
        command::keepView[i], "Keep the view as " + number,
        "Keeps what is looked at as a bookmark, and through which camera, with the settings of this file.",
        {"Ctrl+" + number}, viewNeeded, app::doing([i](Shell& shell) { keep(shell, i); })));
    all.push_back(
        shellCommand(command::keptView[i], "Kept view " + number,
                     "Goes to the view that is kept as " + number +
                         (standardOf(i) ? "; before there is one, to the standard view of this key." : "."),
                     {"Numpad " + number}, viewNeeded, app::doing([i](Shell& shell) { show(shell, i); })));
  }
  return all;
}

} // namespace stretch::ui

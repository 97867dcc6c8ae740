#include "ui/shell/welcome_keys.h"

#include <algorithm>

#include "ui/panels/files/welcome_entries.h"

namespace stretch::ui {

namespace {

/// How far the highlight goes; nothing for a key that does not move it.
std::optional<int> stepOf(app::Key key, const WelcomeState& welcome) {
  const auto& clips = app::bundledClips();
  const bool onPictures = welcome.highlighted < static_cast<int>(clips.size());
  const int row = onPictures ? welcome.columns : 1;
  switch (key) {
  case app::Key::right:
    return 1;
  case app::Key::left:
    return -1;
  case app::Key::down:
    return std::min(row, onPictures ? static_cast<int>(clips.size()) - welcome.highlighted : row);
  case app::Key::up:
    return -row;
  default:
    return std::nullopt;
  }
}

} // namespace

bool pressWelcomeKey(Shell& shell, const app::KeyPress& press) {
  const app::Chord& chord = press.chord;
  if (!shell.open.isEmpty() || isBusy(shell) || chord.ctrl || chord.alt || chord.shift) {
    return false;
  }
  WelcomeState& welcome = shell.ui.welcome;
  if (chord.key == app::Key::enter || chord.key == app::Key::numpadEnter) {
    welcome.entered = true;
    return true;
  }
  const std::optional<int> step = stepOf(chord.key, welcome);
  if (step) {
    const int last = static_cast<int>(welcomeEntries(shell.ui).size()) - 1;
    welcome.highlighted = std::clamp(welcome.highlighted + *step, 0, last);
    welcome.moved = true;
  }
  return step.has_value();
}

} // namespace stretch::ui

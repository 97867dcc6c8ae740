#include "ui/shell/playback.h"

#include <algorithm>
#include <cmath>

#include "app/commands/table/frames.h"

namespace stretch::ui {

namespace {

/// What stands on the screen when playing has come to a frame.
double shownFrame(const TimelineState& time, double clock) {
  return time.onTwos ? 2.0 * std::floor(0.5 * clock) : time.everyFrame ? std::floor(clock) : clock;
}

/// Moves a playhead by the time that passed; answers whether it goes on playing.
bool advance(TimelineState& time, double& playhead, double last, double framesPerSecond,
             double secondsPassed) {
  if (last <= 0.0) {
    return false;
  }
  if (std::abs(playhead - shownFrame(time, time.clock)) > 1e-9) {
    time.clock = playhead; // It was moved by hand, or playing begins.
  }
  // A pause of the program is no leap of the motion.
  const double passed = std::min(secondsPassed, 0.25) * framesPerSecond * time.speed;
  const double frame = time.clock + (time.everyFrame ? std::min(passed, 1.0) : passed);
  time.clock = frame <= last ? frame : time.loop ? std::fmod(frame, last) : last;
  playhead = std::min(shownFrame(time, time.clock), last);
  return frame <= last || time.loop;
}

} // namespace

void snapPlayhead(Shell& shell) {
  double* const playhead = shell.open.character() != nullptr  ? &shell.open.character()->view().frame
                           : shell.open.sequence() != nullptr ? &shell.open.sequence()->view().frame
                                                              : nullptr;
  if (playhead != nullptr && shell.ui.time.timeline.snapToFrames) {
    *playhead = std::round(*playhead);
  }
}

void play(Shell& shell, double secondsPassed) {
  TimelineState& time = shell.ui.time.timeline;
  if (!time.playing) {
    return;
  }
  if (shell.open.sequence() != nullptr) {
    time.playing = advance(time, shell.open.sequence()->view().frame, app::lastFrame(*shell.open.sequence()),
                           shell.open.sequence()->document().mesh->framesPerSecond, secondsPassed);
  } else if (shell.open.character() != nullptr) {
    const app::Document& document = shell.open.character()->document();
    app::ViewState& view = shell.open.character()->view();
    time.playing =
        advance(time, view.frame, app::lastFrame(document, view.clip),
                app::hasClip(document, view.clip) ? app::clipOf(document, view.clip).framesPerSecond : 0.0,
                secondsPassed);
  }
}

} // namespace stretch::ui

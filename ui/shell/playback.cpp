#include "ui/shell/playback.h"

#include <algorithm>
#include <cmath>

#include "app/commands/frames.h"

namespace stretch::ui {

void play(Shell& shell, double secondsPassed) {
  if (shell.session == nullptr || !shell.ui.timeline.playing) {
    return;
  }
  const app::Document& document = shell.session->document();
  app::ViewState& view = shell.session->view();
  const double last = app::lastFrame(document, view.clip);
  if (last <= 0.0) {
    shell.ui.timeline.playing = false;
    return;
  }
  const double rate = app::clipOf(document, view.clip).framesPerSecond * shell.ui.timeline.speed;
  // A pause of the program is no leap of the motion.
  const double frame = view.frame + std::min(secondsPassed, 0.25) * rate;
  if (frame <= last) {
    view.frame = frame;
  } else if (shell.ui.timeline.loop) {
    view.frame = std::fmod(frame, last);
  } else {
    view.frame = last;
    shell.ui.timeline.playing = false;
  }
}

} // namespace stretch::ui

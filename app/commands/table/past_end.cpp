#include "app/commands/table/past_end.h"

#include <fmt/core.h>

#include "app/commands/table/selection.h"
#include "app/edits/keys/key_row.h"

namespace stretch::app {

std::vector<std::string> standingPastEnd(const Document& document, int clip) {
  const Clip& shown = clipOf(document, clip);
  const double last = shown.endSeconds * shown.framesPerSecond;
  std::vector<std::string> past;
  const auto add = [&](int itsClip, const char* what, const std::string& whose, const Vec2& frames) {
    if (itsClip == clip && frames.y > last + keyTolerance) {
      past.push_back(fmt::format("{} of {} ({:g} to {:g})", what, whose, frames.x, frames.y));
    }
  };
  for (const rig::Trail& trail : document.trails) {
    add(trail.clip, "trail", trailTitle(document, trail),
        {trail.settings.startFrame, trail.settings.endFrame});
  }
  for (const rig::Adjustment& adjustment : document.adjustments) {
    const Vec2 keys(adjustment.keys.front().frame, adjustment.keys.back().frame);
    add(adjustment.clip, "offsets", controllerTitle(document, adjustment.controller),
        adjustment.rangeFrames.value_or(keys));
  }
  for (const rig::Pin& pin : document.holds.pins) {
    add(pin.clip, "pin", limbTitle(document, pin.limb), pin.time.rangeFrames);
  }
  for (const rig::Grip& grip : document.holds.grips) {
    add(grip.clip, "grip", limbTitle(document, grip.follower), grip.time.rangeFrames);
  }
  for (const rig::Prop& prop : document.holds.props) {
    add(prop.clip, "prop", prop.node,
        prop.time ? prop.time->rangeFrames : Vec2(prop.boundFrame.value_or(0.0)));
  }
  return past;
}

} // namespace stretch::app

#include "app/bundled_files.h"

#include "app/commands/table/command_ids.h"

namespace stretch::app {

const std::array<BundledClip, 3>& bundledClips() {
  static constexpr std::array<BundledClip, 3> clips{
      {{"dummy.glb", "dummy.png", "One-two punch", "A jab that reaches three arms far.",
        command::bundledPunch},
       {"dummy_swing.glb", "dummy_swing.png", "Baseball swing", "Two hands, one bat, twice the reach.",
        command::bundledSwing},
       {"dummy_leap.glb", "dummy_leap.png", "Leap and landing", "The whole body stretches over ledges.",
        command::bundledLeap}}};
  return clips;
}

} // namespace stretch::app

#include "app/evaluate/frame_count.h"

#include <fmt/core.h>

#include "core/anim/frames.h"

namespace stretch::app {

Status checkFrameCount(const Clip& clip) {
  constexpr double mostFrames = 100000.0;
  const double frames = endInFrames(clip);
  return frames <= mostFrames
             ? Status(Success{})
             : Error{fmt::format("lasts {:.3g} frames, more than {:g}: a key may stand at a wrong time",
                                 frames, mostFrames),
                     fmt::format("clip '{}'", clip.name),
                     "cut the clip, or count in fewer frames per second"};
}

} // namespace stretch::app

#pragma once

#include "core/anim/clip.h"
#include "core/base/result.h"

namespace stretch::app {

/// Nothing to complain of, or that the clip has more frames than can be worked on one by one: a key at an
/// absurd time makes a clip of years.
[[nodiscard]] Status checkFrameCount(const Clip& clip);

} // namespace stretch::app

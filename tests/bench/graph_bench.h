#pragma once

#include "app/document.h"
#include "tests/bench/measure.h"

namespace stretch::bench {

/// Prints what graph and dope sheet cost for each frame of the window, beside a frame without them: the
/// character gets a clip with that many keyed joints. What the graphics card does is not in it.
void measureGraph(const app::Document& character, const Options& options);

} // namespace stretch::bench

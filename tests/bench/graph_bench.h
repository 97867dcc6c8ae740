#pragma once

#include <vector>

#include "app/document.h"
#include "tests/bench/measure.h"

namespace stretch::bench {

inline constexpr const char* graphTitle = "a frame of the graph and the dope sheet, 400 tracks of 600 keys";

/// What graph and dope sheet cost for each frame of the window, beside a frame without them: the character
/// gets a clip with that many keyed joints. What the graphics card does is not in it.
[[nodiscard]] std::vector<Row> graphRows(const app::Document& character, int repetitions);

} // namespace stretch::bench

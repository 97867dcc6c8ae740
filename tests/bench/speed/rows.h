#pragma once

#include <filesystem>
#include <vector>

#include "app/document.h"
#include "tests/bench/speed/comparison.h"

namespace stretch::bench {

struct SpeedInput {
  std::filesystem::path file; ///< What the rows are measured on.
  app::Document document;     ///< The same, open; it has a clip and limbs.
  int repetitions = 20;
};

/// Paths, drags and whole clips.
[[nodiscard]] std::vector<Comparison> motionComparisons(const SpeedInput& input);
/// Opening, saving, memory.
[[nodiscard]] std::vector<Comparison> fileComparisons(const SpeedInput& input);
/// Skinning, thickness, distances.
[[nodiscard]] std::vector<Comparison> surfaceComparisons(const SpeedInput& input);
/// Starting, beside the least program with a window.
[[nodiscard]] std::vector<Comparison> startComparisons(const SpeedInput& input);

} // namespace stretch::bench

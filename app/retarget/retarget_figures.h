#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/forecast/below_floor.h"
#include "core/anim/clip.h"
#include "core/gltf/json/json_document.h"
#include "rig/retarget/skeleton.h"

namespace stretch::app {

/// A clip on the body that plays it.
struct PlayedClip {
  const rig::Skeleton& skeleton;
  const Clip& clip;
};

/// How a body moves where another one stands, touches itself, or has both hands at one thing: see
/// docs/import_clip.md, In numbers. Nothing: there is nothing to measure it by.
struct RetargetFigures {
  std::optional<double> slide;   ///< Farthest over the ground that a ball of the foot, or an ankle whose ball
                                 ///< is up, gets from its place while the source's stands, of the height.
  std::optional<double> contact; ///< From the hand to what the source's touches, mean, of the height.
  std::optional<double> inside;  ///< Share of the vertices of forearms to feet in trunk and head, mean.
  std::optional<double> deepest; ///< How deep the deepest of them is, of the height.
  std::optional<double> held;    ///< How deep what the hands hold gets there, of the height.
  std::optional<double> hands;   ///< Between hands that work together, farthest from the source's distance,
                                 ///< widths of the shoulders.
  BelowFloor below;
  std::optional<double> floor; ///< The same of the height.
};

struct RetargetReport {
  RetargetFigures source;
  RetargetFigures mapped; ///< Before feet and hands are put where they belong.
  RetargetFigures result;
};

/// Measures the clips at the source's frames, touch at up to 24 of them, which are spread evenly.
[[nodiscard]] RetargetReport retargetReport(const PlayedClip& source, const PlayedClip& mapped,
                                            const PlayedClip& result);

/// In percent, in centimetres at a height of 1.7 m, and in widths of the shoulders; null: nothing.
[[nodiscard]] gltf::Json reportToJson(const RetargetReport& report);

/// The same in one line for each figure that there is: "feet slide 0.2 % of the height (as mapped 1.9, source
/// 0.1)".
[[nodiscard]] std::vector<std::string> reportLines(const RetargetReport& report);

/// Those in which the result is seen to be worse than its source, worst first; none where all is well.
[[nodiscard]] std::vector<std::string> worseLines(const RetargetReport& report);

} // namespace stretch::app

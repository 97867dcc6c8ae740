#pragma once

#include <optional>
#include <vector>

#include "rig/motion/motion.h"
#include "rig/motion/solve.h"

namespace stretch::rig {

/// How long a trail's way back to the clip's own motion takes (docs/exaggeration.md, Release).
struct ReleaseLength {
  double seconds = 0.0;       ///< Length in use: within the clip unless that loops.
  double wantedSeconds = 0.0; ///< Without that limit.
  double calmSeconds = 0.0;   ///< From this on the limb's end goes back no faster than it came.
};

/// `solved` with its path, tip, remap and spheres; `nodes`: the limb's joints and its end.
[[nodiscard]] ReleaseLength releaseLength(const MotionInput& input, const SolvedTrail& solved);

/// Whether a sphere at the pivot, where nothing is scaled, moves the limb: that fades beyond the range.
[[nodiscard]] bool pullsPivot(const SolvedTrail& solved, double framesPerSecond);

/// Returns where a trail begins to act, seconds: on a loop what it does before the clip's first key, and
/// before its range, is seen at the loop's end.
[[nodiscard]] double firstSeconds(const MotionState& motion, const SolvedTrail& solved);

/// From the tip to the next key of the nodes on the release's way; nothing on a densely keyed clip, or where
/// no key follows. `keys`: keySpacing of the nodes.
[[nodiscard]] std::optional<double> secondsToNextKey(const Clip& clip, const PathKey& key,
                                                     const std::vector<NodeIndex>& nodes,
                                                     const KeySpacing& keys);

} // namespace stretch::rig

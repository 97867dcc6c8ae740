#pragma once

#include <string>
#include <vector>

#include "core/interchange/figure.h"
#include "core/interchange/glb_parts.h"

namespace stretch::interchange {

/// What became of the animations of a scene.
struct ClipNotes {
  int clips = 0;
  bool hasGaps = false;       ///< Moving keys stand farther apart than a frame and a half.
  bool hasUnevenShed = false; ///< A scale that is not inherited is uneven: shown as near as can be.
};

/// Adds each animation that moves something as a glTF animation: times in seconds from the file's ticks,
/// never before 0. Keys are kept where a node's motion between them is the glTF's own (linear, the shorter
/// turn); where pivots bend it, keys are added until no node is farther than 1e-4 of the figure's height from
/// its place. Tracks that
/// do not move are one key. `meshNodes`: the node that shows each
/// mesh of the scene, -1 without. `fileName`: name of a file's only clip where a program named it, and
/// nobody.
[[nodiscard]] ClipNotes addClips(const aiScene& scene, const Figure& figure,
                                 const std::vector<int>& meshNodes, const std::string& fileName,
                                 GlbParts& parts);

} // namespace stretch::interchange

#pragma once

#include "core/scene/mesh_sequence.h"
#include "skinning/skinned_sequence.h"

namespace stretch::test {

/// A tube along x, 10 long and 1 thick, skinned to a chain of `bones` rigid bones that wave in the x-z plane
/// (frame 0 is straight), with weights that blend over the joints.
[[nodiscard]] skinning::SkinnedSequence wavingTube(int bones, int frames);

/// A body with a trunk, two arms of two bones each and a head, made of cubes, that waves: rigid bones that
/// hang on each other ("trunk", "head", "upper_left", "lower_left", "upper_right", "lower_right") with
/// weights that blend over the joints.
[[nodiscard]] skinning::SkinnedSequence armedBody(int frames);

/// A tube along x, 10 long and 1 thick, at rest in frame 0, then bent to growing arcs in the x-z plane whose
/// centre line is `1 - shortening * curvature` times as long and that are flattened along y by `flattening`
/// (the volume across is kept).
[[nodiscard]] MeshSequence shorteningTube(int frames, double largestCurvature, double shortening,
                                          double flattening);

} // namespace stretch::test

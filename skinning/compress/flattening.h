#pragma once

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/compress/body_stretch.h"

namespace stretch::skinning {

/// How gravity changes the middle of a body: the last frames of two runs of one simulation, with and without
/// gravity.
struct Flattening {
  double height = 1.0; ///< Extent along gravity at mid-body, with gravity over without.
  double width = 1.0;  ///< Extent across gravity and the body.
  double length = 1.0; ///< Factor on the length of the centre line.
  /// The compression factor whose 1 - q and 1 / (1 - q) come closest to height and width.
  double compression = 0.0;
  double youngModulus = 0.0; ///< Pa that give that factor by Eq. 6 at mid-body; 0 when nothing is compressed.
  double predictedHeight = 1.0; ///< 1 - q
  double predictedWidth = 1.0;  ///< 1 / (1 - q)
};

/// Both runs start from the same mesh. `settings` give gravity, mass and scale. Errors: different meshes, no
/// centre line.
[[nodiscard]] Result<Flattening> gravityFlattening(const MeshSequence& with, const MeshSequence& without,
                                                   const BodyStretchSettings& settings);

} // namespace stretch::skinning

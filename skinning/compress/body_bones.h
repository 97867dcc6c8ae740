#pragma once

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/compress/compress.h"

// Internal to skinning/compress: the bones of a sequence, fitted, without the measures of how well they fit.

namespace stretch::skinning {

/// A part of the whole work as work of its own, 0..1.
[[nodiscard]] Proceed partOf(const Proceed& proceed, double from, double to);

[[nodiscard]] inline bool goesOn(const Proceed& proceed, double share) {
  return !proceed || proceed(share);
}

[[nodiscard]] Error stoppedError(const MeshSequence& sequence);

/// Sets skinned, model, segmentWidths, weights, firstFittedFrame and warnings of the answer. Errors as those
/// of compress.
[[nodiscard]] Result<CompressedSequence>
fittedBones(const MeshSequence& sequence, const CompressSettings& settings, const Proceed& proceed);

} // namespace stretch::skinning

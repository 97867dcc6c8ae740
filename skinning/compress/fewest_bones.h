#pragma once

#include "skinning/compress/body_bones.h"

// Internal to skinning/compress.

namespace stretch::skinning {

/// The bones of fittedBones, as few as meet settings.tolerancePercent: their number is doubled until it is
/// met and then narrowed down by halves, which finds the smallest where more bones never fit worse. Where up
/// to mostBonesOfTolerance do not meet it, or twice as many hardly lower the error, the best that was tried,
/// with a warning.
[[nodiscard]] Result<CompressedSequence>
fewestBones(const MeshSequence& sequence, const CompressSettings& settings, const Proceed& proceed);

} // namespace stretch::skinning

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/metrics.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// Frames of a sequence, for a stream that is there already.
struct AppendedFrames {
  std::vector<std::uint8_t> bytes; ///< One frame after the other, as the base describes them.
  std::size_t frameBytes = 0;      ///< Bytes of each frame.
  std::size_t firstNumber = 0;     ///< Number of the first frame, from 0: how many there were before.
  SequenceMetrics metrics;         ///< Distances of what a client shows of them to the sequence.
  SkinnedSequence skinned;         ///< Motion of the frames, on the bones of the base.
};

/// Fits the bones of a stream's base to more frames of its mesh: mesh and weights stay, bones turn, move and,
/// where the stream has scales, stretch freely. What the base holds once for all frames stays as it is there.
/// `bytesBefore`: of the frames that are there already. Errors: the base is none, or of another mesh; the
/// frames before are cut short; or what a client would show is off by more than `mostPercent` (RMSE, of the
/// diagonal).
[[nodiscard]] Result<AppendedFrames> framesForStream(const std::filesystem::path& path,
                                                     const MeshSequence& sequence, std::size_t bytesBefore,
                                                     double mostPercent);

} // namespace stretch::skinning

#pragma once

#include <cstddef>

#include "core/gltf/source.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

struct EncodeSettings {
  bool quantise = false; ///< Rotations and weights as normalised 16-bit integers, which glTF 2.0 allows
                         ///< without extensions.
  /// Tracks that differ by less than this everywhere share one sampler, and those that vary by less than this
  /// have none. Scales: absolute; rotations: chord of the half angle; translations: times the diagonal of the
  /// bind pose's box.
  double tolerance = 1e-6;
};

/// A glTF document ready to be saved, and what it costs to send.
struct EncodedClip {
  gltf::Source source;
  double bytesPerFrame = 0.0; ///< All that changes from frame to frame: every sampler's output once, and the
                              ///< time stamp.
  std::size_t bytesOnce = 0;  ///< The rest of the binary data: mesh, weights, bind matrices.
  std::size_t joints = 0;
  std::size_t samplers = 0;
};

/// One skin, one clip. Bones in a row become a chain of joints: the first is moved, the others hang at a
/// distance that is shared wherever it is the same; free bones stand side by side. The stretch is the scale
/// of the joints that the mesh is bound to: leaves under the chain, so that no joint inherits it. A scale
/// that is a common course in time multiplied by a constant for each bone is stored as just that.
[[nodiscard]] EncodedClip encodeGltf(const SkinnedSequence& sequence, const EncodeSettings& settings = {});

/// Bytes of a frame as positions of all vertices, single precision.
[[nodiscard]] std::size_t sourceBytesPerFrame(const MeshSequence& sequence);

} // namespace stretch::skinning

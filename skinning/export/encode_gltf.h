#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/gltf/source/source.h"
#include "skinning/fit/alternate.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

struct EncodeSettings {
  bool quantise = false; ///< Rotations and weights as normalised 16-bit integers, which glTF 2.0 allows
                         ///< without extensions.
  /// Tracks that differ by less than this everywhere share one sampler, and those that vary by less than this
  /// have none. Scales: absolute; rotations: chord of the half angle; translations: times the diagonal of the
  /// bind pose's box.
  double tolerance = 1e-6;
  bool quantiseMesh = false; ///< Places, normals, texture coordinates and colours as integers
                             ///< (KHR_mesh_quantization).
  bool meshopt = false;      ///< All data but images compressed (EXT_meshopt_compression).
  /// Keys are left out as long as no vertex of any frame is moved farther than this, in percent of the
  /// diagonal of the clip (extentOf). 0, or where that would take more than it saves: every frame is a key.
  double keyTolerancePercent = 0.0;

  friend bool operator==(const EncodeSettings&, const EncodeSettings&) = default;
};

/// A glTF document ready to be saved, and what it costs to send.
struct EncodedClip {
  gltf::Source source;
  double bytesPerFrame = 0.0;  ///< All that changes from frame to frame: every sampler's output once, and the
                               ///< time stamps.
  std::size_t bytesOnce = 0;   ///< The rest of the binary data: mesh, weights, bind matrices, images.
  std::size_t bytesOfJson = 0; ///< Size of the JSON that describes them.
  std::vector<std::uint32_t> places; ///< For each vertex as the file draws them, primitive by primitive, the
                                     ///< vertex of the sequence.
  std::size_t joints = 0;
  std::size_t samplers = 0;
  std::size_t keys = 0;         ///< Keys of all samplers.
  double keyErrorPercent = 0.0; ///< The farthest that leaving out keys moves a vertex of any frame.
};

/// One skin, one clip. Bones in a row become a chain of joints: the first is moved, the others hang at a
/// distance that is shared wherever it is the same; free bones hang on their parents, or stand side by side
/// without one. The stretch is the scale
/// of the joints that the mesh is bound to: leaves under the joints that others hang on, so that none
/// inherits it. A scale that is a common course in time multiplied by a constant for each bone is stored as
/// just that.
[[nodiscard]] EncodedClip encodeGltf(const SkinnedSequence& sequence, const EncodeSettings& settings = {});

/// Encodes a clip, which leaving out keys makes long; nothing when it was stopped.
[[nodiscard]] std::optional<EncodedClip> encodeGltf(const SkinnedSequence& sequence,
                                                    const EncodeSettings& settings, const Proceed& proceed);

/// Bytes of a frame as positions of all vertices, single precision.
[[nodiscard]] std::size_t sourceBytesPerFrame(const MeshSequence& sequence);

} // namespace stretch::skinning

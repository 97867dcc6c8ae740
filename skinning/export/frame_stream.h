#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/gltf/source/source.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// A skinned clip in two parts, for a server that sends frames as they come and a client that shows them
/// (docs/stream.md): what stays, and frames of equal length, each of which says all by itself.
struct FrameStream {
  gltf::Source base; ///< Mesh, weights, skin and nodes without a clip. Its extras say which node
                     ///< takes what of a frame.
  std::vector<std::uint8_t> frames; ///< One after the other: more can be appended.
  std::size_t frameBytes = 0;       ///< Bytes of each frame.

  [[nodiscard]] std::span<const std::uint8_t> frame(std::size_t index) const {
    return {frames.data() + index * frameBytes, frameBytes};
  }
};

inline constexpr std::uint8_t streamVersion = 1;
inline constexpr std::size_t streamHeaderBytes = 8;

/// Courses that the frames of a stream hold.
enum class StreamCourses {
  changing, ///< Those that change in the sequence, shared where bones share it; all else is in the base.
  all,      ///< Rotation and place of every bone, and its scale where any bone stretches: frames of other
            ///< motion can say what they need.
};

/// The courses that encodeGltf writes for the clip, cut into frames: with `quantise` rotations are 16-bit
/// integers. The sequence has at least one frame.
[[nodiscard]] FrameStream streamOf(const SkinnedSequence& sequence, bool quantise,
                                   StreamCourses which = StreamCourses::changing);

/// Appends what a frame begins with.
void putStreamHeader(std::size_t number, std::vector<std::uint8_t>& bytes);

} // namespace stretch::skinning

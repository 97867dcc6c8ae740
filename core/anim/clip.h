#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/copy_on_write.h"
#include "core/math/types.h"
#include "core/scene/node_index.h"

namespace stretch {

enum class Interpolation { step, linear, cubicSpline };
enum class Channel { translation, rotation, scale, weights };

/// One animated property of one node: a glTF channel with its sampler.
struct Track {
  NodeIndex node;
  Channel channel = Channel::translation;
  Interpolation interpolation = Interpolation::linear;
  int width = 3; ///< Numbers per value: 3, 4 for rotations (x, y, z, w), number of targets for weights.
  std::vector<float> times;  ///< Seconds, strictly increasing, at least one.
  std::vector<float> values; ///< width for each key; 3 x width for cubic splines: in-tangent, value,
                             ///< out-tangent (per second).
  int sourceChannel = -1; ///< Index into the file's animation.channels; -1 for a track that the file does not
                          ///< have.

  friend bool operator==(const Track&, const Track&) = default;
};

/// An animation of the file. Tracks target each (node, channel) at most once.
struct Clip {
  std::string name;     ///< May be empty or repeated: the index in the file is the identity.
  int sourceIndex = -1; ///< Index into the file's animations.
  std::vector<CopyOnWrite<Track>> tracks;
  double startSeconds = 0.0; ///< Earliest key of any track, at least 0; 0 without keys. See setEndsFromKeys.
  double endSeconds = 0.0;   ///< Latest key of any track, at least 0; 0 without keys.
  double framesPerSecond = 30.0; ///< Guessed from the key times; a real number.

  friend bool operator==(const Clip&, const Clip&) = default;
};

/// Index of the track that animates (node, channel), or -1.
[[nodiscard]] int findTrack(const Clip& clip, NodeIndex node, Channel channel);

/// Sets start and end to the earliest and the latest key of any track. A clip plays from 0: keys before it
/// (files that break the specification have some) shape the motion, but are no time of the clip.
void setEndsFromKeys(Clip& clip);

/// The rate at which most keys fall on whole frames (within 2 % of a frame), from the usual rates first (24,
/// 25, 30, 50, 60, 120, 12, 15, 8, 6...), then from the median spacing of the keys. Half a rate of 40 or more
/// where 3 in 10 tracks of at least 4 keys are keyed on that: keys between frames, as re-keying adds them to
/// some tracks, do not double it. 30 when keys say nothing.
[[nodiscard]] double guessFramesPerSecond(const std::vector<CopyOnWrite<Track>>& tracks);

/// Number of keys of all tracks.
[[nodiscard]] std::size_t keyCount(const Clip& clip);

/// Number of frames of a clip: the last key's time in frames, rounded, plus 1.
[[nodiscard]] std::int64_t frameCount(const Clip& clip);

} // namespace stretch

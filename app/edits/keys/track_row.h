#pragma once

#include <cstddef>
#include <vector>

#include "app/edits/keys/key_row.h"

namespace stretch::app {

// A track of a clip as a row of keys, and back: docs/keys.md, The clip's own keys.

[[nodiscard]] KeyedRow readTrack(const Track& track, double framesPerSecond, RowDetail detail);

struct WrittenTrack {
  Track track;
  std::vector<std::size_t> rowKeys; ///< For each key of the track, its place in the row.
};

/// The track with the keys of the row; of keys at one time the first. What did not change keeps its bits.
/// `before`: the track that the row was read from, or one without keys.
[[nodiscard]] WrittenTrack writeTrack(const Track& before, const KeyedRow& row, double framesPerSecond);

/// The value of a track at a time, as it is shown; angles nearest to `near`.
[[nodiscard]] KeyValues trackValues(const Track& track, double timeSeconds, const KeyValues& near);

} // namespace stretch::app

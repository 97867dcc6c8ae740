#pragma once

#include "app/edits/key_row.h"

namespace stretch::app {

// A track of a clip as a row of keys, and back: docs/keys.md, The clip's own keys.

[[nodiscard]] KeyedRow readTrack(const Track& track, double framesPerSecond, RowDetail detail);

/// The track with the keys of the row. What did not change keeps its bits. `before`: the track that the row
/// was read from, or one without keys.
[[nodiscard]] Track writeTrack(const Track& before, const KeyedRow& row, double framesPerSecond);

/// The value of a track at a time, as it is shown; angles nearest to `near`.
[[nodiscard]] KeyValues trackValues(const Track& track, double timeSeconds, const KeyValues& near);

} // namespace stretch::app

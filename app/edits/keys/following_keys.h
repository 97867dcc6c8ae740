#pragma once

#include <cstddef>

#include "app/edits/keys/key_row.h"
#include "app/edits/keys/track_row.h"

namespace stretch::app {

// Auto tangents of the clip's own keys: their slopes follow the neighbours (docs/keys.md, The clip's own
// keys).

/// The slope that auto gives a component of a key, for each frame: level where there is no neighbour on one
/// side (null) and where the key is the highest or lowest of the three; else no steeper than would pass them.
[[nodiscard]] double followingSlope(const RowKey* before, const RowKey& key, const RowKey* after,
                                    std::size_t component);

/// Which keys of a track that was read as `row` follow.
void markFollowing(const Document& document, int clip, const Track& track, KeyedRow& row);

/// Writes as writeTrack does (track_row.h); then the following components of keys that were changed, or whose
/// neighbours were, get their slopes.
[[nodiscard]] WrittenTrack writeFollowing(const Track& before, const KeyedRow& row, double framesPerSecond);

/// Keeps in the document which keys of the written track follow.
void rememberFollowing(int clip, const WrittenTrack& written, const KeyedRow& row, Document& document);

} // namespace stretch::app

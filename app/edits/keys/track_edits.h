#pragma once

#include <functional>
#include <span>
#include <vector>

#include "app/document.h"

namespace stretch::app {

// The clip's own keys, edited: a clip of the document has the edited tracks in place of the source's. The
// others are shared with the source's clip, and what is edited is what differs from it.

/// Whether any clip's own keys were edited.
[[nodiscard]] bool hasEditedKeys(const Document& document);

/// The tracks of a clip that are not as the source has them.
[[nodiscard]] std::vector<Track> editedTracks(const Document& document, int clip);

/// Puts tracks in the place of those with the same node and channel, or beside them. The clip begins and ends
/// with its keys. Tracks are sound: keys in order, as many values as they ask for.
[[nodiscard]] Document setTracks(const Document& document, int clip, const std::vector<Track>& tracks);

/// Gives the tracks of a clip that `which` names back as the source has them; what the source does not have
/// goes.
using TrackChoice = std::function<bool(NodeIndex, Channel)>;
[[nodiscard]] Document restoreTracks(const Document& document, int clip, const TrackChoice& which);

/// Every track of every clip.
[[nodiscard]] Document restoreAllTracks(const Document& document);

} // namespace stretch::app

#pragma once

#include <vector>

#include "rig/rekey/key_times.h"

namespace stretch::rig {

/// A window and the times of the keys in it, ascending, its ends included.
struct KeyWindow {
  Window window;
  std::vector<double> times;
};

/// New keys of one property: those of the parts that change it.
struct ChannelKeys {
  ChangedChannel channel;
  std::vector<KeyWindow> windows; ///< Disjoint, ascending.
  double framesPerSecond = 0.0;   ///< Above 0: what is added beside the windows stands on whole frames alone.
};

/// The whole tracks, one for each channel: keys of the source outside the windows bit for bit, the exact
/// motion inside.
[[nodiscard]] std::vector<Track> buildTracks(ExactMotion& exact, const std::vector<ChannelKeys>& channels);

} // namespace stretch::rig

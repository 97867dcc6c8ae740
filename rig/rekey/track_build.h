#pragma once

#include <vector>

#include "rig/rekey/key_times.h"

namespace stretch::rig {

/// New keys of one property: those of the trails that change it, in time order.
struct ChannelKeys {
  ChangedChannel channel;
  std::vector<Window> windows;            ///< Disjoint, ascending.
  std::vector<std::vector<double>> times; ///< One list a window, ascending, ends included.
};

/// The whole track: keys of the source outside the windows bit for bit, the exact motion inside.
[[nodiscard]] Track buildTrack(ExactMotion& exact, const ChannelKeys& keys);

} // namespace stretch::rig

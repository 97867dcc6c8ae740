#pragma once

#include <cstddef>
#include <vector>

#include "core/math/types.h"

namespace stretch::app {

/// Samples put before and after those of a clip that loops: it comes from its own end and goes on with its
/// own beginning, wherever it got to meanwhile. None where it does not loop.
struct LoopRoom {
  std::size_t before = 0;
  std::size_t after = 0;
};

/// For `samples` samples, the last of which shows the first again.
[[nodiscard]] LoopRoom loopRoom(bool loops, std::size_t samples, double samplesPerSecond);

/// One entry for each sample, with the room filled in.
template <typename T>
void wrapList(std::vector<T>& list, const LoopRoom& room) {
  if (room.before == 0) {
    return;
  }
  const std::size_t period = list.size() - 1;
  std::vector<T> wrapped;
  for (std::size_t k = 0; k <= 2 * period + room.after; ++k) {
    wrapped.push_back(list[k < period ? k : (k <= 2 * period ? k - period : k - 2 * period)]);
  }
  list = std::move(wrapped);
}

/// Wraps places of joints (of a limb, base first): what the base travels in one turn is added up.
void wrapJoints(std::vector<std::vector<Vec3>>& joints, const LoopRoom& room);

} // namespace stretch::app

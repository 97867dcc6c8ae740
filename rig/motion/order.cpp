#include "rig/motion/order.h"

#include <algorithm>
#include <numeric>

namespace stretch::rig {

namespace {

// Where the skeleton does not decide.
int habitOf(LimbKind kind) {
  switch (kind) {
  case LimbKind::spine:
    return 0;
  case LimbKind::neck:
    return 1;
  case LimbKind::arm:
    return 2;
  case LimbKind::leg:
    return 3;
  default:
    break;
  }
  return 4;
}

// How many limbs carry each.
std::vector<std::size_t> carrierCounts(const Scene& scene, const std::vector<ActingLimb>& limbs) {
  std::vector<std::size_t> counts;
  counts.reserve(limbs.size());
  for (const ActingLimb& outer : limbs) {
    counts.push_back(
        static_cast<std::size_t>(std::count_if(limbs.begin(), limbs.end(), [&](const ActingLimb& inner) {
          return carries(scene, *inner.limb, *outer.limb);
        })));
  }
  return counts;
}

} // namespace

bool carries(const Scene& scene, const Limb& inner, const Limb& outer) {
  const NodeIndex base = outer.joints.front();
  const bool below = isAncestorOrSelf(scene, inner.joints.front(), base) && inner.joints.front() != base;
  return below || (inner.endNode.exists() && isAncestorOrSelf(scene, inner.endNode, base));
}

std::vector<std::size_t> actingOrder(const Scene& scene, const std::vector<ActingLimb>& limbs) {
  std::vector<std::size_t> waiting(limbs.size());
  std::iota(waiting.begin(), waiting.end(), std::size_t{0});
  std::stable_sort(waiting.begin(), waiting.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(habitOf(limbs[a].limb->kind), limbs[a].startSeconds) <
           std::pair(habitOf(limbs[b].limb->kind), limbs[b].startSeconds);
  });
  std::vector<std::size_t> carriers = carrierCounts(scene, limbs);
  std::vector<std::size_t> order;
  while (!waiting.empty()) {
    auto next = std::find_if(waiting.begin(), waiting.end(), [&](std::size_t i) { return carriers[i] == 0; });
    next = next == waiting.end() ? waiting.begin() : next;
    const std::size_t taken = *next;
    waiting.erase(next);
    order.push_back(taken);
    for (const std::size_t other : waiting) {
      carriers[other] -= carries(scene, *limbs[taken].limb, *limbs[other].limb) ? 1 : 0;
    }
  }
  return order;
}

} // namespace stretch::rig

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/scene/scene.h"
#include "rig/limb.h"

namespace stretch::rig {

/// Whether what moves `inner` moves the base of `outer`: it lies below the base of `inner`, or at or below
/// its end joint (a foot under the root is moved by its leg all the same). Two limbs of one base do not carry
/// each other.
[[nodiscard]] bool carries(const Scene& scene, const Limb& inner, const Limb& outer);

/// A limb that acts, and from when on.
struct ActingLimb {
  const Limb* limb = nullptr;
  double startSeconds = 0.0;
};

/// Indices into `limbs` from the root outwards: each limb after every limb that carries it. Where the
/// skeleton leaves it open: spine, neck, arms, legs, other chains, and among these the earlier start first,
/// then the earlier entry. Limbs that carry each other in a circle (ends under each other's bases) keep that
/// order.
[[nodiscard]] std::vector<std::size_t> actingOrder(const Scene& scene, const std::vector<ActingLimb>& limbs);

/// The items, `order[0]` first.
template <typename T>
[[nodiscard]] std::vector<T> inOrder(std::vector<T> items, const std::vector<std::size_t>& order) {
  std::vector<T> ordered;
  ordered.reserve(order.size());
  for (const std::size_t index : order) {
    ordered.push_back(std::move(items[index]));
  }
  return ordered;
}

} // namespace stretch::rig

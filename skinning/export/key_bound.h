#pragma once

#include <functional>
#include <vector>

#include "core/gltf/source.h"
#include "skinning/skinned_sequence.h"

// Internal to skinning/export: how many keys can go before the mesh shows it.

namespace stretch::skinning {

/// How far vertices of the bind pose are from a bone's pivot.
struct BoneReach {
  double turned = 0.0; ///< The farthest that turns with the bone: its own and of what hangs on it.
  double scaled = 0.0; ///< The farthest of its own.
};

[[nodiscard]] std::vector<BoneReach> reachesOf(const SkinnedSequence& sequence);

/// The bound for single properties (see ClipEncoding) that keeps to one on the mesh.
struct KeyBound {
  double bound = 0.0;          ///< A length; 0: every frame has to be a key.
  double largestPercent = 0.0; ///< The farthest that it moves a vertex of any frame.
};

/// A clip with keys by a bound.
using EncodeWithBound = std::function<gltf::Source(const SkinnedSequence&, double bound)>;

/// Deviations of single properties add up or cancel on the mesh in a way that only the mesh tells: clips with
/// different bounds are encoded, read back and measured against the clip with every key. Both are the mesh
/// without its surface.
[[nodiscard]] KeyBound findKeyBound(const SkinnedSequence& sequence, double tolerancePercent,
                                    const EncodeWithBound& encode);

} // namespace stretch::skinning

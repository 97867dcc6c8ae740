#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/gltf/source/source.h"
#include "skinning/fit/alternate.h"
#include "skinning/skinned_sequence.h"

// Internal to skinning/export: which keys can go before the mesh shows it.

namespace stretch::skinning {

/// For each sampler of a clip, in order, the frames that stay keys, ascending; one alone: the value of that
/// frame for the whole clip.
using KeyPlan = std::vector<std::vector<std::size_t>>;

/// Keys of a clip of ours with a key for every frame, left out one after the other as long as no vertex is
/// moved farther than `bound` (a length) by all of them together; the least harmful first. Courses that can
/// stand still do. Either every course has keys of its own or those of a bone share theirs, whatever takes
/// fewer bytes; where neither saves any, every frame stays a key. Measured on the vertices that lie farthest
/// out from the joints and on those of `also`, counted as the file draws them. Nothing when it was stopped.
[[nodiscard]] std::optional<KeyPlan> planKeys(const gltf::Source& everyKey, std::size_t frames, double bound,
                                              const std::vector<std::size_t>& also, const Proceed& proceed);

} // namespace stretch::skinning

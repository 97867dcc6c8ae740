#include "rig/adjust/adjusted_sampler.h"

#include <utility>

#include "rig/adjust/apply_adjustments.h"

namespace stretch::rig {

namespace {

std::vector<NodeIndex> withAdjusted(std::vector<NodeIndex> nodes, const SolvedAdjustments& adjustments) {
  nodes.insert(nodes.end(), adjustments.nodes.begin(), adjustments.nodes.end());
  return nodes;
}

} // namespace

AdjustedSampler::AdjustedSampler(const Scene& scene, const Clip& clip, const SolvedAdjustments& adjustments,
                                 std::vector<NodeIndex> nodes)
    : adjustments_(adjustments), sampler_(scene, clip, withAdjusted(std::move(nodes), adjustments)),
      skeleton_(sampler_.skeleton()) {}

void AdjustedSampler::sample(double timeSeconds, FrameState& frame) const {
  sampler_.sample(timeSeconds, frame);
  applyAdjustments(skeleton_, adjustments_, frame);
}

} // namespace stretch::rig

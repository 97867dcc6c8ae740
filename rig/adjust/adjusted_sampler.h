#pragma once

#include <vector>

#include "core/anim/clip.h"
#include "core/scene/scene.h"
#include "rig/adjust/solved_adjustments.h"
#include "rig/trail/limb_path.h"

namespace stretch::rig {

/// The adjusted clip of some nodes: a NodeSampler, with the adjustments of the clip on top where there are
/// any. What it is made from has to outlive it.
class AdjustedSampler {
public:
  AdjustedSampler(const Scene& scene, const Clip& clip, const SolvedAdjustments& adjustments,
                  std::vector<NodeIndex> nodes);

  /// Samples as NodeSampler::sample does.
  void sample(double timeSeconds, FrameState& frame) const;
  /// The sampled nodes, those that adjustments move included.
  [[nodiscard]] const Scene& skeleton() const { return skeleton_; }

private:
  const SolvedAdjustments& adjustments_;
  NodeSampler sampler_;
  Scene skeleton_;
};

} // namespace stretch::rig

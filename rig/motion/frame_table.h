#pragma once

#include <memory>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/motion/adjusted_sampler.h"

namespace stretch::rig {

/// The adjusted clip of some nodes at many times, sampled once for everything that asks for them.
class FrameTable {
public:
  /// Samples at the times, in parallel. `nodes`: what the sampler was made for.
  FrameTable(const AdjustedSampler& sampler, std::vector<NodeIndex> nodes, std::vector<double> timesSeconds);

  /// Whether every one of the nodes is filled in.
  [[nodiscard]] bool covers(const std::vector<NodeIndex>& nodes) const;
  /// The frame at a time, or nearer to it than key times are stored; null where there is none.
  [[nodiscard]] const FrameState* find(double timeSeconds) const;

  /// How many frames of a scene are worth keeping.
  [[nodiscard]] static std::size_t most(const Scene& scene);

private:
  std::vector<NodeIndex> nodes_; // ascending
  std::vector<double> times_;    // ascending
  std::vector<FrameState> frames_;
};

/// The adjusted clip of some nodes at any time: out of a table where it has the time, else sampled.
class FrameSource {
public:
  /// As AdjustedSampler. `table`: of the same adjusted clip; null: none.
  FrameSource(const Scene& scene, const Clip& clip, const SolvedAdjustments& adjustments,
              std::vector<NodeIndex> nodes, const FrameTable* table);

  /// Stays as it is until the next call.
  [[nodiscard]] const FrameState& at(double timeSeconds);
  [[nodiscard]] const Scene& skeleton() const { return sampler_.skeleton(); }

private:
  const FrameTable* table_;
  AdjustedSampler sampler_;
  FrameState sampled_;
};

} // namespace stretch::rig

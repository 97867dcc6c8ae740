#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/anim/frame_state.h"
#include "core/scene/scene.h"
#include "rig/adjust/adjusted_sampler.h"

namespace stretch::rig {

/// Frames that nobody looks at any more: the next table is made in their memory. May be used by several
/// threads.
class FramePool {
public:
  /// Frames given back, with whatever they hold; none where there are none.
  [[nodiscard]] std::vector<FrameState> take();
  void give(std::vector<FrameState> frames);

private:
  std::mutex mutex_;
  std::vector<FrameState> frames_;
};

/// A clip's frames of some nodes at many times, made once for everything that asks for them.
class FrameTable {
public:
  /// Times and nodes that a table is made for.
  struct Extent {
    std::vector<NodeIndex> nodes;
    std::vector<double> timesSeconds;
    friend bool operator==(const Extent&, const Extent&) = default;
  };

  /// Each node and each time once, ascending.
  [[nodiscard]] static Extent extentOf(std::vector<NodeIndex> nodes, std::vector<double> timesSeconds);

  /// The clip without its adjustments, sampled in parallel. `extent`: as extentOf answers.
  FrameTable(const Scene& scene, const Clip& clip, Extent extent);
  /// The frames of another table, which need what the adjustments read and move (SolvedAdjustments::nodes),
  /// adjusted in parallel.
  FrameTable(const FrameTable& source, const SolvedAdjustments& adjustments);
  ~FrameTable();
  FrameTable(const FrameTable&) = delete;
  FrameTable& operator=(const FrameTable&) = delete;

  [[nodiscard]] const Extent& extent() const { return extent_; }
  /// Whether every one of the nodes is filled in.
  [[nodiscard]] bool covers(const std::vector<NodeIndex>& nodes) const;
  /// The frame nearest to this time, within the rounding of key times; null where there is none.
  [[nodiscard]] const FrameState* find(double timeSeconds) const;
  /// Returns the same as NodeSampler::skeleton.
  [[nodiscard]] const Scene& skeleton() const { return skeleton_; }

  /// How many frames of a scene are worth keeping.
  [[nodiscard]] static std::size_t most(const Scene& scene);

private:
  Extent extent_;
  Scene skeleton_;
  std::vector<FrameState> frames_;
  std::shared_ptr<FramePool> pool_; // of the adjusted tables of one source, which come and go with each step
                                    // of a drag
};

/// The adjusted clip of some nodes at any time: out of a table where it has the time, else sampled.
class FrameSource {
public:
  /// Samples as AdjustedSampler does. `table` is of the same adjusted clip; null: none.
  FrameSource(const Scene& scene, const Clip& clip, const SolvedAdjustments& adjustments,
              std::vector<NodeIndex> nodes, const FrameTable* table);

  /// Stays as it is until the next call.
  [[nodiscard]] const FrameState& at(double timeSeconds);
  /// The sampled nodes at least.
  [[nodiscard]] const Scene& skeleton();

private:
  [[nodiscard]] const AdjustedSampler& sampler();

  const Scene& scene_;
  const Clip& clip_;
  const SolvedAdjustments& adjustments_;
  std::vector<NodeIndex> nodes_;
  const FrameTable* table_;
  std::optional<AdjustedSampler> sampler_; // made when the table does not have what is asked for
  FrameState sampled_;
};

} // namespace stretch::rig

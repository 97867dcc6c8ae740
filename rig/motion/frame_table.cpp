#include "rig/motion/frame_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tbb/parallel_for.h>

#include "rig/motion/apply_adjustments.h"
#include "rig/trail/limb_path.h"

namespace stretch::rig {

namespace {

// Key times are stored in single precision: a time nearer than this to a key is at it.
double tableRounding(double timeSeconds) {
  return 1e-7 * std::max(1.0, std::abs(timeSeconds));
}

void sortOnce(std::vector<double>& times) {
  std::sort(times.begin(), times.end());
  const auto isSame = [](double a, double b) { return b - a <= tableRounding(a); };
  times.erase(std::unique(times.begin(), times.end(), isSame), times.end());
}

} // namespace

FrameTable::FrameTable(const Scene& scene, const Clip& clip, std::vector<NodeIndex> nodes,
                       std::vector<double> timesSeconds)
    : nodes_(std::move(nodes)), times_(std::move(timesSeconds)) {
  std::sort(nodes_.begin(), nodes_.end());
  sortOnce(times_);
  frames_.resize(times_.size());
  const NodeSampler sampler(scene, clip, nodes_);
  skeleton_ = sampler.skeleton();
  tbb::parallel_for(std::size_t{0}, times_.size(),
                    [&](std::size_t i) { sampler.sample(times_[i], frames_[i]); });
}

FrameTable::FrameTable(const FrameTable& source, const SolvedAdjustments& adjustments)
    : nodes_(source.nodes_), times_(source.times_), skeleton_(source.skeleton_) {
  frames_.resize(times_.size());
  tbb::parallel_for(std::size_t{0}, times_.size(), [&](std::size_t i) {
    frames_[i] = source.frames_[i];
    applyAdjustments(skeleton_, adjustments, frames_[i]);
  });
}

bool FrameTable::covers(const std::vector<NodeIndex>& nodes) const {
  return std::ranges::all_of(
      nodes, [&](NodeIndex node) { return std::binary_search(nodes_.begin(), nodes_.end(), node); });
}

bool FrameTable::covers(const std::vector<double>& timesSeconds) const {
  return std::ranges::all_of(timesSeconds, [&](double time) { return find(time) != nullptr; });
}

const FrameState* FrameTable::find(double timeSeconds) const {
  const double rounding = tableRounding(timeSeconds);
  const auto found = std::lower_bound(times_.begin(), times_.end(), timeSeconds - rounding);
  return found != times_.end() && *found <= timeSeconds + rounding ? &frames_[static_cast<std::size_t>(found - times_.begin())] : nullptr;
}

std::size_t FrameTable::most(const Scene& scene) {
  constexpr std::size_t mostNodes = 250000; // about 64 MB
  return mostNodes / std::max<std::size_t>(1, scene.nodes.size());
}

FrameSource::FrameSource(const Scene& scene, const Clip& clip, const SolvedAdjustments& adjustments,
                         std::vector<NodeIndex> nodes, const FrameTable* table)
    : scene_(scene), clip_(clip), adjustments_(adjustments), nodes_(std::move(nodes)),
      table_(table != nullptr && table->covers(nodes_) ? table : nullptr) {}

const AdjustedSampler& FrameSource::sampler() {
  if (!sampler_) {
    sampler_.emplace(scene_, clip_, adjustments_, nodes_);
  }
  return *sampler_;
}

const Scene& FrameSource::skeleton() {
  return table_ != nullptr ? table_->skeleton() : sampler().skeleton();
}

const FrameState& FrameSource::at(double timeSeconds) {
  if (const FrameState* const known = table_ != nullptr ? table_->find(timeSeconds) : nullptr) {
    return *known;
  }
  sampler().sample(timeSeconds, sampled_);
  return sampled_;
}

} // namespace stretch::rig

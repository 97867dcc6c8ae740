#include "rig/adjust/frame_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "core/anim/key_time.h"
#include "rig/adjust/apply_adjustments.h"
#include "rig/trail/limb_path.h"

namespace stretch::rig {

namespace {

// As many frames as one thread has done before another one is awake.
constexpr std::size_t framesWorthWaking = 256;

template <typename Work>
void forEachFrame(std::size_t count, const Work& work) {
  const tbb::blocked_range<std::size_t> all(0, count, framesWorthWaking);
  tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      work(i);
    }
  });
}

} // namespace

std::vector<FrameState> FramePool::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(frames_, {});
}

void FramePool::give(std::vector<FrameState> frames) {
  const std::scoped_lock lock(mutex_);
  frames_ = std::move(frames);
}

FrameTable::Extent FrameTable::extentOf(std::vector<NodeIndex> nodes, std::vector<double> timesSeconds) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::sort(timesSeconds.begin(), timesSeconds.end());
  timesSeconds.erase(std::unique(timesSeconds.begin(), timesSeconds.end()), timesSeconds.end());
  return {std::move(nodes), std::move(timesSeconds)};
}

FrameTable::FrameTable(const Scene& scene, const Clip& clip, Extent extent)
    : extent_(std::move(extent)), pool_(std::make_shared<FramePool>()) {
  const std::vector<double>& times = extent_.timesSeconds;
  frames_.resize(times.size());
  const NodeSampler sampler(scene, clip, extent_.nodes);
  skeleton_ = sampler.skeleton();
  forEachFrame(times.size(), [&](std::size_t i) { sampler.sample(times[i], frames_[i]); });
}

FrameTable::FrameTable(const FrameTable& source, const SolvedAdjustments& adjustments)
    : extent_(source.extent_), skeleton_(source.skeleton_), frames_(source.pool_->take()),
      pool_(source.pool_) {
  frames_.resize(source.frames_.size());
  forEachFrame(frames_.size(), [&](std::size_t i) {
    frames_[i] = source.frames_[i];
    applyAdjustments(skeleton_, adjustments, source.frames_[i], frames_[i]);
  });
}

FrameTable::~FrameTable() {
  pool_->give(std::move(frames_));
}

bool FrameTable::covers(const std::vector<NodeIndex>& nodes) const {
  return std::ranges::all_of(nodes, [&](NodeIndex node) {
    return std::binary_search(extent_.nodes.begin(), extent_.nodes.end(), node);
  });
}

const FrameState* FrameTable::find(double timeSeconds) const {
  const std::vector<double>& times = extent_.timesSeconds;
  auto nearest = std::lower_bound(times.begin(), times.end(), timeSeconds);
  if (nearest != times.begin() &&
      (nearest == times.end() || timeSeconds - *(nearest - 1) < *nearest - timeSeconds)) {
    --nearest;
  }
  // Keys are stored in single precision, and on a loop a time of the next turn comes back a rounding away.
  return nearest != times.end() && std::abs(*nearest - timeSeconds) <= keyTimeRounding(timeSeconds)
             ? &frames_[static_cast<std::size_t>(nearest - times.begin())]
             : nullptr;
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

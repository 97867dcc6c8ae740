#include "rig/rekey/stretch_build.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/scene/bind_chains.h"

namespace stretch::rig {

namespace {

// Times of keys, each with the time at which the motion is looked at for it.
using KeyTimes = std::map<float, double>;

void addTimesOf(const KeyWindow& keys, KeyTimes& times) {
  constexpr float endless = std::numeric_limits<float>::infinity();
  constexpr double clearOfBorder = 1e-6; // a time nearer to a border than single precision tells is at it
  const double start = keys.times.front();
  const double end = keys.times.back();
  if (keys.window.jumpsBefore) {
    times.emplace(std::nextafter(static_cast<float>(start), -endless),
                  start - clearOfBorder * std::max(1.0, std::abs(start)));
  }
  for (const double time : keys.times) {
    times[static_cast<float>(time)] = time;
  }
  if (keys.window.jumpsAfter) {
    times.emplace(std::nextafter(static_cast<float>(end), endless),
                  end + clearOfBorder * std::max(1.0, std::abs(end)));
  }
}

bool isInside(const std::vector<KeyWindow>& windows, double time) {
  return std::any_of(windows.begin(), windows.end(), [&](const KeyWindow& keys) {
    return time >= keys.times.front() && time <= keys.times.back();
  });
}

// The keys of one node, made one after the other.
class StretchMaker {
public:
  StretchMaker(const ExactMotion& exact, const StretchWindows& stretched) : frames_(stretched.frames) {
    for (const KeyWindow& window : stretched.windows) {
      addTimesOf(window, times_);
    }
    for (const double time : sourceStretchTimes(exact, stretched.node)) {
      if (!isInside(stretched.windows, time)) {
        times_.emplace(static_cast<float>(time), time);
      }
    }
    keys_.node = stretched.node;
  }

  [[nodiscard]] const KeyTimes& times() const { return times_; }

  void makeUpTo(double time, ExactMotion& exact) {
    for (; !times_.empty() && times_.begin()->second <= time; times_.erase(times_.begin())) {
      const StretchFrame frame = frames_->at(exact, times_.begin()->second);
      keys_.times.push_back(times_.begin()->first);
      keys_.axes.push_back(frame.axes);
      keys_.scales.push_back(frame.factors);
    }
  }

  [[nodiscard]] StretchKeys take() {
    if (frames_->axesAreFixed()) {
      keys_.axes.resize(1);
    }
    return std::move(keys_);
  }

private:
  const StretchFrames* frames_;
  KeyTimes times_; // of the keys that are not made yet
  StretchKeys keys_;
};

} // namespace

std::vector<double> sourceStretchTimes(const ExactMotion& exact, NodeIndex node) {
  std::vector<double> times;
  const BindChain* const chain = findBindChain(exact.scene(), node);
  const std::vector<NodeIndex> carriers = chain == nullptr ? std::vector<NodeIndex>{} : chain->nodes();
  for (const CopyOnWrite<Track>& track : exact.clip().tracks) {
    if (std::ranges::find(carriers, track->node) != carriers.end()) {
      times.insert(times.end(), track->times.begin(), track->times.end());
    }
  }
  return times;
}

std::vector<StretchKeys> buildStretches(ExactMotion& exact, const std::vector<StretchWindows>& stretched) {
  std::vector<StretchMaker> makers;
  std::vector<double> times;
  makers.reserve(stretched.size());
  for (const StretchWindows& one : stretched) {
    for (const auto& [key, lookedAt] : makers.emplace_back(exact, one).times()) {
      times.push_back(lookedAt);
    }
  }
  for (const double stop : stopsAmong(std::move(times))) {
    for (StretchMaker& maker : makers) {
      maker.makeUpTo(stop, exact);
    }
  }
  std::vector<StretchKeys> stretches;
  stretches.reserve(makers.size());
  for (StretchMaker& maker : makers) {
    stretches.push_back(maker.take());
  }
  return stretches;
}

} // namespace stretch::rig

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

StretchKeys buildStretch(ExactMotion& exact, const StretchFrames& frames, NodeIndex node,
                         const std::vector<KeyWindow>& windows) {
  KeyTimes times;
  for (const KeyWindow& window : windows) {
    addTimesOf(window, times);
  }
  for (const double time : sourceStretchTimes(exact, node)) {
    if (!isInside(windows, time)) {
      times.emplace(static_cast<float>(time), time);
    }
  }
  StretchKeys keys;
  keys.node = node;
  for (const auto& [key, lookedAt] : times) {
    const StretchFrame frame = frames.at(exact, lookedAt);
    keys.times.push_back(key);
    keys.axes.push_back(frame.axes);
    keys.scales.push_back(frame.factors);
  }
  if (frames.axesAreFixed()) {
    keys.axes.resize(1);
  }
  return keys;
}

} // namespace stretch::rig

#include "rig/rekey/stretch_build.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "core/scene/bind_chains.h"

namespace stretch::rig {

namespace {

struct StretchKey {
  float time = 0.0F;
  StretchParts parts;
};

StretchParts stretchAt(ExactMotion& exact, int node, double time) {
  const FrameState& frame = exact.at(time);
  return frame.stretch.empty() ? StretchParts{} : partsOf(frame.stretch[static_cast<std::size_t>(node)]);
}

bool stretches(const TrailKeys& keys, int node) {
  return std::find(keys.stretchedNodes.begin(), keys.stretchedNodes.end(), node) != keys.stretchedNodes.end();
}

void addTimesOf(const TrailKeys& keys, std::set<float>& times) {
  constexpr float endless = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < keys.windows.size(); ++i) {
    const Window& window = keys.windows[i];
    if (window.jumpsBefore) {
      times.insert(std::nextafter(static_cast<float>(window.startSeconds), -endless));
    }
    for (const double time : keys.stretchTimes[i]) {
      times.insert(static_cast<float>(time));
    }
    if (window.jumpsAfter) {
      times.insert(std::nextafter(static_cast<float>(window.endSeconds), endless));
    }
  }
}

bool isInside(const std::vector<TrailKeys>& trails, int node, float time) {
  return std::any_of(trails.begin(), trails.end(), [&](const TrailKeys& keys) {
    return stretches(keys, node) &&
           std::any_of(keys.windows.begin(), keys.windows.end(), [&](const Window& window) {
             return time >= static_cast<float>(window.startSeconds) &&
                    time <= static_cast<float>(window.endSeconds);
           });
  });
}

// A file that was stretched before keeps its stretch outside the trails.
void addSourceTimes(const ExactMotion& exact, const std::vector<TrailKeys>& trails, int node,
                    std::set<float>& times) {
  const BindChain* chain = findBindChain(exact.scene(), node);
  for (const CopyOnWrite<Track>& track : exact.clip().tracks) {
    if (chain == nullptr || (track->node != chain->leaf && track->node != chain->endLeaf)) {
      continue;
    }
    std::copy_if(track->times.begin(), track->times.end(), std::inserter(times, times.end()),
                 [&](float time) { return !isInside(trails, node, time); });
  }
}

std::vector<StretchKey> keysOf(ExactMotion& exact, const std::vector<TrailKeys>& trails, int node) {
  std::set<float> times;
  for (const TrailKeys& keys : trails) {
    if (stretches(keys, node)) {
      addTimesOf(keys, times);
    }
  }
  addSourceTimes(exact, trails, node, times);
  std::vector<StretchKey> keys;
  for (const float time : times) {
    keys.push_back({time, stretchAt(exact, node, static_cast<double>(time))});
  }
  return keys;
}

// Where K is the identity it has no axis: it takes that of the nearest key that has one.
void fillAxes(std::vector<StretchKey>& keys) {
  Vec3 last(0.0);
  for (StretchKey& key : keys) {
    if (glm::length(key.parts.axis) > 0.0) {
      last = glm::dot(key.parts.axis, last) < 0.0 ? -key.parts.axis : key.parts.axis;
    }
    key.parts.axis = last;
  }
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
    if (glm::length(key->parts.axis) > 0.0) {
      last = key->parts.axis;
    }
    key->parts.axis = last;
  }
}

// The axis of the strongest stretch stands for all when turning it changes no point of the bone by more than
// 1e-5 of it.
bool axisStands(const std::vector<StretchKey>& keys, const Vec3& axis) {
  constexpr double negligible = 1e-5;
  return std::all_of(keys.begin(), keys.end(), [&](const StretchKey& key) {
    return std::abs(key.parts.along - key.parts.across) * angleBetween(key.parts.axis, axis) < negligible;
  });
}

} // namespace

StretchKeys buildStretch(ExactMotion& exact, const std::vector<TrailKeys>& trails, int node) {
  std::vector<StretchKey> all = keysOf(exact, trails, node);
  fillAxes(all);
  const auto strongest =
      std::max_element(all.begin(), all.end(), [](const StretchKey& a, const StretchKey& b) {
        return std::abs(a.parts.along - a.parts.across) < std::abs(b.parts.along - b.parts.across);
      });
  const Vec3 mainAxis = strongest->parts.axis;
  const Quat mainTurn = shortestArc(Vec3(1, 0, 0), mainAxis);
  StretchKeys stretch;
  stretch.node = node;
  const bool fixed = axisStands(all, mainAxis);
  for (const StretchKey& key : all) {
    stretch.times.push_back(key.time);
    stretch.scales.emplace_back(key.parts.along, key.parts.across, key.parts.across);
    if (!fixed) {
      // From the main axis on, so that neighbouring keys turn as little as their axes do.
      stretch.axes.push_back(glm::normalize(shortestArc(mainAxis, key.parts.axis) * mainTurn));
    }
  }
  if (fixed) {
    stretch.axes = {mainTurn};
  }
  return stretch;
}

} // namespace stretch::rig

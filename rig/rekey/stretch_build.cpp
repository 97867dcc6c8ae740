#include "rig/rekey/stretch_build.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"

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

std::vector<StretchKey> keysOf(ExactMotion& exact, const TrailKeys& keys, int node) {
  std::vector<StretchKey> out;
  constexpr float endless = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < keys.windows.size(); ++i) {
    const Window& window = keys.windows[i];
    if (window.jumpsBefore) {
      out.push_back({std::nextafter(static_cast<float>(window.startSeconds), -endless), {}});
    }
    for (const double time : keys.stretchTimes[i]) {
      out.push_back({static_cast<float>(time), stretchAt(exact, node, time)});
    }
    if (window.jumpsAfter) {
      out.push_back({std::nextafter(static_cast<float>(window.endSeconds), endless), {}});
    }
  }
  return out;
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

StretchKeys buildStretch(ExactMotion& exact, const TrailKeys& keys, int node) {
  std::vector<StretchKey> all = keysOf(exact, keys, node);
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

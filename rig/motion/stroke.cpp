#include "rig/motion/stroke.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "rig/motion/solve_steps.h"
#include "rig/trail/limb_path.h"

namespace stretch::rig {

namespace {

constexpr double leastTravel = 0.15;       // Limb lengths: less only trembles.
constexpr double leastPeak = 0.4;          // Limb lengths per second: less only creeps.
constexpr double slowShare = 0.05;         // Of the peak: the limb counts as standing still.
constexpr double turningShare = 0.5;       // Of the peak: so slow, a turn back is the end of a stroke.
constexpr double risenShare = 0.2;         // Of the peak: another stroke begins.
constexpr double smoothingSeconds = 0.025; // Either side: what trembles between frames at 120 a second.

double strengthOf(const Stroke& stroke) {
  return stroke.travel * stroke.peakSpeed;
}

/// Positions of the limb's end seen from its base at every frame, in limb lengths.
std::vector<Vec3> reachOf(const Scene& scene, const Clip& clip, const Limb& limb) {
  const double last = wholeFrameAtMost(std::min(endInFrames(clip), longestFrames));
  std::vector<NodeIndex> nodes = limb.joints;
  if (limb.endNode.exists()) {
    nodes.push_back(limb.endNode);
  }
  const NodeSampler sampler(scene, clip, nodes);
  FrameState frame;
  std::vector<Vec3> reach;
  for (double frameNumber = 0.0; frameNumber <= last; frameNumber += 1.0) {
    sampler.sample(frameNumber / clip.framesPerSecond, frame);
    reach.push_back(leadingPosition(limb, frame) - stayingPosition(limb, frame));
  }
  double length = limb.restLength;
  for (const Vec3& point : reach) {
    length = std::max(length, glm::length(point));
  }
  for (Vec3& point : reach) {
    point /= std::max(length, 1e-12);
  }
  return reach;
}

/// Of each step from a frame to the next, limb lengths per second, smoothed.
std::vector<double> speedsOf(const std::vector<Vec3>& reach, double framesPerSecond) {
  std::vector<double> raw;
  for (std::size_t i = 1; i < reach.size(); ++i) {
    raw.push_back(glm::length(reach[i] - reach[i - 1]) * framesPerSecond);
  }
  const auto radius = static_cast<std::ptrdiff_t>(std::floor(smoothingSeconds * framesPerSecond));
  const auto count = static_cast<std::ptrdiff_t>(raw.size());
  std::vector<double> smooth;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto from = raw.begin() + std::max<std::ptrdiff_t>(0, i - radius);
    const auto to = raw.begin() + std::min(count, i + radius + 1);
    smooth.push_back(std::accumulate(from, to, 0.0) / static_cast<double>(to - from));
  }
  return smooth;
}

/// Whether the limb comes from, or goes to, where it turns back: this step leads away from the peak's.
bool turnsBack(const std::vector<Vec3>& reach, std::ptrdiff_t step, std::ptrdiff_t peak) {
  const auto place = [&](std::ptrdiff_t i) { return reach[static_cast<std::size_t>(i)]; };
  const Vec3 onwards = step < peak ? place(peak + 1) - place(step + 1) : place(step) - place(peak);
  return glm::dot(place(step + 1) - place(step), onwards) < 0.0;
}

/// Whether this step and the one nearer to the peak lead into opposite directions.
bool isSharpTurn(const std::vector<Vec3>& reach, std::ptrdiff_t step, std::ptrdiff_t direction) {
  const auto along = [&](std::ptrdiff_t i) {
    return reach[static_cast<std::size_t>(i + 1)] - reach[static_cast<std::size_t>(i)];
  };
  return glm::dot(along(step), along(step - direction)) < 0.0;
}

/// The last step of the stroke with this peak, looking from the peak in one direction.
std::ptrdiff_t edgeOf(const std::vector<Vec3>& reach, const std::vector<double>& speeds, std::ptrdiff_t peak,
                      std::ptrdiff_t direction) {
  const auto count = static_cast<std::ptrdiff_t>(speeds.size());
  const auto speedAt = [&](std::ptrdiff_t i) { return speeds[static_cast<std::size_t>(i)]; };
  std::ptrdiff_t slowest = peak;
  for (std::ptrdiff_t i = peak + direction; i >= 0 && i < count; i += direction) {
    const bool turned = isSharpTurn(reach, i, direction) ||
                        (speedAt(i) < turningShare * speedAt(peak) && turnsBack(reach, i, peak));
    if (turned || speedAt(i) < slowShare * speedAt(peak)) {
      return i - direction;
    }
    if (speedAt(i) > speedAt(slowest) + risenShare * speedAt(peak)) {
      return slowest;
    }
    slowest = speedAt(i) < speedAt(slowest) ? i : slowest;
  }
  return direction > 0 ? count - 1 : 0;
}

} // namespace

std::vector<Stroke> strokesOf(const Scene& scene, const Clip& clip, const Limb& limb) {
  if (limb.joints.empty()) {
    return {};
  }
  const std::vector<Vec3> reach = reachOf(scene, clip, limb);
  const std::vector<double> speeds = speedsOf(reach, clip.framesPerSecond);
  std::vector<std::ptrdiff_t> fastestFirst(speeds.size());
  std::iota(fastestFirst.begin(), fastestFirst.end(), 0);
  std::stable_sort(fastestFirst.begin(), fastestFirst.end(), [&](std::ptrdiff_t a, std::ptrdiff_t b) {
    return speeds[static_cast<std::size_t>(a)] > speeds[static_cast<std::size_t>(b)];
  });
  std::vector<char> taken(speeds.size(), 0);
  std::vector<Stroke> strokes;
  for (const std::ptrdiff_t peak : fastestFirst) {
    const double speed = speeds[static_cast<std::size_t>(peak)];
    if (speed < leastPeak) {
      break;
    }
    if (taken[static_cast<std::size_t>(peak)] != 0) {
      continue;
    }
    auto first = static_cast<std::size_t>(edgeOf(reach, speeds, peak, -1));
    auto last = static_cast<std::size_t>(edgeOf(reach, speeds, peak, 1));
    for (auto i = static_cast<std::size_t>(peak); i > first; --i) {
      first = taken[i - 1] != 0 ? i : first;
    }
    for (auto i = static_cast<std::size_t>(peak); i < last; ++i) {
      last = taken[i + 1] != 0 ? i : last;
    }
    std::fill(taken.begin() + static_cast<std::ptrdiff_t>(first),
              taken.begin() + static_cast<std::ptrdiff_t>(last) + 1, 1);
    const double travel = glm::length(reach[last + 1] - reach[first]);
    if (travel >= leastTravel) {
      strokes.push_back({static_cast<double>(first), static_cast<double>(last + 1), travel, speed});
    }
  }
  std::sort(strokes.begin(), strokes.end(),
            [](const Stroke& a, const Stroke& b) { return a.startFrame < b.startFrame; });
  return strokes;
}

const Stroke* strokeAt(const std::vector<Stroke>& strokes, double frame, double nearFrames) {
  const auto gap = [&](const Stroke& stroke) {
    const double frames = std::max({0.0, stroke.startFrame - frame, frame - stroke.endFrame});
    return frames > 0.0 ? std::max(frames, nearFrames) : 0.0;
  };
  const auto nearer = [&](const Stroke& a, const Stroke& b) {
    return gap(a) != gap(b) ? gap(a) < gap(b) : strengthOf(a) > strengthOf(b);
  };
  const auto found = std::min_element(strokes.begin(), strokes.end(), nearer);
  return found == strokes.end() ? nullptr : &*found;
}

const Stroke* strongestStroke(const std::vector<Stroke>& strokes) {
  const auto found = std::max_element(strokes.begin(), strokes.end(), [](const Stroke& a, const Stroke& b) {
    return strengthOf(a) < strengthOf(b);
  });
  return found == strokes.end() ? nullptr : &*found;
}

std::optional<Stroke> greatestMovement(const Scene& scene, const Clip& clip, const Limb& limb,
                                       double mostFrames) {
  constexpr double still = 1e-4; // Limb lengths.
  if (limb.joints.empty()) {
    return std::nullopt;
  }
  const std::vector<Vec3> reach = reachOf(scene, clip, limb);
  const auto longest = static_cast<std::size_t>(std::max(1.0, mostFrames));
  Stroke best;
  for (std::size_t first = 0; first < reach.size(); ++first) {
    for (std::size_t last = first + 1; last < std::min(reach.size(), first + longest + 1); ++last) {
      const double travel = glm::length(reach[last] - reach[first]);
      if (travel > best.travel) {
        const auto frames = static_cast<double>(last - first);
        best = {static_cast<double>(first), static_cast<double>(last), travel,
                travel * clip.framesPerSecond / frames};
      }
    }
  }
  return best.travel > still ? std::optional(best) : std::nullopt;
}

} // namespace stretch::rig

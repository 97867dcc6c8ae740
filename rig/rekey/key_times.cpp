#include "rig/rekey/key_times.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace stretch::rig {

namespace {

constexpr double sameKey = 2e-5; // seconds: nearer than this to a key of the source is that key

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

const Track* trackOf(const Clip& clip, int node, Channel channel) {
  const int index = findTrack(clip, node, channel);
  return index < 0 ? nullptr : &*clip.tracks[at(index)];
}

Window windowOf(const MotionState& motion, double start, double end) {
  const double first = std::min(0.0, motion.startSeconds);
  Window window{asKeyTime(std::max(start, first)), asKeyTime(std::min(end, motion.endSeconds)), false, false};
  window.endSeconds = std::max(window.endSeconds, window.startSeconds);
  return window;
}

void mergeOverlaps(std::vector<Window>& windows) {
  std::sort(windows.begin(), windows.end(),
            [](const Window& a, const Window& b) { return a.startSeconds < b.startSeconds; });
  std::vector<Window> merged;
  for (const Window& window : windows) {
    if (!merged.empty() && window.startSeconds <= merged.back().endSeconds) {
      merged.back().endSeconds = std::max(merged.back().endSeconds, window.endSeconds);
      merged.back().jumpsAfter = window.jumpsAfter;
    } else {
      merged.push_back(window);
    }
  }
  windows = std::move(merged);
}

void addWrapped(const MotionState& motion, const SolvedTrail& trail, std::vector<Window>& windows) {
  const double turn = motion.endSeconds - motion.startSeconds;
  if (motion.loops && trail.windowEndSeconds > motion.endSeconds) {
    windows.push_back(windowOf(motion, motion.startSeconds, trail.windowEndSeconds - turn));
  }
  if (motion.loops && trail.windowStartSeconds < std::min(0.0, motion.startSeconds)) {
    windows.push_back(windowOf(motion, trail.windowStartSeconds + turn, motion.endSeconds));
  }
}

std::vector<Window> windowsOf(const MotionState& motion, const SolvedTrail& trail) {
  Window own = windowOf(motion, trail.windowStartSeconds, trail.windowEndSeconds);
  const bool noRelease = !(trail.release.seconds() > 0.0);
  const bool forwards = trail.settings.pivot == Pivot::start;
  own.jumpsAfter = noRelease && forwards && own.endSeconds < motion.endSeconds - sameKey;
  own.jumpsBefore = noRelease && !forwards && own.startSeconds > std::min(0.0, motion.startSeconds) + sameKey;
  std::vector<Window> windows{own};
  addWrapped(motion, trail, windows);
  if (trail.settings.stayInWorld) {
    // Such a limb works against whatever carries it, wherever that moves.
    for (const SolvedTrail& inner : motion.trails) {
      if (&inner == &trail) {
        break;
      }
      windows.push_back(windowOf(motion, inner.windowStartSeconds, inner.windowEndSeconds));
    }
  }
  mergeOverlaps(windows);
  return windows;
}

// Frames and half frames strictly inside a span.
std::vector<double> checkTimes(double framesPerSecond, double start, double end) {
  std::vector<double> times;
  const double step = 0.5 / framesPerSecond;
  for (double i = std::ceil(start / step); i * step < end; i += 1.0) {
    const double time = asKeyTime(i * step);
    if (time > start + sameKey && time < end - sameKey) {
      times.push_back(time);
    }
  }
  return times;
}

std::vector<double> allTimes(ExactMotion& exact, const std::vector<Window>& windows) {
  std::vector<double> times;
  for (const Window& window : windows) {
    times.push_back(window.startSeconds);
    times.push_back(window.endSeconds);
    const std::vector<double> inside =
        checkTimes(exact.motion().framesPerSecond, window.startSeconds, window.endSeconds);
    times.insert(times.end(), inside.begin(), inside.end());
  }
  return times;
}

bool differs(const Vec4& a, const Vec4& b, Channel channel) {
  constexpr double negligible = 1e-8;
  if (channel == Channel::rotation) {
    return std::min(glm::length(a - b), glm::length(a + b)) > negligible;
  }
  return glm::length(a - b) > negligible * (glm::length(a) + glm::length(b));
}

bool isChanged(ExactMotion& exact, const std::vector<double>& times, int node, Channel channel) {
  return std::any_of(times.begin(), times.end(), [&](double time) {
    return differs(channelValue(exact.at(time).pose, node, channel),
                   channelValue(exact.sourceAt(time), node, channel), channel);
  });
}

bool isStretched(ExactMotion& exact, const std::vector<double>& times, int node) {
  constexpr double negligible = 1e-9;
  return std::any_of(times.begin(), times.end(), [&](double time) {
    const FrameState& frame = exact.at(time);
    if (frame.stretch.empty()) {
      return false;
    }
    const Mat3 difference = frame.stretch[at(node)] - Mat3(1.0);
    return glm::length(difference[0]) + glm::length(difference[1]) + glm::length(difference[2]) > negligible;
  });
}

void findChanges(ExactMotion& exact, TrailKeys& keys) {
  const std::vector<double> times = allTimes(exact, keys.windows);
  for (const int node : touchedNodes(keys.trail->limb, keys.trail->topology)) {
    for (const Channel channel : {Channel::translation, Channel::rotation, Channel::scale}) {
      if (isChanged(exact, times, node, channel)) {
        keys.channels.push_back({node, channel, trackOf(exact.clip(), node, channel)});
      }
    }
    if (isStretched(exact, times, node)) {
      keys.stretchedNodes.push_back(node);
    }
  }
}

// Key times of the source win over times of ours that are almost the same.
std::vector<double> firstTimes(const Window& window, const TrailKeys& keys, double framesPerSecond,
                               bool everyFrame) {
  std::vector<double> times{window.startSeconds, window.endSeconds};
  for (const ChangedChannel& channel : keys.channels) {
    if (channel.source == nullptr) {
      continue;
    }
    for (const float key : channel.source->times) {
      const auto time = static_cast<double>(key);
      if (time > window.startSeconds + sameKey && time < window.endSeconds - sameKey) {
        times.push_back(time);
      }
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<double> wanted{asKeyTime(keys.trail->startSeconds), asKeyTime(keys.trail->endSeconds)};
  for (double frame = std::ceil(window.startSeconds * framesPerSecond);
       everyFrame && frame / framesPerSecond < window.endSeconds; frame += 1.0) {
    wanted.push_back(asKeyTime(frame / framesPerSecond));
  }
  for (const double time : wanted) {
    const auto near = std::lower_bound(times.begin(), times.end(), time - sameKey);
    const bool inside = time > window.startSeconds && time < window.endSeconds;
    if (inside && (near == times.end() || *near > time + sameKey)) {
      times.insert(std::lower_bound(times.begin(), times.end(), time), time);
    }
  }
  return times;
}

Vec4 alongShorterArc(const Vec4& from, const Vec4& to) {
  return glm::dot(from, to) < 0.0 ? -to : to;
}

Vec4 between(ExactMotion& exact, const ChangedChannel& channel, double start, double end, double time) {
  const double t = (time - start) / (end - start);
  const Vec4 a = channelValue(exact.at(start).pose, channel.node, channel.channel);
  Vec4 b = channelValue(exact.at(end).pose, channel.node, channel.channel);
  if (channel.channel == Channel::rotation) {
    b = alongShorterArc(a, b);
  }
  if (channel.source != nullptr && channel.source->interpolation == Interpolation::cubicSpline) {
    const double h = end - start;
    const double t2 = t * t;
    const double t3 = t2 * t;
    return a * (2 * t3 - 3 * t2 + 1) + slopeOf(exact, channel, start, 1) * (h * (t3 - 2 * t2 + t)) +
           b * (3 * t2 - 2 * t3) + slopeOf(exact, channel, end, -1) * (h * (t3 - t2));
  }
  if (channel.channel == Channel::rotation) {
    const Quat turn = glm::slerp(Quat(a.w, a.x, a.y, a.z), Quat(b.w, b.x, b.y, b.z), t);
    return {turn.x, turn.y, turn.z, turn.w};
  }
  return a + (b - a) * t;
}

// How far the joints are from the exact motion when the channels run straight between two keys.
double missAt(ExactMotion& exact, const TrailKeys& keys, double start, double end, double time) {
  const FrameState& wanted = exact.at(time);
  Pose pose = wanted.pose;
  for (const ChangedChannel& channel : keys.channels) {
    setChannelValue(pose, channel.node, channel.channel, between(exact, channel, start, end, time));
  }
  const std::vector<Mat4> worlds = worldMatrices(exact.scene(), pose);
  double miss = 0.0;
  for (std::size_t node = 0; node < worlds.size(); ++node) {
    miss = std::max(miss, glm::length(positionOf(worlds[node]) - positionOf(wanted.worlds[node])));
  }
  const double t = (time - start) / (end - start);
  for (const int node : keys.stretchedNodes) {
    const auto stretchAt = [&](double when) {
      const FrameState& frame = exact.at(when);
      return frame.stretch.empty() ? Mat3(1.0) : frame.stretch[at(node)];
    };
    const Mat3 straight = stretchAt(start) * (1.0 - t) + stretchAt(end) * t;
    const Mat3 difference = straight - stretchAt(time);
    for (std::size_t column = 0; column < 3; ++column) {
      miss = std::max(miss, glm::length(difference[column]) * keys.trail->limb.restLength /
                                static_cast<double>(keys.trail->limb.joints.size()));
    }
  }
  return miss;
}

// Adds keys where a span is missed by most until all of it is within the tolerance.
void refine(ExactMotion& exact, const TrailKeys& keys, double tolerance, double start, double end,
            std::vector<double>& added) {
  double worstMiss = tolerance;
  double worstTime = 0.0;
  for (const double time : checkTimes(exact.motion().framesPerSecond, start, end)) {
    const double miss = missAt(exact, keys, start, end, time);
    if (miss > worstMiss) {
      worstMiss = miss;
      worstTime = time;
    }
  }
  if (worstMiss > tolerance) {
    refine(exact, keys, tolerance, start, worstTime, added);
    added.push_back(worstTime);
    refine(exact, keys, tolerance, worstTime, end, added);
  }
}

} // namespace

Vec4 slopeOf(ExactMotion& exact, const ChangedChannel& channel, double timeSeconds, int side) {
  const double step = 0.05 / exact.motion().framesPerSecond;
  const double before = side > 0 ? timeSeconds : timeSeconds - step;
  const double after = side < 0 ? timeSeconds : timeSeconds + step;
  const Vec4 a = channelValue(exact.at(before).pose, channel.node, channel.channel);
  Vec4 b = channelValue(exact.at(after).pose, channel.node, channel.channel);
  if (channel.channel == Channel::rotation) {
    b = alongShorterArc(a, b);
  }
  return (b - a) / (after - before);
}

TrailKeys chooseKeys(ExactMotion& exact, const SolvedTrail& trail, const RekeyOptions& options) {
  TrailKeys keys;
  keys.trail = &trail;
  keys.windows = windowsOf(exact.motion(), trail);
  findChanges(exact, keys);
  for (const Window& window : keys.windows) {
    const std::vector<double> first =
        firstTimes(window, keys, exact.motion().framesPerSecond, options.keyEveryFrame);
    std::vector<double> times{first.front()};
    for (std::size_t i = 1; i < first.size(); ++i) {
      refine(exact, keys, options.tolerance, first[i - 1], first[i], times);
      times.push_back(first[i]);
    }
    keys.times.push_back(std::move(times));
  }
  return keys;
}

} // namespace stretch::rig

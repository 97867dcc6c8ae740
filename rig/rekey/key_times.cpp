#include "rig/rekey/key_times.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "rig/rekey/span_fit.h"

namespace stretch::rig {

namespace {

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

bool isCubicSource(const ChangedChannel& channel) {
  return channel.source != nullptr && channel.source->interpolation == Interpolation::cubicSpline;
}

void findChanges(ExactMotion& exact, TrailKeys& keys) {
  const std::vector<double> times = allTimes(exact, keys.windows);
  for (const int node : touchedNodes(keys.trail->limb, keys.trail->topology)) {
    for (const Channel channel : {Channel::translation, Channel::rotation, Channel::scale}) {
      if (isChanged(exact, times, node, channel)) {
        keys.channels.push_back({node, channel, trackOf(exact.clip(), node, channel), false});
      }
    }
    if (isStretched(exact, times, node)) {
      keys.stretchedNodes.push_back(node);
    }
  }
  const bool anyCubic = std::any_of(keys.channels.begin(), keys.channels.end(), isCubicSource);
  for (ChangedChannel& channel : keys.channels) {
    channel.isCubic = channel.source == nullptr ? anyCubic : isCubicSource(channel);
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

// How far a node, and the mesh that follows it, is from where it should be.
double nodeMiss(const Mat4& world, const Mat4& wanted, double reach) {
  const Mat4 difference = world - wanted;
  double turned = 0.0;
  for (int column = 0; column < 3; ++column) {
    const Vec3 axis(difference[column]);
    turned += glm::dot(axis, axis);
  }
  // Of a turn by a small angle the squares of the three axes' ways add up to twice the angle's.
  return glm::length(Vec3(difference[3])) + reach * std::sqrt(0.5 * turned);
}

// How far the joints are from the exact motion where the channels run along these spans.
double jointMiss(ExactMotion& exact, const TrailKeys& keys, const std::vector<ChannelSpan>& spans,
                 double time) {
  const FrameState& wanted = exact.at(time);
  Pose pose = wanted.pose;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const ChangedChannel& channel = keys.channels[i];
    setChannelValue(pose, channel.node, channel.channel, spans[i].at(channel.channel, time));
  }
  const std::vector<Mat4> worlds = worldMatrices(exact.scene(), pose);
  double miss = 0.0;
  for (std::size_t node = 0; node < worlds.size(); ++node) {
    miss = std::max(miss, nodeMiss(worlds[node], wanted.worlds[node], exact.reachOf(node)));
  }
  return miss;
}

Mat3 stretchAt(ExactMotion& exact, int node, double time) {
  const FrameState& frame = exact.at(time);
  return frame.stretch.empty() ? Mat3(1.0) : frame.stretch[at(node)];
}

// How far the end of a bone is moved where its stretch runs straight between two keys.
double stretchMiss(ExactMotion& exact, const TrailKeys& keys, double start, double end, double time) {
  const Limb& limb = keys.trail->limb;
  const double boneLength = limb.restLength / static_cast<double>(limb.joints.size());
  const double t = (time - start) / (end - start);
  double miss = 0.0;
  for (const int node : keys.stretchedNodes) {
    const Mat3 straight = stretchAt(exact, node, start) * (1.0 - t) + stretchAt(exact, node, end) * t;
    const Mat3 difference = straight - stretchAt(exact, node, time);
    for (std::size_t column = 0; column < 3; ++column) {
      miss = std::max(miss, glm::length(difference[column]) * boneLength);
    }
  }
  return miss;
}

// The whole frame beside a half frame that is missed by more, if the span has one inside: animators key whole
// frames, and readers guess the frame rate from the keys.
template <typename MissAt>
double onWholeFrame(const MissAt& missAt, double framesPerSecond, double start, double end, double time) {
  double best = time;
  double bestMiss = -1.0;
  const double frame = time * framesPerSecond;
  for (const double whole : {std::floor(frame + 1e-3), std::ceil(frame - 1e-3)}) {
    const double candidate = asKeyTime(whole / framesPerSecond);
    if (candidate > start + sameKey && candidate < end - sameKey && missAt(candidate) > bestMiss) {
      best = candidate;
      bestMiss = missAt(candidate);
    }
  }
  return best;
}

// Adds keys where a span is missed by most until all of it is within the tolerance. `missOf(start, end)`
// answers the miss of the span from start to end as a function of time.
template <typename MissOf>
void refine(const MissOf& missOf, double framesPerSecond, double tolerance, double start, double end,
            std::vector<double>& added) {
  const auto missAt = missOf(start, end);
  double worstMiss = tolerance;
  double worstTime = 0.0;
  for (const double time : checkTimes(framesPerSecond, start, end)) {
    const double miss = missAt(time);
    if (miss > worstMiss) {
      worstMiss = miss;
      worstTime = time;
    }
  }
  if (worstMiss > tolerance) {
    const double key = onWholeFrame(missAt, framesPerSecond, start, end, worstTime);
    refine(missOf, framesPerSecond, tolerance, start, key, added);
    added.push_back(key);
    refine(missOf, framesPerSecond, tolerance, key, end, added);
  }
}

template <typename MissOf>
std::vector<double> refined(const MissOf& missOf, double framesPerSecond, double tolerance,
                            const std::vector<double>& first) {
  std::vector<double> times{first.front()};
  for (std::size_t i = 1; i < first.size(); ++i) {
    refine(missOf, framesPerSecond, tolerance, first[i - 1], first[i], times);
    times.push_back(first[i]);
  }
  return times;
}

} // namespace

TrailKeys chooseKeys(ExactMotion& exact, const SolvedTrail& trail, const RekeyOptions& options) {
  TrailKeys keys;
  keys.trail = &trail;
  keys.windows = windowsOf(exact.motion(), trail);
  findChanges(exact, keys);
  const auto missOfJoints = [&](double start, double end) {
    std::vector<ChannelSpan> spans;
    for (const ChangedChannel& channel : keys.channels) {
      spans.push_back(fitSpan(exact, channel, start, end));
    }
    return [&exact, &keys, spans = std::move(spans)](double time) {
      return jointMiss(exact, keys, spans, time);
    };
  };
  const auto missOfStretch = [&](double start, double end) {
    return [&exact, &keys, start, end](double time) { return stretchMiss(exact, keys, start, end, time); };
  };
  const double framesPerSecond = exact.motion().framesPerSecond;
  for (const Window& window : keys.windows) {
    const std::vector<double> first = firstTimes(window, keys, framesPerSecond, options.keyEveryFrame);
    keys.times.push_back(refined(missOfJoints, framesPerSecond, options.tolerance, first));
    keys.stretchTimes.push_back(refined(missOfStretch, framesPerSecond, options.tolerance, first));
  }
  return keys;
}

} // namespace stretch::rig

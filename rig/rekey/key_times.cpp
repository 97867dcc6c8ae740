#include "rig/rekey/key_times.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/index.h"
#include "rig/rekey/span_fit.h"
#include "rig/rekey/stretch_build.h"

namespace stretch::rig {

namespace {

const Track* trackOf(const Clip& clip, NodeIndex node, Channel channel) {
  const int index = findTrack(clip, node, channel);
  return index < 0 ? nullptr : &*clip.tracks[at(index)];
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

bool isStretch(const Mat3& stretch) {
  constexpr double negligible = 1e-9;
  const Mat3 difference = stretch - Mat3(1.0);
  return glm::length(difference[0]) + glm::length(difference[1]) + glm::length(difference[2]) > negligible;
}

bool isCubicSource(const ChangedChannel& channel) {
  return channel.source != nullptr && channel.source->interpolation == Interpolation::cubicSpline;
}

// What of a node a part changes.
struct NodeChanges {
  std::array<bool, 3> channels{}; // translation, rotation, scale
  bool stretches = false;

  [[nodiscard]] bool all() const { return channels[0] && channels[1] && channels[2] && stretches; }
};

constexpr std::array transformChannels{Channel::translation, Channel::rotation, Channel::scale};

void compare(const FrameState& frame, const Pose& source, NodeIndex node, NodeChanges& changes) {
  for (std::size_t i = 0; i < transformChannels.size(); ++i) {
    const Channel channel = transformChannels[i];
    changes.channels[i] = changes.channels[i] || differs(channelValue(frame.pose, node, channel),
                                                         channelValue(source, node, channel), channel);
  }
  changes.stretches = changes.stretches || (!frame.stretch.empty() && isStretch(frame.stretch[at(node)]));
}

// One walk through the times for all nodes: a long clip is not remembered as a whole.
std::vector<NodeChanges> changesOf(ExactMotion& exact, const KeyedPart& part) {
  std::vector<NodeChanges> changes(part.nodes.size());
  for (const double time : allTimes(exact, part.windows)) {
    const FrameState& frame = exact.at(time);
    const Pose& source = exact.sourceAt(time);
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      if (!changes[i].all()) {
        compare(frame, source, part.nodes[i], changes[i]);
      }
    }
  }
  return changes;
}

void findChanges(ExactMotion& exact, PartKeys& keys) {
  const std::vector<NodeChanges> changes = changesOf(exact, *keys.part);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const NodeIndex node = keys.part->nodes[i];
    for (std::size_t c = 0; c < transformChannels.size(); ++c) {
      const Channel channel = transformChannels[c];
      if (changes[i].channels[c]) {
        keys.channels.push_back({node, channel, trackOf(exact.clip(), node, channel), false});
      }
    }
    if (changes[i].stretches) {
      keys.stretchedNodes.push_back(node);
    }
  }
  const bool anyCubic = std::any_of(keys.channels.begin(), keys.channels.end(), isCubicSource);
  for (ChangedChannel& channel : keys.channels) {
    channel.isCubic = channel.source == nullptr ? anyCubic : isCubicSource(channel);
  }
}

// Key times of the source win over times of ours that are almost the same.
std::vector<double> firstTimes(const Window& window, const PartKeys& keys, double framesPerSecond,
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
  std::vector<double> wanted = keys.part->keySeconds;
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
double jointMiss(ExactMotion& exact, const PartKeys& keys, const std::vector<ChannelSpan>& spans,
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

// How far the end of a bone is moved where its stretch runs between two keys as a player plays them.
class StretchSpan {
public:
  StretchSpan(ExactMotion& exact, const PartKeys& keys, const FramesOfNodes& frames, double start, double end)
      : exact_(exact), keys_(keys), start_(start), end_(end) {
    for (const NodeIndex node : keys.stretchedNodes) {
      const StretchFrames& ofNode = frames.at(node);
      ends_.emplace_back(ofNode.at(exact, start), ofNode.at(exact, end));
    }
  }

  [[nodiscard]] double missAt(double time) const {
    const FrameState& frame = exact_.at(time);
    double miss = 0.0;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const Mat3 wanted = frame.stretch.empty() ? Mat3(1.0) : frame.stretch[at(keys_.stretchedNodes[i])];
      const Mat3 difference =
          between(ends_[i].first, ends_[i].second, (time - start_) / (end_ - start_)) - wanted;
      for (int column = 0; column < 3; ++column) {
        miss = std::max(miss, glm::length(difference[column]) * keys_.part->boneLength);
      }
    }
    return miss;
  }

private:
  ExactMotion& exact_;
  const PartKeys& keys_;
  double start_ = 0.0;
  double end_ = 0.0;
  std::vector<std::pair<StretchFrame, StretchFrame>> ends_;
};

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

// The stretches of a node at its times, gathered on one walk through the times of all nodes.
struct SeenStretches {
  std::vector<double> times;
  std::vector<Mat3> stretches; // empty as long as there is none
  std::size_t next = 0;
  bool any = false;

  void look(const FrameState& frame, NodeIndex node, double time) {
    if (next >= times.size() || times[next] != time) {
      return;
    }
    ++next;
    const Mat3 stretch = frame.stretch.empty() ? Mat3(1.0) : frame.stretch[at(node)];
    if (!any && isStretch(stretch)) {
      any = true;
      stretches.assign(next - 1, Mat3(1.0));
    }
    if (any) {
      stretches.push_back(stretch);
    }
  }
};

} // namespace

FramesOfNodes framesOfNodes(ExactMotion& exact, const std::vector<KeyedPart>& parts) {
  std::map<NodeIndex, std::vector<double>> timesOfNodes;
  for (const KeyedPart& part : parts) {
    const std::vector<double> times = allTimes(exact, part.windows);
    for (const NodeIndex node : part.nodes) {
      std::vector<double>& ofNode = timesOfNodes[node];
      ofNode.insert(ofNode.end(), times.begin(), times.end());
      const std::vector<double> brought = sourceStretchTimes(exact, node);
      ofNode.insert(ofNode.end(), brought.begin(), brought.end());
    }
  }
  std::map<NodeIndex, SeenStretches> seen;
  std::vector<double> walk;
  for (auto& [node, times] : timesOfNodes) {
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    std::vector<double> both;
    std::set_union(walk.begin(), walk.end(), times.begin(), times.end(), std::back_inserter(both));
    walk = std::move(both);
    seen[node].times = std::move(times);
  }
  for (const double time : walk) {
    const FrameState& frame = exact.at(time);
    for (auto& [node, stretches] : seen) {
      stretches.look(frame, node, time);
    }
  }
  FramesOfNodes frames;
  for (auto& [node, stretches] : seen) {
    if (stretches.any) {
      frames.emplace(node, StretchFrames(node, std::move(stretches.times), stretches.stretches));
    }
  }
  return frames;
}

PartKeys chooseKeys(ExactMotion& exact, const KeyedPart& part, const FramesOfNodes& frames,
                    const RekeyOptions& options) {
  PartKeys keys;
  keys.part = &part;
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
    return [span = StretchSpan(exact, keys, frames, start, end)](double time) { return span.missAt(time); };
  };
  const double framesPerSecond = exact.motion().framesPerSecond;
  for (const Window& window : part.windows) {
    const std::vector<double> first = firstTimes(window, keys, framesPerSecond, options.keyEveryFrame);
    keys.times.push_back(refined(missOfJoints, framesPerSecond, options.tolerance, first));
    keys.stretchTimes.push_back(refined(missOfStretch, framesPerSecond, options.tolerance, first));
  }
  return keys;
}

} // namespace stretch::rig

#include "rig/rekey/key_times.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "core/base/index.h"
#include "rig/rekey/joint_check.h"
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

// A span is looked at again for every key that it gets, so a long one is cut: what is looked at together is
// remembered together.
std::vector<double> withoutLongSpans(const std::vector<double>& times, double framesPerSecond) {
  constexpr double longest = 500.0; // frames
  std::vector<double> cut{times.front()};
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double length = (times[i] - times[i - 1]) * framesPerSecond;
    const double frames = std::ceil(length / std::ceil(length / longest));
    for (double frame = std::floor(times[i - 1] * framesPerSecond) + frames;
         length > longest && frame / framesPerSecond < times[i] - sameKey; frame += frames) {
      cut.push_back(asKeyTime(frame / framesPerSecond));
    }
    cut.push_back(times[i]);
  }
  return cut;
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
  return withoutLongSpans(times, framesPerSecond);
}

// The two keys of each jump, in place of a key that is as good as one of them.
void addJumps(const KeyedPart& part, const Window& window, std::vector<double>& times) {
  const auto isWithin = [&](double time) { return time > window.startSeconds && time < window.endSeconds; };
  for (const JumpInside& jump : part.jumps) {
    std::erase_if(
        times, [&](double time) { return isWithin(time) && std::abs(time - jump.insideSeconds) < sameKey; });
    for (const double time : {jump.insideSeconds, jump.besideSeconds}) {
      if (isWithin(time)) {
        times.insert(std::ranges::lower_bound(times, time), time);
      }
    }
  }
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
  for (const double whole : {wholeFrameAtMost(frame), wholeFrameAtLeast(frame)}) {
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

// The ascending keys of a span, its end among them, with those added that need the grid of frames this many
// times shorter; a span of more than so many frames is taken as it is.
template <typename MissOf>
std::vector<double> refined(const MissOf& missOf, double framesPerSecond, double tolerance, double mostFrames,
                            double start, const std::vector<double>& keys) {
  std::vector<double> all;
  for (const double key : keys) {
    if ((key - start) * framesPerSecond <= mostFrames) {
      refine(missOf, framesPerSecond, tolerance, start, key, all);
    }
    all.push_back(key);
    start = key;
  }
  return all;
}

// The keys of a span, its end among them. Frames and halves are right to the tolerance. A player that shows
// more pictures than the clip has frames asks between these as well, where a limb that comes to its full
// length turns fast: spans that are off by a few tolerances at eighths of a frame get further keys, and what
// is cut to eighths is looked at once more in between.
template <typename MissOf>
std::vector<double> keysInside(const MissOf& missOf, double framesPerSecond, double tolerance, double start,
                               double end) {
  constexpr double few = 8.0;
  constexpr double anyLength = std::numeric_limits<double>::infinity();
  const std::vector<double> halves = refined(missOf, framesPerSecond, tolerance, anyLength, start, {end});
  const std::vector<double> eighths =
      refined(missOf, 4.0 * framesPerSecond, few * tolerance, anyLength, start, halves);
  return refined(missOf, 32.0 * framesPerSecond, few * tolerance, 5.0, start, eighths);
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
  JointCheck check(exact, keys);
  const auto missOfJoints = [&](double start, double end) {
    std::vector<ChannelSpan> spans;
    for (const ChangedChannel& channel : keys.channels) {
      spans.push_back(fitSpan(exact, channel, start, end));
    }
    return [&check, &keys, spans = std::move(spans)](double time) { return check.missAt(keys, spans, time); };
  };
  const auto missOfStretch = [&](double start, double end) {
    return [span = StretchSpan(exact, keys, frames, start, end)](double time) { return span.missAt(time); };
  };
  const double framesPerSecond = exact.motion().framesPerSecond;
  for (const Window& window : part.windows) {
    const std::vector<double> first = firstTimes(window, keys, framesPerSecond, options.keyEveryFrame);
    std::vector<double> times{first.front()};
    std::vector<double> stretchTimes{first.front()};
    for (std::size_t i = 1; i < first.size(); ++i) {
      std::ranges::copy(keysInside(missOfJoints, framesPerSecond, options.tolerance, first[i - 1], first[i]),
                        std::back_inserter(times));
      std::ranges::copy(keysInside(missOfStretch, framesPerSecond, options.tolerance, first[i - 1], first[i]),
                        std::back_inserter(stretchTimes));
    }
    addJumps(part, window, times);
    addJumps(part, window, stretchTimes);
    keys.times.push_back(std::move(times));
    keys.stretchTimes.push_back(std::move(stretchTimes));
  }
  return keys;
}

} // namespace stretch::rig

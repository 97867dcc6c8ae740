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

void setChanges(const ExactMotion& exact, const std::vector<NodeChanges>& changes, PartKeys& keys) {
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
                               KeyPlaces places) {
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
       places == KeyPlaces::everyFrame && frame / framesPerSecond < window.endSeconds; frame += 1.0) {
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

// What keys are chosen by.
struct KeyRule {
  double framesPerSecond = 30.0;
  double tolerance = 0.0;
  bool onWholeFrames = false; ///< A key that would lie between whole frames is not made; the miss is noted.
};

bool isWholeFrame(const KeyRule& rule, double time) {
  const double frame = time * rule.framesPerSecond;
  return std::abs(frame - std::round(frame)) < frameTolerance;
}

// Adds keys where a span is missed by most until all of it is within the tolerance, and answers what is
// missed all the same. `missOf(start, end)` answers the miss of the span from start to end as a function of
// time.
template <typename MissOf>
double refine(const MissOf& missOf, const KeyRule& rule, double start, double end,
              std::vector<double>& added) {
  const auto missAt = missOf(start, end);
  double worstMiss = rule.tolerance;
  double worstTime = 0.0;
  for (const double time : checkTimes(rule.framesPerSecond, start, end)) {
    const double miss = missAt(time);
    if (miss > worstMiss) {
      worstMiss = miss;
      worstTime = time;
    }
  }
  if (worstMiss <= rule.tolerance) {
    return 0.0;
  }
  const double key = onWholeFrame(missAt, rule.framesPerSecond, start, end, worstTime);
  if (rule.onWholeFrames && !isWholeFrame(rule, key)) {
    return worstMiss;
  }
  const double before = refine(missOf, rule, start, key, added);
  added.push_back(key);
  return std::max(before, refine(missOf, rule, key, end, added));
}

// The ascending keys of a span, its end among them, with those added that need the grid of frames of the
// rule; a span of more than so many frames is taken as it is.
template <typename MissOf>
std::vector<double> refined(const MissOf& missOf, const KeyRule& rule, double mostFrames, double start,
                            const std::vector<double>& keys) {
  std::vector<double> all;
  for (const double key : keys) {
    if ((key - start) * rule.framesPerSecond <= mostFrames) {
      refine(missOf, rule, start, key, all);
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
std::vector<double> keysInside(const MissOf& missOf, const KeyRule& rule, double start, double end) {
  constexpr double few = 8.0;
  constexpr double anyLength = std::numeric_limits<double>::infinity();
  const auto finer = [&](double parts) {
    return KeyRule{parts * rule.framesPerSecond, few * rule.tolerance, false};
  };
  const std::vector<double> halves = refined(missOf, rule, anyLength, start, {end});
  const std::vector<double> eighths = refined(missOf, finer(4.0), anyLength, start, halves);
  return refined(missOf, finer(32.0), 5.0, start, eighths);
}

// Ascending times of a longer walk at which something is looked at.
class Visits {
public:
  explicit Visits(std::vector<double> times) : times_(std::move(times)) {
    std::ranges::sort(times_);
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
  }

  /// Whether a time of the walk, which ascends, is one of them.
  [[nodiscard]] bool take(double time) {
    const bool isThere = taken_ < times_.size() && times_[taken_] == time;
    taken_ += isThere ? 1 : 0;
    return isThere;
  }
  [[nodiscard]] std::size_t taken() const { return taken_; }
  [[nodiscard]] const std::vector<double>& times() const { return times_; }

private:
  std::vector<double> times_;
  std::size_t taken_ = 0;
};

// What a part changes of its nodes.
struct SeenChanges {
  const KeyedPart* part = nullptr;
  Visits visits;
  std::vector<NodeChanges> changes;

  void look(ExactMotion& exact, double time) {
    if (!visits.take(time) || std::ranges::all_of(changes, &NodeChanges::all)) {
      return;
    }
    const FrameState& frame = exact.at(time);
    const Pose& source = exact.sourceAt(time);
    for (std::size_t i = 0; i < changes.size(); ++i) {
      if (!changes[i].all()) {
        compare(frame, source, part->nodes[i], changes[i]);
      }
    }
  }
};

// The stretches of a node at its times.
struct SeenStretches {
  Visits visits;
  std::vector<Mat3> stretches = {}; // empty as long as there is none

  void look(ExactMotion& exact, NodeIndex node, double time) {
    if (!visits.take(time)) {
      return;
    }
    const FrameState& frame = exact.at(time);
    const Mat3 stretch = frame.stretch.empty() ? Mat3(1.0) : frame.stretch[at(node)];
    if (stretches.empty() && isStretch(stretch)) {
      stretches.assign(visits.taken() - 1, Mat3(1.0));
      stretches.push_back(stretch);
    } else if (!stretches.empty()) {
      stretches.push_back(stretch);
    }
  }
};

// What all parts change, seen on one walk through the times of all of them: a long clip is not remembered as
// a whole.
class SeenMotion {
public:
  SeenMotion(ExactMotion& exact, const std::vector<KeyedPart>& parts) {
    std::map<NodeIndex, std::vector<double>> timesOfNodes;
    for (const KeyedPart& part : parts) {
      const std::vector<double> times = allTimes(exact, part.windows);
      for (const NodeIndex node : part.nodes) {
        std::vector<double>& ofNode = timesOfNodes[node];
        ofNode.insert(ofNode.end(), times.begin(), times.end());
        const std::vector<double> brought = sourceStretchTimes(exact, node);
        ofNode.insert(ofNode.end(), brought.begin(), brought.end());
      }
      parts_.push_back({&part, Visits(times), std::vector<NodeChanges>(part.nodes.size())});
      addToWalk(parts_.back().visits.times());
    }
    for (auto& [node, times] : timesOfNodes) {
      const auto [seen, isNew] = nodes_.emplace(node, SeenStretches{Visits(std::move(times))});
      addToWalk(seen->second.visits.times());
    }
    for (const double time : walk_) {
      for (SeenChanges& part : parts_) {
        part.look(exact, time);
      }
      for (auto& [node, stretches] : nodes_) {
        stretches.look(exact, node, time);
      }
    }
  }

  [[nodiscard]] const std::vector<SeenChanges>& parts() const { return parts_; }
  /// Forgets the stretches that they are told from.
  [[nodiscard]] FramesOfNodes takeFrames() {
    FramesOfNodes frames;
    for (auto& [node, seen] : nodes_) {
      if (!seen.stretches.empty()) {
        frames.emplace(node, StretchFrames(node, seen.visits.times(), seen.stretches));
      }
      seen = SeenStretches{Visits({})};
    }
    return frames;
  }

private:
  void addToWalk(const std::vector<double>& times) {
    std::vector<double> both;
    std::ranges::set_union(walk_, times, std::back_inserter(both));
    walk_ = std::move(both);
  }

  std::vector<double> walk_;
  std::vector<SeenChanges> parts_;
  std::map<NodeIndex, SeenStretches> nodes_;
};

// The keys of one part, chosen span by span.
class PartChooser {
public:
  PartChooser(ExactMotion& exact, const FramesOfNodes& frames, const RekeyOptions& options,
              const SeenChanges& seen)
      : exact_(exact), frames_(frames), options_(options), keys_(keysOf(exact, seen)), check_(exact, keys_) {
    openWindow();
  }

  /// Where the next span starts, seconds; endless after the last.
  [[nodiscard]] double nextSeconds() const {
    return isDone() ? std::numeric_limits<double>::infinity() : first_[next_ - 1];
  }
  [[nodiscard]] bool isDone() const { return window_ == keys_.part->windows.size(); }
  [[nodiscard]] PartKeys take() { return std::move(keys_); }
  [[nodiscard]] double largestMiss() const { return largestMiss_; }

  void chooseNext() {
    const auto missOfJoints = [&](double start, double end) {
      std::vector<ChannelSpan> spans;
      for (const ChangedChannel& channel : keys_.channels) {
        spans.push_back(fitSpan(exact_, channel, start, end));
      }
      return [this, spans = std::move(spans)](double time) { return check_.missAt(keys_, spans, time); };
    };
    const auto missOfStretch = [&](double start, double end) {
      return
          [span = StretchSpan(exact_, keys_, frames_, start, end)](double time) { return span.missAt(time); };
    };
    addKeys(missOfJoints, keys_.times.back());
    addKeys(missOfStretch, keys_.stretchTimes.back());
    if (++next_ == first_.size()) {
      closeWindow();
      openWindow();
    }
  }

private:
  static PartKeys keysOf(const ExactMotion& exact, const SeenChanges& seen) {
    PartKeys keys;
    keys.part = seen.part;
    setChanges(exact, seen.changes, keys);
    return keys;
  }

  template <typename MissOf>
  void addKeys(const MissOf& missOf, std::vector<double>& times) {
    const double start = first_[next_ - 1];
    const double end = first_[next_];
    const KeyRule rule{framesPerSecond(), options_.tolerance, options_.places == KeyPlaces::wholeFrames};
    if (!rule.onWholeFrames) {
      std::ranges::copy(keysInside(missOf, rule, start, end), std::back_inserter(times));
      return;
    }
    largestMiss_ = std::max(largestMiss_, refine(missOf, rule, start, end, times));
    times.push_back(end);
  }

  // The next window that has a span.
  void openWindow() {
    for (; !isDone(); closeWindow()) {
      first_ = firstTimes(keys_.part->windows[window_], keys_, framesPerSecond(), options_.places);
      keys_.times.push_back({first_.front()});
      keys_.stretchTimes.push_back({first_.front()});
      next_ = 1;
      if (next_ < first_.size()) {
        return;
      }
    }
  }

  void closeWindow() {
    addJumps(*keys_.part, keys_.part->windows[window_], keys_.times.back());
    addJumps(*keys_.part, keys_.part->windows[window_], keys_.stretchTimes.back());
    ++window_;
  }

  [[nodiscard]] double framesPerSecond() const { return exact_.motion().framesPerSecond; }

  ExactMotion& exact_;
  const FramesOfNodes& frames_;
  const RekeyOptions& options_;
  PartKeys keys_;
  JointCheck check_;
  std::size_t window_ = 0;
  std::vector<double> first_; // ends of the spans of that window
  std::size_t next_ = 1;      // end of the next span
  double largestMiss_ = 0.0;
};

} // namespace

ChosenKeys chooseKeys(ExactMotion& exact, const std::vector<KeyedPart>& parts, const RekeyOptions& options) {
  SeenMotion seen(exact, parts);
  ChosenKeys chosen{{}, seen.takeFrames()};
  std::vector<PartChooser> choosers;
  choosers.reserve(parts.size());
  for (const SeenChanges& part : seen.parts()) {
    choosers.emplace_back(exact, chosen.frames, options, part);
  }
  while (!choosers.empty()) {
    PartChooser& first = *std::ranges::min_element(choosers, {}, &PartChooser::nextSeconds);
    if (first.isDone()) {
      break;
    }
    first.chooseNext();
  }
  chosen.parts.reserve(choosers.size());
  for (PartChooser& chooser : choosers) {
    chosen.largestMiss = std::max(chosen.largestMiss, chooser.largestMiss());
    chosen.parts.push_back(chooser.take());
  }
  return chosen;
}

} // namespace stretch::rig

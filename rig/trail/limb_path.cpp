#include "rig/trail/limb_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <span>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rig/limb.h"

namespace stretch::rig {

namespace {

constexpr double sameTime = 1e-6; // seconds

// The nodes, and the leaves that give them their stretch.
std::vector<NodeIndex> withLeaves(const std::vector<BindChain>& chains, std::vector<NodeIndex> nodes) {
  for (const BindChain& chain : chains) {
    std::ranges::copy(chain.nodes(), std::back_inserter(nodes));
  }
  return nodes;
}

std::vector<BindChain> chainsOf(const Scene& scene, const std::vector<NodeIndex>& nodes) {
  std::vector<BindChain> chains;
  std::copy_if(scene.bindChains.begin(), scene.bindChains.end(), std::back_inserter(chains),
               [&](const BindChain& chain) {
                 return std::find(nodes.begin(), nodes.end(), chain.joint) != nodes.end();
               });
  return chains;
}

std::vector<NodeIndex> withAncestors(const Scene& scene, const std::vector<NodeIndex>& nodes) {
  std::set<NodeIndex> wanted;
  for (NodeIndex node : nodes) {
    for (; node.exists() && wanted.insert(node).second; node = scene.nodes[at(node)].parent) {
    }
  }
  std::vector<NodeIndex> ordered;
  for (const NodeIndex node : parentsFirst(scene)) {
    if (wanted.count(node) != 0) {
      ordered.push_back(node);
    }
  }
  return ordered;
}

void mergeClose(std::vector<double>& times) {
  if (!std::is_sorted(times.begin(), times.end())) {
    std::sort(times.begin(), times.end());
  }
  times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < sameTime; }),
              times.end());
}

bool isOfNodes(const Track& track, const std::vector<NodeIndex>& nodes) {
  return track.channel != Channel::weights &&
         std::find(nodes.begin(), nodes.end(), track.node) != nodes.end();
}

std::span<const float> keysWithin(const Track& track, double startSeconds, double endSeconds) {
  const std::vector<float>& keys = track.times;
  const auto first = std::lower_bound(keys.begin(), keys.end(), startSeconds - sameTime);
  return {first, std::upper_bound(first, keys.end(), endSeconds + sameTime)};
}

std::size_t keyCountOf(const Track& track, double startSeconds, double endSeconds) {
  std::size_t count = 0;
  double last = -std::numeric_limits<double>::infinity();
  for (const double key : keysWithin(track, startSeconds, endSeconds)) {
    if (key - last >= sameTime) {
      last = key;
      ++count;
    }
  }
  return count;
}

// The original path as its trail's space has it.
struct SpacePath {
  std::vector<Vec3> points;
  std::vector<double> seconds;
};

SpacePath inSpace(const LimbPath& path) {
  SpacePath seen;
  for (const LimbSample& sample : path.samples) {
    seen.points.push_back(path.toSpace(sample, sample.end));
    seen.seconds.push_back(sample.timeSeconds);
  }
  return seen;
}

// Cubic through control points of the path, tangents by three points: what an animator's few keys would give.
Vec3 cubicThrough(const SpacePath& path, const std::vector<std::size_t>& controls, std::size_t piece,
                  double time) {
  const auto point = [&](std::size_t c) { return path.points[controls[c]]; };
  const auto seconds = [&](std::size_t c) { return path.seconds[controls[c]]; };
  const auto secant = [&](std::size_t c) {
    return (point(c + 1) - point(c)) / (seconds(c + 1) - seconds(c));
  };
  // Of the parabola through three neighbours, however they are spaced; one-sided at the ends.
  const auto slope = [&](std::size_t c) {
    if (c == 0 || c + 1 == controls.size()) {
      return secant(c == 0 ? 0 : c - 1);
    }
    const double before = seconds(c) - seconds(c - 1);
    const double after = seconds(c + 1) - seconds(c);
    return (secant(c - 1) * after + secant(c) * before) / (before + after);
  };
  const double h = seconds(piece + 1) - seconds(piece);
  const double t = (time - seconds(piece)) / h;
  const double t2 = t * t;
  const double t3 = t2 * t;
  return point(piece) * (2 * t3 - 3 * t2 + 1) + slope(piece) * (h * (t3 - 2 * t2 + t)) +
         point(piece + 1) * (3 * t2 - 2 * t3) + slope(piece + 1) * (h * (t3 - t2));
}

// Indices of both ends and of the extremes of each coordinate.
std::vector<std::size_t> extremes(const SpacePath& path) {
  std::vector<std::size_t> found{0, path.points.size() - 1};
  for (int axis = 0; axis < 3; ++axis) {
    const auto less = [&](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; };
    const auto [low, high] = std::minmax_element(path.points.begin(), path.points.end(), less);
    found.push_back(static_cast<std::size_t>(low - path.points.begin()));
    found.push_back(static_cast<std::size_t>(high - path.points.begin()));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

// The sample that the cubic misses by most, and by how much.
std::pair<std::size_t, double> worstSample(const SpacePath& path, const std::vector<std::size_t>& controls) {
  std::pair<std::size_t, double> worst{0, 0.0};
  for (std::size_t piece = 0; piece + 1 < controls.size(); ++piece) {
    for (std::size_t i = controls[piece] + 1; i < controls[piece + 1]; ++i) {
      const double miss = glm::length(path.points[i] - cubicThrough(path, controls, piece, path.seconds[i]));
      if (miss > worst.second) {
        worst = {i, miss};
      }
    }
  }
  return worst;
}

// The samples on frames of a rate, and the two ends.
LimbPath onFramesOf(const LimbPath& path, double framesPerSecond) {
  LimbPath counted = path;
  const double start = path.samples.front().timeSeconds;
  const double end = path.samples.back().timeSeconds;
  std::erase_if(counted.samples, [&](const LimbSample& sample) {
    const double time = sample.timeSeconds;
    const double frame = std::round(time * framesPerSecond) / framesPerSecond;
    return std::abs(time - frame) >= sameTime && time > start && time < end;
  });
  return counted;
}

bool isDenseAt(const Clip& clip, std::size_t keyCount, double framesPerSecond) {
  return isDenselyKeyed(keyCount, clip.startSeconds, clip.endSeconds, framesPerSecond);
}

// The keys of all these tracks; of one track alone that is dense as frames are counted: those of a long
// capture are not merged for this.
std::size_t keyCountOf(const Clip& clip, const std::vector<NodeIndex>& nodes) {
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    const std::size_t count =
        isOfNodes(*track, nodes) ? keyCountOf(*track, clip.startSeconds, clip.endSeconds) : 0;
    if (isDenseAt(clip, count, clip.framesPerSecond)) {
      return count;
    }
  }
  return keyTimesOf(clip, nodes, clip.startSeconds, clip.endSeconds).size();
}

double keyRateOf(const Clip& clip, std::size_t keyCount) {
  constexpr double lowest = 8.0; // that a file's keys may tell
  const bool mayBeLower =
      !isDenseAt(clip, keyCount, clip.framesPerSecond) && isDenseAt(clip, keyCount, lowest);
  return mayBeLower ? std::min(clip.framesPerSecond, guessFramesPerSecond(clip.tracks))
                    : clip.framesPerSecond;
}

} // namespace

NodeSampler::NodeSampler(const Scene& scene, const Clip& clip, const std::vector<NodeIndex>& nodes)
    : scene_(&scene), chains_(chainsOf(scene, nodes)) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> stepOf(scene.nodes.size(), none);
  for (const NodeIndex node : withAncestors(scene, withLeaves(chains_, nodes))) {
    stepOf[at(node)] = steps_.size();
    steps_.push_back({node, {}});
  }
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    const std::size_t step = stepOf[at(track->node)];
    if (step != none && track->channel != Channel::weights) {
      steps_[step].tracks.push_back(&*track);
    }
  }
}

Transform NodeSampler::localAt(const Step& step, double timeSeconds) const {
  Transform transform = scene_->nodes[at(step.node)].rest;
  for (const Track* track : step.tracks) {
    std::array<double, 4> value{};
    sampleTrack(*track, timeSeconds, value.data());
    if (track->channel == Channel::translation) {
      transform.translation = {value[0], value[1], value[2]};
    } else if (track->channel == Channel::scale) {
      transform.scale = {value[0], value[1], value[2]};
    } else {
      transform.rotation = Quat(value[3], value[0], value[1], value[2]);
    }
  }
  return transform;
}

Mat4 NodeSampler::worldOf(NodeIndex node, const Mat4& local, const std::vector<Mat4>& worlds) const {
  const NodeIndex parent = scene_->nodes[at(node)].parent;
  return !parent.exists() ? local : worlds[at(parent)] * local;
}

void NodeSampler::sample(double timeSeconds, FrameState& frame) const {
  const std::size_t count = scene_->nodes.size();
  frame.timeSeconds = timeSeconds;
  frame.pose.locals.resize(count);
  frame.pose.usesMatrix.resize(count, false);
  frame.worlds.resize(count, Mat4(1.0));
  frame.stretch.assign(chains_.empty() ? 0 : count, Mat3(1.0));
  for (const Step& step : steps_) {
    const auto index = at(step.node);
    frame.pose.locals[index] = localAt(step, timeSeconds);
    frame.pose.usesMatrix[index] = scene_->nodes[index].matrix && step.tracks.empty();
    frame.worlds[index] = worldOf(step.node, localMatrix(*scene_, frame.pose, step.node), frame.worlds);
  }
  for (const BindChain& chain : chains_) {
    frame.stretch[at(chain.joint)] = stretchOf(*scene_, frame.pose, chain);
  }
}

Scene NodeSampler::skeleton() const {
  Scene skeleton;
  skeleton.nodes.resize(scene_->nodes.size());
  for (const Step& step : steps_) {
    const Node& node = scene_->nodes[at(step.node)];
    Node& copy = skeleton.nodes[at(step.node)];
    copy.parent = node.parent;
    copy.rest = node.rest;
    copy.matrix = node.matrix;
    if (node.parent.exists()) {
      skeleton.nodes[at(node.parent)].children.push_back(step.node);
    }
  }
  return skeleton;
}

Vec3 LimbPath::toSpace(const LimbSample& sample, const Vec3& world) const {
  return glm::transpose(axes) * (world - sample.reference);
}

Vec3 LimbPath::toWorld(const LimbSample& sample, const Vec3& inSpace) const {
  return axes * inSpace + sample.reference;
}

double LimbPath::ratioAt(double timeSeconds) const {
  if (timeSeconds <= samples.front().timeSeconds) {
    return ratios.front();
  }
  if (timeSeconds >= samples.back().timeSeconds) {
    return ratios.back();
  }
  const auto next =
      std::upper_bound(samples.begin(), samples.end(), timeSeconds,
                       [](double time, const LimbSample& sample) { return time < sample.timeSeconds; });
  const auto i = static_cast<std::size_t>(next - samples.begin());
  const double span = samples[i].timeSeconds - samples[i - 1].timeSeconds;
  const double t = (timeSeconds - samples[i - 1].timeSeconds) / span;
  return ratios[i - 1] + t * (ratios[i] - ratios[i - 1]);
}

LimbSample limbSample(const Limb& limb, TrailSpace space, NodeIndex hips, const FrameState& source) {
  LimbSample sample;
  sample.timeSeconds = source.timeSeconds;
  sample.base = stayingPosition(limb, source);
  sample.end = leadingPosition(limb, source);
  if (space == TrailSpace::base) {
    sample.reference = sample.base;
  } else if (space == TrailSpace::root && hips.exists()) {
    sample.reference = positionOf(source.worlds[at(hips)]);
  }
  return sample;
}

std::vector<double> sampleTimes(double startSeconds, double endSeconds, double framesPerSecond,
                                const std::vector<double>& keyTimes) {
  std::vector<double> times{startSeconds, endSeconds};
  const double lastFrame = std::floor(endSeconds * framesPerSecond);
  for (double frame = std::ceil(startSeconds * framesPerSecond); frame <= lastFrame; frame += 1.0) {
    times.push_back(frame / framesPerSecond);
  }
  const auto isOnFrame = [&](double time) {
    const double frame = std::round(time * framesPerSecond) / framesPerSecond;
    return std::abs(time - frame) < sameTime && frame > startSeconds && frame < endSeconds;
  };
  for (const double time : keyTimes) {
    if (time > startSeconds && time < endSeconds && !isOnFrame(time)) {
      times.push_back(time);
    }
  }
  mergeClose(times);
  // Merging keeps the earlier of two close times: the range's own end must not be the one that is lost.
  times.back() = endSeconds;
  return times;
}

std::vector<double> timesBetween(const std::vector<double>& timesSeconds, double framesPerSecond) {
  std::vector<double> between;
  for (std::size_t i = 1; i < timesSeconds.size(); ++i) {
    const double middle = 0.5 * (timesSeconds[i - 1] + timesSeconds[i]);
    const double halfFrame = 0.5 * std::round(2.0 * middle * framesPerSecond) / framesPerSecond;
    between.push_back(std::abs(middle - halfFrame) < sameTime ? halfFrame : middle);
  }
  return between;
}

std::vector<double> keyTimesOf(const Clip& clip, const std::vector<NodeIndex>& nodes, double startSeconds,
                               double endSeconds) {
  std::vector<double> times;
  std::vector<std::span<const float>> merged; // most exporters give all tracks the same times
  for (const CopyOnWrite<Track>& track : clip.tracks) {
    if (!isOfNodes(*track, nodes)) {
      continue;
    }
    const std::span<const float> keys = keysWithin(*track, startSeconds, endSeconds);
    const bool isThere = std::ranges::any_of(
        merged, [&](const std::span<const float> other) { return std::ranges::equal(other, keys); });
    if (!isThere) {
      merged.push_back(keys);
      const auto middle = times.insert(times.end(), keys.begin(), keys.end());
      std::inplace_merge(times.begin(), middle, times.end());
    }
  }
  mergeClose(times);
  return times;
}

bool isDenselyKeyed(std::size_t keyCount, double startSeconds, double endSeconds, double framesPerSecond) {
  const double frames = std::max(1.0, (endSeconds - startSeconds) * framesPerSecond);
  constexpr double densest = 0.6; // keys per frame; hand-keyed clips stay below one key in two frames
  return static_cast<double>(keyCount) - 1.0 > densest * frames && keyCount > 4;
}

KeySpacing keySpacing(const Clip& clip, const std::vector<NodeIndex>& nodes) {
  const std::size_t keyCount = keyCountOf(clip, nodes);
  const double keysPerSecond = keyRateOf(clip, keyCount);
  return {keysPerSecond, isDenseAt(clip, keyCount, keysPerSecond)};
}

std::vector<double> chooseControlFrames(const LimbPath& path, const std::vector<double>& keyTimes,
                                        double framesPerSecond, double keysPerSecond, double tolerance) {
  const LimbPath counted = keysPerSecond < framesPerSecond ? onFramesOf(path, keysPerSecond) : path;
  const std::vector<LimbSample>& samples = counted.samples;
  const double start = samples.front().timeSeconds;
  const double end = samples.back().timeSeconds;
  constexpr std::size_t mostChosen = 10; // More hide the character; the hand adds what it needs.
  std::vector<double> times{start, end};
  if (!isDenselyKeyed(keyTimes.size(), start, end, keysPerSecond)) {
    times.insert(times.end(), keyTimes.begin(), keyTimes.end());
  } else {
    const SpacePath seen = inSpace(counted);
    std::vector<std::size_t> controls = extremes(seen);
    for (auto worst = worstSample(seen, controls); worst.second > tolerance && controls.size() < mostChosen;
         worst = worstSample(seen, controls)) {
      controls.insert(std::lower_bound(controls.begin(), controls.end(), worst.first), worst.first);
    }
    for (const std::size_t control : controls) {
      const double time = samples[control].timeSeconds;
      const double onFrame = std::round(time * keysPerSecond) / keysPerSecond;
      const bool isEnd = time == start || time == end; // a range may begin and end between frames
      times.push_back(!isEnd && onFrame > start && onFrame < end ? onFrame : time); // Where the artist stops.
    }
  }
  mergeClose(times);
  std::transform(times.begin(), times.end(), times.begin(),
                 [&](double time) { return time * framesPerSecond; });
  return times;
}

} // namespace stretch::rig

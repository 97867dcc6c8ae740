#include "rig/motion/solve_steps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "rig/limb.h"
#include "rig/motion/release_length.h"

namespace stretch::rig {

namespace {

Mat3 axesOf(const TrailSettings& settings) {
  return settings.space == TrailSpace::view ? settings.viewAxes : Mat3(1.0);
}

// How far the path gets from where it begins.
double farthestOf(const std::vector<Vec3>& points) {
  double extent = 0.0;
  for (const Vec3& point : points) {
    extent = std::max(extent, glm::length(point - points.front()));
  }
  return extent;
}

/// The spheres that the user set, and the two ends of the range, which always have one.
void setByHand(SolvedTrail& solved) {
  const double start = solved.settings.startFrame;
  const double end = solved.settings.endFrame;
  std::vector<double>& frames = solved.controlFrames;
  frames = {start, end};
  for (const double frame : solved.trail.controlFrames) {
    if (frame > start + frameTolerance && frame < end - frameTolerance) {
      frames.push_back(frame);
    }
  }
  std::sort(frames.begin(), frames.end());
}

/// A sphere that was pulled is there, whatever would be chosen now.
void keepPulledSpheres(SolvedTrail& solved) {
  std::vector<double>& frames = solved.controlFrames;
  for (const SphereOffset& sphere : solved.settings.spheres) {
    const bool known =
        std::ranges::any_of(frames, [&](double frame) { return sameFrame(frame, sphere.frame); });
    if (!known) {
      frames.push_back(sphere.frame);
    }
  }
  std::sort(frames.begin(), frames.end());
}

} // namespace

std::vector<NodeIndex> pathNodes(const MotionInput& input, const Limb& limb) {
  std::vector<NodeIndex> nodes = jointsAndEnd(limb);
  if (input.hips.exists()) {
    nodes.push_back(input.hips);
  }
  return nodes;
}

PathKey pathKeyOf(const std::string& limb, const TrailSettings& used) {
  return {limb, used.startFrame, used.endFrame, used.pivot, used.space, axesOf(used)};
}

PathTimes pathTimes(const MotionInput& input, const Limb& limb, const PathKey& key) {
  if (input.sameClip != nullptr) {
    const auto same = std::ranges::find_if(input.sameClip->trails, [&](const SolvedTrail& before) {
      return before.limb == limb && before.pathKey.startFrame == key.startFrame &&
             before.pathKey.endFrame == key.endFrame && before.pathKey.pivot == key.pivot;
    });
    if (same != input.sameClip->trails.end()) {
      return same->times;
    }
  }
  const Clip& clip = *input.clip;
  const double fps = clip.framesPerSecond;
  const double start = key.startFrame / fps;
  const double end = key.endFrame / fps;
  const std::vector<NodeIndex> nodes = jointsAndEnd(limb);
  PathTimes times;
  times.keys = keyTimesOf(clip, nodes, start, end);
  times.spacing = keySpacing(clip, nodes);
  times.nextKeySeconds = secondsToNextKey(clip, key, nodes, times.spacing);
  times.samples = sampleTimes(start, end, fps, times.keys);
  times.between = timesBetween(times.samples, fps);
  return times;
}

OriginalPath samplePath(const MotionInput& input, const Limb& limb, const PathKey& key, FrameSource& frames) {
  constexpr double controlTolerance = 0.01; // of the limb's rest length
  OriginalPath original;
  original.pathKey = key;
  original.times = pathTimes(input, limb, key);
  const PathTimes& times = original.times;
  LimbPath& path = original.path;
  path.axes = key.axes;
  path.samples.reserve(times.samples.size());
  path.between.reserve(times.between.size());
  std::vector<Vec3> points;
  points.reserve(times.samples.size());
  for (const double time : times.samples) {
    const FrameState& frame = frames.at(time);
    path.samples.push_back(limbSample(limb, key.space, input.hips, frame));
    original.bend.add(pointsToLead(limb, frame), rotationOf(frame.worlds[at(limb.joints.front())]));
    points.push_back(path.toSpace(path.samples.back(), path.samples.back().end));
  }
  // A path that only trembles has no length to go by.
  if (onlyTrembles(points, farthestOf(points), limb.restLength)) {
    points.assign(points.size(), points.front());
  }
  path.ratios = pathRatios(points, times.samples, key.pivot);
  // A planted foot stands still at the keys only: between them it slides about.
  for (const double time : times.between) {
    path.between.push_back(limbSample(limb, key.space, input.hips, frames.at(time)));
  }
  original.chosenFrames =
      chooseControlFrames(path, times.keys, input.clip->framesPerSecond, times.spacing.keysPerSecond,
                          controlTolerance * limb.restLength);
  return original;
}

void setControlFrames(SolvedTrail& solved) {
  solved.controlFrames = solved.chosenFrames;
  if (!solved.trail.controlFrames.empty()) {
    setByHand(solved);
  }
  keepPulledSpheres(solved);
}

Vec2 defaultRange(const Scene& scene, const Clip& clip, const Limb& limb) {
  const double last = std::min(endInFrames(clip), longestFrames);
  const NodeSampler sampler(scene, clip, jointsAndEnd(limb));
  FrameState sampled;
  const auto reachAt = [&](double frame) {
    sampler.sample(frame / clip.framesPerSecond, sampled);
    return leadingPosition(limb, sampled) - stayingPosition(limb, sampled);
  };
  const Vec3 begin = reachAt(0.0);
  double farthest = 0.0;
  double farthestFrame = last;
  for (double frame = 1.0; frame <= wholeFrameAtMost(last); frame += 1.0) {
    const double distance = glm::length(reachAt(frame) - begin);
    if (distance > farthest * (1.0 + 1e-9)) {
      farthest = distance;
      farthestFrame = frame;
    }
  }
  return {0.0, std::min(farthestFrame, last)};
}

TrailSpace startingSpace(const Scene& scene, const Clip& clip, const Limb& limb, NodeIndex hips,
                         const Vec2& rangeFrames) {
  if (!hips.exists() || limb.ledByFirst) {
    return TrailSpace::world;
  }
  std::vector<NodeIndex> nodes = jointsAndEnd(limb);
  nodes.push_back(hips);
  const NodeSampler sampler(scene, clip, nodes);
  FrameState sampled;
  double hipsWay = 0.0;
  double endWay = 0.0;
  std::optional<LimbSample> first;
  const double clipStart = clip.startSeconds * clip.framesPerSecond;
  const double start = std::clamp(rangeFrames.x, clipStart, endInFrames(clip)); // outside nothing moves
  const double last = std::min({rangeFrames.y, start + longestFrames, endInFrames(clip)});
  for (double frame = start; frame <= last; frame += 1.0) {
    sampler.sample(frame / clip.framesPerSecond, sampled);
    const LimbSample here = limbSample(limb, TrailSpace::root, hips, sampled);
    first = first ? first : here;
    hipsWay = std::max(hipsWay, glm::length(here.reference - first->reference));
    endWay = std::max(endWay, glm::length((here.end - here.base) - (first->end - first->base)));
  }
  return hipsWay > 0.5 * endWay ? TrailSpace::root : TrailSpace::world;
}

} // namespace stretch::rig

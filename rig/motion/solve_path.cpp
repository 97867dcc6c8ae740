#include "rig/motion/solve_steps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "core/anim/frames.h"
#include "rig/limb.h"

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
    const bool inRange =
        sphere.frame >= solved.settings.startFrame && sphere.frame <= solved.settings.endFrame;
    const bool known = std::any_of(frames.begin(), frames.end(),
                                   [&](double frame) { return sameFrame(frame, sphere.frame); });
    if (inRange && !known) {
      frames.push_back(sphere.frame);
    }
  }
  std::sort(frames.begin(), frames.end());
}

} // namespace

std::vector<NodeIndex> pathNodes(const MotionInput& input, const Limb& limb) {
  std::vector<NodeIndex> nodes = limb.joints;
  nodes.push_back(limb.endNode.exists() ? limb.endNode : limb.joints.back());
  if (input.hips.exists()) {
    nodes.push_back(input.hips);
  }
  return nodes;
}

void samplePath(const MotionInput& input, FrameSource& frames, SolvedTrail& solved) {
  std::vector<Vec3> points;
  std::vector<double> times;
  solved.path.axes = axesOf(solved.settings);
  for (const double time :
       sampleTimes(solved.startSeconds, solved.endSeconds, input.clip->framesPerSecond, solved.keyTimes)) {
    const FrameState& frame = frames.at(time);
    solved.path.samples.push_back(limbSample(solved.limb, solved.settings.space, input.hips, frame));
    solved.bend.add(pointsToLead(solved.limb, frame),
                    rotationOf(frame.worlds[at(solved.limb.joints.front())]));
    const LimbSample& sample = solved.path.samples.back();
    points.push_back(solved.path.toSpace(sample, sample.end));
    times.push_back(time);
  }
  // A path that only trembles has no length to go by.
  if (onlyTrembles(points, farthestOf(points), solved.limb.restLength)) {
    points.assign(points.size(), points.front());
  }
  solved.path.ratios = pathRatios(points, times, solved.settings.pivot);
  // A planted foot stands still at the keys only: between them it slides about.
  for (const double time : timesBetween(times, input.clip->framesPerSecond)) {
    const FrameState& frame = frames.at(time);
    solved.path.between.push_back(limbSample(solved.limb, solved.settings.space, input.hips, frame));
  }
}

void setControlFrames(const MotionInput& input, SolvedTrail& solved, const SolvedTrail* samePathBefore) {
  constexpr double controlTolerance = 0.01; // of the limb's rest length
  if (!solved.trail.controlFrames.empty()) {
    setByHand(solved);
  } else if (samePathBefore != nullptr && samePathBefore->trail.controlFrames.empty()) {
    solved.controlFrames = samePathBefore->controlFrames;
  } else {
    solved.controlFrames = chooseControlFrames(solved.path, solved.keyTimes, input.clip->framesPerSecond,
                                               controlTolerance * solved.limb.restLength);
  }
  keepPulledSpheres(solved);
}

Vec2 defaultRange(const Scene& scene, const Clip& clip, const Limb& limb) {
  const double last = std::min(endInFrames(clip), longestFrames);
  std::vector<NodeIndex> nodes = limb.joints;
  if (limb.endNode.exists()) {
    nodes.push_back(limb.endNode);
  }
  const NodeSampler sampler(scene, clip, nodes);
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
  std::vector<NodeIndex> nodes = limb.joints;
  nodes.push_back(limb.endNode.exists() ? limb.endNode : limb.joints.back());
  nodes.push_back(hips);
  const NodeSampler sampler(scene, clip, nodes);
  FrameState sampled;
  double hipsWay = 0.0;
  double endWay = 0.0;
  std::optional<LimbSample> first;
  const double last = std::min(rangeFrames.y, rangeFrames.x + longestFrames);
  for (double frame = rangeFrames.x; frame <= last; frame += 1.0) {
    sampler.sample(frame / clip.framesPerSecond, sampled);
    const LimbSample here = limbSample(limb, TrailSpace::root, hips, sampled);
    first = first ? first : here;
    hipsWay = std::max(hipsWay, glm::length(here.reference - first->reference));
    endWay = std::max(endWay, glm::length((here.end - here.base) - (first->end - first->base)));
  }
  return hipsWay > 0.5 * endWay ? TrailSpace::root : TrailSpace::world;
}

} // namespace stretch::rig

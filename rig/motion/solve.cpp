#include "rig/motion/motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/index.h"
#include "rig/limb.h"
#include "rig/motion/order.h"

namespace stretch::rig {

namespace {

Mat3 axesOf(const TrailSettings& settings) {
  return settings.space == TrailSpace::view ? settings.viewAxes : Mat3(1.0);
}

// Nobody exaggerates an hour in one go; a broken file may claim to last for years.
constexpr double longestFrames = 100000.0;

TrailSettings usable(TrailSettings settings, const Clip& clip) {
  const double lastFrame = std::max(0.0, clip.endSeconds * clip.framesPerSecond);
  settings.startFrame = std::clamp(settings.startFrame, 0.0, lastFrame);
  settings.endFrame = std::clamp(settings.endFrame, settings.startFrame,
                                 std::min(lastFrame, settings.startFrame + longestFrames));
  settings.scale = std::max(settings.scale, smallestScale);
  return settings;
}

double lengthOf(const std::vector<Vec3>& polyline) {
  double length = 0.0;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    length += glm::length(polyline[i] - polyline[i - 1]);
  }
  return length;
}

void samplePath(const MotionInput& input, SolvedTrail& solved, const std::vector<double>& keyTimes) {
  std::vector<int> nodes = solved.limb.joints;
  nodes.push_back(solved.limb.endNode >= 0 ? solved.limb.endNode : solved.limb.joints.back());
  if (input.biped->hips >= 0) {
    nodes.push_back(input.biped->hips);
  }
  const NodeSampler sampler(*input.scene, *input.clip, nodes);
  FrameState frame;
  std::vector<Vec3> points;
  std::vector<double> times;
  solved.path.axes = axesOf(solved.settings);
  for (const double time :
       sampleTimes(solved.startSeconds, solved.endSeconds, input.clip->framesPerSecond, keyTimes)) {
    sampler.sample(time, frame);
    solved.path.samples.push_back(limbSample(solved.limb, solved.settings.space, input.biped->hips, frame));
    solved.bend.add(limbPoints(solved.limb, frame), rotationOf(frame.worlds[at(solved.limb.joints.front())]));
    const LimbSample& sample = solved.path.samples.back();
    points.push_back(solved.path.toSpace(sample, sample.end));
    times.push_back(time);
  }
  // A path that only trembles has no length to go by.
  constexpr double trembling = 1e-3; // of the limb's rest length
  if (lengthOf(points) < trembling * solved.limb.restLength) {
    points.assign(points.size(), points.front());
  }
  solved.path.ratios = pathRatios(points, times, solved.settings.pivot);
  // A planted foot stands still at the keys only: between them it slides about.
  for (std::size_t i = 1; i < times.size(); ++i) {
    sampler.sample(0.5 * (times[i - 1] + times[i]), frame);
    solved.path.between.push_back(limbSample(solved.limb, solved.settings.space, input.biped->hips, frame));
  }
}

void solveTipOf(SolvedTrail& solved) {
  const bool pivotAtStart = solved.settings.pivot == Pivot::start;
  const LimbSample& tipSample = pivotAtStart ? solved.path.samples.back() : solved.path.samples.front();
  TipProblem problem;
  for (const LimbSample& sample : solved.path.samples) {
    problem.points.push_back(solved.path.toSpace(sample, sample.end));
  }
  for (const LimbSample& sample : solved.path.between) {
    problem.between.push_back(solved.path.toSpace(sample, sample.end));
  }
  const double poseLength = glm::length(tipSample.end - tipSample.base);
  problem.basePosition = solved.path.toSpace(tipSample, tipSample.base);
  problem.limbLength = solved.settings.reference == Reference::pose ? poseLength : solved.limb.restLength;
  problem.scale = solved.settings.scale;
  problem.axes = solved.settings.axes;
  problem.pivot = solved.settings.pivot;
  problem.pull = solved.settings.pull;
  solved.tip = solveTip(problem);
}

// Of two frames, beyond the rounding of key times.
bool differs(double frame, double other) {
  return std::abs(frame - other) > 0.01;
}

void explainTip(SolvedTrail& solved, double framesPerSecond) {
  const TipSolution& tip = solved.tip;
  if (solved.trail.settings.scale < smallestScale) {
    solved.warnings.push_back(
        fmt::format("scale {:g} is taken as {:g}", solved.trail.settings.scale, smallestScale));
  }
  if (solved.settings.endFrame - solved.settings.startFrame >= longestFrames) {
    solved.warnings.push_back(fmt::format("the range is cut to {:g} frames", longestFrames));
  } else if (differs(solved.settings.startFrame, solved.trail.settings.startFrame) ||
             differs(solved.settings.endFrame, solved.trail.settings.endFrame)) {
    solved.warnings.push_back(fmt::format("the range is cut to the frames {:g} to {:g}, which the clip has",
                                          solved.settings.startFrame, solved.settings.endFrame));
  }
  if (tip.outcome == TipOutcome::nothingToScale) {
    solved.warnings.emplace_back(
        "nothing to scale: the limb's end does not move along the active axes in this range");
  } else if (!tip.reached()) {
    solved.warnings.push_back(
        fmt::format("not reachable: the limb gets to {:.4g} of {:.4g}", tip.reachedLength, tip.wantedLength));
  }
  const std::size_t tipIndex =
      solved.settings.pivot == Pivot::start ? solved.path.samples.size() - 1 : std::size_t{0};
  if (tip.moved && at(tip.farthestSample) == tipIndex) {
    solved.warnings.emplace_back(
        "the limb's end strays between the frames from where it is on them: its path is moved as a whole");
  } else if (tip.moved) {
    const double frame = solved.path.samples[at(tip.farthestSample)].timeSeconds * framesPerSecond;
    solved.warnings.push_back(
        fmt::format("the path comes back on itself and is moved as a whole; a range that ends at frame "
                    "{:g}, where the limb's end is farthest from the pivot, would be scaled",
                    frame));
  }
}

// To the limb's next key on a sparsely keyed clip, else a third of the range; within the
// clip unless it loops.
double releaseSecondsOf(const MotionInput& input, const SolvedTrail& solved, const std::vector<int>& nodes) {
  const Clip& clip = *input.clip;
  const bool forwards = solved.settings.pivot == Pivot::start;
  const double room =
      forwards ? clip.endSeconds - solved.endSeconds : solved.startSeconds - std::min(0.0, clip.startSeconds);
  const double limit = std::min(input.loops ? clip.endSeconds - clip.startSeconds : room,
                                longestFrames / clip.framesPerSecond);
  if (solved.settings.releaseFrames) {
    return std::clamp(*solved.settings.releaseFrames / clip.framesPerSecond, 0.0, std::max(0.0, limit));
  }
  const std::vector<double> keys = keyTimesOf(clip, nodes, clip.startSeconds, clip.endSeconds);
  double wanted = (solved.endSeconds - solved.startSeconds) / 3.0;
  if (!isDenselyKeyed(keys, clip.startSeconds, clip.endSeconds, clip.framesPerSecond)) {
    constexpr double later = 1e-5;
    const auto next = std::upper_bound(keys.begin(), keys.end(), solved.tipSeconds + later);
    const auto before = std::lower_bound(keys.begin(), keys.end(), solved.tipSeconds - later);
    if (forwards && next != keys.end()) {
      wanted = *next - solved.tipSeconds;
    } else if (!forwards && before != keys.begin()) {
      wanted = solved.tipSeconds - *(before - 1);
    }
  }
  return std::clamp(wanted, 0.0, std::max(0.0, limit));
}

void setWindow(SolvedTrail& solved, double fadeSeconds) {
  const bool forwards = solved.settings.pivot == Pivot::start;
  const double release = solved.release.seconds();
  solved.windowStartSeconds = solved.startSeconds - (forwards ? fadeSeconds : release);
  solved.windowEndSeconds = solved.endSeconds + (forwards ? release : fadeSeconds);
}

bool pullsPivot(const SolvedTrail& solved, double framesPerSecond) {
  const bool forwards = solved.settings.pivot == Pivot::start;
  const double pivotSeconds = forwards ? solved.startSeconds : solved.endSeconds;
  return glm::length(solved.offsets.at(pivotSeconds * framesPerSecond)) > 0.0;
}

const SolvedTrail* solvedBefore(const MotionInput& input, const Trail& trail) {
  if (input.previous == nullptr) {
    return nullptr;
  }
  const std::vector<SolvedTrail>& trails = input.previous->trails;
  const auto found = std::find_if(trails.begin(), trails.end(), [&](const SolvedTrail& solved) {
    return solved.trail.id == trail.id && solved.trail.limb == trail.limb && solved.trail.clip == trail.clip;
  });
  return found == trails.end() ? nullptr : &*found;
}

// Whether the settings, as used, ask for the same original path.
bool samePath(const TrailSettings& a, const TrailSettings& b) {
  return a.startFrame == b.startFrame && a.endFrame == b.endFrame && a.pivot == b.pivot &&
         a.space == b.space && (a.space != TrailSpace::view || a.viewAxes == b.viewAxes);
}

void setControlFrames(const MotionInput& input, SolvedTrail& solved, const std::vector<double>& keyTimes,
                      const SolvedTrail* samePathBefore) {
  constexpr double controlTolerance = 0.01; // of the limb's rest length
  if (!solved.trail.controlFrames.empty()) {
    solved.controlFrames = solved.trail.controlFrames;
    std::sort(solved.controlFrames.begin(), solved.controlFrames.end());
  } else if (samePathBefore != nullptr && samePathBefore->trail.controlFrames.empty()) {
    solved.controlFrames = samePathBefore->controlFrames;
  } else {
    solved.controlFrames = chooseControlFrames(solved.path, keyTimes, input.clip->framesPerSecond,
                                               controlTolerance * solved.limb.restLength);
  }
}

SolvedTrail solveTrail(const MotionInput& input, const Trail& trail, const Limb& limb) {
  const SolvedTrail* before = solvedBefore(input, trail);
  if (before != nullptr && before->trail == trail) {
    return *before;
  }
  SolvedTrail solved;
  solved.trail = trail;
  solved.limb = limb;
  solved.settings = usable(trail.settings, *input.clip);
  solved.topology = before != nullptr
                        ? before->topology
                        : limbTopology(*input.scene, limb, input.limbs, bindPoseWorlds(*input.scene));
  solved.active = trail.connected || trail.applied.has_value();
  const double fps = input.clip->framesPerSecond;
  solved.startSeconds = solved.settings.startFrame / fps;
  solved.endSeconds = solved.settings.endFrame / fps;
  solved.tipSeconds = solved.settings.pivot == Pivot::start ? solved.endSeconds : solved.startSeconds;
  std::vector<int> keyed = limb.joints;
  if (limb.endNode >= 0) {
    keyed.push_back(limb.endNode);
  }
  const std::vector<double> keyTimes = keyTimesOf(*input.clip, keyed, solved.startSeconds, solved.endSeconds);
  if (before != nullptr && samePath(before->settings, solved.settings)) {
    solved.path = before->path;
    solved.bend = before->bend;
  } else {
    before = nullptr;
    samplePath(input, solved, keyTimes);
  }
  solveTipOf(solved);
  explainTip(solved, fps);
  solved.remap = Remap(solved.settings.remap, solved.settings.easeIn, solved.settings.easeOut);
  setControlFrames(input, solved, keyTimes, before);
  solved.offsets = SphereOffsets(solved.controlFrames, solved.settings.spheres);
  const double release = releaseSecondsOf(input, solved, keyed);
  solved.release = Release(release, solved.settings.overshoot);
  setWindow(solved, pullsPivot(solved, fps) ? release : 0.0);
  return solved;
}

const Limb* limbOf(const MotionInput& input, const std::string& id) {
  const auto found =
      std::find_if(input.limbs.begin(), input.limbs.end(), [&](const Limb& limb) { return limb.id == id; });
  return found != input.limbs.end() && !found->joints.empty() ? &*found : nullptr;
}

bool fits(const LimbWeight& weight, const Limb& limb) {
  return std::all_of(weight.samples.begin(), weight.samples.end(),
                     [&](const WeightSample& sample) { return sample.strains.size() == limb.joints.size(); });
}

} // namespace

MotionState solveMotion(const MotionInput& input) {
  MotionState motion;
  motion.clip = input.clipIndex;
  motion.framesPerSecond = input.clip->framesPerSecond;
  motion.startSeconds = input.clip->startSeconds;
  motion.endSeconds = input.clip->endSeconds;
  motion.hips = input.biped->hips;
  motion.loops = input.loops;
  for (const Trail& trail : input.trails) {
    if (const Limb* const limb = limbOf(input, trail.limb)) {
      motion.trails.push_back(solveTrail(input, trail, *limb));
    }
  }
  std::vector<ActingLimb> acting;
  for (const SolvedTrail& solved : motion.trails) {
    acting.push_back({&solved.limb, solved.startSeconds});
  }
  motion.trails = inOrder(std::move(motion.trails), actingOrder(*input.scene, acting));
  return motion;
}

void setWeight(const MotionInput& input, std::vector<LimbWeight> weights, MotionState& motion) {
  std::erase_if(weights, [&](const LimbWeight& one) {
    const Limb* const limb = limbOf(input, one.limb);
    return limb == nullptr || !fits(one, *limb);
  });
  const auto has = [&](const std::string& id) {
    return std::any_of(weights.begin(), weights.end(), [&](const LimbWeight& one) { return one.limb == id; });
  };
  const bool anyLeg = std::any_of(weights.begin(), weights.end(),
                                  [&](const LimbWeight& one) { return isLeg(*limbOf(input, one.limb)); });
  for (const Limb& limb : input.limbs) {
    if (anyLeg && isLeg(limb) && !limb.joints.empty() && !has(limb.id)) {
      weights.push_back({limb.id, {}, 0.0, 0.0, 0.0, 0.0});
    }
  }
  const std::vector<Mat4> bindWorlds = bindPoseWorlds(*input.scene);
  motion.weights.clear();
  for (LimbWeight& one : weights) {
    const Limb& limb = *limbOf(input, one.limb);
    motion.weights.push_back(
        {std::move(one), limb, limbTopology(*input.scene, limb, input.limbs, bindWorlds)});
  }
  std::vector<ActingLimb> acting;
  for (const SolvedWeight& solved : motion.weights) {
    acting.push_back({&solved.limb, 0.0});
  }
  motion.weights = inOrder(std::move(motion.weights), actingOrder(*input.scene, acting));
}

Vec2 defaultRange(const Scene& scene, const Clip& clip, const Limb& limb) {
  const double last = std::min(clip.endSeconds * clip.framesPerSecond, longestFrames);
  std::vector<int> nodes = limb.joints;
  if (limb.endNode >= 0) {
    nodes.push_back(limb.endNode);
  }
  const NodeSampler sampler(scene, clip, nodes);
  FrameState sampled;
  const auto reachAt = [&](double frame) {
    sampler.sample(frame / clip.framesPerSecond, sampled);
    return endPosition(limb, sampled) - positionOf(sampled.worlds[at(limb.joints.front())]);
  };
  const Vec3 begin = reachAt(0.0);
  double farthest = 0.0;
  double farthestFrame = last;
  for (double frame = 1.0; frame <= std::floor(last + 1e-3); frame += 1.0) {
    const double distance = glm::length(reachAt(frame) - begin);
    if (distance > farthest * (1.0 + 1e-9)) {
      farthest = distance;
      farthestFrame = frame;
    }
  }
  return {0.0, std::min(farthestFrame, last)};
}

} // namespace stretch::rig

#include "rig/motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/rotation.h"
#include "rig/ik/limb_shape.h"
#include "rig/limb_deform.h"

namespace stretch::rig {

namespace {

constexpr double shortestReachOfRest = 1e-3;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

// From the root outwards: a limb must be solved after every limb that carries its base.
int solveOrder(LimbKind kind) {
  switch (kind) {
  case LimbKind::spine:
    return 0;
  case LimbKind::neck:
    return 1;
  case LimbKind::leftArm:
  case LimbKind::rightArm:
    return 2;
  case LimbKind::leftLeg:
  case LimbKind::rightLeg:
    return 3;
  case LimbKind::chain:
    return 4;
  }
  return 4;
}

Mat3 axesOf(const TrailSettings& settings) {
  return settings.space == TrailSpace::view ? settings.viewAxes : Mat3(1.0);
}

TrailSettings usable(TrailSettings settings, const Clip& clip) {
  const double lastFrame = clip.endSeconds * clip.framesPerSecond;
  settings.startFrame = std::clamp(settings.startFrame, 0.0, lastFrame);
  settings.endFrame = std::clamp(settings.endFrame, settings.startFrame, lastFrame);
  settings.scale = std::max(settings.scale, smallestScale);
  return settings;
}

void samplePath(const MotionInput& input, SolvedTrail& solved, const std::vector<double>& keyTimes) {
  std::vector<int> nodes = solved.limb.joints;
  nodes.push_back(solved.limb.endNode >= 0 ? solved.limb.endNode : solved.limb.joints.back());
  if (input.biped->hips >= 0) {
    nodes.push_back(input.biped->hips);
  }
  const NodeSampler sampler(*input.scene, *input.clip, nodes);
  std::vector<Mat4> worlds;
  std::vector<Vec3> points;
  std::vector<double> times;
  solved.path.axes = axesOf(solved.settings);
  for (const double time :
       sampleTimes(solved.startSeconds, solved.endSeconds, input.clip->framesPerSecond, keyTimes)) {
    sampler.sample(time, worlds);
    solved.path.samples.push_back(
        limbSample(solved.limb, solved.settings.space, input.biped->hips, worlds, time));
    solved.bend.add(limbPoints(solved.limb, worlds), rotationOf(worlds[at(solved.limb.joints.front())]));
    const LimbSample& sample = solved.path.samples.back();
    points.push_back(solved.path.toSpace(sample, sample.end));
    times.push_back(time);
  }
  solved.path.ratios = pathRatios(points, times, solved.settings.pivot);
}

// The stop plane cuts the way from the original to the exaggerated point: the limb's end comes as far as the
// plane.
Vec3 stoppedAt(const StopPlane& plane, const Vec3& original, const Vec3& target) {
  const double before = glm::dot(plane.normal, original - plane.point);
  const double after = glm::dot(plane.normal, target - plane.point);
  if (after <= 0.0 || before >= 0.0) {
    return after <= 0.0 ? target : original;
  }
  return original + (target - original) * (before / (before - after));
}

void solveTipOf(SolvedTrail& solved) {
  const bool pivotAtStart = solved.settings.pivot == Pivot::start;
  const LimbSample& tipSample = pivotAtStart ? solved.path.samples.back() : solved.path.samples.front();
  TipProblem problem;
  for (const LimbSample& sample : solved.path.samples) {
    problem.points.push_back(solved.path.toSpace(sample, sample.end));
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

void explainTip(SolvedTrail& solved, double framesPerSecond) {
  const TipSolution& tip = solved.tip;
  if (solved.trail.settings.scale < smallestScale) {
    solved.warnings.push_back(
        fmt::format("scale {:g} is taken as {:g}", solved.trail.settings.scale, smallestScale));
  }
  if (tip.outcome == TipOutcome::nothingToScale) {
    solved.warnings.emplace_back(
        "nothing to scale: the limb's end does not move along the active axes in this range");
  } else if (!tip.reached()) {
    solved.warnings.push_back(
        fmt::format("not reachable: the limb gets to {:.4g} of {:.4g}", tip.reachedLength, tip.wantedLength));
  }
  if (tip.moved) {
    const double frame = solved.path.samples[at(tip.farthestSample)].timeSeconds * framesPerSecond;
    solved.warnings.push_back(
        fmt::format("the path comes back on itself and is moved as a whole; a range that ends at frame "
                    "{:g}, where the limb's end is farthest from the pivot, would be scaled",
                    frame));
  }
}

// Section 5: to the controller's next key on a sparsely keyed clip, else a third of the range; within the
// clip unless it loops.
double releaseSecondsOf(const MotionInput& input, const SolvedTrail& solved, const std::vector<int>& nodes) {
  const Clip& clip = *input.clip;
  const bool forwards = solved.settings.pivot == Pivot::start;
  const double room =
      forwards ? clip.endSeconds - solved.endSeconds : solved.startSeconds - std::min(0.0, clip.startSeconds);
  const double limit = input.loops ? clip.endSeconds - clip.startSeconds : room;
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

SolvedTrail solveTrail(const MotionInput& input, const Trail& trail, const Limb& limb,
                       const std::vector<Mat4>& bindWorlds) {
  SolvedTrail solved;
  solved.trail = trail;
  solved.limb = limb;
  solved.settings = usable(trail.settings, *input.clip);
  solved.topology = limbTopology(*input.scene, limb, input.limbs, bindWorlds);
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
  samplePath(input, solved, keyTimes);
  solveTipOf(solved);
  explainTip(solved, fps);
  solved.remap = Remap(solved.settings.remap, solved.settings.easeIn, solved.settings.easeOut);
  constexpr double controlTolerance = 0.01; // of the limb's rest length
  solved.controlFrames = trail.controlFrames.empty() ? chooseControlFrames(solved.path, keyTimes, fps,
                                                                           controlTolerance * limb.restLength)
                                                     : trail.controlFrames;
  solved.offsets = SphereOffsets(solved.controlFrames, solved.settings.spheres);
  const double release = releaseSecondsOf(input, solved, keyed);
  solved.release = Release(release, solved.settings.overshoot);
  setWindow(solved, pullsPivot(solved, fps) ? release : 0.0);
  return solved;
}

// w(r) E(c) with pull and spheres, world space, at a time of the range, from the source's sample there.
Vec3 rangeOffset(const SolvedTrail& solved, const LimbSample& sample, double frame, double weight) {
  const Vec3 original = solved.path.toSpace(sample, sample.end);
  Vec3 offset(0.0);
  if (solved.tip.outcome != TipOutcome::nothingToScale) {
    offset = weight * (exaggeratePoint(solved.tip, original) - original) + weight * solved.tip.pull;
  }
  return solved.path.axes * (offset + solved.offsets.at(frame));
}

bool insideWindow(const SolvedTrail& solved, double timeSeconds) {
  constexpr double rounding = 1e-7;
  return timeSeconds >= solved.windowStartSeconds - rounding &&
         timeSeconds <= solved.windowEndSeconds + rounding;
}

// On a loop, the time one turn later or earlier where that is what falls into the trail's window.
double wrapped(const MotionState& motion, const SolvedTrail& solved, double timeSeconds) {
  const double turn = motion.endSeconds - motion.startSeconds;
  if (!motion.loops || insideWindow(solved, timeSeconds)) {
    return timeSeconds;
  }
  const double other = timeSeconds < solved.windowStartSeconds ? timeSeconds + turn : timeSeconds - turn;
  return insideWindow(solved, other) ? other : timeSeconds;
}

// How far past the tip (release) or before the pivot (fade) a time lies; both 0 inside the range.
struct Outside {
  double pastTip = 0.0;
  double pastPivot = 0.0;
};

Outside outsideOf(const SolvedTrail& solved, double timeSeconds) {
  const double before = std::max(0.0, solved.startSeconds - timeSeconds);
  const double after = std::max(0.0, timeSeconds - solved.endSeconds);
  const bool forwards = solved.settings.pivot == Pivot::start;
  return {forwards ? after : before, forwards ? before : after};
}

// The limb's own amount at a time: w, w times the decay in the release, 0 before the pivot.
struct Amount {
  double weight = 0.0;
  double decay = 1.0;
  Vec3 offset{0.0};
};

Amount amountAt(const MotionState& motion, const SolvedTrail& solved, const LimbSample& sample) {
  const double framesPerSecond = motion.framesPerSecond;
  const double timeSeconds = wrapped(motion, solved, sample.timeSeconds);
  const Outside outside = outsideOf(solved, timeSeconds);
  constexpr double rounding = 1e-7; // seconds: key times are stored in single precision
  if (outside.pastTip > rounding) {
    // The tip's own offset, which decays: the limb goes on with the clip below it.
    const bool forwards = solved.settings.pivot == Pivot::start;
    const LimbSample& tip = forwards ? solved.path.samples.back() : solved.path.samples.front();
    const double decay = solved.release.at(outside.pastTip);
    return {1.0, decay, decay * rangeOffset(solved, tip, solved.tipSeconds * framesPerSecond, 1.0)};
  }
  if (outside.pastPivot > rounding) {
    const double fade =
        solved.release.seconds() > 0.0 ? 1.0 - smoothstep(outside.pastPivot / solved.release.seconds()) : 0.0;
    return {0.0, fade, solved.path.axes * solved.offsets.at(timeSeconds * framesPerSecond) * fade};
  }
  const double weight = solved.remap.at(solved.path.ratioAt(sample.timeSeconds));
  return {weight, 1.0, rangeOffset(solved, sample, sample.timeSeconds * framesPerSecond, weight)};
}

Vec3 targetFrom(const SolvedTrail& solved, const LimbSample& sample, const Amount& amount) {
  Vec3 target = sample.end + 0.5 * solved.settings.blend * amount.offset;
  return solved.settings.stopAt ? stoppedAt(*solved.settings.stopAt, sample.end, target) : target;
}

// Where a point beside the limb goes when inner trails carry its base: it moves and turns with the base's
// parent.
Vec3 carriedPoint(const Scene& scene, const SolvedTrail& solved, const LimbSample& sample, const Vec3& point,
                  const std::vector<Mat4>& sourceWorlds, const FrameState& frame) {
  const int base = solved.limb.joints.front();
  const int parent = scene.nodes[at(base)].parent;
  if (solved.settings.stayInWorld || frame.worlds[at(base)] == sourceWorlds[at(base)]) {
    return point;
  }
  const Quat turn =
      parent < 0 ? Quat(1.0, 0.0, 0.0, 0.0)
                 : rotationOf(frame.worlds[at(parent)]) * glm::inverse(rotationOf(sourceWorlds[at(parent)]));
  return positionOf(frame.worlds[at(base)]) + turn * (point - sample.base);
}

void applyTrail(const Scene& scene, const MotionState& motion, const SolvedTrail& solved,
                const std::vector<Mat4>& sourceWorlds, FrameState& frame) {
  const LimbSample sample =
      limbSample(solved.limb, solved.settings.space, motion.hips, sourceWorlds, frame.timeSeconds);
  const bool inside = insideWindow(solved, wrapped(motion, solved, frame.timeSeconds));
  const Vec3 baseNow = positionOf(frame.worlds[at(solved.limb.joints.front())]);
  const bool ridesOn = !solved.settings.stayInWorld;
  if (!inside && (ridesOn || glm::length(baseNow - sample.base) <= 0.0)) {
    return;
  }
  const Amount amount = inside ? amountAt(motion, solved, sample) : Amount{};
  const Vec3 target =
      carriedPoint(scene, solved, sample, targetFrom(solved, sample, amount), sourceWorlds, frame);
  LimbShapeProblem problem;
  problem.points = limbPoints(solved.limb, frame.worlds);
  problem.target = target;
  problem.bendNormal =
      solved.bend.at(problem.points, rotationOf(frame.worlds[at(solved.limb.joints.front())]));
  problem.shortestReach = shortestReachOfRest * solved.limb.restLength;
  problem.stretchSwitch = solved.settings.stretchSwitch;
  problem.bend = solved.settings.bend;
  problem.restLength = solved.limb.restLength;
  problem.straightenAmount =
      solved.settings.stretchSwitch * amount.weight * amount.decay * 0.5 * solved.settings.blend;
  problem.grows = solved.settings.scale >= 1.0;
  const bool still = glm::length(target - problem.points.back()) <= 0.0;
  if (still && (problem.bend == Bend::keep || problem.straightenAmount <= 0.0)) {
    return;
  }
  const LimbShape shape = solveLimbShape(problem);
  if (!shape.isIdentity()) {
    deformLimb(scene, solved.limb, solved.topology, shape, {solved.settings.volume, solved.settings.turnEnd},
               frame);
  }
}

// The active trails that stand before `solved` from the root outwards.
void applyInnerTrails(const Scene& scene, const MotionState& motion, const SolvedTrail& solved,
                      const std::vector<Mat4>& sourceWorlds, FrameState& frame) {
  for (const SolvedTrail& inner : motion.trails) {
    if (&inner == &solved) {
      return;
    }
    if (inner.active) {
      applyTrail(scene, motion, inner, sourceWorlds, frame);
    }
  }
}

// Whether an active trail that is solved earlier may move this one's limb.
bool isCarried(const MotionState& motion, const SolvedTrail& solved) {
  return std::any_of(motion.trails.begin(), motion.trails.end(), [&](const SolvedTrail& other) {
    return other.active && solveOrder(other.limb.kind) < solveOrder(solved.limb.kind);
  });
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
  const std::vector<Mat4> bindWorlds = bindPoseWorlds(*input.scene);
  for (const Trail& trail : input.trails) {
    const auto limb = std::find_if(input.limbs.begin(), input.limbs.end(),
                                   [&](const Limb& l) { return l.id == trail.limb; });
    if (limb != input.limbs.end() && !limb->joints.empty()) {
      motion.trails.push_back(solveTrail(input, trail, *limb, bindWorlds));
    }
  }
  std::stable_sort(motion.trails.begin(), motion.trails.end(),
                   [](const SolvedTrail& a, const SolvedTrail& b) {
                     return solveOrder(a.limb.kind) < solveOrder(b.limb.kind);
                   });
  return motion;
}

Vec3 targetAt(const MotionState& motion, const SolvedTrail& solved, const LimbSample& sample) {
  if (!insideWindow(solved, wrapped(motion, solved, sample.timeSeconds))) {
    return sample.end;
  }
  return targetFrom(solved, sample, amountAt(motion, solved, sample));
}

FrameState evaluateMotion(const Scene& scene, const Clip& clip, const MotionState& motion,
                          double timeSeconds) {
  FrameState frame = frameOf(scene, samplePose(scene, clip, timeSeconds), timeSeconds);
  const std::vector<Mat4> sourceWorlds = frame.worlds;
  for (const SolvedTrail& solved : motion.trails) {
    if (solved.active) {
      applyTrail(scene, motion, solved, sourceWorlds, frame);
    }
  }
  return frame;
}

DrawnTrail pathsAt(const Scene& scene, const Clip& clip, const MotionState& motion, const SolvedTrail& solved,
                   const std::vector<double>& frames) {
  std::vector<int> nodes = touchedNodes(solved.limb, solved.topology);
  if (motion.hips >= 0) {
    nodes.push_back(motion.hips);
  }
  const NodeSampler sampler(scene, clip, nodes);
  const bool carried = isCarried(motion, solved);
  DrawnTrail drawn;
  drawn.frames = frames;
  std::vector<Mat4> worlds;
  for (const double frameNumber : frames) {
    const double time = frameNumber / motion.framesPerSecond;
    sampler.sample(time, worlds);
    const LimbSample sample = limbSample(solved.limb, solved.settings.space, motion.hips, worlds, time);
    drawn.original.push_back(sample.end);
    drawn.exaggerated.push_back(targetAt(motion, solved, sample));
    if (carried) {
      FrameState frame = frameOf(scene, samplePose(scene, clip, time), time);
      const std::vector<Mat4> sourceWorlds = frame.worlds;
      applyInnerTrails(scene, motion, solved, sourceWorlds, frame);
      for (Vec3* point : {&drawn.original.back(), &drawn.exaggerated.back()}) {
        *point = carriedPoint(scene, solved, sample, *point, sourceWorlds, frame);
      }
    }
  }
  return drawn;
}

DrawnTrail drawnPaths(const Scene& scene, const Clip& clip, const MotionState& motion,
                      const SolvedTrail& solved, std::size_t samplesPerFrame) {
  const double fps = motion.framesPerSecond;
  const double start = fps * std::max(solved.windowStartSeconds, std::min(0.0, clip.startSeconds));
  const double end = std::max(start, fps * std::min(solved.windowEndSeconds, clip.endSeconds));
  const auto perFrame = static_cast<double>(std::max<std::size_t>(1, samplesPerFrame));
  const auto count = static_cast<std::size_t>(std::floor((end - start) * perFrame + 1e-6)) + 1;
  std::vector<double> frames;
  for (std::size_t i = 0; i < count; ++i) {
    frames.push_back(start + static_cast<double>(i) / perFrame);
  }
  return pathsAt(scene, clip, motion, solved, frames);
}

Vec2 defaultRange(const Scene& scene, const Clip& clip, const Limb& limb) {
  const double last = clip.endSeconds * clip.framesPerSecond;
  std::vector<int> nodes = limb.joints;
  if (limb.endNode >= 0) {
    nodes.push_back(limb.endNode);
  }
  const NodeSampler sampler(scene, clip, nodes);
  std::vector<Mat4> worlds;
  const auto reachAt = [&](double frame) {
    sampler.sample(frame / clip.framesPerSecond, worlds);
    return endPosition(limb, worlds) - positionOf(worlds[at(limb.joints.front())]);
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

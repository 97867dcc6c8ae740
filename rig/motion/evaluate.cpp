#include "rig/motion/evaluate.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/anim/key_time.h"
#include "core/base/index.h"
#include "rig/adjust/apply_adjustments.h"
#include "rig/ik/limb_shape.h"
#include "rig/limb.h"
#include "rig/motion/keep_held.h"
#include "rig/motion/range_offset.h"
#include "rig/motion/release_length.h"
#include "rig/motion/stop.h"
#include "rig/reach/limb_deform.h"

namespace stretch::rig {

namespace {

constexpr double shortestReachOfRest = 1e-3;

bool insideWindow(const SolvedTrail& solved, double timeSeconds) {
  const double rounding = keyTimeRounding(timeSeconds);
  return timeSeconds >= solved.windowStartSeconds - rounding &&
         timeSeconds <= solved.windowEndSeconds + rounding;
}

// Before its first key a clip that loops holds what it has there.
double heldTime(const MotionState& motion, const SolvedTrail& solved, double timeSeconds) {
  return motion.loops ? std::max(timeSeconds, firstSeconds(motion, solved)) : timeSeconds;
}

// Whether a time falls into a trail's window, on a loop one turn later or earlier as well.
bool actsAt(const MotionState& motion, const SolvedTrail& solved, double timeSeconds) {
  const double turn = motion.loops ? motion.endSeconds - motion.startSeconds : 0.0;
  const double held = heldTime(motion, solved, timeSeconds);
  return insideWindow(solved, held) || insideWindow(solved, held - turn) || insideWindow(solved, held + turn);
}

// How far past the tip (release) and before the pivot (fade) a time outside the range lies: on a loop both,
// round it.
struct Outside {
  double pastTip = 0.0;
  double pastPivot = 0.0;
};

Outside outsideOf(const MotionState& motion, const SolvedTrail& solved, double timeSeconds) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto past = [&](double seconds) {
    const double aTurnLater = std::max(0.0, seconds + motion.endSeconds - motion.startSeconds);
    return seconds >= 0.0 ? seconds : motion.loops ? aTurnLater : never;
  };
  const double before = past(solved.startSeconds - timeSeconds);
  const double after = past(timeSeconds - solved.endSeconds);
  const bool forwards = solved.settings.pivot == Pivot::start;
  return {forwards ? after : before, forwards ? before : after};
}

// The limb's own amount at a time: w, w times the decay in the release.
struct Amount {
  double weight = 0.0;
  double decay = 1.0;
  Vec3 offset{0.0};
};

Amount amountAt(const MotionState& motion, const SolvedTrail& solved, const LimbSample& sample) {
  const double framesPerSecond = motion.framesPerSecond;
  const double timeSeconds = heldTime(motion, solved, sample.timeSeconds);
  const double rounding = keyTimeRounding(timeSeconds);
  if (timeSeconds >= solved.startSeconds - rounding && timeSeconds <= solved.endSeconds + rounding) {
    const double weight = solved.remap.at(solved.path.ratioAt(timeSeconds));
    return {weight, 1.0, rangeOffset(solved, sample, timeSeconds * framesPerSecond, weight)};
  }
  // The tip's own offset, which decays: the limb goes on with the clip below it. What is pulled at the pivot
  // fades in, on a loop while the other decays where there is no room for one after the other.
  const Outside outside = outsideOf(motion, solved, timeSeconds);
  const double decay = solved.release.at(outside.pastTip);
  const double fade =
      solved.release.seconds() > 0.0 ? 1.0 - smoothstep(outside.pastPivot / solved.release.seconds()) : 0.0;
  const Vec3 tip = rangeOffset(solved, tipSample(solved), solved.tipSeconds * framesPerSecond, 1.0);
  const Vec3 pivot = solved.path.axes * pivotOffset(solved, framesPerSecond);
  return {1.0, decay, decay * tip + fade * pivot};
}

// What carries a limb's base: the end of a limb with a trail where the base goes along with that, else its
// parent.
NodeIndex carrierOf(const Scene& scene, const MotionState& motion, NodeIndex base) {
  const auto carrier = std::ranges::find_if(motion.trails, [&](const SolvedTrail& inner) {
    return inner.active &&
           std::ranges::find(inner.topology.companions, base) != inner.topology.companions.end();
  });
  return carrier != motion.trails.end() ? carrier->limb.endNode : scene.nodes[at(base)].parent;
}

// How inner trails carry what hangs on a limb's base: it moves and turns with what carries the base.
struct Carry {
  bool still = true;
  Vec3 baseBefore{0.0};
  Vec3 baseNow{0.0};
  Quat turn{1.0, 0.0, 0.0, 0.0};

  [[nodiscard]] Vec3 point(const Vec3& world) const {
    return still ? world : baseNow + turn * (world - baseBefore);
  }
  [[nodiscard]] Vec3 vector(const Vec3& world) const { return still ? world : turn * world; }
};

Carry carryOf(const Scene& scene, const MotionState& motion, const SolvedTrail& solved,
              const LimbSample& sample, const FrameState& source, const FrameState& frame) {
  const NodeIndex base = stayingNode(solved.limb);
  Carry carry;
  carry.still = solved.settings.stayInWorld || frame.worlds[at(base)] == source.worlds[at(base)];
  carry.baseBefore = sample.base;
  carry.baseNow = stayingPosition(solved.limb, frame);
  const NodeIndex carrier = carry.still ? NodeIndex::none : carrierOf(scene, motion, base);
  if (carrier.exists()) {
    carry.turn = rotationOf(frame.worlds[at(carrier)]) * glm::inverse(rotationOf(source.worlds[at(carrier)]));
  }
  return carry;
}

// Whether an active trail of the same limb that acts earlier moves it at this time: the limb starts from
// where that one leaves it, so that the release of the one lasts into the range of the next.
bool followsAnother(const MotionState& motion, std::size_t trail, double timeSeconds) {
  const std::string& limb = motion.trails[trail].limb.id;
  return std::any_of(motion.trails.begin(), motion.trails.begin() + static_cast<std::ptrdiff_t>(trail),
                     [&](const SolvedTrail& earlier) {
                       return earlier.active && earlier.limb.id == limb &&
                              actsAt(motion, earlier, timeSeconds);
                     });
}

// Where the end would be without this trail and where the trail wants it, inner trails included.
struct Target {
  Vec3 original{0.0};
  Vec3 wanted{0.0};
};

Target targetIn(const FrameState& frame, const Carry& carry, const MotionState& motion, std::size_t trail,
                const LimbSample& sample, const Amount& amount) {
  const SolvedTrail& solved = motion.trails[trail];
  Target target;
  target.original = followsAnother(motion, trail, sample.timeSeconds) ? leadingPosition(solved.limb, frame)
                                                                      : carry.point(sample.end);
  target.wanted = target.original + carry.vector(0.5 * solved.settings.blend * amount.offset);
  if (solved.settings.stopAt) {
    target.wanted =
        stoppedTarget(solved, {carry.baseNow, target.original, target.wanted, sample.timeSeconds});
  }
  return target;
}

// Outside its window a trail has only what keeps its limb in the world to do, where an inner trail moves the
// base.
bool hasNothingToDo(const MotionState& motion, std::size_t trail, const LimbSample& sample,
                    const FrameState& frame) {
  const SolvedTrail& solved = motion.trails[trail];
  if (actsAt(motion, solved, sample.timeSeconds)) {
    return false;
  }
  const Vec3 baseNow = stayingPosition(solved.limb, frame);
  return !solved.settings.stayInWorld || glm::length(baseNow - sample.base) <= 0.0 ||
         followsAnother(motion, trail, sample.timeSeconds);
}

Amount amountOrNone(const MotionState& motion, const SolvedTrail& solved, const LimbSample& sample) {
  return actsAt(motion, solved, sample.timeSeconds) ? amountAt(motion, solved, sample) : Amount{};
}

LimbShapeProblem shapeProblem(const SolvedTrail& solved, const Amount& amount, const Vec3& target,
                              const FrameState& frame) {
  LimbShapeProblem problem;
  problem.points = pointsToLead(solved.limb, frame);
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
  return problem;
}

} // namespace

FrameState sampledFrame(const Scene& scene, const Clip& clip, double timeSeconds) {
  const double heldSeconds = std::min(timeSeconds, clip.endSeconds);
  return frameOf(scene, samplePose(scene, clip, heldSeconds), heldSeconds);
}

FrameState adjustedFrame(const Scene& scene, const Clip& clip, const MotionState& motion,
                         double timeSeconds) {
  FrameState frame = sampledFrame(scene, clip, timeSeconds);
  applyAdjustments(scene, motion.adjustments, frame);
  return frame;
}

std::vector<HeldGoal> applyTrailsAndHolds(const Scene& scene, const MotionState& motion, FrameState& frame) {
  const FrameState source = frame;
  for (std::size_t trail = 0; trail < motion.trails.size(); ++trail) {
    if (motion.trails[trail].active) {
      applyTrail(scene, motion, trail, source, frame);
    }
  }
  return applyHolds(scene, motion, source, frame);
}

void applyAfterHolds(const Scene& scene, const MotionState& motion, std::vector<HeldGoal>& goals,
                     FrameState& frame) {
  const FrameState before = goals.empty() || motion.weights.empty() ? FrameState{} : frame;
  applyWeight(scene, motion.weights, motion.hips, motion.outline, frame);
  if (!before.worlds.empty()) {
    keepHeld(scene, motion, before, goals, frame);
  }
}

void applyMotion(const Scene& scene, const MotionState& motion, FrameState& frame) {
  std::vector<HeldGoal> goals = applyTrailsAndHolds(scene, motion, frame);
  applyAfterHolds(scene, motion, goals, frame);
}

FrameState evaluateMotion(const Scene& scene, const Clip& clip, const MotionState& motion,
                          double timeSeconds) {
  FrameState frame = adjustedFrame(scene, clip, motion, timeSeconds);
  applyMotion(scene, motion, frame);
  frame.timeSeconds = timeSeconds;
  return frame;
}

void applyTrail(const Scene& scene, const MotionState& motion, std::size_t trail, const FrameState& source,
                FrameState& frame) {
  const SolvedTrail& solved = motion.trails[trail];
  const LimbSample sample = limbSample(solved.limb, solved.settings.space, motion.hips, source);
  if (hasNothingToDo(motion, trail, sample, frame)) {
    return;
  }
  const Amount amount = amountOrNone(motion, solved, sample);
  const Carry carry = carryOf(scene, motion, solved, sample, source, frame);
  const Vec3 target = targetIn(frame, carry, motion, trail, sample, amount).wanted;
  const LimbShapeProblem problem = shapeProblem(solved, amount, target, frame);
  const bool still = glm::length(target - problem.points.back()) <= 0.0;
  if (still && (problem.bend == Bend::keep || problem.straightenAmount <= 0.0)) {
    return;
  }
  const LimbShape shape = solveLimbShape(problem);
  if (!shape.isIdentity()) {
    deformLimb(scene, solved.limb, solved.topology, poseToLead(solved.limb, shape, frame),
               {solved.settings.volume, solved.settings.turnEnd}, frame);
  }
}

PathPoint pathPoint(const Scene& scene, const MotionState& motion, std::size_t trail,
                    const FrameState& source, const FrameState& frame) {
  const SolvedTrail& solved = motion.trails[trail];
  const LimbSample sample = limbSample(solved.limb, solved.settings.space, motion.hips, source);
  const Carry carry = carryOf(scene, motion, solved, sample, source, frame);
  const Amount amount = amountOrNone(motion, solved, sample);
  return {carry.point(sample.end), targetIn(frame, carry, motion, trail, sample, amount).wanted};
}

} // namespace stretch::rig

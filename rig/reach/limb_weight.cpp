#include "rig/reach/limb_weight.h"
#include "rig/limb.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/anim/key_time.h"
#include "core/base/index.h"
#include "rig/ik/limb_shape.h"
#include "rig/ik/two_bone.h"
#include "rig/reach/limb_deform.h"
#include "rig/trail/release.h"

namespace stretch::rig {

namespace {

const Vec3 up(0.0, 1.0, 0.0);

double fadeAt(const LimbWeight& weight, double timeSeconds) {
  const double rounding = keyTimeRounding(timeSeconds);
  if (timeSeconds < weight.startSeconds - rounding || timeSeconds > weight.endSeconds + rounding) {
    return 0.0;
  }
  const double in = weight.fadeInSeconds > 0.0
                        ? smoothstep((timeSeconds - weight.startSeconds) / weight.fadeInSeconds)
                        : 1.0;
  const double out = weight.fadeOutSeconds > 0.0
                         ? smoothstep((weight.endSeconds - timeSeconds) / weight.fadeOutSeconds)
                         : 1.0;
  return std::min(in, out);
}

WeightSample between(const WeightSample& a, const WeightSample& b, double timeSeconds) {
  const double length = b.timeSeconds - a.timeSeconds;
  const double t = length > 0.0 ? (timeSeconds - a.timeSeconds) / length : 0.0;
  WeightSample sample = a;
  sample.planted += t * (b.planted - a.planted);
  sample.kept += t * (b.kept - a.kept);
  for (std::size_t i = 0; i < sample.strains.size(); ++i) {
    sample.strains[i] += (b.strains[i] - a.strains[i]) * t;
  }
  return sample;
}

bool isZero(const Mat3& matrix) {
  return matrix == Mat3(0.0);
}

// The part of a strain that has the bone as an axis: then K keeps the bone's direction, and K of a trail and
// this one are one symmetric matrix whichever comes first.
Mat3 alignedStretch(const Mat3& strain, const Vec3& unitAxis) {
  const Mat3 along = glm::outerProduct(unitAxis, unitAxis);
  const Mat3 across = Mat3(1.0) - along;
  return Mat3(1.0) + along * glm::dot(unitAxis, strain * unitAxis) + across * strain * across;
}

std::vector<Mat3> stretchesOf(const SolvedWeight& solved, const WeightSample& sample,
                              const FrameState& frame) {
  const std::vector<Vec3> points = limbPoints(solved.limb, frame);
  std::vector<Mat3> stretches;
  for (std::size_t i = 0; i < solved.limb.joints.size(); ++i) {
    const Mat4& world = frame.worlds[at(solved.limb.joints[i])];
    const Vec3 bone = points[i + 1] - points[i];
    const bool usable = glm::length(bone) > 0.0 && glm::determinant(Mat3(world)) != 0.0;
    stretches.push_back(
        usable ? alignedStretch(sample.strains[i], glm::normalize(transformVector(glm::inverse(world), bone)))
               : Mat3(1.0));
  }
  return stretches;
}

// A limb on its way through applyWeight.
struct Moving {
  const SolvedWeight* solved = nullptr;
  double planted = 0.0;
  double kept = 0.0;
  Vec3 endBefore{0.0};
  Vec3 endMove{0.0};  // by its own strain alone
  double depth = 0.0; // from the end down to the lowest point of the hand or foot
  double floor = 0.0; // how low that may get
};

Moving movingOf(const SolvedWeight& solved, const WeightSample& sample, const BodyOutline& outline,
                double floor, const FrameState& frame) {
  Moving moving{&solved, sample.planted, sample.kept, endPosition(solved.limb, frame), {}, 0.0, floor};
  const double lowest = lowestOf(outline, solved.ends, frame).value_or(moving.endBefore.y);
  moving.depth = moving.endBefore.y - lowest;
  moving.floor = std::min(floor, lowest);
  return moving;
}

void giveWay(const Scene& scene, const SolvedWeight& solved, const WeightSample& sample, FrameState& frame) {
  if (!std::all_of(sample.strains.begin(), sample.strains.end(), isZero)) {
    stretchLimb(scene, solved.limb, solved.topology, stretchesOf(solved, sample, frame), frame);
  }
}

// What the legs that stand lost on average along +Y, negative: the hips go down by it.
double lostByLegs(const std::vector<Moving>& limbs) {
  double lost = 0.0;
  double standing = 0.0;
  for (const Moving& leg : limbs) {
    lost += leg.planted * leg.endMove.y;
    standing += leg.planted;
  }
  return standing > 0.0 ? -lost / standing * std::min(1.0, standing) : 0.0;
}

// How far up the hips have to go, once moved by `move`, so that no foot that hangs free gets too low.
double liftOfFeet(const std::vector<Moving>& limbs, double move) {
  double lift = 0.0;
  double touching = 0.0;
  for (const Moving& leg : limbs) {
    if (isLeg(leg.solved->limb)) {
      lift = std::max(lift, leg.floor - (leg.endBefore.y - leg.depth + leg.endMove.y + move));
      touching = std::max(touching, leg.kept);
    }
  }
  return (1.0 - touching) * lift;
}

double hipsMove(const std::vector<Moving>& limbs, double floor, double lowestRiding) {
  const bool anyLeg =
      std::any_of(limbs.begin(), limbs.end(), [](const Moving& one) { return isLeg(one.solved->limb); });
  if (!anyLeg) {
    return 0.0;
  }
  const double lost = lostByLegs(limbs);
  return std::max(lost + liftOfFeet(limbs, lost), floor - lowestRiding);
}

// How much of a change of its reach a leg takes by bending, 0..1. A straight one would have to bend a lot for
// a little, and does not: it is scaled instead.
double bendingShare(double straightness) {
  constexpr double straight = 0.995; // of the sum of its bones
  constexpr double bent = 0.97;
  return smoothstep((straight - straightness) / (straight - bent));
}

// A limb of two bones brought to a target, by its knee as far as that is bent, and scaled as a whole for the
// rest; nothing where it has no length.
std::optional<LimbPose> bentTo(const std::vector<Vec3>& points, const Vec3& target) {
  const double bones = glm::length(points[1] - points[0]) + glm::length(points[2] - points[1]);
  const double reach = glm::length(points[2] - points[0]);
  const double wanted = glm::length(target - points[0]);
  if (!(reach > 0.0) || !(wanted > 0.0)) {
    return std::nullopt;
  }
  constexpr double nearlyStraight = 0.998;
  const double byBending = std::min(reach * std::pow(wanted / reach, bendingShare(reach / bones)),
                                    std::max(reach, nearlyStraight * bones));
  const double scale = wanted / byBending;
  TwoBoneProblem problem;
  problem.base = points[0];
  problem.joint = points[0] + scale * (points[1] - points[0]);
  problem.end = points[0] + scale * (points[2] - points[0]);
  problem.target = target;
  const TwoBoneShape shape = solveTwoBone(problem);
  if (shape.outcome != ShapeOutcome::reached) {
    return std::nullopt;
  }
  const double stretch = scale * shape.scale;
  return LimbPose{{shape.turns[0], shape.turns[1]}, {stretch, stretch}, Vec3(0.0), shape.end};
}

// Turns and scales a limb as a whole.
void scaleTo(const Scene& scene, const Limb& limb, const LimbTopology& topology, const Vec3& target,
             FrameState& frame) {
  constexpr double shortestReachOfRest = 1e-3;
  LimbShapeProblem problem;
  problem.points = limbPoints(limb, frame);
  problem.target = target;
  problem.shortestReach = shortestReachOfRest * limb.restLength;
  problem.restLength = limb.restLength;
  const LimbShape shape = solveLimbShape(problem);
  if (!shape.isIdentity()) {
    deformLimb(scene, limb, topology, limbPose(shape), {}, frame);
  }
}

// Brings a limb's end to a place from wherever it went.
void bringTo(const Scene& scene, const SolvedWeight& solved, const Vec3& target, FrameState& frame) {
  if (glm::length(target - endPosition(solved.limb, frame)) <= 0.0) {
    return;
  }
  if (isLeg(solved.limb)) {
    bendBack(scene, solved.limb, solved.topology, target, frame);
  } else {
    scaleTo(scene, solved.limb, solved.topology, target, frame);
  }
}

// A foot on the ground where it was, another one and a hand no lower than allowed.
void putDown(const Scene& scene, const Moving& moving, FrameState& frame) {
  const Vec3 now = endPosition(moving.solved->limb, frame);
  Vec3 target = isLeg(moving.solved->limb) ? now + moving.kept * (moving.endBefore - now) : now;
  target.y = std::max(target.y, moving.floor + moving.depth);
  bringTo(scene, *moving.solved, target, frame);
}

bool isUnder(const Scene& scene, NodeIndex node, const std::vector<NodeIndex>& nodes) {
  for (NodeIndex above = scene.nodes[at(node)].parent; above.exists();
       above = scene.nodes[at(above)].parent) {
    if (std::find(nodes.begin(), nodes.end(), above) != nodes.end()) {
      return true;
    }
  }
  return false;
}

// The hips, and what belongs to a limb but does not hang on them: a foot under the root.
std::vector<NodeIndex> goingWithHips(const Scene& scene, const std::vector<Moving>& limbs, NodeIndex hips) {
  std::vector<NodeIndex> all{hips};
  for (const Moving& one : limbs) {
    const Limb& limb = one.solved->limb;
    if (!isUnder(scene, limb.joints.front(), {hips})) {
      continue;
    }
    all.insert(all.end(), limb.joints.begin(), limb.joints.end());
    all.insert(all.end(), one.solved->topology.companions.begin(), one.solved->topology.companions.end());
    if (limb.endNode.exists()) {
      all.push_back(limb.endNode);
    }
  }
  std::vector<NodeIndex> highest;
  std::copy_if(all.begin(), all.end(), std::back_inserter(highest),
               [&](NodeIndex node) { return !isUnder(scene, node, all); });
  return highest;
}

void moveHips(const Scene& scene, const std::vector<Moving>& limbs, NodeIndex hips, double move,
              FrameState& frame) {
  if (!hips.exists() || move == 0.0) {
    return;
  }
  for (const NodeIndex node : goingWithHips(scene, limbs, hips)) {
    moveNode(scene, node, positionOf(frame.worlds[at(node)]) + move * up, frame);
  }
}

} // namespace

WeightSample weightAt(const LimbWeight& weight, double timeSeconds) {
  if (weight.samples.empty()) {
    return {timeSeconds, {}, 0.0, 1.0};
  }
  const auto after = std::lower_bound(
      weight.samples.begin(), weight.samples.end(), timeSeconds,
      [](const WeightSample& sample, double seconds) { return sample.timeSeconds < seconds; });
  WeightSample sample = weight.samples.back();
  if (after == weight.samples.begin()) {
    sample = weight.samples.front();
  } else if (after != weight.samples.end()) {
    sample = between(*(after - 1), *after, timeSeconds);
  }
  sample.timeSeconds = timeSeconds;
  const double fade = fadeAt(weight, timeSeconds);
  if (fade <= 0.0) {
    return {timeSeconds, {}, 0.0, sample.kept};
  }
  for (Mat3& strain : sample.strains) {
    strain *= fade;
  }
  return sample;
}

void bendBack(const Scene& scene, const Limb& limb, const LimbTopology& topology, const Vec3& target,
              FrameState& frame) {
  const std::vector<Vec3> points = limbPoints(limb, frame);
  if (points.size() == 3) {
    if (const std::optional<LimbPose> bent = bentTo(points, target)) {
      deformLimb(scene, limb, topology, *bent, {}, frame);
      return;
    }
  }
  scaleTo(scene, limb, topology, target, frame);
}

void applyWeight(const Scene& scene, const std::vector<SolvedWeight>& weights, NodeIndex hips,
                 const BodyOutline& outline, FrameState& frame) {
  constexpr double bottomless = -std::numeric_limits<double>::infinity();
  std::vector<WeightSample> samples;
  bool anyGives = false;
  for (const SolvedWeight& solved : weights) {
    samples.push_back(weightAt(solved.weight, frame.timeSeconds));
    const std::vector<Mat3>& strains = samples.back().strains;
    anyGives = anyGives || !std::all_of(strains.begin(), strains.end(), isZero);
  }
  if (!anyGives) {
    return;
  }
  const double floor = lowestOf(outline, outline.body, frame).value_or(bottomless);
  std::vector<Moving> limbs;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    limbs.push_back(movingOf(weights[i], samples[i], outline, floor, frame));
    giveWay(scene, weights[i], samples[i], frame);
    limbs.back().endMove = endPosition(weights[i].limb, frame) - limbs.back().endBefore;
  }
  const double lowestRiding = lowestOf(outline, outline.riding, frame).value_or(-bottomless);
  moveHips(scene, limbs, hips, hipsMove(limbs, floor, lowestRiding), frame);
  for (const Moving& moving : limbs) {
    if (isLeg(moving.solved->limb) || isArm(moving.solved->limb)) {
      putDown(scene, moving, frame);
    }
  }
}

} // namespace stretch::rig

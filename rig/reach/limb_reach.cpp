#include "rig/reach/limb_reach.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "core/math/polyline.h"
#include "core/math/rotation.h"
#include "rig/controllers/controller.h"
#include "rig/ik/limb_shape.h"
#include "rig/reach/limb_deform.h"
#include "rig/trail/limb_path.h"

namespace stretch::rig {

namespace {

Vec3 baseInBind(const BindPlaces& places, const Limb& limb) {
  return positionOf(places.worlds[at(limb.joints.front())]);
}

std::vector<double> alongOf(const Limb& limb, const BindPlaces& places) {
  std::vector<double> along = lengthsAlong(limbPoints(limb, places.worlds));
  const double whole = along.back();
  for (std::size_t i = 0; i < along.size(); ++i) {
    along[i] =
        whole > 0.0 ? along[i] / whole : static_cast<double>(i) / static_cast<double>(along.size() - 1);
  }
  return along;
}

// The poses of a limb over the clip.
struct SampledPose {
  double timeSeconds = 0.0;
  std::vector<Vec3> points;
  Quat base{1.0, 0.0, 0.0, 0.0};
};

std::vector<SampledPose> posesOf(const ReachInput& input, const Limb& limb) {
  constexpr double mostSamples = 200.0;
  const NodeSampler sampler(input.scene, input.clip, jointsAndEnd(limb));
  const double length = std::max(0.0, input.clip.endSeconds - input.clip.startSeconds);
  const double count = std::clamp(std::ceil(length * input.clip.framesPerSecond), 1.0, mostSamples);
  std::vector<SampledPose> poses;
  FrameState frame;
  for (double i = 0.0; i <= count; i += 1.0) {
    const double time = input.clip.startSeconds + length * i / count;
    sampler.sample(time, frame);
    poses.push_back({time, limbPoints(limb, frame), rotationOf(frame.worlds[at(limb.joints.front())])});
  }
  return poses;
}

// Of each point, the sum over the poses.
std::vector<double> bendAngles(const std::vector<SampledPose>& poses) {
  std::vector<double> angles(poses.front().points.size(), 0.0);
  for (const SampledPose& pose : poses) {
    for (std::size_t p = 1; p + 1 < pose.points.size(); ++p) {
      angles[p] += angleBetween(pose.points[p] - pose.points[p - 1], pose.points[p + 1] - pose.points[p]);
    }
  }
  return angles;
}

// A limb that never bends takes its middle for the elbow or knee.
std::size_t bendPointOf(const std::vector<double>& angles, const std::vector<double>& along) {
  const std::size_t last = along.size() - 1;
  if (last < 2) {
    return 0;
  }
  constexpr double leastRadians = 0.02; // over all poses
  std::size_t best = 1;
  for (std::size_t i = 2; i < last; ++i) {
    const bool clear = std::max(angles[i], angles[best]) > leastRadians;
    const bool better =
        clear ? angles[i] > angles[best] : std::abs(along[i] - 0.5) < std::abs(along[best] - 0.5);
    best = better ? i : best;
  }
  return best;
}

// Knees forward and elbows back, where the clip does not tell.
BendDirections bendsOf(const ReachInput& input, const Limb& limb, std::size_t bendPoint,
                       const std::vector<SampledPose>& poses) {
  const Quat base = rotationOf(input.places.worlds[at(limb.joints.front())]);
  const Vec3 forward = facingInBind(input.limbs, input.places);
  BendDirections bends(glm::inverse(base) * (isLeg(limb) ? forward : -forward));
  for (const SampledPose& pose : poses) {
    bends.add(pose.timeSeconds, pose.points.front(), pose.points[bendPoint], pose.points.back(), pose.base);
  }
  bends.keepClear();
  return bends;
}

// As a limb of two spans; answers as reachAsOne does.
Vec3 bendTo(const Scene& scene, const ReachingLimb& reaching, const ReachGoal& goal, FrameState& frame) {
  const Limb& limb = reaching.limb;
  TwoBoneProblem problem = posedLimb(reaching, frame);
  problem.target = goal.place;
  problem.poleOffset = goal.pole;
  problem.softness = goal.softness;
  problem.stretchSwitch = goal.stretchSwitch;
  const TwoBoneShape shape = solveTwoBone(problem);
  LimbPose pose;
  pose.turns.reserve(limb.joints.size());
  pose.stretches.assign(limb.joints.size(), shape.scale);
  for (std::size_t bone = 0; bone < limb.joints.size(); ++bone) {
    pose.turns.push_back(shape.turns[bone < reaching.bendPoint ? 0 : 1]);
  }
  pose.end = shape.end;
  deformLimb(scene, limb, reaching.topology, pose, {goal.volume, false, goal.endTurn}, frame);
  return shape.end;
}

std::optional<Mat4> endMatrix(const Limb& limb, const FrameState& frame) {
  return limb.endNode.exists() ? std::optional(frame.worlds[at(limb.endNode)]) : std::nullopt;
}

// Left and right, legs before arms before others.
std::vector<std::pair<const Limb*, const Limb*>> pairsOf(const std::vector<Limb>& limbs) {
  std::vector<std::pair<const Limb*, const Limb*>> pairs;
  for (const Limb& limb : limbs) {
    const Limb* const other = limb.side == LimbSide::left ? limbAt(limbs, mirrored(limb)) : nullptr;
    if (other != nullptr && !limb.joints.empty()) {
      pairs.emplace_back(&limb, other);
    }
  }
  std::stable_partition(pairs.begin(), pairs.end(), [](const auto& pair) { return isLeg(*pair.first); });
  return pairs;
}

} // namespace

Vec3 facingInBind(const std::vector<Limb>& limbs, const BindPlaces& places) {
  const Vec3 up(0.0, 1.0, 0.0);
  for (const auto& [left, right] : pairsOf(limbs)) {
    const Vec3 forward = glm::cross(baseInBind(places, *left) - baseInBind(places, *right), up);
    if (glm::length(forward) > 0.0) {
      return glm::normalize(forward);
    }
  }
  return {0.0, 0.0, 1.0};
}

TwoBoneProblem posedLimb(const ReachingLimb& reaching, const FrameState& frame) {
  const std::vector<NodeIndex>& joints = reaching.limb.joints;
  const Mat4& base = frame.worlds[at(joints.front())];
  TwoBoneProblem problem;
  problem.base = positionOf(base);
  problem.end = endPosition(reaching.limb, frame);
  problem.joint = positionOf(frame.worlds[at(joints[reaching.bendPoint])]);
  problem.target = problem.end;
  problem.usualBend = rotationOf(base) * reaching.bends.at(frame.timeSeconds);
  return problem;
}

ReachingLimb reachingLimb(const ReachInput& input, const Limb& limb) {
  ReachingLimb reaching;
  reaching.limb = limb;
  reaching.topology = limbTopology(input.scene, limb, input.limbs, input.places);
  reaching.along = alongOf(limb, input.places);
  if (hasElbowOrKnee(limb) || limb.kind == LimbKind::chain) {
    const std::vector<SampledPose> poses = posesOf(input, limb);
    reaching.bendPoint = bendPointOf(bendAngles(poses), reaching.along);
    reaching.bends = bendsOf(input, limb, reaching.bendPoint, poses);
  }
  return reaching;
}

Vec3 reachAsOne(const Scene& scene, const ReachingLimb& reaching, const ReachGoal& goal, FrameState& frame) {
  const Limb& limb = reaching.limb;
  LimbShapeProblem problem;
  problem.points = limbPoints(limb, frame);
  problem.target = goal.place;
  problem.shortestReach = 1e-3 * limb.restLength;
  problem.restLength = limb.restLength;
  problem.stretchSwitch = goal.stretchSwitch;
  const LimbShape shape = solveLimbShape(problem);
  deformLimb(scene, limb, reaching.topology, limbPose(shape), {goal.volume, false, goal.endTurn}, frame);
  return shape.end;
}

// Joints that hang in unevenly scaled ones do not turn as stiff bones do: what the limb misses its goal by
// is solved again from where it came to. Rotations that a file holds in single precision are not worth
// another try: they are off by some 5e-7 of the limb.
void reach(const Scene& scene, const ReachingLimb& reaching, const ReachGoal& goal, FrameState& frame) {
  constexpr int mostTries = 24;
  constexpr double unseen = 1e-6; // of the limb
  const double near = unseen * reaching.limb.restLength;
  const std::optional<Mat4> before = endMatrix(reaching.limb, frame);
  ReachGoal next = goal;
  for (int tries = 0; tries < mostTries; ++tries) {
    const Vec3 end = reaching.bendPoint > 0 ? bendTo(scene, reaching, next, frame)
                                            : reachAsOne(scene, reaching, next, frame);
    const bool isReachable = glm::length(goal.place - end) <= near;
    if (!isReachable || glm::length(goal.place - endPosition(reaching.limb, frame)) <= near) {
      return;
    }
    next.pole = Vec3(0.0);
    if (before) {
      const Quat wanted = goal.endTurn * rotationOf(*before);
      next.endTurn = wanted * glm::inverse(rotationOf(*endMatrix(reaching.limb, frame)));
    }
  }
}

} // namespace stretch::rig

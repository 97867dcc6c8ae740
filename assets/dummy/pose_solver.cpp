#include "assets/dummy/pose_solver.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace stretch::assets {

namespace {

Quat turned(const Vec3& degrees) {
  const Vec3 angles = degrees * (pi / 180.0);
  return glm::angleAxis(angles.y, Vec3(0.0, 1.0, 0.0)) * glm::angleAxis(angles.x, Vec3(1.0, 0.0, 0.0)) *
         glm::angleAxis(angles.z, Vec3(0.0, 0.0, 1.0));
}

/// Right-handed frame whose first axis is `first` and whose second lies towards `second`.
Mat3 frameOf(const Vec3& first, const Vec3& second) {
  const Vec3 x = glm::normalize(first);
  const Vec3 y = glm::normalize(second - glm::dot(second, x) * x);
  return {x, y, glm::cross(x, y)};
}

/// Rotation that carries one pair of directions to another.
Quat rotationBetween(const Mat3& from, const Mat3& to) {
  return glm::normalize(glm::quat_cast(to * glm::transpose(from)));
}

/// The part of a rotation that turns about `axis` (unit).
Quat twistOf(const Quat& rotation, const Vec3& axis) {
  const double along = glm::dot(Vec3(rotation.x, rotation.y, rotation.z), axis);
  const Quat twist(rotation.w, along * axis.x, along * axis.y, along * axis.z);
  return glm::normalize(rotation.w < 0.0 ? -twist : twist);
}

/// Distance that a limb of length `reach` spans when asked for `wanted`: eased towards straight, never quite
/// there.
double easedReach(double wanted, double reach) {
  const double start = 0.94 * reach;
  const double room = 0.055 * reach;
  return wanted <= start ? wanted : start + room * (1.0 - std::exp(-(wanted - start) / room));
}

struct Solver {
  const std::vector<Joint>& skeleton;
  const Pose& pose;
  SolvedPose solved;

  [[nodiscard]] std::size_t joint(const std::string& name) const {
    return static_cast<std::size_t>(jointIndex(skeleton, name));
  }
  [[nodiscard]] Vec3 bindOffset(std::size_t from, std::size_t to) const {
    return skeleton[to].position - skeleton[from].position;
  }

  /// Puts a joint where its parent carries it, with the given world rotation.
  void place(std::size_t j, const Quat& rotation) {
    const auto parent = static_cast<std::size_t>(skeleton[j].parent);
    solved.positions[j] = solved.positions[parent] + solved.rotations[parent] * bindOffset(parent, j);
    solved.rotations[j] = rotation;
  }
};

void solveTrunk(Solver& solver) {
  const Quat hips = solver.solved.rotations[0];
  const Quat chest = turned(solver.pose[Control::chestTurn]);
  const Quat head = turned(solver.pose[Control::headTurn]);
  solver.place(solver.joint("Spine"), glm::slerp(hips, chest, 0.30));
  solver.place(solver.joint("Spine1"), glm::slerp(hips, chest, 0.68));
  solver.place(solver.joint("Spine2"), chest);
  solver.place(solver.joint("Neck"), glm::slerp(chest, head, 0.45));
  solver.place(solver.joint("Head"), head);
}

/// Upper and lower bone of a limb whose first joint is placed, so that its end comes to `target` with the
/// middle joint towards `pole`.
struct Limb {
  std::size_t upper;
  std::size_t lower;
  std::size_t end;
};

/// `firmness`, 0 to 1: how much of the easing towards straight is left out.
void solveLimb(Solver& solver, const Limb& limb, const Vec3& target, const Vec3& pole, double firmness) {
  const Vec3 upperBind = solver.bindOffset(limb.upper, limb.lower);
  const Vec3 lowerBind = solver.bindOffset(limb.lower, limb.end);
  const double upperLength = glm::length(upperBind);
  const double lowerLength = glm::length(lowerBind);
  const Vec3 span = target - solver.solved.positions[limb.upper];
  const double wanted = glm::length(span);
  const double reach = upperLength + lowerLength;
  const double eased = easedReach(wanted, reach);
  const double distance = firmness < 1.0 ? eased + firmness * (std::min(wanted, 0.9999 * reach) - eased)
                                         : std::min(wanted, 0.9999 * reach);
  const Vec3 direction = span / wanted;
  const Vec3 side = frameOf(direction, pole)[1];
  const double along =
      (upperLength * upperLength - lowerLength * lowerLength + distance * distance) / (2.0 * distance);
  const Vec3 upper =
      along * direction + std::sqrt(std::max(0.0, upperLength * upperLength - along * along)) * side;
  const Vec3 lower = distance * direction - upper;
  const Vec3 normal = glm::cross(side, direction);
  const Vec3 bindNormal = glm::cross(upperBind, lowerBind);
  solver.solved.rotations[limb.upper] =
      rotationBetween(frameOf(upperBind, bindNormal), frameOf(upper, normal));
  solver.place(limb.lower, rotationBetween(frameOf(lowerBind, bindNormal), frameOf(lower, normal)));
}

/// Controls of one side: the left side's, or as many places further for the right.
Vec3 sideControl(const Pose& pose, Control left, bool isLeft, Control firstLeft, Control firstRight) {
  const std::size_t shift =
      isLeft ? 0 : static_cast<std::size_t>(firstRight) - static_cast<std::size_t>(firstLeft);
  return pose.values[static_cast<std::size_t>(left) + shift];
}

void solveArm(Solver& solver, bool isLeft) {
  const std::string side = isLeft ? "Left" : "Right";
  const auto control = [&](Control left) {
    return sideControl(solver.pose, left, isLeft, Control::leftWrist, Control::rightWrist);
  };
  const double sign = isLeft ? 1.0 : -1.0;
  const Vec3 clavicle = control(Control::leftClavicle);
  const Quat chest = solver.solved.rotations[solver.joint("Spine2")];
  solver.place(solver.joint(side + "Shoulder"), chest * turned({0.0, -sign * clavicle.x, sign * clavicle.y}));

  const Limb arm{solver.joint(side + "Arm"), solver.joint(side + "ForeArm"), solver.joint(side + "Hand")};
  solver.place(arm.upper, chest);
  const double firmness = solver.pose[Control::holds][isLeft ? 0 : 1];
  solveLimb(solver, arm, control(Control::leftWrist), control(Control::leftElbow), firmness);

  const Quat hand =
      handRotation(solver.skeleton, isLeft, control(Control::leftKnuckles), control(Control::leftThumb));
  // The forearm takes half of the hand's twist, as radius and ulna do.
  const Quat forearm = solver.solved.rotations[arm.lower];
  const Vec3 axis = glm::normalize(forearm * solver.bindOffset(arm.lower, arm.end));
  const Quat twist = twistOf(hand * glm::conjugate(forearm), axis);
  solver.solved.rotations[arm.lower] = glm::slerp(Quat(1.0, 0.0, 0.0, 0.0), twist, 0.5) * forearm;
  solver.place(arm.end, hand);
  solver.place(solver.joint(side + "HandMiddle1"), hand);
  solver.place(solver.joint(side + "HandThumb1"), hand);
}

void solveLeg(Solver& solver, bool isLeft) {
  const std::string side = isLeft ? "Left" : "Right";
  const auto control = [&](Control left) {
    return sideControl(solver.pose, left, isLeft, Control::leftBall, Control::rightBall);
  };
  const Vec3 lift = control(Control::leftFoot);
  const Quat flat = turned({0.0, lift.y, 0.0});
  const Quat foot = flat * turned({lift.x, 0.0, 0.0});
  const Limb leg{solver.joint(side + "UpLeg"), solver.joint(side + "Leg"), solver.joint(side + "Foot")};
  const std::size_t ball = solver.joint(side + "ToeBase");
  const Vec3 ankle = control(Control::leftBall) - foot * solver.bindOffset(leg.end, ball);
  solver.place(leg.upper, solver.solved.rotations[0]);
  // The knee points where the toes point, a little turned out.
  const double out = isLeft ? 12.0 : -12.0;
  const Vec3 knee = control(Control::leftKnee);
  const bool free = glm::length(knee) < 1e-9;
  const Vec3 pole = free ? turned({0.0, lift.y + out, 0.0}) * Vec3(0.0, 0.0, 1.0) : knee;
  solveLimb(solver, leg, ankle, pole, 1.0);
  solver.place(leg.end, foot);
  solver.place(ball, flat * turned({lift.z, 0.0, 0.0}));
}

} // namespace

SolvedPose solvePose(const std::vector<Joint>& skeleton, const Pose& pose) {
  return solvePose(skeleton, pose, pose[Control::hips], turned(pose[Control::hipsTurn]));
}

SolvedPose solvePose(const std::vector<Joint>& skeleton, const Pose& pose, const Vec3& hips,
                     const Quat& hipsRotation) {
  Solver solver{skeleton, pose, {}};
  solver.solved.positions.assign(skeleton.size(), Vec3(0.0));
  solver.solved.rotations.assign(skeleton.size(), Quat(1.0, 0.0, 0.0, 0.0));
  solver.solved.positions[0] = hips;
  solver.solved.rotations[0] = hipsRotation;
  solveTrunk(solver);
  for (const bool isLeft : {true, false}) {
    solveArm(solver, isLeft);
    solveLeg(solver, isLeft);
  }
  return solver.solved;
}

Quat handRotation(const std::vector<Joint>& skeleton, bool isLeft, const Vec3& knuckles, const Vec3& thumb) {
  const std::string side = isLeft ? "Left" : "Right";
  // In the bind pose the knuckles continue the forearm and the thumb points forwards.
  const Vec3 forearm = jointPosition(skeleton, side + "Hand") - jointPosition(skeleton, side + "ForeArm");
  return rotationBetween(frameOf(forearm, {0.0, 0.0, 1.0}), frameOf(knuckles, thumb));
}

Quat localRotation(const std::vector<Joint>& skeleton, const SolvedPose& solved, int joint) {
  const auto j = static_cast<std::size_t>(joint);
  if (skeleton[j].parent < 0) {
    return solved.rotations[j];
  }
  return glm::conjugate(solved.rotations[static_cast<std::size_t>(skeleton[j].parent)]) * solved.rotations[j];
}

} // namespace stretch::assets

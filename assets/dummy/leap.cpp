#include "assets/dummy/leap.h"

#include <glm/gtc/quaternion.hpp>

#include "assets/dummy/keying.h"
#include "assets/dummy/pose_solver.h"
#include "assets/dummy/props.h"

namespace stretch::assets {

namespace {

using enum Control;

constexpr double ledgeTop = 0.85;
constexpr double platformTop = 0.30;
constexpr double sole = 0.030; ///< Height of the ball of a standing foot above what it stands on.

/// Trunk: where the hips are, and by how much hips, chest and head lean forward.
struct Trunk {
  Vec3 hips;
  double hipsLean = 0.0;
  double chestLean = 0.0;
  double headLean = 0.0;
  double yaw = 0.0; ///< Of the hips, to the left; the chest turns against it.
};

Pose trunkPose(int frame, const Trunk& trunk) {
  Pose pose;
  pose.frame = frame;
  pose[hips] = trunk.hips;
  pose[hipsTurn] = {trunk.hipsLean, trunk.yaw, 0.0};
  pose[chestTurn] = {trunk.chestLean, -1.2 * trunk.yaw, 0.0};
  pose[headTurn] = {trunk.headLean, 0.0, 0.0};
  for (const Control clavicle : {leftClavicle, rightClavicle}) {
    pose[clavicle] = {2.0, 2.0, 0.0};
  }
  return pose;
}

/// Controls of one side.
struct Side {
  double sign; ///< Of x.
  Control wrist;
  Control elbow;
  Control knuckles;
  Control thumb;
  Control clavicle;
  Control ball;
  Control foot;
  Control knee;
};

constexpr Side left{1.0,          leftWrist, leftElbow, leftKnuckles, leftThumb,
                    leftClavicle, leftBall,  leftFoot,  leftKnee};
constexpr Side right{-1.0,          rightWrist, rightElbow, rightKnuckles, rightThumb,
                     rightClavicle, rightBall,  rightFoot,  rightKnee};

Vec3 onSide(const Side& side, const Vec3& place) {
  return {side.sign * place.x, place.y, place.z};
}

/// An arm; x points away from the middle of the body.
struct Arm {
  Vec3 wrist; ///< From the hips.
  Vec3 elbow;
  Vec3 knuckles;
  Vec3 thumb;
};

void setArm(Pose& pose, const Side& side, const Arm& arm) {
  pose[side.wrist] = pose[hips] + onSide(side, arm.wrist);
  pose[side.elbow] = onSide(side, arm.elbow);
  pose[side.knuckles] = onSide(side, arm.knuckles);
  pose[side.thumb] = onSide(side, arm.thumb);
}

void setArms(Pose& pose, const Arm& arm) {
  setArm(pose, left, arm);
  setArm(pose, right, arm);
}

constexpr Arm forwardArm{{0.15, 0.36, 0.36}, {0.35, -0.8, -0.5}, {-0.15, 0.65, 0.75}, {-0.35, 0.75, -0.55}};
constexpr Arm backArm{{0.27, 0.20, -0.26}, {0.30, 0.1, -1.0}, {0.0, -0.85, 0.45}, {-0.35, 0.45, 0.80}};
constexpr Arm restingArm{{0.28, 0.06, 0.10}, {0.45, -0.3, -0.8}, {-0.05, -0.85, 0.45}, {-0.5, 0.35, 0.75}};
constexpr Arm raisedArm{{0.42, 0.66, 0.16}, {0.8, -0.5, -0.4}, {0.45, 0.75, 0.4}, {-0.45, 0.55, -0.6}};

/// Knees point where the hips look, and up, so that a drawn-up knee goes to the chest.
void setKnee(Pose& pose, const Side& side) {
  const Quat turn = glm::angleAxis(pose[hipsTurn].y * pi / 180.0, Vec3(0.0, 1.0, 0.0)) *
                    glm::angleAxis(pose[hipsTurn].x * pi / 180.0, Vec3(1.0, 0.0, 0.0));
  pose[side.knee] = turn * onSide(side, {0.16, 0.5, 1.0});
}

/// A foot on the ground: where, how far the heel is up.
void stand(Pose& pose, const Side& side, const Vec3& ball, double heel, double out = 6.0) {
  pose[side.ball] = ball;
  pose[side.foot] = {heel, side.sign * out, 0.0};
  setKnee(pose, side);
}

/// A foot in the air: the ball from the hips, x away from the middle; the pitch of foot and toes.
void lift(Pose& pose, const Side& side, const Vec3& fromHips, double pitch) {
  pose[side.ball] = pose[hips] + onSide(side, fromHips);
  pose[side.foot] = {pitch, side.sign * 4.0, pitch};
  setKnee(pose, side);
}

void liftBoth(Pose& pose, const Vec3& fromHips, double pitch) {
  lift(pose, left, fromHips, pitch);
  lift(pose, right, fromHips, pitch);
}

// Where the feet stand, in the order in which they do.
constexpr Vec3 startLeft{0.10, sole, -2.05};
constexpr Vec3 startRight{-0.11, sole, -2.48};
constexpr Vec3 firstStep{-0.07, sole, -0.72};
constexpr Vec3 secondStep{0.07, sole, 0.45};
constexpr Vec3 takeOffRight{-0.11, sole, 1.20};
constexpr Vec3 takeOffLeft{0.11, sole, 1.32};
constexpr Vec3 landingLeft{0.14, platformTop + sole, 5.14};
constexpr Vec3 landingRight{-0.14, platformTop + sole, 5.10};
constexpr Vec3 lastStep{0.12, platformTop + sole, 5.56};

std::vector<Pose> start() {
  Pose ready = trunkPose(0, {{0.0, 0.885, -2.26}, 6.0, 12.0, 4.0, -4.0});
  setArms(ready, restingArm);
  stand(ready, left, startLeft, 2.0);
  stand(ready, right, startRight, 18.0, 14.0);

  Pose gather = trunkPose(7, {{-0.02, 0.785, -2.40}, 22.0, 42.0, 6.0, 8.0});
  setArm(gather, left, {{0.28, 0.24, -0.10}, {0.30, 0.3, -1.0}, {0.0, -0.85, 0.1}, {-0.35, 0.45, 0.80}});
  setArm(gather, right, {{0.16, 0.24, 0.52}, {0.35, -0.8, -0.5}, {-0.15, 0.45, 0.85}, {-0.35, 0.8, -0.4}});
  stand(gather, left, startLeft, 8.0);
  stand(gather, right, startRight, 6.0, 14.0);

  Pose push = trunkPose(11, {{0.02, 0.800, -2.02}, 28.0, 38.0, 8.0, -2.0});
  setArm(push, left, {{0.26, 0.08, 0.06}, {0.4, -0.3, -0.9}, {-0.1, -0.2, 0.9}, {-0.4, 0.8, 0.2}});
  setArm(push, right, {{0.24, 0.06, 0.16}, {0.4, -0.3, -0.9}, {-0.1, 0.2, 0.9}, {-0.4, 0.8, 0.0}});
  stand(push, left, startLeft, 0.0);
  stand(push, right, startRight, 56.0, 14.0);
  return {ready, gather, push};
}

/// A step of the run, as the side that stands does it and the other swings through: contact, passing, push.
struct Step {
  const Side& standing;
  const Side& swinging;
  Vec3 ball;
};

Pose contactPose(int frame, const Step& step, const Vec3& hipsAt) {
  Pose pose = trunkPose(frame, {hipsAt, 10.0, 18.0, 4.0, -9.0 * step.standing.sign});
  setArm(pose, step.standing, backArm);
  setArm(pose, step.swinging, forwardArm);
  stand(pose, step.standing, step.ball, 2.0);
  lift(pose, step.swinging, {0.09, -0.56, -0.46}, 78.0);
  return pose;
}

Pose passingPose(int frame, const Step& step, const Vec3& hipsAt) {
  Pose pose = trunkPose(frame, {hipsAt, 14.0, 22.0, 6.0, 0.0});
  const Arm through{{0.25, 0.16, 0.04}, {0.35, -0.2, -0.9}, {-0.1, -0.1, 0.9}, {-0.4, 0.85, 0.1}};
  setArms(pose, through);
  stand(pose, step.standing, step.ball, 4.0);
  lift(pose, step.swinging, {0.09, -0.46, -0.20}, 84.0);
  return pose;
}

Pose pushPose(int frame, const Step& step, const Vec3& hipsAt) {
  Pose pose = trunkPose(frame, {hipsAt, 12.0, 20.0, 4.0, 9.0 * step.standing.sign});
  setArm(pose, step.standing, forwardArm);
  setArm(pose, step.swinging, backArm);
  stand(pose, step.standing, step.ball, 54.0);
  lift(pose, step.swinging, {0.09, -0.52, 0.24}, 22.0);
  return pose;
}

std::vector<Pose> run() {
  const Step away{left, right, startLeft};
  const Step first{right, left, firstStep};
  const Step second{left, right, secondStep};
  return {pushPose(14, away, {0.02, 0.835, -1.62}),      contactPose(18, first, {-0.02, 0.865, -0.98}),
          passingPose(20, first, {-0.03, 0.835, -0.67}), pushPose(22, first, {-0.01, 0.865, -0.34}),
          contactPose(25, second, {0.02, 0.865, 0.14}),  passingPose(27, second, {0.03, 0.830, 0.42}),
          pushPose(29, second, {0.01, 0.855, 0.72})};
}

/// Both feet stamp, a deep crouch, and everything stretches forwards and up.
std::vector<Pose> takeOff() {
  Pose stamp = trunkPose(31, {{-0.01, 0.800, 0.98}, 16.0, 26.0, 4.0, 0.0});
  setArms(stamp, {{0.28, 0.12, -0.10}, {0.35, 0.0, -1.0}, {0.0, -0.65, 0.65}, {-0.4, 0.6, 0.6}});
  stand(stamp, right, takeOffRight, 10.0);
  lift(stamp, left, {0.11, -0.68, 0.06}, 24.0);

  Pose crouch = trunkPose(33, {{0.0, 0.690, 1.18}, 36.0, 56.0, 6.0, 0.0});
  setArms(crouch, {{0.29, 0.10, 0.16}, {0.40, -0.2, -0.9}, {0.0, -0.6, 0.75}, {-0.4, 0.6, 0.6}});
  stand(crouch, right, takeOffRight, 16.0);
  stand(crouch, left, takeOffLeft, 8.0);

  Pose drive = trunkPose(34, {{0.0, 0.770, 1.325}, 40.0, 52.0, 6.0, 0.0});
  setArms(drive, {{0.25, 0.14, 0.38}, {0.45, -0.7, -0.5}, {0.0, -0.05, 1.0}, {-0.45, 0.8, 0.2}});
  stand(drive, right, takeOffRight, 38.0);
  stand(drive, left, takeOffLeft, 28.0);

  Pose push = trunkPose(35, {{0.0, 0.870, 1.47}, 40.0, 44.0, 8.0, 0.0});
  setArms(push, {{0.20, 0.42, 0.52}, {0.5, -0.9, 0.0}, {0.0, 0.3, 0.95}, {-0.5, 0.8, -0.2}});
  stand(push, right, takeOffRight, 60.0);
  stand(push, left, takeOffLeft, 52.0);
  return {stamp, crouch, drive, push};
}

/// Flat over the first ledge, hands leading, legs behind.
std::vector<Pose> dive() {
  const Arm reaching{{0.18, 0.14, 0.91}, {0.8, -0.6, 0.0}, {0.0, 0.1, 1.0}, {-0.75, 0.6, 0.0}};
  Pose leaving = trunkPose(36, {{0.0, 1.000, 1.64}, 48.0, 48.0, 10.0, 0.0});
  setArms(leaving, {{0.19, 0.40, 0.68}, {0.7, -0.8, 0.0}, {0.0, 0.25, 1.0}, {-0.6, 0.7, -0.1}});
  lift(leaving, right, {0.10, -0.82, -0.42}, 72.0);
  lift(leaving, left, {0.10, -0.84, -0.34}, 68.0);

  Pose rising = trunkPose(38, {{0.0, 1.198, 1.88}, 64.0, 60.0, 16.0, 0.0});
  setArms(rising, {{0.18, 0.28, 0.84}, {0.8, -0.7, 0.0}, {0.0, 0.2, 1.0}, {-0.7, 0.65, 0.0}});
  lift(rising, right, {0.10, -0.60, -0.68}, 108.0);
  lift(rising, left, {0.10, -0.54, -0.70}, 112.0);

  Pose flat = trunkPose(41, {{0.0, 1.368, 2.25}, 84.0, 78.0, 28.0, 0.0});
  setArms(flat, reaching);
  lift(flat, right, {0.10, -0.20, -0.86}, 136.0);
  lift(flat, left, {0.10, -0.12, -0.88}, 140.0);

  Pose over = trunkPose(43, {{0.0, 1.395, 2.50}, 90.0, 86.0, 36.0, 0.0});
  setArms(over, {{0.20, -0.06, 0.90}, {0.85, -0.3, -0.2}, {0.0, -0.2, 1.0}, {-0.9, 0.35, 0.0}});
  lift(over, right, {0.10, -0.06, -0.86}, 142.0);
  lift(over, left, {0.10, 0.00, -0.88}, 146.0);
  return {leaving, rising, flat, over};
}

/// Hands where they stand on the second ledge.
void plantHands(Pose& pose) {
  for (const Side& side : {left, right}) {
    pose[side.wrist] = onSide(side, {0.265, ledgeTop + 0.145, 3.46});
    pose[side.elbow] = onSide(side, {0.9, 0.25, -0.45});
    pose[side.knuckles] = onSide(side, {0.0, -0.38, 0.92});
    pose[side.thumb] = onSide(side, {-1.0, 0.0, 0.0});
  }
  pose[holds] = {1.0, 1.0, 0.0};
}

/// The hands catch the ledge, the legs come through between the arms.
std::vector<Pose> vault() {
  Pose caught = trunkPose(46, {{0.0, 1.300, 2.85}, 86.0, 88.0, 46.0, 0.0});
  plantHands(caught);
  liftBoth(caught, {0.10, -0.16, -0.70}, 138.0);

  Pose drawn = trunkPose(48, {{0.0, 1.335, 3.07}, 80.0, 78.0, 40.0, 0.0});
  plantHands(drawn);
  liftBoth(drawn, {0.09, -0.35, -0.22}, 110.0);

  Pose through = trunkPose(50, {{0.0, 1.285, 3.23}, 66.0, 72.0, 30.0, 0.0});
  plantHands(through);
  liftBoth(through, {0.07, -0.34, 0.10}, 62.0);

  Pose leaving = trunkPose(52, {{0.0, 1.310, 3.48}, 40.0, 44.0, 22.0, 0.0});
  setArms(leaving, {{0.31, 0.00, 0.06}, {0.8, 0.1, -0.6}, {0.1, -0.6, 0.7}, {-0.9, -0.2, 0.2}});
  liftBoth(leaving, {0.07, -0.36, 0.27}, 26.0);
  return {caught, drawn, through, leaving};
}

/// The body opens, arms up, feet reach for the platform.
std::vector<Pose> descent() {
  Pose opening = trunkPose(54, {{0.0, 1.395, 3.74}, 20.0, 24.0, 16.0, 0.0});
  setArms(opening, {{0.38, 0.20, -0.04}, {0.6, 0.1, -0.8}, {0.35, -0.7, 0.3}, {-0.5, 0.1, 0.85}});
  liftBoth(opening, {0.11, -0.46, 0.36}, 4.0);

  Pose high = trunkPose(57, {{0.0, 1.435, 4.11}, 4.0, 6.0, 18.0, 0.0});
  setArms(high, raisedArm);
  liftBoth(high, {0.12, -0.66, 0.30}, 2.0);

  Pose reaching = trunkPose(60, {{0.0, 1.310, 4.50}, 4.0, 4.0, 24.0, 0.0});
  setArms(reaching, {{0.40, 0.74, 0.10}, {0.9, -0.2, -0.4}, {0.35, 0.9, 0.1}, {-0.5, 0.3, -0.7}});
  liftBoth(reaching, {0.13, -0.83, 0.30}, 12.0);
  return {opening, high, reaching};
}

void standOnPlatform(Pose& pose, double heel) {
  stand(pose, left, landingLeft, heel, 12.0);
  stand(pose, right, landingRight, heel, 12.0);
}

/// Both feet touch, knees and trunk give, then it rises and steps out of it.
std::vector<Pose> landing() {
  Pose touch = trunkPose(63, {{0.0, 1.075, 4.88}, 12.0, 14.0, 22.0, 0.0});
  setArms(touch, {{0.42, 0.58, 0.14}, {0.9, -0.4, -0.3}, {0.6, 0.6, 0.4}, {-0.4, 0.6, -0.6}});
  standOnPlatform(touch, 16.0);

  Pose give = trunkPose(65, {{0.0, 0.850, 4.98}, 30.0, 42.0, 22.0, 0.0});
  setArms(give, {{0.38, 0.22, 0.22}, {0.8, -0.2, -0.6}, {0.35, -0.1, 0.9}, {-0.5, 0.8, 0.0}});
  standOnPlatform(give, 2.0);

  Pose deep = trunkPose(68, {{0.0, 0.700, 4.99}, 42.0, 66.0, 20.0, 0.0});
  setArms(deep, {{0.30, -0.06, 0.44}, {0.8, -0.2, -0.6}, {0.05, -0.6, 0.8}, {-0.75, 0.45, 0.3}});
  standOnPlatform(deep, 4.0);

  Pose held = trunkPose(71, {{0.0, 0.695, 4.99}, 42.0, 68.0, 16.0, 0.0});
  setArms(held, {{0.29, -0.08, 0.45}, {0.8, -0.2, -0.6}, {0.05, -0.6, 0.8}, {-0.75, 0.45, 0.3}});
  standOnPlatform(held, 4.0);
  return {touch, give, deep, held};
}

std::vector<Pose> stepOut() {
  Pose rise = trunkPose(78, {{-0.04, 1.000, 5.08}, 22.0, 28.0, 8.0, 0.0});
  setArms(rise, {{0.31, 0.04, 0.16}, {0.6, -0.2, -0.8}, {0.0, -0.7, 0.7}, {-0.6, 0.5, 0.5}});
  stand(rise, right, landingRight, 0.0, 12.0);
  stand(rise, left, landingLeft, 22.0, 12.0);

  Pose step = trunkPose(82, {{-0.04, 1.140, 5.20}, 8.0, 12.0, 4.0, 5.0});
  setArm(step, left, backArm);
  setArm(step, right, {{0.20, 0.18, 0.26}, {0.4, -0.7, -0.6}, {-0.1, 0.2, 0.9}, {-0.4, 0.85, -0.2}});
  stand(step, right, landingRight, 6.0, 12.0);
  lift(step, left, {0.10, -0.66, 0.12}, 14.0);

  Pose weight = trunkPose(87, {{0.02, 1.150, 5.38}, 6.0, 10.0, 2.0, -4.0});
  setArms(weight, restingArm);
  stand(weight, right, landingRight, 26.0, 12.0);
  stand(weight, left, lastStep, 0.0, 8.0);

  Pose stop = trunkPose(96, {{0.01, 1.170, 5.36}, 3.0, 3.0, -2.0, -2.0});
  setArms(stop, {{0.27, 0.03, 0.05}, {0.45, -0.2, -0.9}, {-0.05, -0.95, 0.3}, {-0.5, 0.3, 0.8}});
  stand(stop, right, landingRight, 20.0, 12.0);
  stand(stop, left, lastStep, 0.0, 8.0);
  return {rise, step, weight, stop};
}

} // namespace

std::vector<Prop> leapBlocks() {
  return {makeBlock("Low ledge", {-0.60, 0.0, 1.80}, {0.60, 0.42, 2.10}),
          makeBlock("Ledge", {-0.60, 0.0, 3.20}, {0.60, ledgeTop, 3.75}),
          makeBlock("Platform", {-0.80, 0.0, 4.60}, {0.80, platformTop, 6.40})};
}

std::vector<Pose> leapPoses() {
  std::vector<Pose> poses;
  for (const auto& part : {start, run, takeOff, dive, vault, descent, landing, stepOut}) {
    const std::vector<Pose> added = part();
    poses.insert(poses.end(), added.begin(), added.end());
  }
  return poses;
}

Motion leapMotion(const std::vector<Joint>& skeleton) {
  return keyHolding("Leap and landing", skeleton, leapPoses(), leapFramesPerSecond,
                    [](const Pose& pose) { return pose; }, {});
}

} // namespace stretch::assets

#include "assets/dummy/swing.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "assets/dummy/pose_solver.h"

namespace stretch::assets {

namespace {

using enum Control;

/// How far the middle of either fist is from the middle between them, along the bat.
constexpr double halfGap = 0.082;

/// From the wrist to the middle of the closed glove, in the bind pose of the left hand.
constexpr Vec3 gloveMiddle{0.083, -0.073, 0.028};

Vec3 batDirection(const Pose& pose) {
  const Vec3 angles = pose[batAim] * (pi / 180.0);
  return {std::cos(angles.y) * std::sin(angles.x), std::sin(angles.y),
          std::cos(angles.y) * std::cos(angles.x)};
}

struct HandControls {
  Control wrist;
  Control knuckles;
  Control thumb;
};

/// Lays one hand on the bat as firmly as it holds it.
void layHand(const std::vector<Joint>& skeleton, Pose& pose, bool isLeft, double firmness) {
  const HandControls hand = isLeft ? HandControls{leftWrist, leftKnuckles, leftThumb}
                                   : HandControls{rightWrist, rightKnuckles, rightThumb};
  const Vec3 along = batDirection(pose);
  const Vec3 toKnuckles = glm::normalize(pose[hand.knuckles]);
  const Vec3 across = glm::normalize(toKnuckles - glm::dot(toKnuckles, along) * along);
  const Quat rotation = handRotation(skeleton, isLeft, across, along);
  const Vec3 middle = isLeft ? gloveMiddle : mirrored(gloveMiddle);
  const Vec3 held = pose[bat] + (isLeft ? -halfGap : halfGap) * along - rotation * middle;
  pose[hand.wrist] += firmness * (held - pose[hand.wrist]);
  pose[hand.knuckles] = toKnuckles + firmness * (across - toKnuckles);
  pose[hand.thumb] += firmness * (along - pose[hand.thumb]);
}

/// Sideways to the pitcher, knees bent, hands behind the right shoulder, eyes on the ball.
Pose stance(int frame) {
  Pose pose;
  pose.frame = frame;
  pose[hips] = {-0.04, 0.835, -0.02};
  pose[hipsTurn] = {14.0, -4.0, 0.0};
  pose[chestTurn] = {20.0, -14.0, -2.0};
  pose[headTurn] = {4.0, 60.0, 2.0};
  pose[leftElbow] = {0.10, -0.90, 0.55};
  pose[leftKnuckles] = {-0.80, -0.30, 0.40};
  pose[leftThumb] = {-0.5, 0.7, -0.3};
  pose[leftClavicle] = {14.0, 2.0, 0.0};
  pose[rightElbow] = {-0.75, -0.60, -0.25};
  pose[rightKnuckles] = {0.30, 0.50, 0.65};
  pose[rightThumb] = {-0.5, 0.7, -0.3};
  pose[rightClavicle] = {-6.0, 4.0, 0.0};
  pose[leftBall] = {0.235, 0.030, 0.080};
  pose[leftFoot] = {0.0, 14.0, 0.0};
  pose[leftKnee] = {0.25, 0.0, 1.0};
  pose[rightBall] = {-0.275, 0.030, 0.075};
  pose[rightFoot] = {0.0, -8.0, 0.0};
  pose[rightKnee] = {-0.25, 0.0, 1.0};
  pose[holds] = {1.0, 1.0, 0.0};
  pose[bat] = {-0.300, 1.290, 0.270};
  pose[batAim] = {-122.0, 56.0, 0.0};
  return pose;
}

/// The bat swings a little forwards in the waiting hands.
Pose waggle(int frame, double much) {
  Pose pose = stance(frame);
  pose[hips] += much * Vec3(0.012, -0.016, 0.0);
  pose[chestTurn] += much * Vec3(1.0, 4.0, 0.0);
  pose[bat] += much * Vec3(0.012, -0.022, 0.010);
  pose[batAim] += much * Vec3(-16.0, 8.0, 0.0);
  return pose;
}

/// The weight goes over the back foot, the front heel comes up.
Pose load(int frame) {
  Pose pose = stance(frame);
  pose[hips] = {-0.125, 0.822, -0.02};
  pose[hipsTurn] = {13.0, -12.0, 2.0};
  pose[chestTurn] = {19.0, -24.0, 3.0};
  pose[headTurn] = {5.0, 56.0, 3.0};
  pose[leftFoot] = {34.0, 4.0, 0.0};
  pose[bat] = {-0.405, 1.280, 0.225};
  pose[batAim] = {-136.0, 58.0, 0.0};
  return pose;
}

/// Front knee up, everything coiled over the back leg.
Pose legKick(int frame, double further) {
  Pose pose = stance(frame);
  pose[hips] = Vec3(-0.205, 0.842, -0.02) + further * Vec3(0.02, -0.012, 0.0);
  pose[hipsTurn] = {8.0, -24.0 - 4.0 * further, 4.0};
  pose[chestTurn] = {14.0, -34.0 - 4.0 * further, 8.0};
  pose[headTurn] = {5.0, 44.0, 5.0};
  pose[leftBall] = Vec3(-0.045, 0.335, 0.205) + further * Vec3(0.03, 0.0, 0.0);
  pose[leftFoot] = {34.0, -12.0, 34.0};
  pose[leftKnee] = {0.10, 0.25, 1.0};
  pose[leftElbow] = {0.20, -0.75, 0.60};
  pose[bat] = Vec3(-0.530, 1.300, 0.125) + further * Vec3(-0.015, 0.01, -0.01);
  pose[batAim] = {-154.0, 56.0, 0.0};
  return pose;
}

/// The front foot reaches out; hips open, hands stay behind.
Pose stride(int frame) {
  Pose pose = stance(frame);
  pose[hips] = {-0.085, 0.808, -0.005};
  pose[hipsTurn] = {8.0, -12.0, 4.0};
  pose[chestTurn] = {14.0, -36.0, 8.0};
  pose[headTurn] = {6.0, 46.0, 6.0};
  pose[leftBall] = {0.330, 0.105, 0.130};
  pose[leftFoot] = {-6.0, 22.0, 0.0};
  pose[leftKnee] = {0.55, 0.1, 1.0};
  pose[rightFoot] = {6.0, -4.0, 0.0};
  pose[leftElbow] = {0.30, -0.70, 0.60};
  pose[bat] = {-0.500, 1.285, 0.110};
  pose[batAim] = {-156.0, 48.0, 0.0};
  return pose;
}

Pose planted(Pose pose) {
  pose[leftBall] = {0.430, 0.030, 0.110};
  pose[leftFoot] = {0.0, 48.0, 0.0};
  pose[leftKnee] = {0.85, 0.0, 0.75};
  return pose;
}

/// The foot is down: the hips have begun to turn, the shoulders have not.
Pose footPlant(int frame) {
  Pose pose = planted(stance(frame));
  pose[hips] = {0.035, 0.785, 0.010};
  pose[hipsTurn] = {8.0, 16.0, 2.0};
  pose[chestTurn] = {13.0, -26.0, 8.0};
  pose[headTurn] = {8.0, 54.0, 6.0};
  pose[rightFoot] = {20.0, 6.0, 0.0};
  pose[rightKnee] = {0.25, 0.0, 1.0};
  pose[leftElbow] = {0.40, -0.70, 0.60};
  pose[leftKnuckles] = {-0.75, -0.20, 0.60};
  pose[rightElbow] = {-0.60, -0.85, 0.00};
  pose[rightKnuckles] = {0.20, 0.35, 0.85};
  pose[bat] = {-0.395, 1.215, 0.160};
  pose[batAim] = {-148.0, 32.0, 0.0};
  return pose;
}

/// Hips ahead of shoulders, shoulders ahead of hands: the bat lags and flattens.
Pose drive(int frame) {
  Pose pose = planted(stance(frame));
  pose[hips] = {0.105, 0.782, 0.030};
  pose[hipsTurn] = {6.0, 50.0, -2.0};
  pose[chestTurn] = {12.0, 10.0, 8.0};
  pose[headTurn] = {12.0, 56.0, 4.0};
  pose[rightFoot] = {34.0, 26.0, 0.0};
  pose[rightKnee] = {0.55, 0.0, 0.85};
  pose[leftElbow] = {0.60, -0.70, 0.40};
  pose[leftKnuckles] = {-0.35, -0.45, 0.80};
  pose[rightElbow] = {-0.35, -0.95, 0.05};
  pose[rightKnuckles] = {-0.20, -0.35, 0.90};
  pose[bat] = {-0.120, 1.050, 0.375};
  pose[batAim] = {-112.0, 6.0, 0.0};
  return pose;
}

/// Arms almost long, the barrel out over the plate.
Pose contact(int frame) {
  Pose pose = planted(stance(frame));
  pose[hips] = {0.140, 0.800, 0.035};
  pose[hipsTurn] = {2.0, 74.0, -6.0};
  pose[chestTurn] = {8.0, 46.0, 6.0};
  pose[headTurn] = {20.0, 42.0, 0.0};
  pose[rightFoot] = {48.0, 46.0, 0.0};
  pose[rightKnee] = {0.80, 0.0, 0.60};
  pose[leftElbow] = {0.80, -0.60, -0.05};
  pose[leftKnuckles] = {0.70, -0.70, 0.10};
  pose[leftClavicle] = {6.0, 2.0, 0.0};
  pose[rightElbow] = {-0.10, -1.0, 0.0};
  pose[rightKnuckles] = {0.75, -0.65, 0.10};
  pose[rightClavicle] = {10.0, 2.0, 0.0};
  pose[bat] = {0.335, 0.985, 0.350};
  pose[batAim] = {6.0, -10.0, 0.0};
  return pose;
}

/// Both arms long towards the pitcher.
Pose extension(int frame) {
  Pose pose = contact(frame);
  pose[hips] = {0.165, 0.806, 0.030};
  pose[hipsTurn] = {0.0, 82.0, -6.0};
  pose[chestTurn] = {4.0, 74.0, 2.0};
  pose[headTurn] = {14.0, 50.0, 0.0};
  pose[rightFoot] = {54.0, 54.0, 0.0};
  pose[leftElbow] = {0.30, -0.80, -0.50};
  pose[leftKnuckles] = {-0.05, -0.80, 0.45};
  pose[rightElbow] = {-0.1, -1.0, 0.25};
  pose[rightKnuckles] = {0.10, -0.85, 0.35};
  pose[rightClavicle] = {16.0, 2.0, 0.0};
  pose[bat] = {0.480, 1.060, 0.170};
  pose[batAim] = {72.0, 2.0, 0.0};
  return pose;
}

/// The wrists roll over.
Pose rollOver(int frame) {
  Pose pose = extension(frame);
  pose[hips] = {0.180, 0.812, 0.022};
  pose[hipsTurn] = {-1.0, 86.0, -5.0};
  pose[chestTurn] = {2.0, 88.0, 0.0};
  pose[headTurn] = {10.0, 60.0, 0.0};
  pose[leftElbow] = {0.30, -0.40, -0.85};
  pose[leftKnuckles] = {0.45, -0.45, 0.75};
  pose[rightElbow] = {0.15, -0.95, 0.30};
  pose[rightKnuckles] = {0.50, -0.45, 0.65};
  pose[bat] = {0.530, 1.200, -0.010};
  pose[batAim] = {124.0, 16.0, 0.0};
  return pose;
}

/// Hands rise to the left shoulder; the top hand is about to let go.
Pose wrap(int frame) {
  Pose pose = rollOver(frame);
  pose[hips] = {0.185, 0.812, 0.012};
  pose[hipsTurn] = {-2.0, 89.0, -4.0};
  pose[chestTurn] = {0.0, 100.0, -2.0};
  pose[headTurn] = {4.0, 72.0, 0.0};
  pose[leftElbow] = {0.35, 0.00, -0.95};
  pose[leftKnuckles] = {0.45, 0.55, 0.55};
  pose[leftClavicle] = {0.0, 10.0, 0.0};
  pose[rightElbow] = {0.45, -0.85, 0.35};
  pose[rightKnuckles] = {0.65, 0.45, 0.15};
  pose[bat] = {0.475, 1.390, -0.175};
  pose[batAim] = {180.0, 34.0, 0.0};
  return pose;
}

/// One-handed finish: the bat hangs over the back.
Pose finish(int frame, double further) {
  Pose pose = wrap(frame);
  pose[hips] = {0.190, 0.808, 0.005};
  pose[hipsTurn] = {-4.0, 92.0, -2.0};
  pose[chestTurn] = {-4.0, 110.0 + 2.0 * further, -4.0};
  pose[headTurn] = {-6.0, 84.0, 0.0};
  pose[rightFoot] = {58.0, 58.0, 0.0};
  pose[leftElbow] = {0.30, 0.10, -1.0};
  pose[leftKnuckles] = {0.25, 0.90, 0.20};
  pose[leftClavicle] = {-6.0, 14.0, 0.0};
  pose[holds] = {1.0, 0.0, 0.0};
  pose[rightWrist] = {0.560, 1.130, 0.150};
  pose[rightElbow] = {0.1, -0.9, 0.6};
  pose[rightKnuckles] = {0.9, 0.3, -0.2};
  pose[rightThumb] = {0.0, 0.9, -0.4};
  pose[rightClavicle] = {12.0, 0.0, 0.0};
  pose[bat] = Vec3(0.330, 1.560, -0.400) + further * Vec3(-0.01, 0.01, -0.01);
  pose[batAim] = {246.0 + 6.0 * further, -14.0 - 8.0 * further, 0.0};
  return pose;
}

/// The eyes follow the ball; the arm with the bat comes down on its side.
Pose lower(int frame) {
  Pose pose = finish(frame, 0.0);
  pose[hips] = {0.188, 0.810, 0.005};
  pose[hipsTurn] = {-3.0, 90.0, -1.0};
  pose[chestTurn] = {-4.0, 104.0, -3.0};
  pose[headTurn] = {-12.0, 84.0, 0.0};
  pose[leftElbow] = {-0.30, -0.10, -0.9};
  pose[leftKnuckles] = {0.75, 0.35, -0.30};
  pose[leftClavicle] = {0.0, 8.0, 0.0};
  pose[rightWrist] = {0.480, 1.000, 0.270};
  pose[rightElbow] = {-0.3, -0.7, 0.6};
  pose[rightKnuckles] = {0.75, -0.40, 0.0};
  pose[rightThumb] = {0.5, 0.6, -0.4};
  pose[bat] = {0.440, 1.330, -0.490};
  pose[batAim] = {214.0, 14.0, 0.0};
  return pose;
}

Pose watch(int frame, double further) {
  Pose pose = finish(frame, 0.0);
  pose[hips] = Vec3(0.180, 0.815, 0.005) + further * Vec3(-0.005, 0.006, 0.0);
  pose[hipsTurn] = {-2.0, 88.0, -1.0};
  pose[chestTurn] = {-4.0, 96.0, -2.0};
  pose[headTurn] = {-16.0 - 4.0 * further, 84.0, 0.0};
  pose[rightFoot] = {50.0, 56.0, 0.0};
  pose[leftElbow] = {-0.70, -0.20, -0.6};
  pose[leftKnuckles] = {0.20, -0.95, -0.05};
  pose[leftClavicle] = {0.0, 4.0, 0.0};
  pose[rightWrist] = {0.390, 0.905, 0.330};
  pose[rightElbow] = {-0.6, -0.4, 0.6};
  pose[rightKnuckles] = {0.35, -0.92, 0.05};
  pose[rightThumb] = {0.9, 0.3, -0.3};
  pose[rightClavicle] = {2.0, 0.0, 0.0};
  pose[bat] = Vec3(0.430, 0.940, -0.430) + further * Vec3(0.0, -0.02, 0.01);
  pose[batAim] = {118.0, -42.0 - 5.0 * further, 0.0};
  return pose;
}

} // namespace

std::vector<Pose> swingPoses() {
  return {stance(0),        waggle(6, 1.0), waggle(11, -0.3), load(17),        legKick(23, 0.0),
          legKick(27, 1.0), stride(31),     footPlant(34),    drive(36),       contact(38),
          extension(40),    rollOver(42),   wrap(44),         finish(48, 0.0), finish(54, 1.0),
          lower(61),        watch(68, 0.0), watch(78, 1.0),   watch(88, 1.0)};
}

PropPlace batPlace(const Pose& pose) {
  const Vec3 angles = pose[batAim] * (pi / 180.0);
  const Quat tipped = glm::angleAxis(angles.x, Vec3(0.0, 1.0, 0.0)) *
                      glm::angleAxis(0.5 * pi - angles.y, Vec3(1.0, 0.0, 0.0));
  return {pose[bat], tipped};
}

Pose withBatHeld(const std::vector<Joint>& skeleton, const Pose& pose) {
  Pose held = pose;
  layHand(skeleton, held, true, pose[holds].x);
  layHand(skeleton, held, false, pose[holds].y);
  return held;
}

Motion swingMotion(const std::vector<Joint>& skeleton, int batNode) {
  return keyHolding("Baseball swing", skeleton, swingPoses(), swingFramesPerSecond,
                    [&](const Pose& pose) { return withBatHeld(skeleton, pose); }, {{batNode, batPlace}});
}

} // namespace stretch::assets

#include "assets/dummy/punch.h"

namespace stretch::assets {

namespace {

using enum Control;

/// Left foot in front, weight between the feet, gloves at the chin, eyes on the opponent, who stands at +Z.
Pose guard(int frame) {
  Pose pose;
  pose.frame = frame;
  pose[hips] = {-0.015, 0.880, 0.030};
  pose[hipsTurn] = {4.0, -34.0, 0.0};
  pose[chestTurn] = {11.0, -28.0, 0.0};
  pose[headTurn] = {6.0, -8.0, 0.0};
  pose[leftWrist] = {0.130, 1.225, 0.300};
  pose[leftElbow] = {0.45, -1.0, -0.05};
  pose[leftKnuckles] = {-0.10, 0.80, 0.60};
  pose[leftThumb] = {-0.55, 0.35, -0.50};
  pose[leftClavicle] = {6.0, 4.0, 0.0};
  pose[rightWrist] = {-0.125, 1.205, 0.165};
  pose[rightElbow] = {-0.40, -1.0, -0.15};
  pose[rightKnuckles] = {0.14, 0.85, 0.50};
  pose[rightThumb] = {0.55, 0.35, -0.55};
  pose[rightClavicle] = {6.0, 4.0, 0.0};
  pose[leftBall] = {0.115, 0.030, 0.235};
  pose[leftFoot] = {26.0, -22.0, 0.0};
  pose[rightBall] = {-0.150, 0.030, -0.150};
  pose[rightFoot] = {36.0, -50.0, 0.0};
  return pose;
}

/// Lowest point of a bounce: knees give, heels almost touch, gloves and head follow.
Pose crouch(int frame, double sway) {
  Pose pose = guard(frame);
  pose[hips] += Vec3(sway, -0.048, -0.008);
  pose[hipsTurn] += Vec3(2.0, -2.0, 60.0 * sway);
  pose[chestTurn] += Vec3(4.0, -3.0, 80.0 * sway);
  pose[headTurn] += Vec3(-2.0, 0.0, 40.0 * sway);
  pose[leftWrist] += Vec3(sway, -0.035, 0.006);
  pose[rightWrist] += Vec3(sway, -0.035, 0.004);
  pose[leftFoot].x = 10.0;
  pose[rightFoot].x = 20.0;
  return pose;
}

Pose rise(int frame, double sway) {
  Pose pose = guard(frame);
  pose[hips] += Vec3(sway, 0.004, 0.006);
  pose[chestTurn] += Vec3(-1.0, 3.0, 80.0 * sway);
  pose[leftWrist] += Vec3(sway, 0.006, 0.010);
  pose[rightWrist] += Vec3(sway, 0.010, -0.004);
  return pose;
}

/// The left shoulder winds back, weight onto the back foot.
Pose jabAnticipation(int frame) {
  Pose pose = crouch(frame, -0.03);
  pose[hips] = {-0.075, 0.800, -0.045};
  pose[hipsTurn] = {5.0, -14.0, 4.0};
  pose[chestTurn] = {12.0, 8.0, 7.0};
  pose[headTurn] = {10.0, -4.0, 4.0};
  pose[leftWrist] = {0.205, 1.120, 0.120};
  pose[leftElbow] = {0.70, -0.65, -0.75};
  pose[leftKnuckles] = {-0.12, 0.60, 0.80};
  pose[leftClavicle] = {-14.0, 3.0, 0.0};
  pose[rightWrist] = {-0.160, 1.170, 0.205};
  pose[leftFoot].x = 16.0;
  pose[rightFoot].x = 14.0;
  return pose;
}

/// Hips and back foot drive first; the fist has only left the chin.
Pose jabDrive(int frame) {
  Pose pose = guard(frame);
  pose[hips] = {0.005, 0.826, 0.070};
  pose[hipsTurn] = {5.0, -48.0, 0.0};
  pose[chestTurn] = {14.0, -30.0, 1.0};
  pose[headTurn] = {6.0, -8.0, 0.0};
  pose[leftWrist] = {0.165, 1.240, 0.420};
  pose[leftElbow] = {0.60, -0.85, -0.1};
  pose[leftKnuckles] = {-0.10, 0.30, 0.95};
  pose[leftThumb] = {-0.75, 0.45, -0.30};
  pose[leftClavicle] = {8.0, 5.0, 0.0};
  pose[rightWrist] = {-0.130, 1.190, 0.160};
  pose[leftFoot].x = 8.0;
  pose[rightFoot] = {40.0, -46.0, 0.0};
  return pose;
}

/// Arm, shoulder, hip and back leg in one line.
Pose jabExtension(int frame, double further) {
  Pose pose = guard(frame);
  pose[hips] = Vec3(0.030, 0.838, 0.120) + further * Vec3(0.006, -0.004, 0.014);
  pose[hipsTurn] = {7.0, -60.0 - 3.0 * further, -2.0};
  pose[chestTurn] = {12.0, -72.0 - 4.0 * further, -4.0};
  pose[headTurn] = {8.0, -14.0, -5.0};
  pose[leftWrist] = Vec3(0.000, 1.385, 1.020) + further * Vec3(0.0, 0.0, 0.06);
  pose[leftElbow] = {0.75, -0.65, 0.0};
  pose[leftKnuckles] = {0.0, -0.02, 1.0};
  pose[leftThumb] = {-1.0, 0.12, 0.0};
  pose[leftClavicle] = {20.0 + 2.0 * further, 9.0, 0.0};
  pose[rightWrist] = {-0.175, 1.190, 0.235};
  pose[rightKnuckles] = {0.25, 0.85, 0.40};
  pose[leftFoot].x = 4.0;
  pose[rightFoot] = {48.0, -42.0, 0.0};
  return pose;
}

/// The fist comes back lower and wider than it went.
Pose jabRecoil(int frame) {
  Pose pose = guard(frame);
  pose[hips] = {-0.025, 0.850, 0.025};
  pose[hipsTurn] = {4.0, -40.0, 1.0};
  pose[chestTurn] = {10.0, -40.0, 1.0};
  pose[headTurn] = {5.0, -8.0, 1.0};
  pose[leftWrist] = {0.175, 1.200, 0.390};
  pose[leftKnuckles] = {-0.10, 0.60, 0.80};
  pose[leftClavicle] = {8.0, 4.0, 0.0};
  pose[rightWrist] = {-0.165, 1.190, 0.150};
  pose[leftFoot].x = 18.0;
  pose[rightFoot] = {28.0, -50.0, 0.0};
  return pose;
}

/// The right shoulder winds back, low, both knees loaded.
Pose crossAnticipation(int frame) {
  Pose pose = guard(frame);
  pose[hips] = {-0.075, 0.800, -0.045};
  pose[hipsTurn] = {6.0, -58.0, 2.0};
  pose[chestTurn] = {16.0, -74.0, 4.0};
  pose[headTurn] = {8.0, -14.0, 4.0};
  pose[leftWrist] = {0.110, 1.190, 0.360};
  pose[leftClavicle] = {12.0, 5.0, 0.0};
  pose[rightWrist] = {-0.285, 1.110, 0.010};
  pose[rightElbow] = {-0.8, -0.7, -0.5};
  pose[rightKnuckles] = {-0.02, 0.75, 0.65};
  pose[rightClavicle] = {-12.0, 3.0, 0.0};
  pose[leftFoot].x = 16.0;
  pose[rightFoot] = {12.0, -54.0, 0.0};
  return pose;
}

Pose crossDrive(int frame) {
  Pose pose = guard(frame);
  pose[hips] = {-0.005, 0.822, 0.070};
  pose[hipsTurn] = {7.0, -12.0, -2.0};
  pose[chestTurn] = {17.0, -34.0, 0.0};
  pose[headTurn] = {8.0, -4.0, 0.0};
  pose[leftWrist] = {0.165, 1.190, 0.330};
  pose[rightWrist] = {-0.235, 1.220, 0.180};
  pose[rightElbow] = {-0.85, -0.65, -0.2};
  pose[rightKnuckles] = {0.12, 0.20, 1.0};
  pose[rightThumb] = {0.75, 0.50, -0.30};
  pose[rightClavicle] = {2.0, 5.0, 0.0};
  pose[leftFoot].x = 8.0;
  pose[rightFoot] = {46.0, -26.0, 0.0};
  return pose;
}

/// All of the body behind the right fist; the back heel has turned out.
Pose crossExtension(int frame, double further) {
  Pose pose = guard(frame);
  pose[hips] = Vec3(0.060, 0.832, 0.160) + further * Vec3(0.006, -0.006, 0.016);
  pose[hipsTurn] = {9.0, 28.0 + 4.0 * further, -4.0};
  pose[chestTurn] = {18.0, 50.0 + 5.0 * further, -8.0};
  pose[headTurn] = {8.0, 6.0, 3.0};
  pose[leftWrist] = {0.235, 1.170, 0.310};
  pose[leftElbow] = {0.65, -0.9, -0.2};
  pose[leftKnuckles] = {-0.05, 0.90, 0.40};
  pose[rightWrist] = Vec3(0.020, 1.360, 1.150) + further * Vec3(0.01, -0.01, 0.06);
  pose[rightElbow] = {-0.80, -0.60, 0.0};
  pose[rightKnuckles] = {0.0, -0.04, 1.0};
  pose[rightThumb] = {1.0, 0.12, 0.0};
  pose[rightClavicle] = {22.0, 8.0, 0.0};
  pose[leftFoot] = {3.0, -22.0, 0.0};
  pose[rightFoot] = {56.0, -4.0 + 2.0 * further, 0.0};
  return pose;
}

Pose crossRecoil(int frame) {
  Pose pose = guard(frame);
  pose[hips] = {-0.040, 0.868, -0.005};
  pose[hipsTurn] = {3.0, -40.0, 1.0};
  pose[chestTurn] = {8.0, -40.0, 2.0};
  pose[headTurn] = {4.0, -10.0, 0.0};
  pose[leftWrist] = {0.120, 1.215, 0.270};
  pose[rightWrist] = {-0.150, 1.170, 0.150};
  pose[rightFoot] = {36.0, -53.0, 0.0};
  return pose;
}

} // namespace

std::vector<Pose> punchPoses() {
  return {guard(0),
          crouch(4, 0.014),
          rise(8, 0.022),
          crouch(12, -0.008),
          rise(16, -0.016),
          jabAnticipation(21),
          jabDrive(24),
          jabExtension(27, 0.0),
          jabExtension(29, 1.0),
          jabRecoil(33),
          crossAnticipation(37),
          crossDrive(40),
          crossExtension(43, 0.0),
          crossExtension(45, 1.0),
          crossRecoil(50),
          crouch(55, 0.004),
          guard(60)};
}

std::vector<Pose> guardPoses() {
  return {guard(0), crouch(4, 0.018), rise(8, 0.004), crouch(12, -0.018), guard(16)};
}

} // namespace stretch::assets

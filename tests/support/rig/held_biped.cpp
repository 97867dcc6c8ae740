#include "tests/support/rig/held_biped.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/motion/solve_holds.h"
#include "tests/support/nodes.h"

namespace stretch::test {

MovingBiped bipedWithBat(const SyntheticBiped& body) {
  MovingBiped moving = still(body);
  addPunch(moving, Interpolation::linear);
  const NodeIndex bat = addNode(moving.scene, "bat", NodeIndex(0), Vec3(0.3, 0.4, 0.5));
  moving.scene.nodes[at(bat)].rest.rotation = axisAngle(glm::normalize(Vec3(1, 2, -1)), 0.7);
  moving.node["bat"] = bat;
  return moving;
}

rig::HoldTime heldOver(double startFrame, double endFrame, double inFrames, double outFrames) {
  return {Vec2(startFrame, endFrame), Vec2(inFrames, outFrames)};
}

rig::Pin pinAt(const std::string& limb, const rig::HoldTime& time, double atFrame) {
  rig::Pin pin;
  pin.limb = limb;
  pin.time = time;
  pin.atFrame = atFrame;
  return pin;
}

rig::MotionState held(rig::MotionInput input, const rig::Holds& holds) {
  input.holds = holds;
  rig::MotionState motion = rig::solveMotion(input);
  rig::setHolds(input, motion);
  return motion;
}

rig::MotionState held(const MovingBiped& moving, const rig::Holds& holds) {
  return held(motionInput(moving, {}), holds);
}

rig::HeldPlace endPlaceOf(const MovingBiped& moving, const std::string& limb, const FrameState& frame) {
  const auto end = at(moving.limb(limb).endNode);
  return {positionOf(frame.worlds[end]), rotationOf(frame.worlds[end])};
}

double placesApart(const rig::HeldPlace& a, const rig::HeldPlace& b) {
  return glm::length(a.position - b.position);
}

double turnApart(const rig::HeldPlace& a, const rig::HeldPlace& b) {
  const Quat turn = a.orientation * glm::inverse(b.orientation);
  return 2.0 * std::atan2(glm::length(Vec3(turn.x, turn.y, turn.z)), std::abs(turn.w));
}

} // namespace stretch::test

#include "tests/support/rig/adjusted_biped.h"

namespace stretch::test {

namespace {

rig::Adjustment oneKey(const std::string& controller, double frame) {
  rig::Adjustment adjustment;
  adjustment.controller = controller;
  adjustment.keys.emplace_back();
  adjustment.keys.back().frame = frame;
  return adjustment;
}

} // namespace

rig::Adjustment moved(const std::string& controller, const Vec3& move, double frame) {
  rig::Adjustment adjustment = oneKey(controller, frame);
  adjustment.keys.back().move = move;
  return adjustment;
}

rig::Adjustment turned(const std::string& controller, const Vec3& turnDegrees, double frame) {
  rig::Adjustment adjustment = oneKey(controller, frame);
  adjustment.keys.back().turn = turnDegrees * (pi / 180.0);
  return adjustment;
}

rig::Adjustment valued(const std::string& attribute, double value, double frame) {
  rig::Adjustment adjustment = oneKey(attribute, frame);
  adjustment.keys.back().value = value;
  return adjustment;
}

rig::Adjustment within(rig::Adjustment adjustment, double startFrame, double endFrame) {
  adjustment.rangeFrames = Vec2(startFrame, endFrame);
  return adjustment;
}

rig::MotionState adjusted(const MovingBiped& moving, const std::vector<rig::Adjustment>& adjustments,
                          const std::vector<rig::Trail>& trails) {
  rig::MotionInput input = motionInput(moving, trails);
  input.adjustments = adjustments;
  return rig::solveMotion(input);
}

Rekeyed rekeyedOf(const MovingBiped& moving, const std::vector<rig::Adjustment>& adjustments) {
  Rekeyed rekeyed;
  rekeyed.motion = adjusted(moving, adjustments);
  rig::RekeyOptions options;
  options.tolerance = 0.5e-4 * moving.body.height;
  rekeyed.keys = rig::rekey(moving.scene, moving.clip, rekeyed.motion, options);
  rekeyed.clip = rig::withTracks(moving.clip, rekeyed.keys.tracks);
  return rekeyed;
}

} // namespace stretch::test

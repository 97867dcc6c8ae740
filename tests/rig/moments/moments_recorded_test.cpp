#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/moments/body_motion.h"
#include "rig/moments/cycles.h"
#include "rig/moments/moments.h"
#include "tests/support/recorded.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/moving_creatures.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr Vec3 towardsItsRight{-1, 0, 0}; ///< Of a body that faces +Z.

std::string momentsText(const std::string& title, const MovingBiped& moving) {
  const BodyMotion motion = motionOfBody(moving.scene, moving.clip, moving.body, moving.body.limbs);
  std::string text = fmt::format("{} at {} frames per second: {} samples, reach {:.4f}\n", title,
                                 moving.clip.framesPerSecond, motion.forward.size(), motion.reach);
  const std::vector<bool> cycles = limbsInCycles(motion, moving.body.limbs);
  for (std::size_t i = 0; i < moving.body.limbs.size(); ++i) {
    double fastest = 0.0;
    double sum = 0.0;
    const Velocities velocities = velocitiesOf(motion.limbs[i].places, motion.samplesPerSecond);
    for (const double speed : velocities.speeds) {
      fastest = std::max(fastest, speed);
      sum += speed;
    }
    text += fmt::format("  {} reaches {:.4f} , weighs {:.2f} , fastest {:.3f} , together {:.3f}{}\n",
                        moving.body.limbs[i].id, motion.limbs[i].reach, motion.limbs[i].weight, fastest, sum,
                        cycles[i] ? " , goes round" : "");
  }
  for (const Moment& moment : momentsOf(moving.scene, moving.clip, moving.body)) {
    text += fmt::format("  {} of {} from {} to {} , {:.3f} strong\n", momentKindName(moment.kind),
                        moment.limb, moment.startFrame, moment.tipFrame, moment.strength);
  }
  return text;
}

void addTurnsAtFrames(MovingBiped& moving, const std::string& key, const Vec3& axis,
                      const std::vector<std::pair<double, double>>& degreesAtFrames) {
  const NodeIndex node = moving.node.at(key);
  const Quat rest = moving.scene.nodes[at(node)].rest.rotation;
  RotationKeys keys;
  for (const auto& [frame, degrees] : degreesAtFrames) {
    keys.emplace_back(frame / moving.clip.framesPerSecond, axisAngle(axis, degrees * pi / 180.0) * rest);
  }
  moving.clip.tracks.emplace_back(rotationTrack(node, Interpolation::linear, keys));
}

void addMoves(MovingBiped& moving, const std::string& key,
              const std::vector<std::pair<double, Vec3>>& movesAtFrames) {
  const NodeIndex node = moving.node.at(key);
  VectorKeys keys;
  for (const auto& [frame, move] : movesAtFrames) {
    keys.emplace_back(frame / moving.clip.framesPerSecond,
                      moving.scene.nodes[at(node)].rest.translation + move);
  }
  moving.clip.tracks.emplace_back(vectorTrack(node, Channel::translation, Interpolation::linear, keys));
}

double rateBy(Row& row) {
  return row.oneOf(std::array{24.0, 25.0, 30.0, 60.0, 120.0});
}

/// Some limbs turn, fast and slowly, and hold still between.
MovingBiped acting(Row& row, const SyntheticBiped& body, const std::vector<std::string>& keys) {
  MovingBiped moving = still(body);
  moving.clip.framesPerSecond = rateBy(row);
  const double length = row.between(14.0, 60.0);
  for (const std::string& key : keys) {
    if (row.once(3)) {
      continue;
    }
    std::vector<std::pair<double, double>> turns{{0.0, row.around(40.0)}};
    while (turns.back().first < length) {
      const double frame = std::min(length, turns.back().first + row.between(1.0, 14.0));
      turns.emplace_back(frame, row.once(3) ? turns.back().second : row.around(80.0));
    }
    addTurnsAtFrames(moving, key, glm::normalize(row.vector(1.0) + Vec3(0.0, 0.3, 0.0)), turns);
  }
  if (row.once(2)) {
    addMoves(moving, "hips", {{0.0, Vec3(0.0)}, {row.between(3.0, 10.0), row.vector(0.4)}});
  }
  setEndsFromKeys(moving.clip);
  return moving;
}

/// Limbs swing to and fro, so often in the clip, each a part of it behind the others; some clips stop a frame
/// before they close, or do not close.
MovingBiped swinging(Row& row, const SyntheticBiped& body, const std::vector<std::string>& keys) {
  MovingBiped moving = still(body);
  moving.clip.framesPerSecond = rateBy(row);
  const int length = 24;
  const int last = row.once(3) ? length - 1 : row.once(4) ? length - 5 : length;
  for (const std::string& key : keys) {
    if (row.once(4)) {
      continue;
    }
    const double times = 1.0 + row.below(4);
    const double behind = 0.25 * row.below(4);
    const double wide = row.between(5.0, 45.0);
    std::vector<std::pair<double, double>> turns;
    for (int frame = 0; frame <= last; ++frame) {
      turns.emplace_back(frame, wide * std::sin(2.0 * pi * (times * frame / length + behind)));
    }
    addTurnsAtFrames(moving, key, row.once(3) ? Vec3(0, 0, 1) : towardsItsRight, turns);
  }
  setEndsFromKeys(moving.clip);
  return moving;
}

/// The hips fall, the feet stop them or not, one of them or both, and go on down.
MovingBiped falling(Row& row) {
  MovingBiped moving = still(namedBody());
  moving.clip.framesPerSecond = rateBy(row);
  const double touch = row.between(4.0, 14.0);
  const double lowest = touch + row.between(1.0, 7.0);
  const double height = row.between(0.1, 0.9);
  const double sinks = row.between(0.02, 0.4);
  std::vector<std::pair<double, Vec3>> moves;
  for (double frame = 0.0; frame < touch; frame += 1.0) {
    const double share = frame / touch;
    moves.emplace_back(frame, Vec3(0.0, height * (1.0 - share * share), 0.0));
  }
  moves.emplace_back(touch, Vec3(0.0));
  moves.emplace_back(lowest, Vec3(0.0, -sinks, 0.0));
  moves.emplace_back(lowest + 10.0, Vec3(0.0, -sinks * row.between(0.5, 1.0), 0.0));
  addMoves(moving, "hips", moves);
  const double bend = std::acos(1.0 - sinks / 0.84) * 180.0 / pi;
  for (const char* const side : {"l", "r"}) {
    if (!row.once(4)) {
      addTurnsAtFrames(moving, std::string("thigh.") + side, towardsItsRight,
                       {{0.0, 0.0}, {touch, 0.0}, {lowest, bend}, {lowest + 10.0, bend}});
      addTurnsAtFrames(moving, std::string("shin.") + side, towardsItsRight,
                       {{0.0, 0.0}, {touch, 0.0}, {lowest, -2.0 * bend}, {lowest + 10.0, -2.0 * bend}});
    }
  }
  setEndsFromKeys(moving.clip);
  return moving;
}

} // namespace

TEST_CASE("The moments of clips in which limbs act, swing and land are as they were looked at") {
  std::string text;
  Row row(5);
  const std::vector<std::string> joints{"upperArm.l", "upperArm.r", "foreArm.l", "thigh.l",
                                        "thigh.r",    "spine0",     "neck0"};
  SyntheticBiped large = namedBody({.clavicles = false, .fingers = false});
  large.size = 4.0;
  large.facesBackwards = true;
  for (int i = 0; i < 14; ++i) {
    text += momentsText(fmt::format("acting {}", i), acting(row, i % 3 == 2 ? large : namedBody(), joints));
  }
  for (int i = 0; i < 20; ++i) {
    text +=
        momentsText(fmt::format("swinging {}", i), swinging(row, i % 3 == 2 ? large : namedBody(), joints));
  }
  for (int i = 0; i < 16; ++i) {
    text += momentsText(fmt::format("falling {}", i), falling(row));
  }
  text += momentsText("horse", pawingHorse()) + momentsText("snake", strikingSnake());
  SyntheticBiped horse = makeHorse();
  nameByKeys(horse);
  for (int i = 0; i < 6; ++i) {
    text += momentsText(fmt::format("swinging horse {}", i),
                        swinging(row, horse, {"thigh.l", "thigh.r", "scapula.l", "scapula.r", "tail0"}));
  }
  const std::string difference = differenceFromRecord("moments", text, 5e-4);
  INFO(difference);
  CHECK(difference.empty());
}

#include <memory>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "rig/adjust/solve_adjustments.h"
#include "rig/motion/controller_places.h"
#include "tests/support/recorded.h"
#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/moving_creatures.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

std::string placeText(const Vec3& value) {
  return fmt::format(" {:.4f} {:.4f} {:.4f}", value.x, value.y, value.z);
}

std::string placedText(Row& row, const std::string& title, const MovingBiped& moving,
                       const std::string& limb) {
  const ControllerList list = controllersOf(moving.scene, moving.body.limbs, moving.body.hips);
  std::vector<Adjustment> adjustments;
  for (std::uint32_t i = row.below(4); i > 0; --i) {
    const Controller& controller = row.oneOf(list.controllers);
    if (controller.moves) {
      adjustments.push_back(test::moved(controller.id, row.vector(0.15)));
    } else {
      adjustments.push_back(turned(controller.id, row.vector(30.0)));
    }
  }
  std::vector<Trail> trails;
  if (row.once(2)) {
    trails.push_back(connectedTrail(limb, 3.0, 14.0, row.between(0.5, 2.5)));
  }
  const MotionState motion = adjusted(moving, adjustments, trails);
  const FrameState shown = atFrame(moving, motion, row.between(0.0, 24.0));
  SolvedAdjustments solved = motion.adjustments;
  if (solved.body == nullptr) {
    solved.body = std::make_shared<const AdjustedBody>(
        adjustedBody({moving.scene, moving.clip, moving.body.hips, moving.body.limbs}));
  }
  std::string text = title + "\n";
  for (const PlacedController& placed : placeControllers({moving.scene, moving.clip, solved, shown})) {
    if (placed.kind == ControllerKind::joint && !row.once(6)) {
      continue;
    }
    const Quat& turn = placed.orientationWorld;
    text += fmt::format("  {} kind {} carried by {} {} {} at", placed.id, static_cast<int>(placed.kind),
                        static_cast<int>(placed.carrier), placed.moves ? "moves" : "stays",
                        placed.turns ? "turns" : "stands") +
            placeText(placed.placeWorld) + " turned" +
            placeText((turn.w < 0.0 ? -1.0 : 1.0) * Vec3(turn.x, turn.y, turn.z)) + " along" +
            placeText(placed.carrierAxesWorld[0]) + placeText(placed.carrierAxesWorld[1]) + " slack" +
            placeText(placed.slack) + " joint" +
            (placed.jointWorld ? placeText(*placed.jointWorld) : " none") + "\n";
  }
  return text;
}

/// Everything turns a little about axes of its own.
MovingBiped turningEverywhere(const SyntheticBiped& body, Row& row) {
  MovingBiped moving = still(body);
  for (const auto& [key, node] : moving.node) {
    const Quat rest = moving.scene.nodes[at(node)].rest.rotation;
    const Quat turn = glm::normalize(Quat(1.0, row.around(0.15), row.around(0.15), row.around(0.15)));
    moving.clip.tracks.emplace_back(
        rotationTrack(node, Interpolation::linear, {{0.0, rest}, {1.0, rest * turn}}));
  }
  setEndsFromKeys(moving.clip);
  return moving;
}

} // namespace

TEST_CASE("Where the controllers of bodies of every build stand and along what they move is as it was looked "
          "at") {
  std::string text;
  Row row(3);
  SyntheticBiped large = namedBody({.spineJoints = 4, .neckJoints = 2, .clavicles = false});
  large.size = 3.0;
  large.facesBackwards = true;
  for (int i = 0; i < 4; ++i) {
    text += placedText(row, "a punch", punchingBiped(), "left-arm");
    text += placedText(row, "splines", punchingBiped(Interpolation::cubicSpline), "left-leg");
    text += placedText(row, "large, facing back", turningEverywhere(large, row), "right-arm");
    text += placedText(row, "a horse", pawingHorse(), "front-left-leg");
    text += placedText(row, "a snake", strikingSnake(), "spine");
    for (Creature& creature : creatures()) {
      nameByKeys(creature.body);
      const MovingBiped moving = turningEverywhere(creature.body, row);
      text += placedText(row, creature.title, moving, moving.body.limbs.front().id);
    }
  }
  const std::string difference = differenceFromRecord("placed-controllers", text, 5e-4);
  INFO(difference);
  CHECK(difference.empty());
}

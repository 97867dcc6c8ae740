#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/rig/creatures.h"
#include "tests/support/rig/moving_creatures.h"
#include "tests/support/rig/rekeyed_clip.h"
#include "tests/support/rig/soft_limbs.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

Vec3 placeIn(const FrameState& frame, NodeIndex node) {
  return positionOf(frame.worlds[at(node)]);
}

double degreesBetween(const FrameState& before, const FrameState& after, NodeIndex node) {
  const Quat turn = rotationOf(after.worlds[at(node)]) * glm::inverse(rotationOf(before.worlds[at(node)]));
  return 2.0 * std::atan2(glm::length(Vec3(turn.x, turn.y, turn.z)), std::abs(turn.w)) * 180.0 / pi;
}

SoftBones longerEachFrame(double /*frame*/) {
  return {1.2, 0.9, 1.0, Vec3(0.3, 1.0, 0.2), 0.0};
}

} // namespace

TEST_CASE("The head of a serpent leads, at whichever end of its joints it is") {
  CHECK(strikingSnake().limb("spine").ledByFirst);
  SyntheticBiped tailFirst = makeSnake();
  nameByKeys(tailFirst);
  CHECK_FALSE(still(tailFirst).limb("spine").ledByFirst);
  const MovingBiped snake = strikingSnake();
  CHECK(startingSpace(snake.scene, snake.clip, snake.limb("spine"), snake.body.hips, {0, 12}) ==
        TrailSpace::world);
  for (const Limb& limb : pawingHorse().body.limbs) {
    CHECK_FALSE(limb.ledByFirst);
  }
}

TEST_CASE("A serpent's strike brings its head farther, straight as it was, and leaves the end of its tail") {
  const MovingBiped snake = strikingSnake();
  const Limb& spine = snake.limb("spine");
  const NodeIndex head = snake.node.at("head");
  const NodeIndex jaw = snake.node.at("jaw");
  for (const Bend bend : {Bend::keep, Bend::straighten}) {
    for (const double scale : {0.8, 1.5, 2.0}) {
      CAPTURE(bend == Bend::keep, scale);
      Trail trail = connectedTrail("spine", 0, 12, scale);
      trail.settings.bend = bend;
      const MotionState motion = solved(snake, {trail});
      const FrameState before = sourceAtFrame(snake, 12);
      const FrameState after = atFrame(snake, motion, 12);
      CHECK(lengthOf(spine, after) == Approx(scale * lengthOf(spine, before)).epsilon(1e-4));
      CHECK(glm::distance(endPosition(spine, after), endPosition(spine, before)) < 1e-6 * snake.body.height);
      CHECK(std::abs(glm::dot(rotationOf(after.worlds[at(head)]), rotationOf(before.worlds[at(head)]))) ==
            Approx(1.0).margin(1e-9));
      const Vec3 bite = placeIn(before, jaw) - placeIn(before, head);
      CHECK(glm::distance(placeIn(after, jaw) - placeIn(after, head), bite) < 1e-9);
      const DrawnTrail drawn =
          pathsAt(snake.scene, snake.clip, motion, 0, drawnFrames(snake.clip, motion.trails[0], 2));
      for (std::size_t i = 0; i < drawn.frames.size(); ++i) {
        const FrameState here = atFrame(snake, motion, drawn.frames[i]);
        CHECK(glm::distance(leadingPosition(spine, here), drawn.exaggerated[i]) < 1e-5 * snake.body.height);
      }
    }
  }
}

TEST_CASE("A strike that is saved plays as it was shown") {
  const MovingBiped snake = strikingSnake();
  const Rekeyed rekeyed = rekeyedOf(snake, {connectedTrail("spine", 0, 12, 1.6)});
  CHECK(worstMiss(snake, rekeyed, 0, 24) < 1e-4 * snake.body.height);
}

TEST_CASE("The end of a serpent's spine turns by what its controller is turned, and goes where it is moved") {
  const MovingBiped snake = strikingSnake();
  const Limb& spine = snake.limb("spine");
  const Vec3 aside(0.2, 0.0, 0.1);
  const FrameState before = sourceAtFrame(snake, 12);
  const FrameState turnedOne = atFrame(snake, adjusted(snake, {turned("spine-top", {0, 60, 0})}), 12);
  REQUIRE(spine.endNode.exists());
  CHECK(degreesBetween(before, turnedOne, spine.endNode) == Approx(60.0).margin(1e-6));
  CHECK(glm::distance(endPosition(spine, turnedOne), endPosition(spine, before)) < 1e-6 * snake.body.height);
  CHECK(placeIn(turnedOne, spine.joints.front()) == placeIn(before, spine.joints.front()));

  const FrameState movedTop = atFrame(snake, adjusted(snake, {test::moved("spine-top", aside)}), 12);
  CHECK(glm::distance(endPosition(spine, movedTop), endPosition(spine, before)) ==
        Approx(glm::length(aside)).epsilon(1e-6));
  CHECK(degreesBetween(before, movedTop, spine.endNode) < 1e-6);

  const FrameState movedLow = atFrame(snake, adjusted(snake, {test::moved("spine-low", aside)}), 12);
  CHECK(glm::distance(placeIn(movedLow, spine.joints.front()), placeIn(before, spine.joints.front())) ==
        Approx(glm::length(aside)).epsilon(1e-6));
  CHECK(glm::distance(endPosition(spine, movedLow), endPosition(spine, before)) < 1e-6 * snake.body.height);
}

TEST_CASE("Weight stretches each bone of a serpent, also that behind its head") {
  const MovingBiped snake = strikingSnake();
  const Limb& spine = snake.limb("spine");
  const FrameState soft =
      atFrame(snake, softMotion(snake, {}, {softLimb(snake, "spine", longerEachFrame)}), 12);
  const std::vector<Vec3> before = limbPoints(spine, sourceAtFrame(snake, 12));
  const std::vector<Vec3> after = limbPoints(spine, soft);
  for (std::size_t i = 0; i < spine.joints.size(); ++i) {
    CHECK(glm::distance(after[i + 1] - after[i], 1.2 * (before[i + 1] - before[i])) < 1e-9);
  }
}

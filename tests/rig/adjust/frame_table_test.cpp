#include "rig/adjust/frame_table.h"

#include <memory>

#include <catch2/catch.hpp>

#include "rig/motion/paths.h"
#include "tests/support/rig/adjusted_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

MotionInput inputOf(const MovingBiped& moving, std::vector<Adjustment> adjustments) {
  MotionInput input;
  input.scene = &moving.scene;
  input.clip = &moving.clip;
  input.hips = moving.body.hips;
  input.limbs = moving.body.limbs;
  input.trails = {connectedTrail("left-arm", 6.0, 12.0, 2.0), connectedTrail("right-leg", 0.0, 20.0, 1.5)};
  input.adjustments = std::move(adjustments);
  return input;
}

std::vector<NodeIndex> allNodes(const Scene& scene) {
  std::vector<NodeIndex> nodes;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    nodes.emplace_back(i);
  }
  return nodes;
}

} // namespace

TEST_CASE("a table has the adjusted frames of its own times, and no others") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = adjusted(moving, {moved("hips", {0.0, -0.1, 0.0})});
  const FrameTable source(moving.scene, moving.clip,
                          FrameTable::extentOf(allNodes(moving.scene), {0.25, 0.1, 0.25}));
  CHECK(source.extent().timesSeconds == std::vector<double>{0.1, 0.25});
  const FrameTable table(source, motion.adjustments);
  const FrameState* const frame = table.find(0.1);
  REQUIRE(frame != nullptr);
  CHECK(frame->worlds == adjustedFrame(moving.scene, moving.clip, motion, 0.1).worlds);
  CHECK(source.find(0.1)->worlds == sampledFrame(moving.scene, moving.clip, 0.1).worlds);
  CHECK(table.find(0.25) != nullptr);
  CHECK(table.find(0.2) == nullptr);
  CHECK(table.find(0.3) == nullptr);
}

TEST_CASE("a time that a file rounds to single precision finds the frame that it means") {
  const MovingBiped moving = punchingBiped();
  const double third = 1.0 / 3.0;
  const FrameTable source(moving.scene, moving.clip,
                          FrameTable::extentOf(allNodes(moving.scene), {0.1, third, 5.2}));
  CHECK(source.find(static_cast<double>(static_cast<float>(third))) == source.find(third));
  CHECK(source.find(static_cast<double>(static_cast<float>(0.1))) == source.find(0.1));
  CHECK(source.find(static_cast<double>(static_cast<float>(5.2))) == source.find(5.2));
  CHECK(source.find(third) != nullptr);
  CHECK(source.find(third)->timeSeconds == third);
  const double beside = third + 1e-8; // the key of another trail
  const FrameTable close(moving.scene, moving.clip,
                         FrameTable::extentOf(allNodes(moving.scene), {third, beside}));
  CHECK(close.find(third)->timeSeconds == third);
  CHECK(close.find(beside)->timeSeconds == beside);
  CHECK(source.find(third + 1e-6) == nullptr);
  CHECK(source.find(third - 1e-6) == nullptr);
}

TEST_CASE("a table made in the memory of one that is gone has frames of its own") {
  const MovingBiped moving = punchingBiped();
  const MotionState low = adjusted(moving, {moved("hips", {0.0, -0.1, 0.0}), moved("head", {0.0, 0.3, 0.0})});
  const MotionState high = adjusted(moving, {moved("hips", {0.0, 0.02, 0.0})});
  const std::vector<double> times{0.0, 0.1, 0.25, 0.3};
  const FrameTable source(moving.scene, moving.clip, FrameTable::extentOf(allNodes(moving.scene), times));
  auto gone = std::make_unique<const FrameTable>(source, low.adjustments);
  const FrameState* const memory = gone->find(0.25);
  gone.reset();
  const FrameTable first(source, high.adjustments);
  CHECK(first.find(0.25) == memory);
  const FrameTable second(source, low.adjustments);
  for (const double time : times) {
    INFO(time);
    const FrameState expected = adjustedFrame(moving.scene, moving.clip, high, time);
    CHECK(first.find(time)->worlds == expected.worlds);
    CHECK(first.find(time)->pose.locals == expected.pose.locals);
    CHECK(first.find(time)->stretch == expected.stretch);
    CHECK(first.find(time)->timeSeconds == time);
    CHECK(second.find(time)->worlds == adjustedFrame(moving.scene, moving.clip, low, time).worlds);
    CHECK(source.find(time)->worlds == sampledFrame(moving.scene, moving.clip, time).worlds);
  }
}

TEST_CASE("frames kept from another offset give the trails that are solved without them") {
  const MovingBiped moving = punchingBiped();
  const MotionState before = solveMotion(inputOf(moving, {moved("hips", {0.0, -0.1, 0.05})}));
  REQUIRE(before.sourceFrames != nullptr);
  for (const char* const controller : {"hips", "left-hand", "spine-top"}) {
    MotionInput input = inputOf(moving, {moved(controller, {0.02, -0.04, 0.0})});
    const MotionState fresh = solveMotion(input);
    input.sameClip = &before;
    const MotionState kept = solveMotion(input);
    const bool isSameController = std::string(controller) == "hips";
    CHECK((kept.sourceFrames == before.sourceFrames) == isSameController);
    for (std::size_t trail = 0; trail < fresh.trails.size(); ++trail) {
      const std::vector<double> frames = drawnFrames(moving.clip, fresh.trails[trail], 2);
      CHECK(pathsAt(moving.scene, moving.clip, kept, trail, frames) ==
            pathsAt(moving.scene, moving.clip, fresh, trail, frames));
    }
  }
}

TEST_CASE("what hangs on the hips as one piece goes down with them, its joints as they were") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = adjusted(moving, {moved("hips", {0.0, -0.1, 0.0})});
  const FrameState frame = atFrame(moving, motion, 10.0);
  const FrameState source = sourceAtFrame(moving, 10.0);
  for (const char* const limb : {"left-arm", "right-arm", "spine", "neck"}) {
    for (const NodeIndex joint : moving.limb(limb).joints) {
      CHECK(frame.pose.locals[at(joint)] == source.pose.locals[at(joint)]);
      CHECK(std::abs(positionOf(frame.worlds[at(joint)]).y - positionOf(source.worlds[at(joint)]).y + 0.1) <
            1e-9);
    }
  }
}

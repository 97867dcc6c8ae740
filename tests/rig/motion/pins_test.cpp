#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/math/rotation.h"
#include "rig/motion/apply_holds.h"
#include "tests/support/rig/adjusted_biped.h"
#include "tests/support/rig/held_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr double closely = 1e-7; // of a body about 1.8 units tall

// A share of the way that is as slow at its ends as a hold comes and goes.
double easedShare(double share) {
  return share * share * (3.0 - 2.0 * share);
}

double wholeLength(const MovingBiped& moving, const std::string& limb, const FrameState& frame) {
  const std::vector<Vec3> points = limbPoints(moving.limb(limb), frame.worlds);
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += glm::length(points[i] - points[i - 1]);
  }
  return length;
}

std::vector<double> boneVolumes(const MovingBiped& moving, const std::string& limb, const FrameState& frame) {
  std::vector<double> volumes;
  for (const NodeIndex joint : moving.limb(limb).joints) {
    volumes.push_back(frame.stretch.empty() ? 1.0 : glm::determinant(frame.stretch[at(joint)]));
  }
  return volumes;
}

} // namespace

TEST_CASE("a hold comes over its first blend and goes over its second") {
  const HoldSpan span{1.0, 2.0, 0.5, 0.25, 0.0};
  const auto [seconds, strength] = GENERATE(table<double, double>({{0.0, 0.0},
                                                                   {0.5, 0.0},
                                                                   {0.625, 0.15625},
                                                                   {0.75, 0.5},
                                                                   {0.875, 0.84375},
                                                                   {1.0, 1.0},
                                                                   {1.5, 1.0},
                                                                   {2.0, 1.0},
                                                                   {2.0625, 0.84375},
                                                                   {2.125, 0.5},
                                                                   {2.1875, 0.15625},
                                                                   {2.25, 0.0},
                                                                   {3.0, 0.0}}));
  CAPTURE(seconds);
  CHECK(span.strengthAt(seconds) == Approx(strength).margin(1e-12));
  const HoldSpan backwards{-2.0, -1.0, 0.25, 0.5, 0.0};
  CHECK(backwards.strengthAt(-seconds) == Approx(strength).margin(1e-12));
}

TEST_CASE("a hold without a blend on one side jumps there alone") {
  const HoldSpan comes{1.0, 2.0, 0.5, 0.0, 0.0};
  CHECK(comes.strengthAt(0.75) == Approx(0.5));
  CHECK(comes.strengthAt(2.01) == Approx(0.0).margin(1e-12));
  const HoldSpan goes{1.0, 2.0, 0.0, 0.5, 0.0};
  CHECK(goes.strengthAt(0.99) == Approx(0.0).margin(1e-12));
  CHECK(goes.strengthAt(2.25) == Approx(0.5));
}

TEST_CASE("in a loop of three seconds a blend goes on at the other end of the clip") {
  const HoldSpan early{0.25, 2.0, 0.5, 0.0, 3.0};
  CHECK(early.strengthAt(2.875) == Approx(0.15625));
  CHECK(early.strengthAt(3.0) == Approx(0.5));
  CHECK(early.strengthAt(0.0) == Approx(0.5));
  CHECK(early.strengthAt(2.5) == Approx(0.0).margin(1e-12));
  const HoldSpan late{1.0, 2.75, 0.0, 0.5, 3.0};
  CHECK(late.strengthAt(0.0) == Approx(0.5));
  CHECK(late.strengthAt(0.125) == Approx(0.15625));
  CHECK(late.strengthAt(0.5) == Approx(0.0).margin(1e-12));
  CHECK_FALSE(early.actsInTurn(-1));
  CHECK(early.actsInTurn(0));
  CHECK(early.actsInTurn(1));
  CHECK(late.actsInTurn(-1));
  CHECK_FALSE(late.actsInTurn(1));
}

TEST_CASE("what comes or goes without a blend does not reach over the seam of a loop") {
  const HoldSpan whole{0.0, 3.0, 0.0, 0.0, 3.0};
  CHECK_FALSE(whole.actsInTurn(-1));
  CHECK_FALSE(whole.actsInTurn(1));
  const HoldSpan once{0.25, 2.75, 0.5, 0.5, 0.0};
  CHECK_FALSE(once.actsInTurn(-1));
  CHECK_FALSE(once.actsInTurn(1));
}

TEST_CASE("a pin acts over the seam of a loop that stands, not of one that travels") {
  const auto [travel, acts] = GENERATE(table<Vec3, bool>(
      {{Vec3(0.0), true}, {Vec3(0, 0, 0.3), false}, {Vec3(0.3, 0, 0), false}, {Vec3(0, 0.3, 0), false}}));
  MovingBiped moving = punchingBiped();
  const NodeIndex hips = moving.node.at("hips");
  std::erase_if(moving.clip.tracks, [&](const auto& leaf) { return leaf->node == hips; });
  const Vec3 rest = moving.scene.nodes[at(hips)].rest.translation;
  moving.clip.tracks.emplace_back(
      vectorTrack(hips, Channel::translation, Interpolation::linear,
                  {{0.0, rest}, {0.5, rest + Vec3(0, 0, 0.2)}, {1.0, rest + travel}}));
  Holds holds;
  holds.pins = {pinAt("left-arm", heldOver(2, 8, 6, 0), 8)};
  const FrameState source = sourceAtFrame(moving, 22);
  const MotionState looped = held(motionInput(moving, {}, true), holds);
  CHECK((placesApart(endPlaceOf(moving, "left-arm", atFrame(moving, looped, 22)),
                     endPlaceOf(moving, "left-arm", source)) > 1e-3) == acts);
  const MotionState once = held(motionInput(moving, {}, false), holds);
  CHECK(largestMatrixMiss(atFrame(moving, once, 22), source) < 1e-12);
}

TEST_CASE("a pinned hand or foot stays where the clip has it at one frame, and comes and goes evenly") {
  const std::string limb = GENERATE(from_range(handsAndFeet));
  const bool turns = GENERATE(true, false);
  CAPTURE(limb, turns);
  const MovingBiped moving = punchingBiped();
  Holds holds;
  holds.pins = {pinAt(limb, heldOver(8, 14, 4, 8), 10)};
  holds.pins.front().turns = turns;
  const MotionState motion = held(moving, holds);
  const HeldPlace pinned = endPlaceOf(moving, limb, sourceAtFrame(moving, 10));
  for (double frame = 0.0; frame <= 24.0; frame += 0.5) {
    CAPTURE(frame);
    const FrameState source = sourceAtFrame(moving, frame);
    const FrameState after = atFrame(moving, motion, frame);
    const double outside = frame < 8 ? (8 - frame) / 4 : frame > 14 ? (frame - 14) / 8 : 0.0;
    const double strength = 1.0 - easedShare(std::clamp(outside, 0.0, 1.0));
    const HeldPlace own = endPlaceOf(moving, limb, source);
    const HeldPlace there = endPlaceOf(moving, limb, after);
    CHECK(glm::length(there.position - glm::mix(own.position, pinned.position, strength)) < closely);
    CHECK(turnApart(there, own) == Approx(turns ? strength * turnApart(pinned, own) : 0.0).margin(1e-6));
    if (strength <= 0.0) {
      CHECK(largestMatrixMiss(after, source) < 1e-12);
    }
  }
}

TEST_CASE("a pin holds the place of the adjusted clip") {
  const std::string limb = GENERATE(from_range(handsAndFeet));
  const MovingBiped moving = punchingBiped();
  MotionInput input = motionInput(moving, {});
  input.adjustments = {moved("hips", Vec3(0.05, -0.03, 0.02)), turned("chest", Vec3(0, 20, 0)),
                       valued("left-leg.follow", 1.0), valued("right-leg.follow", 1.0)};
  Holds holds;
  holds.pins = {pinAt(limb, heldOver(0, 24), 6)};
  const HeldPlace wanted = endPlaceOf(moving, limb, atFrame(moving, held(input, {}), 6));
  REQUIRE(placesApart(wanted, endPlaceOf(moving, limb, sourceAtFrame(moving, 6))) > 0.01);
  const MotionState motion = held(input, holds);
  for (const double frame : {0.0, 6.0, 13.0, 24.0}) {
    const HeldPlace there = endPlaceOf(moving, limb, atFrame(moving, motion, frame));
    CHECK(placesApart(there, wanted) < closely);
    CHECK(turnApart(there, wanted) < 1e-6);
  }
}

TEST_CASE("a pin out of reach stretches the limb, or leaves its bones as long as they are") {
  const std::string limb = GENERATE(from_range(handsAndFeet));
  const double stretch = GENERATE(0.0, 1.0);
  CAPTURE(limb, stretch);
  const MovingBiped moving = punchingBiped();
  Holds holds;
  holds.pins = {pinAt(limb, heldOver(0, 24), 0)};
  const FrameState source = sourceAtFrame(moving, 5);
  const Vec3 base = limbPoints(moving.limb(limb), source.worlds).front();
  const Vec3 aside = glm::normalize(Vec3(0.6, -0.4, 0.5));
  const double length = wholeLength(moving, limb, source);
  holds.pins.front().place = HeldPlace{base + 1.5 * length * aside, Quat(1, 0, 0, 0)};
  holds.pins.front().stretch = stretch;
  const FrameState after = atFrame(moving, held(moving, holds), 5);
  const double reached = stretch > 0.0 ? 1.5 * length : length;
  CHECK(glm::length(endPlaceOf(moving, limb, after).position - (base + reached * aside)) < 1e-6);
  CHECK(wholeLength(moving, limb, after) == Approx(reached).margin(1e-6));
}

TEST_CASE("a held limb that is twice as long keeps as much of its volume as its controller says") {
  const std::string limb = GENERATE(from_range(handsAndFeet));
  const double kept = GENERATE(-0.5, 0.0, 0.4, 1.0, 1.7);
  CAPTURE(limb, kept);
  const MovingBiped moving = punchingBiped();
  const FrameState source = sourceAtFrame(moving, 5);
  const std::vector<Vec3> points = limbPoints(moving.limb(limb), source.worlds);
  Holds holds;
  holds.pins = {pinAt(limb, heldOver(0, 24), 0)};
  holds.pins.front().place =
      HeldPlace{points.front() + 2.0 * wholeLength(moving, limb, source) * Vec3(0, 0, 1), Quat(1, 0, 0, 0)};
  MotionInput input = motionInput(moving, {});
  input.adjustments = {valued(limb + ".volume", kept)};
  for (const double volume : boneVolumes(moving, limb, atFrame(moving, held(input, holds), 5))) {
    CHECK(volume == Approx(std::pow(2.0, 1.0 - std::clamp(kept, 0.0, 1.0))).epsilon(1e-5));
  }
}

TEST_CASE("a limb that a trail stretched gets its length and its thickness back where it is held") {
  const std::string limb = GENERATE("left-arm", "left-leg");
  const double volume = GENERATE(0.0, 0.5, 1.0);
  CAPTURE(limb, volume);
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail(limb, 0, 12, 2.0);
  trail.settings.volume = volume;
  Holds holds;
  holds.pins = {pinAt(limb, heldOver(11, 13, 2, 2), 12)};
  const MotionState motion = held(motionInput(moving, {trail}), holds);
  const FrameState source = sourceAtFrame(moving, 12);
  const FrameState after = atFrame(moving, motion, 12);
  CHECK(wholeLength(moving, limb, atFrame(moving, solved(moving, {trail}), 12)) >
        1.5 * wholeLength(moving, limb, source));
  CHECK(wholeLength(moving, limb, after) == Approx(wholeLength(moving, limb, source)).epsilon(1e-5));
  for (const double now : boneVolumes(moving, limb, after)) {
    CHECK(now == Approx(1.0).epsilon(1e-5));
  }
}

TEST_CASE("a limb that a trail stretched does not jump where its hold begins to come and where it is gone") {
  const std::string limb = GENERATE("left-arm", "left-leg");
  const MovingBiped moving = punchingBiped();
  const Trail trail = connectedTrail(limb, 0, 12, 2.0);
  Holds holds;
  holds.pins = {pinAt(limb, heldOver(12, 12, 4, 1), 12)};
  const MotionState free = solved(moving, {trail});
  const MotionState motion = held(motionInput(moving, {trail}), holds);
  for (const double frame : {8.01, 12.99}) {
    CAPTURE(frame);
    CHECK(largestNodeMiss(atFrame(moving, motion, frame), atFrame(moving, free, frame)) < 2e-3);
  }
}

TEST_CASE("pins of limbs that the character lacks do nothing, and the others hold") {
  const MovingBiped moving = punchingBiped();
  Holds holds;
  holds.pins = {pinAt("tail", heldOver(0, 24), 6), pinAt("right-leg", heldOver(0, 24), 6)};
  const MotionState motion = held(moving, holds);
  REQUIRE(motion.holds.pins.size() == 2);
  CHECK_FALSE(motion.holds.pins.front().has_value());
  CHECK(placesApart(endPlaceOf(moving, "right-leg", atFrame(moving, motion, 20)),
                    endPlaceOf(moving, "right-leg", sourceAtFrame(moving, 6))) < closely);
}

// When a hold has all of a limb's end: of pins, of grips the limb that follows, of props the firm hands.
#include <catch2/catch.hpp>

#include "tests/support/rig/held_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

bool hasAll(const MovingBiped& moving, const MotionState& motion, const char* limb, double frame) {
  return isFullyHeld(motion.holds, moving.limb(limb), frame / moving.clip.framesPerSecond);
}

} // namespace

TEST_CASE("A grip has all of the hand that follows over its range, and nothing of the one that leads") {
  const MovingBiped moving = bipedWithBat();
  Holds holds;
  Grip grip;
  grip.follower = "right-arm";
  grip.leader = "left-arm";
  grip.time = heldOver(6, 12, 3, 3);
  holds.grips = {grip};
  const MotionState motion = held(moving, holds);
  for (const double frame : {6.0, 9.0, 12.0}) {
    CAPTURE(frame);
    CHECK(hasAll(moving, motion, "right-arm", frame));
    CHECK_FALSE(hasAll(moving, motion, "left-arm", frame));
  }
  for (const double frame : {2.0, 5.0, 13.5, 20.0}) {
    CAPTURE(frame);
    CHECK_FALSE(hasAll(moving, motion, "right-arm", frame));
  }
}

TEST_CASE("A prop has all of a hand that is wholly firm on it, over its range") {
  const MovingBiped moving = bipedWithBat();
  Holds holds;
  Prop prop;
  prop.node = "bat";
  prop.boundFrame = 0.0;
  prop.time = heldOver(6, 12, 3, 3);
  for (const auto& [limb, firmness] : {std::pair("left-arm", 0.9), {"right-arm", 1.0}}) {
    OffsetKey key;
    key.value = firmness;
    prop.hands.push_back({limb, {key}});
  }
  holds.props = {prop};
  const MotionState motion = held(moving, holds);
  CHECK(hasAll(moving, motion, "right-arm", 9.0));
  CHECK_FALSE(hasAll(moving, motion, "left-arm", 9.0));
  CHECK_FALSE(hasAll(moving, motion, "left-leg", 9.0));
  CHECK_FALSE(hasAll(moving, motion, "right-arm", 4.5)); // comes
  CHECK_FALSE(hasAll(moving, motion, "right-arm", 20.0));
}

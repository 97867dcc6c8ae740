#include "app/auto/held_things.h"

#include <utility>

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::app;

namespace {

rig::OffsetKey firmness(double frame, double value) {
  return {.frame = frame, .value = value};
}

/// A bat that the left hand holds from frame 0 and lets go between 8 and 10, and the right one takes at 5.
rig::Prop bat() {
  rig::Prop prop;
  prop.hands = {{"left-arm", {firmness(0.0, 1.0), firmness(8.0, 1.0), firmness(10.0, 0.0)}},
                {"right-arm", {firmness(5.0, 1.0)}}};
  return prop;
}

} // namespace

TEST_CASE("A hand holds a prop from its first firm key until it begins to let go") {
  const rig::Prop prop = bat();
  CHECK(isHeldBy(prop, "left-arm"));
  CHECK(isHeldBy(prop, "right-arm"));
  CHECK_FALSE(isHeldBy(prop, "neck"));
  for (const double frame : {0.0, 4.0, 8.0}) {
    CHECK(isHeldBy(prop, "left-arm", frame));
  }
  for (const double frame : {-1.0, 8.5, 10.0, 20.0}) {
    CHECK_FALSE(isHeldBy(prop, "left-arm", frame));
  }
  CHECK_FALSE(isHeldBy(prop, "right-arm", 4.9));
  CHECK(isHeldBy(prop, "right-arm", 5.0));
  CHECK(isHeldBy(prop, "right-arm", 30.0));
  CHECK_FALSE(isHeldBy(prop, "neck", 6.0));
}

TEST_CASE(
    "Both hands are on a prop only at frames at which each of them holds it, whichever is asked first") {
  AutoPlan plan;
  plan.holds.props = {bat()};
  for (const auto& [frame, both] : {std::pair(4.0, false), {6.0, true}, {9.0, false}, {12.0, false}}) {
    CAPTURE(frame);
    CHECK(areOnProp(plan, "left-arm", "right-arm", frame) == both);
    CHECK(areOnProp(plan, "right-arm", "left-arm", frame) == both);
  }
  rig::Prop other;
  other.hands = {{"left-arm", {firmness(0.0, 1.0)}}};
  plan.holds.props.push_back(other);
  CHECK_FALSE(areOnProp(plan, "left-arm", "right-arm", 12.0)); // each on one of its own
  CHECK_FALSE(areOnProp(AutoPlan{}, "left-arm", "right-arm", 6.0));
}

#include "app/auto/held_things.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/auto/clip_ground.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/nodes.h"

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

/// The boxer with a stick that is as far from its left hand as each frame says, and no part of the hand.
template <typename Distance>
Document withStick(const Distance& distanceAt) {
  Document document = test::boxer();
  Scene scene = *document.scene;
  scene.meshes.push_back({"Stick", {Primitive{}}, {}});
  const NodeIndex stick = test::addNode(scene, "Stick", NodeIndex::none, {0.0, 0.0, 0.0});
  scene.nodes[at(stick)].mesh = static_cast<int>(scene.meshes.size()) - 1;
  document.scene = std::make_shared<const Scene>(std::move(scene));
  Track moves;
  moves.node = stick;
  moves.channel = Channel::translation;
  moves.width = 3;
  for (int frame = 0; frame <= 20; ++frame) {
    const Vec3 place = test::endOf(document, "left-arm", frame) + Vec3(0.0, 0.0, distanceAt(frame));
    moves.times.push_back(static_cast<float>(frame / 30.0));
    for (int axis = 0; axis < 3; ++axis) {
      moves.values.push_back(static_cast<float>(place[axis]));
    }
  }
  Clip clip = document.clips->front();
  clip.tracks.emplace_back(std::move(moves));
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  return document;
}

/// When a hand holds the stick and lets it go, where a stroke between two frames is exaggerated.
std::vector<rig::OffsetKey> heldOver(const Document& document, double start, double end) {
  PlannedTrail planned;
  planned.trail.limb = "left-arm";
  planned.trail.settings.startFrame = start;
  planned.trail.settings.endFrame = end;
  AutoPlan plan;
  plan.trails = {planned};
  const std::vector<rig::Prop> props = propsFor(clipGround(document, 0), plan);
  REQUIRE(props.size() <= 1);
  if (props.empty()) {
    return {};
  }
  REQUIRE(props.front().hands.size() == 1);
  CHECK(props.front().hands.front().limb == "left-arm");
  return props.front().hands.front().keys;
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

TEST_CASE("A thing that slips in the hand is held on, one that is away for longer than a hand lets go is "
          "taken again") {
  using Keys = std::vector<rig::OffsetKey>;
  const double arm = findLimb(test::boxer(), "left-arm")->restLength;
  // It slips by a tenth of the arm at each of so many frames after the sixth.
  const auto slipping = [&](int frames) {
    return withStick([=](int frame) { return 0.1 + 0.1 * arm * std::clamp(frame - 6, 0, frames); });
  };
  for (const int frames : {0, 1, 3}) {
    CAPTURE(frames);
    CHECK(heldOver(slipping(frames), 0.0, 5.0) == Keys{firmness(0.0, 1.0)});
  }
  CHECK(heldOver(slipping(5), 0.0, 5.0) ==
        Keys{firmness(0.0, 1.0), firmness(6.0, 1.0), firmness(9.0, 0.0), firmness(11.0, 1.0)});
  // Held through a stroke's range, a frame more or less; else it is of no matter.
  CHECK_FALSE(heldOver(slipping(5), 11.0, 20.0).empty());
  CHECK_FALSE(heldOver(slipping(5), 10.0, 21.0).empty());
  CHECK(heldOver(slipping(5), 9.0, 20.0).empty());
  CHECK_FALSE(heldOver(slipping(5), 0.0, 7.0).empty());
  CHECK(heldOver(slipping(5), 0.0, 8.0).empty());
}

TEST_CASE("A hand holds what is near it, stays as far from it for three frames and goes along as it swings") {
  using Keys = std::vector<rig::OffsetKey>;
  const double arm = findLimb(test::boxer(), "left-arm")->restLength;
  // As far away as 1.2 of the arm.
  const auto apart = [&](double share) {
    return heldOver(withStick([=](int) { return share * arm; }), 0.0, 5.0);
  };
  CHECK(apart(1.19) == Keys{firmness(0.0, 1.0)});
  CHECK(apart(1.21).empty());
  // By 0.06 of the arm from frame to frame it slips out.
  const auto slipping = [&](double share) {
    return heldOver(withStick([=](int frame) { return 0.1 + share * arm * std::clamp(frame - 6, 0, 5); }),
                    0.0, 5.0);
  };
  CHECK(slipping(0.059) == Keys{firmness(0.0, 1.0)});
  CHECK(slipping(0.061) ==
        Keys{firmness(0.0, 1.0), firmness(6.0, 1.0), firmness(9.0, 0.0), firmness(11.0, 1.0)});
  // Near the hand from one frame to another, far from it else.
  const auto passing = [&](int first, int last) {
    return heldOver(withStick([=](int frame) { return first <= frame && frame <= last ? 0.1 : 5.0; }), first,
                    last);
  };
  CHECK(passing(5, 8) ==
        Keys{firmness(0.0, 0.0), firmness(5.0, 1.0), firmness(8.0, 1.0), firmness(11.0, 0.0)});
  CHECK(passing(5, 7).empty());
  CHECK(passing(14, 18) == // The clip ends before the hand has let go.
        Keys{firmness(0.0, 0.0), firmness(14.0, 1.0), firmness(18.0, 1.0), firmness(20.0, 0.0)});
  // The arm turns by 0.08 radians a frame at first: within three it goes 0.24 of its length, within four
  // 0.32.
  CHECK(passing(0, 3).empty());
  CHECK(passing(0, 4) == Keys{firmness(0.0, 1.0), firmness(4.0, 1.0), firmness(7.0, 0.0)});
}

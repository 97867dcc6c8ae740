// Where what is held gets keys: over all of its hold, and on both sides of where that jumps.
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

#include "rig/rekey/keyed_part.h"
#include "tests/support/rig/held_biped.h"
#include "tests/support/rig/rekeyed_clip.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

TEST_CASE("a pin that comes or goes at once jumps in the keys as well, and blends where it does not") {
  const bool comesAtOnce = GENERATE(true, false);
  CAPTURE(comesAtOnce);
  const MovingBiped moving = punchingBiped();
  Holds holds;
  holds.pins = {pinAt("left-arm", heldOver(6, 18, comesAtOnce ? 0.0 : 2.0, comesAtOnce ? 2.0 : 0.0), 0.0)};
  Rekeyed rekeyed{held(moving, holds), {}, {}};
  RekeyOptions options;
  options.tolerance = 0.5e-4 * moving.body.height;
  rekeyed.keys = rekey(moving.scene, moving.clip, rekeyed.motion, options);
  rekeyed.clip = withTracks(moving.clip, rekeyed.keys.tracks);
  const double border = comesAtOnce ? 6.0 : 18.0;
  const double beside = comesAtOnce ? 6.0 - 1e-3 : 18.0 + 1e-3;
  const HeldPlace pinned = endPlaceOf(moving, "left-arm", sourceAtFrame(moving, 0.0));
  REQUIRE(placesApart(pinned, endPlaceOf(moving, "left-arm", sourceAtFrame(moving, border))) > 0.05);
  CHECK(placesApart(pinned, endPlaceOf(moving, "left-arm", poseOf(moving, rekeyed.clip, border))) <
        1e-4 * moving.body.height);
  CHECK(largestNodeMiss(poseOf(moving, rekeyed.clip, beside), sourceAtFrame(moving, beside)) < 1e-6);
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
}

TEST_CASE("a prop that is held all through a loop is keyed over it once, not again for the turns beside it") {
  MovingBiped moving = bipedWithBat();
  std::erase_if(moving.clip.tracks, [&](const CopyOnWrite<Track>& track) {
    return track->node == moving.body.hips; // the body stays in its place
  });
  OffsetKey firm;
  firm.value = 1.0;
  Prop prop;
  prop.node = "bat";
  prop.time = heldOver(0, 24, 4, 4);
  prop.hands.push_back({"left-arm", {firm}});
  Holds holds;
  holds.props = {prop};
  const MotionState motion = held(motionInput(moving, {}, true), holds);
  const std::vector<KeyedPart> parts = keyedParts(motion);
  const auto part = std::ranges::find_if(
      parts, [&](const KeyedPart& one) { return one.nodes == std::vector{moving.node.at("bat")}; });
  REQUIRE(part != parts.end());
  REQUIRE(part->windows.size() == 1);
  CHECK(part->windows[0].startSeconds == 0.0);
  CHECK(part->windows[0].endSeconds == 1.0);
}

TEST_CASE("on a loop the blend of a hold has its keys across the seam, at either end of the clip") {
  const bool comes = GENERATE(true, false);
  MovingBiped moving = punchingBiped();
  std::erase_if(moving.clip.tracks,
                [&](const CopyOnWrite<Track>& track) { return track->node == moving.body.hips; });
  Holds holds;
  holds.pins = {pinAt("left-arm", comes ? heldOver(2, 8, 6, 0) : heldOver(16, 22, 0, 6), comes ? 8.0 : 16.0)};
  Rekeyed rekeyed{held(motionInput(moving, {}, true), holds), {}, {}};
  const double across = comes ? 23.0 : 1.0;
  REQUIRE(placesApart(endPlaceOf(moving, "left-arm", atFrame(moving, rekeyed.motion, across)),
                      endPlaceOf(moving, "left-arm", sourceAtFrame(moving, across))) > 0.01);
  RekeyOptions options;
  options.tolerance = 0.5e-4 * moving.body.height;
  rekeyed.keys = rekey(moving.scene, moving.clip, rekeyed.motion, options);
  rekeyed.clip = withTracks(moving.clip, rekeyed.keys.tracks);
  CHECK(worstMiss(moving, rekeyed, 0, 24) < 1e-4 * moving.body.height);
}

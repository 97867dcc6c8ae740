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

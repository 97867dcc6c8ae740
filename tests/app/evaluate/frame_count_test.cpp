#include "app/evaluate/frame_count.h"

#include <catch2/catch.hpp>

#include "tests/support/refusal.h"

using namespace stretch;

TEST_CASE("A clip of a hundred thousand frames is worked on, one of a frame more is refused by its name") {
  const double rate = GENERATE(24.0, 30.0, 120.0);
  Clip clip;
  clip.name = "long walk";
  clip.framesPerSecond = rate;
  clip.endSeconds = 100000.0 / rate;
  CHECK(test::refusal(app::checkFrameCount(clip)) == "accepted");
  clip.endSeconds = 100001.0 / rate;
  CHECK(test::refusal(app::checkFrameCount(clip)) == "clip 'long walk': lasts 1e+05 frames, more than "
                                                     "100000: a key may stand at a wrong time; cut the clip, "
                                                     "or count in fewer frames per second");
  clip.endSeconds = 2345678.0 / rate;
  CHECK_THAT(test::refusal(app::checkFrameCount(clip)), Catch::Contains("lasts 2.35e+06 frames"));
  clip.endSeconds = 0.0;
  CHECK(test::refusal(app::checkFrameCount(clip)) == "accepted");
}

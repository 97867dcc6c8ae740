// What is found on a trail's frames, summed up for the lines that tell it.
#include "app/evaluate/trail_look.h"

#include <vector>

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::app;

TEST_CASE("A finding knows its first and last frame and the worst, which is not the largest value") {
  Finding finding;
  CHECK_FALSE(finding.any());
  finding.add(0.0, 0.4, 2.5); // a limb that is too short is the worse the shorter it is
  CHECK(finding.any());
  CHECK(finding.frames() == "at frame 0");
  finding.add(3.0, 0.2, 5.0);
  finding.add(7.0, 1.9, 1.9);
  CHECK(finding.first == 0.0);
  CHECK(finding.last == 7.0);
  CHECK(finding.worst == 0.2);
  CHECK(finding.worstFrame == 3.0);
  CHECK(finding.frames() == "at frames 0 to 7 (worst at 3)");
  finding.add(8.0, 2.0, 5.0); // as bad: the first of them is told
  CHECK(finding.worstFrame == 3.0);
}

TEST_CASE("Findings in every respect count for the first and the last frame of all") {
  const std::vector<Finding Findings::*> respects{&Findings::lengths, &Findings::turns, &Findings::vertices,
                                                  &Findings::swings,  &Findings::jumps, &Findings::edges,
                                                  &Findings::elbows,  &Findings::ends,  &Findings::lows,
                                                  &Findings::floors,  &Findings::bends};
  CHECK_FALSE(Findings().any());
  CHECK(Findings().worstFrames().empty());
  for (std::size_t i = 0; i < respects.size(); ++i) {
    CAPTURE(i);
    Findings alone;
    (alone.*respects[i]).add(0.0, 1.0, 1.0);
    CHECK(alone.any());
    CHECK(alone.firstFrame() == 0.0);
    CHECK(alone.lastFrame() == 0.0);
    CHECK(alone.worstFrames() == std::vector{0.0});
    Findings both = alone;
    Finding& other = both.*respects[(i + 1) % respects.size()];
    other.add(4.0, 1.0, 1.0);
    other.add(9.0, 2.0, 2.0);
    CHECK(both.firstFrame() == 0.0);
    CHECK(both.lastFrame() == 9.0);
    CHECK(both.worstFrames().size() == 2);
  }
}

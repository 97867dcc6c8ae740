#include "app/evaluate/way_back.h"

#include <optional>
#include <string>

#include <catch2/catch.hpp>

#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double wayRate = 20.0;

/// Frames of a way back, as it is, as it is wanted, and as it would be calm.
struct WayBack {
  double used = 4.0;
  double wanted = 10.0;
  double calm = 8.0;
  rig::Pivot pivot = rig::Pivot::start;
  bool loops = false;
  bool endsMeet = false;
  bool active = true;
};

std::optional<WayBackProblem> wayProblem(const WayBack& way) {
  // The boxer's punch ends elsewhere than it begins, the swings do not.
  const Document document = way.endsMeet ? test::swinger() : test::boxer();
  REQUIRE(endsMeet(document, 0) == way.endsMeet);
  rig::MotionState motion;
  motion.clip = 0;
  motion.framesPerSecond = wayRate;
  motion.loops = way.loops;
  rig::SolvedTrail trail;
  trail.active = way.active;
  trail.settings.pivot = way.pivot;
  trail.release = rig::Release(way.used / wayRate, 0.0);
  trail.wantedReleaseSeconds = way.wanted / wayRate;
  trail.calmReleaseSeconds = way.calm / wayRate;
  return wayBackProblem(document, motion, trail);
}

std::string toldOf(const WayBack& way) {
  const std::optional<WayBackProblem> problem = wayProblem(way);
  return problem ? problem->what : "";
}

} // namespace

TEST_CASE("A way back that is as long as is wanted, or as is calm, is no problem") {
  const bool loops = GENERATE(false, true);
  const bool meet = GENERATE(false, true);
  CHECK(toldOf({.used = 7.96, .loops = loops, .endsMeet = meet}).empty());
  CHECK_FALSE(toldOf({.used = 7.94, .loops = loops, .endsMeet = meet}).empty());
  CHECK(toldOf({.used = 4.0, .wanted = 4.0, .loops = loops, .endsMeet = meet}).empty());
  CHECK_FALSE(toldOf({.used = 4.0, .wanted = 4.1, .loops = loops, .endsMeet = meet}).empty());
  CHECK(toldOf({.used = 4.0, .calm = 4.0, .loops = loops, .endsMeet = meet}).empty());
  CHECK(toldOf({.loops = loops, .endsMeet = meet, .active = false}).empty());
}

TEST_CASE("A way back that the clip cuts off is told with its frames and what to do, at either end") {
  CHECK(toldOf({}) ==
        "the limb snaps back in 4 frames, faster than the stroke, because the clip ends there; end the "
        "range earlier");
  CHECK(toldOf({.pivot = rig::Pivot::end}) ==
        "the limb leaps out in 4 frames, faster than the stroke, because the "
        "clip begins there; start the range later");
  CHECK_THAT(toldOf({.used = 1.0}), Catch::Contains("snaps back in 1 frame, faster"));
  CHECK_THAT(toldOf({.used = 2.5}), Catch::Contains("snaps back in 2.5 frames, faster"));
  CHECK_FALSE(wayProblem({})->loopHelps);
}

TEST_CASE("A clip that ends with a stretch holds it, which is no problem") {
  CHECK(toldOf({.used = 0.04}).empty());
  CHECK_FALSE(toldOf({.used = 0.06}).empty());
}

TEST_CASE("On a loop the range that begins again cuts a way back off") {
  const bool meet = GENERATE(false, true);
  CHECK(toldOf({.loops = true, .endsMeet = meet}) ==
        "the limb snaps back in 4 frames, faster than the stroke, "
        "because its range begins again there; make the range shorter");
  CHECK_THAT(toldOf({.pivot = rig::Pivot::end, .loops = true, .endsMeet = meet}),
             Catch::StartsWith("the limb leaps out in 4 frames"));
  CHECK_THAT(toldOf({.used = 0.04, .loops = true, .endsMeet = meet}),
             Catch::StartsWith("the limb snaps back at once, faster"));
  CHECK_FALSE(wayProblem({.loops = true, .endsMeet = meet})->loopHelps);
}

TEST_CASE("A clip whose ends meet and that is no loop is told that it would snap back at its seam") {
  for (const double used : {0.0, 3.0}) {
    const std::optional<WayBackProblem> problem = wayProblem({.used = used, .endsMeet = true});
    REQUIRE(problem);
    CHECK(problem->loopHelps);
    CHECK(problem->what == "the clip's last pose is its first, and played as a loop the limb snaps back " +
                               std::string(used == 0.0 ? "at once" : "in 3 frames") + " at the seam");
  }
}

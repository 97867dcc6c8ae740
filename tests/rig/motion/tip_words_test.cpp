// What is told of a tip that is odd, on trails whose numbers are set by hand.
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "rig/motion/solve_steps.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

using Lines = std::vector<std::string>;

/// A trail over frames 4 to 10 of 20 a second whose tip is as it was asked for.
SolvedTrail plainTrail() {
  SolvedTrail solved;
  solved.settings.startFrame = solved.trail.settings.startFrame = 4.0;
  solved.settings.endFrame = solved.trail.settings.endFrame = 10.0;
  solved.settings.scale = solved.trail.settings.scale = 1.5;
  for (double frame = 4.0; frame <= 10.0; frame += 1.0) {
    solved.path.samples.push_back({frame / 20.0, Vec3(0.0), Vec3(frame, 0.0, 0.0), Vec3(0.0)});
  }
  solved.tip.wantedLength = solved.tip.reachedLength = 2.0;
  solved.tip.trailScale = 1.5;
  return solved;
}

Lines told(SolvedTrail solved) {
  explainTip(solved, 20.0);
  return solved.warnings;
}

SolvedTrail ranged(double startFrame, double endFrame) {
  SolvedTrail solved = plainTrail();
  solved.trail.settings.startFrame = startFrame;
  solved.trail.settings.endFrame = endFrame;
  return solved;
}

} // namespace

TEST_CASE("of a tip that is as it was asked for nothing is told") {
  CHECK(told(plainTrail()).empty());
}

TEST_CASE("a scale below the smallest is told with what it is taken as") {
  SolvedTrail solved = plainTrail();
  solved.trail.settings.scale = 0.02;
  CHECK(told(solved) == Lines{"scale 0.02 is taken as 0.05"});
  solved.trail.settings.scale = 0.05;
  CHECK(told(solved).empty());
}

TEST_CASE(
    "a range that the clip does not have is told with what is left, not where the clip ends in its frame") {
  const Lines cut{"the range is cut to the frames 4 to 10, which the clip has"};
  CHECK(told(ranged(4.009, 10.009)).empty()); // Key times are rounded.
  CHECK(told(ranged(3.98, 10.0)) == cut);
  CHECK(told(ranged(4.02, 10.0)) == cut);
  CHECK(told(ranged(4.0, 10.5)).empty());
  CHECK(told(ranged(4.0, 10.6)) == cut);
  CHECK(told(ranged(4.0, 9.9)) == cut);
  CHECK(told(ranged(3.0, 10.4)) == cut);
  SolvedTrail endless = ranged(0.0, 1e7);
  endless.settings.startFrame = 0.0;
  endless.settings.endFrame = 100000.0;
  CHECK(told(endless) == Lines{"the range is cut to 100000 frames"});
}

TEST_CASE("a camera that is not there is told, and what the scale counts in then") {
  SolvedTrail solved = plainTrail();
  solved.settings.sight.camera = "front";
  CHECK(told(solved) == Lines{"there is no camera 'front' to look through"});
  solved.settings.sight.asSeen = true;
  CHECK(told(solved) ==
        Lines{"there is no camera 'front' to look through: the scale counts in the limb's own length"});
  solved.camera = CameraPlace{};
  CHECK(told(solved).empty());
}

TEST_CASE("a length that is not reached is told with both, unless only spheres pull the limb") {
  SolvedTrail solved = plainTrail();
  solved.tip.reachedLength = 1.25;
  const Lines missed{"not reachable: the limb gets to 1.25 of 2"};
  CHECK(told(solved) == missed);
  solved.tip.reachedLength = 2.0001;
  CHECK(told(solved).empty());
  solved.tip.reachedLength = 1.25;
  solved.settings.scale = 1.0;
  CHECK(told(solved) == missed);
  solved.settings.spheres = {{5.0, Vec3(1.0), {}}};
  CHECK(told(solved).empty());
  solved.settings.scale = 1.1;
  CHECK(told(solved) == missed);
  solved.tip.outcome = TipOutcome::nothingToScale;
  CHECK(told(solved) ==
        Lines{"nothing to scale: the limb's end does not move along the active axes in this range"});
}

TEST_CASE("a path that is moved as a whole is told with the frame at which it would be scaled") {
  const bool forwards = GENERATE(true, false);
  SolvedTrail solved = plainTrail();
  solved.settings.pivot = forwards ? Pivot::start : Pivot::end;
  solved.tip.moved = true;
  solved.tip.farthestSample = 3;
  CHECK(told(solved) ==
        Lines{"the path comes back on itself and is moved as a whole; a range that ends at frame "
              "7, where the limb's end is farthest from the pivot, would be scaled"});
  solved.tip.farthestSample = forwards ? 6 : 0;
  CHECK(
      told(solved) ==
      Lines{
          "the limb's end strays between the frames from where it is on them: its path is moved as a whole"});
  solved.tip.farthestSample = forwards ? 0 : 6;
  CHECK(told(solved)[0].find(forwards ? "frame 4," : "frame 10,") != std::string::npos);
  solved.tip.moved = false;
  CHECK(told(solved).empty());
}

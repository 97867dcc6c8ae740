#include "core/anim/frames.h"

#include <catch2/catch.hpp>

#include "core/anim/key_time.h"
#include "core/anim/track_names.h"
#include "core/math/polyline.h"

using namespace stretch;

TEST_CASE("Frames less than a thousandth apart are one, in ranges and beside whole frames as well") {
  for (const double off : {-0.0009, 0.0, 0.0009}) {
    INFO(off);
    CHECK(sameFrame(12.0, 12.0 + off));
    CHECK(isWithinFrames(4.0, 12.0, 12.0 + off));
    CHECK(isWithinFrames(4.0, 12.0, 4.0 + off));
    CHECK(wholeFrameAtMost(12.0 + off) == 12.0);
    CHECK(wholeFrameAtLeast(12.0 + off) == 12.0);
  }
  CHECK_FALSE(sameFrame(12.0, 12.0011));
  CHECK_FALSE(sameFrame(12.0, 11.9989));
  CHECK_FALSE(isWithinFrames(4.0, 12.0, 12.0011));
  CHECK_FALSE(isWithinFrames(4.0, 12.0, 3.9989));
  CHECK(isWithinFrames(4.0, 12.0, 8.5));
  CHECK(wholeFrameAtMost(11.9989) == 11.0);
  CHECK(wholeFrameAtLeast(12.0011) == 13.0);
}

TEST_CASE("A clip that ends between two frames ends there, and its last frame is the nearer one") {
  Clip clip;
  clip.framesPerSecond = 30.0;
  clip.endSeconds = 0.42;
  CHECK(endInFrames(clip) == Approx(12.6));
  CHECK(lastFrame(clip) == 13.0);
  clip.endSeconds = 0.0;
  CHECK(lastFrame(clip) == 0.0);
  clip.endSeconds = -1.0;
  CHECK(lastFrame(clip) == 0.0);
}

TEST_CASE("Channels and interpolations are found by the names that glTF has for them") {
  CHECK(nameOf(Channel::translation) == std::string("translation"));
  CHECK(nameOf(Interpolation::cubicSpline) == std::string("CUBICSPLINE"));
  for (const Channel channel : {Channel::translation, Channel::rotation, Channel::scale, Channel::weights}) {
    CHECK(channelNamed(nameOf(channel)) == channel);
  }
  for (const Interpolation kind : {Interpolation::step, Interpolation::linear, Interpolation::cubicSpline}) {
    CHECK(interpolationNamed(nameOf(kind)) == kind);
  }
  CHECK_FALSE(channelNamed("morph"));
  CHECK_FALSE(interpolationNamed("linear"));
}

TEST_CASE("A line is as long as its pieces together, and its points lie at the sums of them") {
  const std::vector<Vec3> corner{Vec3(0.0), Vec3(3.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0), Vec3(3.0, 4.0, 0.0)};
  CHECK(polylineLength(corner) == 7.0);
  CHECK(lengthsAlong(corner) == std::vector<double>{0.0, 3.0, 3.0, 7.0});
  CHECK(polylineLength({}) == 0.0);
  CHECK(lengthsAlong({}) == std::vector<double>{0.0});
}

TEST_CASE("Times of keys are of single precision, and a border is met by the next of them on either side") {
  constexpr double aboveTenth = 0.100000001490116119384765625; // the nearest one to 0.1
  CHECK(asKeyTime(0.1) == aboveTenth);
  CHECK(keyTimeAtLeast(0.1) == aboveTenth);
  CHECK(keyTimeAtMost(0.1) == 0.0999999940395355224609375);
  CHECK(keyTimeAtMost(0.7) == 0.699999988079071044921875); // the nearest one to 0.7
  CHECK(keyTimeAtLeast(0.7) == 0.7000000476837158203125);
  CHECK(keyTimeAtMost(-0.1) == -aboveTenth);
  CHECK(keyTimeAtLeast(-0.7) == -0.699999988079071044921875);
  for (const double exact : {-1.5, 0.0, 0.25, 3.0}) {
    CHECK(keyTimeAtMost(exact) == exact);
    CHECK(keyTimeAtLeast(exact) == exact);
  }
}

TEST_CASE("Within the rounding of a time lies the next time of a key, before and after, however late") {
  CHECK(keyTimeRounding(0.0) == 2e-7);
  CHECK(keyTimeRounding(0.5) == 2e-7);
  CHECK(keyTimeRounding(8.0) == Approx(1.6e-6));
  CHECK(keyTimeRounding(-8.0) == Approx(1.6e-6));
  for (const double time : {0.1, 0.7, 9.3, 1234.1}) {
    CHECK(keyTimeAtLeast(time) < time + keyTimeRounding(time));
    CHECK(keyTimeAtMost(time) > time - keyTimeRounding(time));
  }
}

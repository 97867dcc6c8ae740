#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "skinning/elastic/limb_elasticity.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

constexpr double framesPerSecond = 240.0;
constexpr double jerkSeconds = 0.25;
constexpr double seconds = 2.0;

// How long a hanging bone is in each frame whose base is still, and from jerkSeconds on is lifted with one
// gravity.
std::vector<double> lengthsWhenLifted(const LimbElasticity& settings) {
  LimbMotion motion;
  motion.framesPerSecond = framesPerSecond;
  for (int k = 0; k <= static_cast<int>(seconds * framesPerSecond); ++k) {
    const double t = std::max(0.0, k / framesPerSecond - jerkSeconds);
    const Vec3 base(0.0, 0.5 * 9.81 * t * t, 0.0);
    motion.joints.push_back({base, base - Vec3(0.0, 0.3, 0.0)});
  }
  const auto frames = limbElasticity(limbSegments({0.3}, {0.08}), motion, settings);
  REQUIRE(frames);
  std::vector<double> lengths;
  for (const auto& frame : *frames) {
    lengths.push_back(frame[0].factors.along);
  }
  return lengths;
}

// Seconds of the moments at which the bone passes the length that it comes to.
std::vector<double> passings(const std::vector<double>& lengths, double settled) {
  std::vector<double> times;
  for (std::size_t k = 1; k < lengths.size(); ++k) {
    const double before = lengths[k - 1] - settled;
    const double now = lengths[k] - settled;
    if (before * now < 0.0) {
      times.push_back((static_cast<double>(k) - now / (now - before)) / framesPerSecond);
    }
  }
  return times;
}

double hertz(double stiffness) {
  LimbElasticity loose;
  loose.stiffness = stiffness;
  loose.damping = 0.05;
  const std::vector<double> lengths = lengthsWhenLifted(loose);
  // Twice the weight at rest, less the last frames, where the path ends.
  const double settled = 1.0 + 2.0 * (lengths.front() - 1.0);
  const std::vector<double> times = passings(lengths, settled);
  REQUIRE(times.size() > 4);
  return 2.0 / (times[4] - times[0]);
}

// How far past the length that it comes to the bone swings, in parts of the way there.
double overshoot(double damping) {
  LimbElasticity settings;
  settings.damping = damping;
  const std::vector<double> lengths = lengthsWhenLifted(settings);
  const double way = lengths.front() - 1.0;
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  return (longest - 1.0 - 2.0 * way) / way;
}

} // namespace

TEST_CASE("a limb swings six times a second, and twice as fast when it is four times as stiff") {
  CHECK(hertz(1.0) == Approx(6.0).epsilon(0.05));
  CHECK(hertz(4.0) == Approx(12.0).epsilon(0.05));
}

TEST_CASE("damping decides how far a limb swings over: fully damped, not at all") {
  CHECK(overshoot(1.0) < 0.01);
  // The lift starts as gently as its smoothed acceleration, which takes the edge off the swing.
  CHECK(overshoot(0.4) > 0.05);
  CHECK(overshoot(0.1) > 2.0 * overshoot(0.4));
}

TEST_CASE("a limb gives way as much at whatever frame rate its motion is given") {
  // A swing that is caught within a sixth of a second.
  const auto longest = [](double rate) {
    LimbMotion motion;
    motion.framesPerSecond = rate;
    for (int k = 0; k <= static_cast<int>(std::lround(rate)); ++k) {
      const double t = std::clamp((k / rate - 0.5) * 6.0, 0.0, 1.0);
      const Vec3 base(0.0, 0.3 * t * t * (3.0 - 2.0 * t), 0.0);
      motion.joints.push_back({base, base - Vec3(0.0, 0.3, 0.0)});
    }
    const auto frames = limbElasticity(limbSegments({0.3}, {0.08}), motion, {});
    REQUIRE(frames);
    double most = 1.0;
    for (const auto& frame : *frames) {
      most = std::max(most, frame[0].factors.along);
    }
    return most;
  };
  const double wanted = longest(240.0);
  REQUIRE(wanted > 1.01);
  for (const double rate : {48.0, 60.0, 96.0}) {
    CAPTURE(rate);
    CHECK(longest(rate) - 1.0 == Approx(wanted - 1.0).epsilon(0.03));
  }
}

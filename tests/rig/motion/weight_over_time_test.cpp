#include <catch2/catch.hpp>

#include "rig/reach/limb_weight.h"

using namespace stretch;
using namespace stretch::rig;

namespace {

WeightSample sampleAt(double seconds, double strain, double planted, double kept) {
  return {seconds, {Mat3(strain), Mat3(2.0 * strain)}, planted, kept};
}

LimbWeight backwardsInTime(const LimbWeight& weight) {
  LimbWeight turned = weight;
  turned.samples.assign(weight.samples.rbegin(), weight.samples.rend());
  for (WeightSample& sample : turned.samples) {
    sample.timeSeconds = -sample.timeSeconds;
  }
  turned.startSeconds = -weight.endSeconds;
  turned.endSeconds = -weight.startSeconds;
  turned.fadeInSeconds = weight.fadeOutSeconds;
  turned.fadeOutSeconds = weight.fadeInSeconds;
  return turned;
}

double strainOf(const WeightSample& sample) {
  return sample.strains.empty() ? 0.0 : sample.strains.front()[0][0];
}

} // namespace

TEST_CASE("weight is straight between its samples in all that it says, and held beside them") {
  const LimbWeight weight{
      "left-leg", {sampleAt(1.0, 0.1, 0.2, 0.4), sampleAt(2.0, 0.5, 1.0, 0.8)}, 0.0, 3.0, 0.0, 0.0};
  const auto [seconds, share] = GENERATE(table<double, double>(
      {{0.5, 0.0}, {1.0, 0.0}, {1.25, 0.25}, {1.5, 0.5}, {1.875, 0.875}, {2.0, 1.0}, {2.5, 1.0}}));
  CAPTURE(seconds);
  const WeightSample there = weightAt(weight, seconds);
  CHECK(there.timeSeconds == Approx(seconds));
  REQUIRE(there.strains.size() == 2);
  CHECK(there.strains[0][0][0] == Approx(0.1 + 0.4 * share));
  CHECK(there.strains[1][2][2] == Approx(0.2 + 0.8 * share));
  CHECK(there.planted == Approx(0.2 + 0.8 * share));
  CHECK(there.kept == Approx(0.4 + 0.4 * share));
}

TEST_CASE("weight fades in and out inside its range, each over its own time, and backwards the same way") {
  const LimbWeight weight{
      "left-leg", {sampleAt(0.0, 1.0, 1.0, 1.0), sampleAt(4.0, 1.0, 1.0, 1.0)}, 1.0, 3.0, 0.5, 1.0};
  const auto [seconds, share] = GENERATE(table<double, double>({{0.5, 0.0},
                                                                {1.0, 0.0},
                                                                {1.125, 0.15625},
                                                                {1.25, 0.5},
                                                                {1.375, 0.84375},
                                                                {1.5, 1.0},
                                                                {2.0, 1.0},
                                                                {2.25, 0.84375},
                                                                {2.5, 0.5},
                                                                {2.75, 0.15625},
                                                                {3.0, 0.0},
                                                                {3.5, 0.0}}));
  CAPTURE(seconds);
  CHECK(strainOf(weightAt(weight, seconds)) == Approx(share).margin(1e-12));
  CHECK(strainOf(weightAt(backwardsInTime(weight), -seconds)) == Approx(share).margin(1e-12));
}

TEST_CASE("a leg without samples of its own keeps its foot and carries nothing") {
  const WeightSample still = weightAt({"left-leg", {}, 0.0, 1.0, 0.0, 0.0}, 0.5);
  CHECK(still.strains.empty());
  CHECK(still.planted == Approx(0.0).margin(1e-12));
  CHECK(still.kept == Approx(1.0));
}

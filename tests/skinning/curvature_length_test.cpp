#include <catch2/catch.hpp>

#include <cmath>

#include "skinning/elastic/curvature_length.h"

using namespace stretch::skinning;

namespace {

std::vector<CurvatureLength> along(double slope, double intercept, int count) {
  std::vector<CurvatureLength> frames;
  for (int i = 0; i < count; ++i) {
    const double curvature = 0.1 * ((7 * i) % count);
    frames.push_back({curvature, slope * curvature + intercept});
  }
  return frames;
}

} // namespace

TEST_CASE("a line is found again with R^2 1") {
  const LineFit fit = fitLine(along(-10.191, 306.03, 50));
  CHECK(fit.slope == Approx(-10.191));
  CHECK(fit.intercept == Approx(306.03));
  CHECK(fit.rSquared == Approx(1.0));
}

TEST_CASE("R^2 is the share of the variance that the line explains") {
  const LineFit fit = fitLine({{0.0, 1.0}, {1.0, 3.0}, {2.0, 2.0}});
  CHECK(fit.slope == Approx(0.5));
  CHECK(fit.intercept == Approx(1.5));
  CHECK(fit.rSquared == Approx(0.25));
}

TEST_CASE("frames of one curvature or one length have no slope to fit") {
  CHECK(fitLine({{2.0, 5.0}, {2.0, 7.0}}).slope == 0.0);
  CHECK(fitLine({{2.0, 5.0}, {2.0, 7.0}}).intercept == Approx(6.0));
  CHECK(fitLine({{1.0, 5.0}, {2.0, 5.0}}).rSquared == 0.0);
  CHECK(fitLine({}).intercept == 0.0);
}

TEST_CASE("a length that saturates is followed by the monotone curve, not by the line") {
  std::vector<CurvatureLength> frames;
  for (int i = 0; i <= 60; ++i) {
    const double curvature = 0.1 * i;
    frames.push_back({curvature, std::max(280.0, 320.0 - 15.0 * curvature)});
  }
  const LengthFunction line = fitLength(frames, LengthModel::line);
  const LengthFunction curve = fitLength(frames, LengthModel::monotone);
  CHECK(curve.monotone.rSquared > 0.999);
  CHECK(line.line.rSquared < 0.9);
  CHECK(curve.at(1.0) == Approx(305.0).margin(0.5));
  CHECK(curve.at(5.0) == Approx(280.0).margin(0.1));
  CHECK(curve.at(100.0) == Approx(280.0));
  CHECK(fitLength(frames).model == LengthModel::monotone);
}

TEST_CASE(
    "without a wish the line is taken wherever it explains about as much as the curve, or frames are few") {
  std::vector<CurvatureLength> frames;
  frames.reserve(40);
  for (int i = 0; i < 40; ++i) {
    frames.push_back({0.1 * i, 300.0 - i + 2.0 * std::sin(7.0 * i)});
  }
  CHECK(fitLength(frames).model == LengthModel::line);
  CHECK(fitLength({{0.0, 10.0}, {1.0, 9.9}, {2.0, 9.8}, {3.0, 5.0}, {4.0, 4.9}}).model == LengthModel::line);
}

TEST_CASE("the monotone curve never rises, and pools what would") {
  const MonotoneFit fit = fitMonotone({{0.0, 10.0}, {1.0, 6.0}, {2.0, 8.0}, {3.0, 1.0}});
  REQUIRE(fit.lengths.size() == 3);
  CHECK(fit.lengths[1] == Approx(7.0));
  CHECK(fit.curvatures[1] == Approx(1.5));
  CHECK(fit.at(-1.0) == 10.0);
  CHECK(fit.at(1.5) == Approx(7.0));
  CHECK(fit.at(0.75) == Approx(8.5));
}

TEST_CASE("too few frames, or a curvature that explains nothing, fall back to the mean length and say so") {
  const LengthFunction few = fitLength({{0.0, 10.0}, {1.0, 8.0}});
  CHECK(few.model == LengthModel::measuredMean);
  CHECK(few.at(5.0) == Approx(9.0));
  CHECK(few.remark.find("frames") != std::string::npos);
  const LengthFunction noise = fitLength({{0.0, 1.0}, {1.0, 3.0}, {2.0, 1.0}, {3.0, 3.0}, {4.0, 1.0}});
  CHECK(noise.model == LengthModel::measuredMean);
  CHECK(noise.remark.find("R^2") != std::string::npos);
}

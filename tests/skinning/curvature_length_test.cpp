#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

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

namespace {

std::vector<CurvatureLength> wobbling(std::size_t count) {
  std::vector<CurvatureLength> frames;
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<double>(i);
    frames.push_back({std::abs(3.0 * std::sin(1.7 * t)),
                      100.0 - 4.0 * std::abs(3.0 * std::sin(1.7 * t)) + 3.0 * std::cos(5.1 * t)});
  }
  return frames;
}

double squaresOff(const std::vector<CurvatureLength>& frames, double slope, double intercept) {
  double sum = 0.0;
  for (const CurvatureLength& frame : frames) {
    const double off = frame.length - slope * frame.curvatureRadians - intercept;
    sum += off * off;
  }
  return sum;
}

} // namespace

TEST_CASE("no other line is nearer to the frames, and R^2 is what it leaves of their variance") {
  const std::vector<CurvatureLength> frames = wobbling(23);
  const LineFit fit = fitLine(frames);
  const double least = squaresOff(frames, fit.slope, fit.intercept);
  for (const double step : {-0.01, 0.01}) {
    CHECK(squaresOff(frames, fit.slope + step, fit.intercept) > least);
    CHECK(squaresOff(frames, fit.slope, fit.intercept + step) > least);
  }
  double mean = 0.0;
  for (const CurvatureLength& frame : frames) {
    mean += frame.length / 23.0;
  }
  CHECK(fit.rSquared == Approx(1.0 - least / squaresOff(frames, 0.0, mean)));
  CHECK(fitLength(frames).meanLength == Approx(mean));
}

TEST_CASE("the order of the frames changes neither fit") {
  std::vector<CurvatureLength> frames = wobbling(17);
  const MonotoneFit monotone = fitMonotone(frames);
  const LineFit line = fitLine(frames);
  std::ranges::reverse(frames);
  CHECK(fitMonotone(frames).curvatures == monotone.curvatures);
  CHECK(fitLine(frames).slope == Approx(line.slope));
  std::rotate(frames.begin(), frames.begin() + 5, frames.end());
  CHECK(fitMonotone(frames).rSquared == Approx(monotone.rSquared));
  CHECK(std::ranges::is_sorted(monotone.curvatures));
  CHECK(std::ranges::is_sorted(monotone.lengths, std::greater<>()));
}

TEST_CASE("knots of the monotone curve are the means of the frames that are pooled, of every one of them") {
  // One block of three at the start, one of two at the end, and frames of one curvature in one block.
  const MonotoneFit fit =
      fitMonotone({{0.0, 8.0}, {1.0, 9.0}, {2.0, 13.0}, {3.0, 6.0}, {3.0, 4.0}, {4.0, 1.0}, {6.0, 2.0}});
  CHECK(fit.curvatures == std::vector<double>{1.0, 3.0, 5.0});
  CHECK(fit.lengths == std::vector<double>{10.0, 5.0, 1.5});
  CHECK(fit.at(0.0) == 10.0);
  CHECK(fit.at(2.0) == Approx(7.5));
  CHECK(fit.at(4.5) == Approx(2.375));
  CHECK(fit.at(5.5) == 1.5);
  CHECK(fitMonotone({}).at(1.0) == 0.0);
  // What it leaves: 4 + 1 + 9 + 0.5 of the first, 1 + 1 of the second at their curvatures.
  const double mean = 43.0 / 7.0;
  double total = 0.0, off = 0.0;
  for (const auto& [curvature, length] :
       {std::pair(0.0, 8.0), {1.0, 9.0}, {2.0, 13.0}, {3.0, 6.0}, {3.0, 4.0}, {4.0, 1.0}, {6.0, 2.0}}) {
    total += (length - mean) * (length - mean);
    off += (length - fit.at(curvature)) * (length - fit.at(curvature));
  }
  CHECK(fit.rSquared == Approx(1.0 - off / total));
}

TEST_CASE("four frames are enough for a line and twelve for a curve, three and eleven are not") {
  const auto straight = [](std::size_t count) {
    std::vector<CurvatureLength> frames;
    for (std::size_t i = 0; i < count; ++i) {
      frames.push_back({static_cast<double>(i), 10.0 - static_cast<double>(i)});
    }
    return frames;
  };
  CHECK(fitLength(straight(4)).model == LengthModel::line);
  CHECK(fitLength(straight(4)).remark.empty());
  CHECK(fitLength(straight(3)).model == LengthModel::measuredMean);
  CHECK(fitLength(straight(3)).remark.starts_with("only 3 frames"));
  const auto stepping = [](std::size_t count) { // A line explains much less of it.
    std::vector<CurvatureLength> frames;
    for (std::size_t i = 0; i < count; ++i) {
      frames.push_back({static_cast<double>(i), i < count / 2 ? 10.0 : 4.0});
    }
    return frames;
  };
  CHECK(fitLength(stepping(12)).model == LengthModel::monotone);
  CHECK(fitLength(stepping(11)).model == LengthModel::line);
  CHECK(fitLength(stepping(11), LengthModel::monotone).model == LengthModel::monotone);
  CHECK(fitLength(stepping(12), LengthModel::line).model == LengthModel::line);
  const LengthFunction mean = fitLength(stepping(12), LengthModel::measuredMean);
  CHECK(mean.model == LengthModel::measuredMean);
  CHECK(mean.remark.empty());
  CHECK(mean.at(0.0) == Approx(7.0));
  CHECK(mean.frameCount == 12);
}

TEST_CASE("a curve has to explain three tenths of the variance by itself, whatever the line explains") {
  // Lengths that rise with curvature: a line explains all, a curve that never rises nothing.
  std::vector<CurvatureLength> rising;
  rising.reserve(12);
  for (int i = 0; i < 12; ++i) {
    rising.push_back({0.5 * i, 10.0 + i});
  }
  CHECK(fitLength(rising, LengthModel::line).model == LengthModel::line);
  CHECK(fitLength(rising, LengthModel::monotone).model == LengthModel::measuredMean);
  CHECK(fitLength(rising).model == LengthModel::line);
}

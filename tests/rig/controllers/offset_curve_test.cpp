#include "rig/controllers/offset_curve.h"

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::rig;

namespace {

OffsetKey keyAt(double frame, double value, KeyInterpolation interpolation = KeyInterpolation::automatic) {
  OffsetKey key;
  key.frame = frame;
  key.value = value;
  key.interpolation = interpolation;
  return key;
}

double valueAt(const OffsetCurve& curve, double frame) {
  return curve.at(frame / 24.0).value;
}

} // namespace

TEST_CASE("an offset curve goes through its keys and never beyond them") {
  const OffsetCurve curve({"a", 0, {}, {keyAt(0, 0), keyAt(6, 1), keyAt(7, 1), keyAt(20, -2)}}, 0.0, 24.0);
  CHECK(valueAt(curve, 6) == 1.0);
  CHECK(valueAt(curve, 20) == -2.0);
  for (double frame = 0.0; frame <= 20.0; frame += 0.25) {
    CHECK(valueAt(curve, frame) <= 1.0);
    CHECK(valueAt(curve, frame) >= -2.0);
  }
  CHECK(valueAt(curve, -5) == 0.0);
  CHECK(valueAt(curve, 100) == -2.0);
}

TEST_CASE("inside a range the offset begins and ends at nothing, and an attribute at its standard value") {
  const OffsetCurve curve({"a", 0, Vec2(4, 20), {keyAt(12, 0.2)}}, 0.7, 24.0);
  CHECK(valueAt(curve, 4) == 0.7);
  CHECK(valueAt(curve, 12) == 0.2);
  CHECK(valueAt(curve, 20) == 0.7);
  CHECK(valueAt(curve, 2) == 0.7);
  CHECK(!curve.jumpsAtStart());
  const OffsetCurve standing({"a", 0, Vec2(4, 20), {keyAt(4, 0.2)}}, 0.7, 24.0);
  CHECK(valueAt(standing, 4) == 0.2);
  CHECK(valueAt(standing, 3.9) == 0.7);
  CHECK(standing.jumpsAtStart());
}

TEST_CASE("keys are passed as their interpolation says") {
  const auto between = [](KeyInterpolation interpolation) {
    return OffsetCurve({"a", 0, {}, {keyAt(0, 0, interpolation), keyAt(10, 1, interpolation)}}, 0.0, 24.0);
  };
  CHECK(valueAt(between(KeyInterpolation::linear), 2.5) == Approx(0.25));
  CHECK(valueAt(between(KeyInterpolation::flat), 2.5) == Approx(0.15625));
  CHECK(valueAt(between(KeyInterpolation::stepped), 9.99) == 0.0);
  CHECK(valueAt(between(KeyInterpolation::stepped), 10) == 1.0);
  OffsetKey steep = keyAt(0, 0, KeyInterpolation::free);
  steep.valueSlope = 0.5; // for each frame
  const OffsetCurve free({"a", 0, {}, {steep, keyAt(10, 0)}}, 0.0, 24.0);
  CHECK(valueAt(free, 0.01) == Approx(0.005).epsilon(0.01));
  CHECK(valueAt(free, 3) > 0.5);
}

namespace {

constexpr std::size_t numbersOfKey = 7; // Move and turn along three axes, and value.

double& numberAt(OffsetKey& key, std::size_t which) {
  const auto axis = static_cast<Vec3::length_type>(which % 3);
  return which < 3 ? key.move[axis] : which < 6 ? key.turn[axis] : key.value;
}

double& keySlope(OffsetKey& key, std::size_t which) {
  const auto axis = static_cast<Vec3::length_type>(which % 3);
  return which < 3 ? key.moveSlope[axis] : which < 6 ? key.turnSlope[axis] : key.valueSlope;
}

double numberAt(const Offset& offset, std::size_t which) {
  const auto axis = static_cast<Vec3::length_type>(which % 3);
  return which < 3 ? offset.move[axis] : which < 6 ? offset.turn[axis] : offset.value;
}

/// Frame, number, slope for each frame.
struct KeyNumbers {
  double frame = 0.0;
  double number = 0.0;
  double slope = 0.0;
  KeyInterpolation interpolation = KeyInterpolation::automatic;
};

Adjustment adjustmentWith(const std::vector<KeyNumbers>& keys, std::size_t which = 6) {
  Adjustment adjustment{"a", 0, {}, {}};
  for (const KeyNumbers& one : keys) {
    OffsetKey key;
    key.frame = one.frame;
    key.interpolation = one.interpolation;
    numberAt(key, which) = one.number;
    keySlope(key, which) = one.slope;
    adjustment.keys.push_back(key);
  }
  return adjustment;
}

/// Slopes for each frame on both sides of a frame, by small steps.
std::pair<double, double> slopesAt(const OffsetCurve& curve, double frame) {
  const double step = 1e-4;
  const double here = valueAt(curve, frame);
  return {(here - valueAt(curve, frame - step)) / step, (valueAt(curve, frame + step) - here) / step};
}

constexpr KeyInterpolation freely = KeyInterpolation::free;
constexpr KeyInterpolation linearly = KeyInterpolation::linear;
constexpr KeyInterpolation flatly = KeyInterpolation::flat;
constexpr KeyInterpolation smoothly = KeyInterpolation::automatic;
constexpr KeyInterpolation inSteps = KeyInterpolation::stepped;

} // namespace

TEST_CASE("moves and turns along each axis pass the same curve as values, and leave the other ones alone") {
  const std::vector<KeyNumbers> keys{{2, 0.5, 0.3, freely},    {5, -1.0, -0.2, smoothly},
                                     {9, -1.5, 0.1, linearly}, {12, 2.0, 0.7, inSteps},
                                     {13, 1.0, -0.4, freely},  {20, 0.2, 0.5, flatly}};
  const OffsetCurve values(adjustmentWith(keys), 0.0, 24.0);
  for (std::size_t which = 0; which < numbersOfKey; ++which) {
    const OffsetCurve curve(adjustmentWith(keys, which), 0.0, 24.0);
    for (double frame = 0.0; frame <= 22.0; frame += 0.25) {
      const Offset offset = curve.at(frame / 24.0);
      CAPTURE(which, frame);
      CHECK(numberAt(offset, which) == valueAt(values, frame));
      for (std::size_t other = 0; other < numbersOfKey; ++other) {
        CHECK((other == which || numberAt(offset, other) == 0.0));
      }
    }
  }
}

TEST_CASE("between two free keys stands the one cubic that has their numbers and slopes") {
  const double rate = GENERATE(24.0, 30.0, 120.0);
  const double from = 0.4, to = -0.9, out = 0.35, in = -0.6, first = 3.0, last = 11.0;
  const OffsetCurve curve(adjustmentWith({{first, from, out, freely}, {last, to, in, freely}}), 0.0, rate);
  const double length = last - first;
  const double cube = (2.0 * (from - to) / length + out + in) / (length * length);
  const double square = (3.0 * (to - from) / length - 2.0 * out - in) / length;
  for (double frame = first; frame <= last; frame += 0.5) {
    const double x = frame - first;
    CHECK(curve.at(frame / rate).value == Approx(((cube * x + square) * x + out) * x + from).margin(1e-12));
  }
}

TEST_CASE("a key of each kind is come to and left as it says, at both ends of the keys too") {
  const auto around = [](KeyInterpolation interpolation, double number) {
    const OffsetCurve curve(
        adjustmentWith({{0, 0.0, 0.0, flatly}, {4, number, 0.25, interpolation}, {12, 2.0, 0.0, flatly}}),
        0.0, 24.0);
    return slopesAt(curve, 4.0);
  };
  const auto isNear = [](const std::pair<double, double>& slopes, double in, double out) {
    return std::abs(slopes.first - in) < 1e-3 && std::abs(slopes.second - out) < 1e-3;
  };
  CHECK(isNear(around(linearly, 1.0), 0.25, 0.125));
  CHECK(isNear(around(flatly, 1.0), 0.0, 0.0));
  CHECK(isNear(around(freely, 1.0), 0.25, 0.25));
  CHECK(isNear(around(smoothly, 3.0), 0.0, 0.0)); // A highest place is passed level.
  const auto [in, out] = around(smoothly, 1.0);
  CHECK(in == Approx(out).epsilon(1e-2));
  CHECK(in == Approx(36.0 / 208.0).epsilon(1e-2)); // The harmonic mean of a quarter and an eighth, 20 to 16.
  // The first and the last key have one neighbour alone.
  const OffsetCurve lines(adjustmentWith({{2, 1.0, 0.0, linearly}, {6, 3.0, 0.0, linearly}}), 0.0, 24.0);
  CHECK(isNear(slopesAt(lines, 2.0), 0.0, 0.5));
  CHECK(isNear(slopesAt(lines, 6.0), 0.5, 0.0));
  const OffsetCurve curves(adjustmentWith({{2, 1.0}, {6, 3.0}}), 0.0, 24.0);
  CHECK(isNear(slopesAt(curves, 2.0), 0.0, 0.0));
  CHECK(isNear(slopesAt(curves, 6.0), 0.0, 0.0));
}

TEST_CASE("a stepped key holds until the next one, however that one is come to") {
  const KeyInterpolation next = GENERATE(freely, linearly, flatly, smoothly, inSteps);
  const OffsetCurve curve(
      adjustmentWith({{2, 1.0, 0.0, inSteps}, {6, 3.0, 0.5, next}, {8, 3.0, 0.0, flatly}}), 0.0, 24.0);
  for (const double frame : {2.0, 3.0, 5.99}) {
    CHECK(valueAt(curve, frame) == 1.0);
  }
  CHECK(valueAt(curve, 6.0) == 3.0);
}

TEST_CASE("a stepped key counts from its frame on, at the time that a file has for it as well") {
  for (double frame = 1.0; frame < 24.0; frame += 1.0) {
    const OffsetCurve curve(adjustmentWith({{0, 1.0, 0.0, inSteps}, {frame, 3.0, 0.0, inSteps}}), 0.0, 24.0);
    CAPTURE(frame);
    CHECK(curve.at(static_cast<double>(static_cast<float>(frame / 24.0))).value == 3.0);
  }
}

TEST_CASE("a curve jumps at the key after a stepped one of another value, in whatever number that is") {
  const auto seconds = [](const std::vector<KeyNumbers>& keys, std::size_t which) {
    return OffsetCurve(adjustmentWith(keys, which), 0.0, 24.0).jumpSeconds();
  };
  for (std::size_t which = 0; which < numbersOfKey; ++which) {
    CHECK(seconds({{0, 1.0, 0.0, inSteps}, {6, 2.0}, {12, 5.0, 0.0, inSteps}, {18, 5.0}, {24, 0.0}}, which) ==
          std::vector<double>{6.0 / 24.0});
    CHECK(seconds({{0, 1.0}, {6, 2.0, 0.0, inSteps}, {12, 1.0, 0.0, inSteps}, {18, 0.0, 0.0, inSteps}},
                  which) == std::vector<double>{0.5, 0.75});
    CHECK(seconds({{0, 1.0}, {6, 2.0}}, which).empty());
  }
}

TEST_CASE("a curve jumps at an end of its range where a key with another than the standard value is there") {
  const auto curveOf = [](double frame, double number, std::size_t which) {
    Adjustment adjustment = adjustmentWith({{frame, number}}, which);
    adjustment.rangeFrames = Vec2(4, 20);
    return OffsetCurve(adjustment, which == 6 ? 0.7 : 0.0, 24.0);
  };
  for (std::size_t which = 0; which < numbersOfKey; ++which) {
    CHECK(curveOf(4, 0.2, which).jumpsAtStart());
    CHECK_FALSE(curveOf(4, 0.2, which).jumpsAtEnd());
    CHECK(curveOf(20, 0.2, which).jumpsAtEnd());
    CHECK_FALSE(curveOf(20, 0.2, which).jumpsAtStart());
    CHECK_FALSE(curveOf(12, 0.2, which).jumpsAtStart());
    CHECK_FALSE(curveOf(12, 0.2, which).jumpsAtEnd());
  }
  CHECK_FALSE(curveOf(4, 0.7, 6).jumpsAtStart());
  CHECK_FALSE(curveOf(20, 0.7, 6).jumpsAtEnd());
  const OffsetCurve endless(adjustmentWith({{4, 0.2}, {20, 0.3}}), 0.0, 24.0); // Without a range it is held
                                                                               // instead.
  CHECK_FALSE(endless.jumpsAtStart());
  CHECK_FALSE(endless.jumpsAtEnd());
}

TEST_CASE("a range covers its ends, and stands in for keys there that are not") {
  Adjustment adjustment = adjustmentWith({{12, 0.4}});
  adjustment.rangeFrames = Vec2(4, 20);
  const OffsetCurve curve(adjustment, 0.0, 24.0);
  CHECK(curve.startSeconds() == 4.0 / 24.0);
  CHECK(curve.endSeconds() == 20.0 / 24.0);
  CHECK(curve.keySeconds() == std::vector<double>{4.0 / 24.0, 0.5, 20.0 / 24.0});
  CHECK(curve.covers(4.0 / 24.0));
  CHECK(curve.covers(20.0 / 24.0));
  CHECK(curve.covers(static_cast<float>(20.0 / 24.0))); // As a file has it.
  CHECK(curve.covers(static_cast<float>(4.0 / 24.0)));
  CHECK_FALSE(curve.covers(3.99 / 24.0));
  CHECK_FALSE(curve.covers(20.01 / 24.0));
  adjustment = adjustmentWith({{4, 0.1}, {20, 0.4}});
  adjustment.rangeFrames = Vec2(4, 20);
  CHECK(OffsetCurve(adjustment, 0.0, 24.0).keySeconds() == std::vector<double>{4.0 / 24.0, 20.0 / 24.0});
  const OffsetCurve endless(adjustmentWith({{4, 0.2}}), 0.0, 24.0);
  CHECK(endless.covers(-100.0));
  CHECK(endless.covers(100.0));
  CHECK(endless.keySeconds() == std::vector<double>{4.0 / 24.0});
}

TEST_CASE("a curve without keys covers nothing and has the standard value") {
  Adjustment adjustment{"a", 0, {}, {}};
  const OffsetCurve curve(adjustment, 0.6, 24.0);
  CHECK_FALSE(curve.covers(0.0));
  CHECK(valueAt(curve, 3.0) == 0.6);
  CHECK(curve.at(0.0).move == Vec3(0.0));
  CHECK(curve.keySeconds().empty());
  CHECK(curve.jumpSeconds().empty());
  CHECK_FALSE(curve.jumpsAtStart());
  CHECK_FALSE(curve.jumpsAtEnd());
}

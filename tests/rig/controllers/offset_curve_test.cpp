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

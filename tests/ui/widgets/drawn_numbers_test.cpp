// Numbers of widgets for drawn input, against plain ways of counting them: axes, curves, transitions, typed
// sums.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/support/row.h"
#include "ui/widgets/arithmetic.h"
#include "ui/widgets/axis.h"
#include "ui/widgets/curve_view.h"
#include "ui/widgets/remap_editor.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

Axis drawnAxis(test::Row& row) {
  const double start = row.around(500.0) + 1.234567e-7; // on no mark
  const double width = std::pow(10.0, row.between(-3.0, 4.0));
  const bool isUpright = row.once(2);
  const auto pixel = static_cast<float>(row.between(0.0, 300.0));
  const auto length = static_cast<float>(row.between(20.0, 1500.0));
  return {start, start + width, isUpright ? pixel + length : pixel, isUpright ? pixel : pixel + length};
}

/// The smallest of 1, 2, 5, 10, 20, 50 ... that is at least so large.
double roundStep(double least) {
  for (int power = -9; power < 12; ++power) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double step = factor * std::pow(10.0, power);
      if (step >= least * (1.0 - 1e-12)) {
        return step;
      }
    }
  }
  return 0.0;
}

std::vector<Curve> drawnCurves(test::Row& row) {
  std::vector<Curve> curves(row.below(4));
  for (Curve& curve : curves) {
    curve.hidden = row.once(3);
    for (std::vector<Vec2>* const points : {&curve.points, &curve.before, &curve.source}) {
      for (std::uint32_t i = row.once(2) ? 0 : row.below(6); i > 0; --i) {
        points->emplace_back(static_cast<double>(points->size()), row.around(9.0));
      }
    }
    for (std::uint32_t i = row.below(5); i > 0; --i) {
      curve.keys.push_back(
          {Vec2(row.around(50.0), row.around(9.0)), Vec2(0.0), static_cast<int>(i), row.once(2)});
    }
  }
  return curves;
}

/// A sum as text with its value; brackets, signs and all four kinds.
std::pair<std::string, double> drawnSum(test::Row& row, int depth) {
  if (depth == 0 || row.once(3)) {
    const double number = 0.25 * (1 + row.below(40));
    return {fmt::format("{}", number), number};
  }
  const auto [left, a] = drawnSum(row, depth - 1);
  const auto [right, b] = drawnSum(row, depth - 1);
  switch (row.below(5)) {
  case 0:
    return {fmt::format("({}+{})", left, right), a + b};
  case 1:
    return {fmt::format("({}-{})", left, right), a - b};
  case 2:
    return {fmt::format("({})*({})", left, right), a * b};
  case 3:
    return b == 0.0 ? std::pair(left, a) : std::pair(fmt::format("(({})/({}))", left, right), a / b);
  default:
    return {fmt::format("-({})", left), -a};
  }
}

} // namespace

TEST_CASE("Marks of drawn axes are round, as near as they may be, and none within is left out",
          "[drawn-numbers]") {
  test::Row row(3);
  for (int i = 0; i < 400; ++i) {
    const Axis axis = drawnAxis(row);
    const auto pixels = static_cast<float>(row.between(5.0, 120.0));
    const double perPixel =
        std::abs((axis.end - axis.start) / static_cast<double>(axis.pixelEnd - axis.pixelStart));
    CAPTURE(axis.start, axis.end, axis.pixelStart, axis.pixelEnd, pixels);
    CHECK(axis.valuesPerPixel() == Approx(perPixel));
    const double step = markStep(axis, pixels, false);
    CHECK(step == Approx(roundStep(perPixel * static_cast<double>(pixels))));
    CHECK(markStep(axis, pixels, true) == Approx(std::max(1.0, std::round(step))));
    std::vector<double> wanted;
    for (double k = std::floor(axis.start / step) - 1.0; k * step <= axis.end + step * 1e-9; k += 1.0) {
      if (k * step >= axis.start - step * 1e-9) {
        wanted.push_back(k * step);
      }
    }
    const std::vector<double> found = marks(axis, step);
    const std::vector<double> turned = marks({axis.end, axis.start, axis.pixelStart, axis.pixelEnd}, step);
    REQUIRE(found.size() == std::min<std::size_t>(wanted.size(), 500));
    for (std::size_t k = 0; k < found.size(); ++k) {
      CHECK(found[k] == Approx(wanted[k]).margin(1e-9 * step));
      CHECK(turned[k] == found[k]);
    }
    const double value = axis.start + row.between(0.0, 1.0) * (axis.end - axis.start);
    CHECK(axis.toValue(axis.toPixel(value)) == Approx(value).margin(1e-4 * (axis.end - axis.start)));
    CHECK(axis.toPixel(axis.start) == Approx(axis.pixelStart));
    CHECK(axis.toPixel(axis.end) == Approx(axis.pixelEnd));
  }
  CHECK(marks({0.0, 1e4, 0.0F, 10.0F}, 1.0).size() == 500);
  CHECK(Axis{0.0, 3.0, 5.0F, 5.5F}.valuesPerPixel() == 3.0); // less than a pixel wide
}

TEST_CASE("A drawn zoom keeps its place, and is as wide as asked for within its bounds", "[drawn-numbers]") {
  test::Row row(4);
  for (int i = 0; i < 200; ++i) {
    const double start = row.around(50.0);
    const double width = row.between(0.5, 200.0);
    const double part = row.between(-0.5, 1.5);
    const double factor = row.between(0.05, 8.0);
    const double smallest = row.between(0.1, 20.0);
    const double largest = smallest + row.between(1.0, 500.0);
    const Span span = zoomed({start, start + width}, start + part * width, factor, smallest, largest);
    CHECK(span.end - span.start == Approx(std::max(smallest, std::min(largest, width * factor))));
    CHECK(span.start + part * (span.end - span.start) == Approx(start + part * width).margin(1e-9));
  }
}

TEST_CASE("Drawn curves are fitted by all of their shown points, and picks by their keys",
          "[drawn-numbers]") {
  test::Row row(5);
  for (int i = 0; i < 300; ++i) {
    std::vector<Curve> curves = drawnCurves(row);
    std::vector<double> values;
    std::vector<Vec2> picked;
    for (const Curve& curve : curves) {
      for (const std::vector<Vec2>* const points : {&curve.points, &curve.before, &curve.source}) {
        for (const Vec2& point : *points) {
          if (!curve.hidden) {
            values.push_back(point.y);
          }
        }
      }
      for (const CurveKey& key : curve.keys) {
        if (key.picked) {
          picked.push_back(key.at);
        }
      }
    }
    const Span fit = fittedValues(curves);
    if (values.empty()) {
      CHECK((fit.start == -1.0 && fit.end == 1.0));
    } else {
      const auto [low, high] = std::ranges::minmax(values);
      const double margin = low == high ? 0.1 * std::max(1.0, std::abs(high)) : 0.12 * (high - low);
      CHECK(fit.start == Approx(low - margin));
      CHECK(fit.end == Approx(high + margin));
    }
    const std::optional<CurveFit> picks = fittedPicks(curves);
    REQUIRE(picks.has_value() == !picked.empty());
    if (picks) {
      const auto byFrame = std::ranges::minmax(picked, {}, &Vec2::x);
      const auto byValue = std::ranges::minmax(picked, {}, &Vec2::y);
      const double frames = byFrame.max.x - byFrame.min.x;
      const double aside = std::max(2.0, 0.15 * frames);
      const double above =
          std::max({0.2 * (byValue.max.y - byValue.min.y), 0.01 * std::abs(byValue.max.y), 0.001});
      CHECK(picks->frames.start == Approx(byFrame.min.x - aside));
      CHECK(picks->frames.end == Approx(byFrame.max.x + aside));
      CHECK(picks->values.start == Approx(byValue.min.y - above));
      CHECK(picks->values.end == Approx(byValue.max.y + above));
    }
    // A curve is read as a chord between its points.
    for (const Curve& curve : curves) {
      for (std::size_t k = 0; k + 1 < curve.points.size(); ++k) {
        const double share = row.between(0.0, 1.0);
        CHECK(curveValue(curve.points, static_cast<double>(k) + share) ==
              Approx((1.0 - share) * curve.points[k].y + share * curve.points[k + 1].y).margin(1e-9));
      }
      if (!curve.points.empty()) {
        CHECK(curveValue(curve.points, -0.1) == curve.points.front().y);
        CHECK(curveValue(curve.points, curve.points.back().x + 0.1) == curve.points.back().y);
      }
    }
  }
}

TEST_CASE("A curve is lost from sight once, where an edit took all of it out of the values that show",
          "[drawn-numbers]") {
  const auto curveAt = [](double value) {
    return Curve{.label = "", .points = {{0.0, value}, {1.0, value + 1.0}}};
  };
  const Span values{0.0, 10.0};
  for (const auto& [to, isLost] :
       {std::pair(5.0, false), {-1.0, false}, {-1.1, true}, {10.0, false}, {10.1, true}, {-30.0, true}}) {
    CAPTURE(to);
    std::vector<Curve> curves{curveAt(3.0), curveAt(4.0), curveAt(90.0)};
    CHECK_FALSE(lostFromSight(curves, values)); // The third one was never seen.
    CHECK((curves[0].seen && curves[1].seen && !curves[2].seen));
    curves[1].points = curveAt(to).points;
    CHECK(lostFromSight(curves, values) == isLost);
    CHECK(curves[1].seen == !isLost);
    CHECK_FALSE(lostFromSight(curves, values));
  }
  std::vector<Curve> hidden{curveAt(3.0)};
  CHECK_FALSE(lostFromSight(hidden, values));
  hidden[0].hidden = true;
  CHECK_FALSE(lostFromSight(hidden, values));
  CHECK_FALSE(hidden[0].seen);
}

TEST_CASE("Drawn points of a transition are brought where they may stand, and those that may stay",
          "[drawn-numbers]") {
  test::Row row(6);
  for (int i = 0; i < 400; ++i) {
    const RemapPoints drawn{{row.around(1.4), row.around(1.4)}, {row.around(1.4), row.around(1.4)}};
    const RemapPoints now = clampedRemap(drawn);
    const auto within = [](double value, double low, double high) {
      return value < low ? low : value > high ? high : value;
    };
    CHECK(now.easeIn.y == within(drawn.easeIn.y, 0.0, 0.5));
    CHECK(now.easeOut.y == within(drawn.easeOut.y, 0.5, 1.0));
    CHECK(now.easeIn.x >= 0.0);
    CHECK(now.easeOut.x >= 0.0);
    CHECK(now.easeIn.x + now.easeOut.x < 1.0);
    const double in = within(drawn.easeIn.x, 0.0, 1.0);
    const double out = within(drawn.easeOut.x, 0.0, 1.0);
    if (in + out < 0.98) {
      CHECK(now.easeIn.x == in);
      CHECK(now.easeOut.x == out);
    } else { // Both give way alike, as far as there is something.
      CHECK(now.easeIn.x + now.easeOut.x > 0.97);
      CHECK((in - now.easeIn.x == Approx(out - now.easeOut.x).margin(0.03) || now.easeIn.x == 0.0));
    }
    CHECK(clampedRemap(now) == now);
  }
}

TEST_CASE("Drawn sums are worth what they say, and goes on from what is there", "[drawn-numbers]") {
  test::Row row(7);
  for (int i = 0; i < 300; ++i) {
    const auto [text, value] = drawnSum(row, 4);
    CAPTURE(text);
    const std::optional<double> typed = typedNumber(text, 3.0);
    REQUIRE(typed.has_value() == std::isfinite(value));
    if (typed) {
      CHECK(*typed == Approx(value));
      CHECK(*typedNumber("+=" + text, 3.0) == Approx(3.0 + value));
      CHECK(*typedNumber("-=" + text, 3.0) == Approx(3.0 - value));
      CHECK(*typedNumber("*= " + text + " %", 3.0) == Approx(3.0 * value));
    }
    if (typed && value != 0.0) {
      CHECK(*typedNumber("/=" + text, 3.0) == Approx(3.0 / value));
    }
    CHECK_FALSE(typedNumber(text + ")", 3.0));
    CHECK_FALSE(typedNumber("(" + text, 3.0));
    CHECK_FALSE(typedNumber(text + "*", 3.0));
  }
  // From left to right, products before sums.
  CHECK(typedNumber("10-4-3", 0.0) == 3.0);
  CHECK(typedNumber("16/4/2", 0.0) == 2.0);
  CHECK(typedNumber("2+3*4-6/2", 0.0) == 11.0);
  CHECK(typedNumber("--2", 0.0) == 2.0);
  CHECK(typedNumber("+2", 0.0) == 2.0);
  CHECK(typedNumber("x2,5 %", 0.0) == 2.5);
  CHECK_FALSE(typedNumber("/=0", 1.0));
  CHECK_FALSE(typedNumber("+=", 1.0));
  CHECK_FALSE(typedNumber("1.2.3", 1.0));
  const std::string brackets(32, '(');
  CHECK(typedNumber(brackets + "1" + std::string(32, ')'), 0.0) == 1.0);
  CHECK_FALSE(typedNumber(brackets + "(1)" + std::string(32, ')'), 0.0));
}

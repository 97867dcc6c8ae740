#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <thread>

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

#include "skinning/geometry/shape_diameter.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

/// The definition of the shape diameter with so many rays that their number no longer shows, on a shape where
/// the length of a ray is known: `lengthOf(angle, turn)`.
template <typename LengthOf>
double denseReference(LengthOf&& lengthOf) {
  std::vector<std::pair<double, double>> lengths; // Length and weight.
  const int rings = 400;
  const int turns = 200;
  for (int i = 0; i < rings; ++i) {
    const double angle = std::acos(1.0 - 0.5 * (i + 0.5) / rings);
    for (int j = 0; j < turns; ++j) {
      lengths.emplace_back(lengthOf(angle, 2.0 * pi * (j + 0.5) / turns),
                           1.0 / std::max(angle * 180.0 / pi, 1.0));
    }
  }
  std::sort(lengths.begin(), lengths.end());
  const double median = lengths[lengths.size() / 2].first;
  double mean = 0.0;
  double square = 0.0;
  for (const auto& [length, weight] : lengths) {
    mean += length / static_cast<double>(lengths.size());
    square += length * length / static_cast<double>(lengths.size());
  }
  const double deviation = std::sqrt(square - mean * mean);
  double sum = 0.0;
  double weights = 0.0;
  for (const auto& [length, weight] : lengths) {
    if (std::abs(length - median) <= deviation) {
      sum += weight * length;
      weights += weight;
    }
  }
  return sum / weights;
}

double meanOver(const test::Shape& shape, const ShapeDiameters& diameters, double from, double to) {
  std::vector<int> group;
  for (const Triangle& t : shape.triangles) {
    const float x = (shape.positions[t[0]].x + shape.positions[t[1]].x + shape.positions[t[2]].x) / 3.0F;
    group.push_back(static_cast<double>(x) > from && static_cast<double>(x) < to ? 0 : -1);
  }
  return meanByGroup(shape.positions, shape.triangles, diameters.faces, group, 1)[0];
}

} // namespace

TEST_CASE("the shape diameter of a sphere is that of many rays, about three quarters of its diameter") {
  const test::Shape shape = test::sphere(4);
  const auto diameters = shapeDiameters(shape.positions, shape.triangles);
  REQUIRE(diameters);
  const double reference = denseReference([](double angle, double) { return 2.0 * std::cos(angle); });
  CHECK(reference > 1.5);
  CHECK(reference < 1.54);
  CHECK(meanOver(shape, *diameters, -2.0, 2.0) == Approx(reference).epsilon(0.02));
}

TEST_CASE("the shape diameter of the middle of a long tube is that of many rays, nearly its width") {
  const double radius = 0.5;
  const test::Shape shape = test::tube(20.0, radius, 160, 48);
  const auto diameters = shapeDiameters(shape.positions, shape.triangles);
  REQUIRE(diameters);
  const double reference = denseReference([&](double angle, double turn) {
    // From the wall straight inwards along y; the axis runs along x.
    const Vec3 direction(std::sin(angle) * std::cos(turn), std::cos(angle), std::sin(angle) * std::sin(turn));
    return 2.0 * radius * direction.y / (direction.y * direction.y + direction.z * direction.z);
  });
  CHECK(reference / radius == Approx(1.97).margin(0.02));
  CHECK(meanOver(shape, *diameters, 5.0, 15.0) == Approx(reference).epsilon(0.02));
}

TEST_CASE("the shape diameter does not depend on how triangles are wound") {
  test::Shape shape = test::tube(6.0, 0.5, 24, 16);
  const auto before = shapeDiameters(shape.positions, shape.triangles);
  for (std::size_t t = 0; t < shape.triangles.size(); t += 2) {
    std::swap(shape.triangles[t][0], shape.triangles[t][1]);
  }
  const auto after = shapeDiameters(shape.positions, shape.triangles);
  REQUIRE(before);
  REQUIRE(after);
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    // Turned triangles start their corners elsewhere, so the rays' fan around the normal may be rotated.
    CHECK(after->vertices[v] == Approx(before->vertices[v]).epsilon(0.05));
  }
}

TEST_CASE("a flat sheet has no shape diameter and says so") {
  const test::Shape shape = test::plane(4, 0.0);
  const auto diameters = shapeDiameters(shape.positions, shape.triangles);
  REQUIRE_FALSE(diameters);
  CHECK(diameters.error().line().find("shape diameter") != std::string::npos);
}

TEST_CASE(
    "work in parallel keeps its smallest numbers, whether or not a shape diameter was measured before it") {
  std::vector<float> halves(10000, 0.0F);
  bool isMeasured = false;
  std::thread fresh([&] {
    const test::Shape shape = test::sphere(2);
    isMeasured = shapeDiameters(shape.positions, shape.triangles).ok();
    const volatile float smallest = 1e-39F;
    tbb::parallel_for(std::size_t{0}, halves.size(), [&](std::size_t i) { halves[i] = smallest * 0.5F; });
  });
  fresh.join();
  CHECK(isMeasured);
  CHECK(std::ranges::all_of(halves, [](float half) { return half > 0.0F; }));
}

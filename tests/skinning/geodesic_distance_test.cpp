#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "skinning/geometry/geodesic_distance.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

std::vector<double> distancesFrom(const test::Shape& shape, std::uint32_t source) {
  return GeodesicSolver(shape.positions, shape.triangles).distances({source});
}

/// Mean of |found - exact| / exact over all vertices but the source.
template <typename Exact>
double meanRelativeError(const test::Shape& shape, std::uint32_t source, Exact&& exact) {
  const std::vector<double> found = distancesFrom(shape, source);
  double sum = 0.0;
  for (std::size_t v = 0; v < found.size(); ++v) {
    const double truth = exact(Vec3(shape.positions[v]));
    sum += v == source ? 0.0 : std::abs(found[v] - truth) / truth;
  }
  return sum / static_cast<double>(found.size() - 1);
}

/// Distance between two points of a torus around y by the straight parametrisation's shortest path: found by
/// relaxing a finely cut path in (u, v).
double torusDistance(double majorRadius, double minorRadius, Vec2 from, Vec2 to) {
  constexpr int pieces = 48;
  const auto speed = [&](double v) { return majorRadius + minorRadius * std::cos(v); };
  double best = 1e9;
  for (const double du : {0.0, 2.0 * pi, -2.0 * pi}) {
    for (const double dv : {0.0, 2.0 * pi, -2.0 * pi}) {
      std::vector<Vec2> path;
      for (int i = 0; i <= pieces; ++i) {
        path.push_back(from + (to + Vec2(du, dv) - from) * (static_cast<double>(i) / pieces));
      }
      for (int round = 0; round < 2000; ++round) {
        for (std::size_t i = 1; i + 1 < path.size(); ++i) {
          // Euler-Lagrange step of the squared length: v pulled towards smaller circles, u to the mean by
          // weights.
          const double before = std::pow(speed(0.5 * (path[i - 1].y + path[i].y)), 2.0);
          const double after = std::pow(speed(0.5 * (path[i].y + path[i + 1].y)), 2.0);
          path[i].x = (before * path[i - 1].x + after * path[i + 1].x) / (before + after);
          const double turn = 0.5 * (path[i + 1].x - path[i - 1].x);
          const double pull = -speed(path[i].y) * minorRadius * std::sin(path[i].y) * turn * turn /
                              (minorRadius * minorRadius);
          path[i].y = 0.5 * (path[i - 1].y + path[i + 1].y - pull);
        }
      }
      double length = 0.0;
      for (std::size_t i = 1; i < path.size(); ++i) {
        const double r = speed(0.5 * (path[i].y + path[i - 1].y));
        length += std::hypot(r * (path[i].x - path[i - 1].x), minorRadius * (path[i].y - path[i - 1].y));
      }
      best = std::min(best, length);
    }
  }
  return best;
}

} // namespace

TEST_CASE("distances on a sphere are great circles to a mean error of 1 %") {
  const test::Shape shape = test::sphere(4);
  const Vec3 pole(shape.positions[0]);
  CHECK(meanRelativeError(shape, 0, [&](const Vec3& p) {
          return std::acos(std::clamp(glm::dot(glm::normalize(p), pole), -1.0, 1.0));
        }) < 0.01);
}

TEST_CASE("distances on a plane are straight lines, obtuse triangles or not") {
  for (const double jitter : {0.0, 0.3, 0.45}) {
    const test::Shape shape = test::plane(24, jitter);
    for (const std::uint32_t source : {0U, 300U}) {
      const Vec3 from(shape.positions[source]);
      CHECK(meanRelativeError(shape, source, [&](const Vec3& p) { return glm::length(p - from); }) < 0.01);
    }
  }
}

TEST_CASE("distances on a torus follow its geodesics to a mean error of 1 %") {
  const double majorRadius = 2.0;
  const double minorRadius = 0.7;
  const test::Shape shape = test::torus(majorRadius, minorRadius, 80, 32);
  const std::vector<double> found = distancesFrom(shape, 0);
  double sum = 0.0;
  int count = 0;
  for (std::size_t v = 37; v < found.size(); v += 131) {
    const std::size_t ring = v / 32;
    const Vec2 to(2.0 * pi * static_cast<double>(ring) / 80.0, 2.0 * pi * static_cast<double>(v % 32) / 32.0);
    const double truth = torusDistance(majorRadius, minorRadius, Vec2(0.0), to);
    sum += std::abs(found[v] - truth) / truth;
    ++count;
  }
  CHECK(sum / count < 0.01);
}

TEST_CASE("several sources: the nearest counts, and a limit leaves the rest unreached") {
  const test::Shape shape = test::plane(10, 0.0);
  const GeodesicSolver solver(shape.positions, shape.triangles);
  const std::vector<double> both = solver.distances({0, 10});
  CHECK(both[5] == Approx(0.5));
  CHECK(both[9] == Approx(0.1));
  const std::vector<double> near = solver.distances({0}, 0.35);
  CHECK(near[3] == Approx(0.3));
  CHECK(std::isinf(near[4]));
}

TEST_CASE(
    "a front that starts on a whole edge moves nearly straight, though it is taken for the sum of circles") {
  const test::Shape shape = test::plane(10, 0.0);
  const GeodesicSolver solver(shape.positions, shape.triangles);
  std::vector<std::uint32_t> edge(11);
  for (std::uint32_t i = 0; i < 11; ++i) {
    edge[i] = i;
  }
  const std::vector<double> found = solver.distances(edge);
  for (std::size_t v = 0; v < found.size(); ++v) {
    CHECK(found[v] == Approx(static_cast<double>(shape.positions[v].z)).margin(0.15 * 0.1)); // Cells of 0.1.
  }
}

TEST_CASE("an edge of four triangles is crossed, another part is not reached") {
  test::Shape shape;
  shape.positions = {{0, 0, 0},     {0, 1, 0}, {1, 0.5F, 0}, {-1, 0.5F, 0}, {0, 0.5F, 1},
                     {0, 0.5F, -1}, {5, 0, 0}, {6, 0, 0},    {5, 1, 0}};
  shape.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}, {6, 7, 8}};
  const GeodesicSolver solver(shape.positions, shape.triangles);
  const std::vector<double> found = solver.distances({2});
  for (std::size_t v = 0; v < 6; ++v) {
    CHECK(std::isfinite(found[v]));
  }
  CHECK(found[4] <= 2.3);
  CHECK(std::isinf(found[6]));
}

TEST_CASE("triangles wound at random do not change distances") {
  test::Shape shape = test::sphere(3);
  const std::vector<double> before = distancesFrom(shape, 7);
  for (std::size_t t = 0; t < shape.triangles.size(); t += 3) {
    std::swap(shape.triangles[t][0], shape.triangles[t][1]);
  }
  const std::vector<double> after = distancesFrom(shape, 7);
  for (std::size_t v = 0; v < before.size(); ++v) {
    CHECK(after[v] == Approx(before[v]).margin(1e-9));
  }
}

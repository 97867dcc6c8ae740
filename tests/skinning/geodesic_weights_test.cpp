#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "skinning/weights/geodesic_weights.h"
#include "tests/support/refusal.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/skinning/weight_of.h"

using namespace stretch;
using namespace stretch::skinning;
using test::weightOf;

namespace {

// Two bones, end to end, along the middle of a tube that is 10 long.
const std::vector<BoneSegment> halves{{Vec3(0.0), Vec3(5.0, 0.0, 0.0)},
                                      {Vec3(5.0, 0.0, 0.0), Vec3(10.0, 0.0, 0.0)}};

/// A flat strip along x, so narrow that only the way along it counts, with vertices every half unit.
test::Shape narrowStrip(int length) {
  test::Shape shape;
  for (int i = 0; i <= 2 * length; ++i) {
    shape.positions.emplace_back(0.5F * static_cast<float>(i), 0.0F, 0.0F);
    shape.positions.emplace_back(0.5F * static_cast<float>(i), 0.0F, 0.01F);
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(4 * length); i += 2) {
    shape.triangles.push_back({i, i + 1, i + 2});
    shape.triangles.push_back({i + 1, i + 3, i + 2});
  }
  return shape;
}

} // namespace

TEST_CASE("a bone weighs by how far its patch is in lengths of the bone, and not beyond a thousandth") {
  const test::Shape flat = narrowStrip(12);
  const double border = GENERATE(1.0, 2.0, 6.0);
  const GeodesicWeightSettings settings =
      GENERATE(GeodesicWeightSettings{}, GeodesicWeightSettings{2.0, 0.5}, GeodesicWeightSettings{4.0, 0.2});
  const std::vector<BoneSegment> bones{{Vec3(0.0, 0.0, 0.0), Vec3(border, 0.0, 0.0)},
                                       {Vec3(border, 0.0, 0.0), Vec3(12.0, 0.0, 0.0)}};
  const auto weights = geodesicWeights(flat.positions, flat.triangles, bones, settings);
  REQUIRE(weights);
  const auto share = [&](double away, double length) {
    const double reach = length * (settings.offset * std::pow(1000.0, 1.0 / settings.power) + 1.0);
    return away > reach ? 0.0 : std::pow(std::max(0.0, away) / length + settings.offset, -settings.power);
  };
  for (std::size_t v = 0; v < flat.positions.size(); ++v) {
    const auto x = static_cast<double>(flat.positions[v].x);
    const double first = share(x - border, border);
    const double second = share(border - x, 12.0 - border);
    CAPTURE(x, border, settings.power, settings.offset);
    CHECK(weightOf((*weights)[v], 0) == Approx(first / (first + second)).margin(1e-5));
    CHECK(weightOf((*weights)[v], 1) == Approx(second / (first + second)).margin(1e-5));
  }
}

TEST_CASE("the nearest bone of a face is told by the nearest place on it, its ends among them") {
  const test::Shape flat = narrowStrip(8);
  const auto strongest = [&](const std::vector<BoneSegment>& bones, double x) {
    const auto weights = geodesicWeights(flat.positions, flat.triangles, bones);
    REQUIRE(weights);
    const auto vertex = static_cast<std::size_t>(4.0 * x);
    return weightOf((*weights)[vertex], 0) > weightOf((*weights)[vertex], 1) ? 0 : 1;
  };
  // The second bone points away from the strip and ends at it; a point is a bone as well.
  const std::vector<BoneSegment> away{{Vec3(0.0, 0.0, 0.0), Vec3(2.0, 0.0, 0.0)},
                                      {Vec3(6.0, 5.0, 0.0), Vec3(6.0, 0.0, 0.0)}};
  CHECK(strongest(away, 3.0) == 0);
  CHECK(strongest(away, 5.0) == 1);
  const std::vector<BoneSegment> point{{Vec3(1.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0)},
                                       {Vec3(7.0, 0.0, 0.0), Vec3(8.0, 0.0, 0.0)}};
  CHECK(strongest(point, 1.0) == 0);
  CHECK(strongest(point, 3.0) == 0);
  CHECK(strongest(point, 7.0) == 1);
}

TEST_CASE("a bone with no face of its own gets no weight") {
  const test::Shape flat = narrowStrip(4);
  const std::vector<BoneSegment> bones{{Vec3(0.0, 0.0, 0.0), Vec3(4.0, 0.0, 0.0)},
                                       {Vec3(0.0, 3.0, 0.0), Vec3(4.0, 3.0, 0.0)}};
  const auto weights = geodesicWeights(flat.positions, flat.triangles, bones);
  REQUIRE(weights);
  for (const Influences& one : *weights) {
    CHECK(weightOf(one, 0) == 1.0);
    CHECK(weightOf(one, 1) == 0.0);
  }
}

TEST_CASE("a vertex of no triangle follows the bone that is nearest to it") {
  test::Shape tube = test::tube(10.0, 0.5, 20, 8);
  tube.positions.emplace_back(9.0F, 2.0F, 0.0F);
  tube.positions.emplace_back(1.0F, 2.0F, 0.0F);
  const auto weights = geodesicWeights(tube.positions, tube.triangles, halves);
  REQUIRE(weights);
  CHECK(weightOf((*weights)[tube.positions.size() - 2], 1) == 1.0);
  CHECK(weightOf((*weights)[tube.positions.size() - 1], 0) == 1.0);
}

TEST_CASE("weights of a vertex sum to one, and go over from bone to bone along the surface") {
  const test::Shape tube = test::tube(10.0, 0.5, 20, 8);
  const auto weights = geodesicWeights(tube.positions, tube.triangles, halves);
  REQUIRE(weights);
  for (std::size_t v = 0; v < tube.positions.size(); ++v) {
    const double first = weightOf((*weights)[v], 0);
    CHECK(first + weightOf((*weights)[v], 1) == Approx(1.0).epsilon(1e-6));
    const float x = tube.positions[v].x;
    CHECK((first > 0.5) == (x < 5.0F || (x == 5.0F && first > 0.5)));
  }
}

TEST_CASE("of more than four bones the four strongest are kept, the first of equal ones") {
  const Influences kept = strongestFour({0.1, 0.3, 0.0, 0.2, 0.2, 0.2, 0.2});
  CHECK(kept.bones[0] == 1);
  CHECK(weightOf(kept, 1) == Approx(1.0 / 3.0));
  for (const std::size_t bone : {3U, 4U, 5U}) {
    CHECK(weightOf(kept, bone) == Approx(2.0 / 9.0));
  }
  CHECK(weightOf(kept, 6) == 0.0);
  CHECK(strongestFour({0.0, 0.0}).weights[0] == 1.0F);
}

TEST_CASE("weights without bones or without triangles are refused") {
  const test::Shape tube = test::tube(10.0, 0.5, 4, 4);
  const std::string reason = "weights need bones (at most 65535) and triangles";
  CHECK_THAT(test::refusal(geodesicWeights(tube.positions, tube.triangles, {})), Catch::StartsWith(reason));
  CHECK_THAT(test::refusal(geodesicWeights(tube.positions, {}, halves)), Catch::StartsWith(reason));
  const std::vector<BoneSegment> tooMany(65536);
  CHECK_THAT(test::refusal(geodesicWeights(tube.positions, tube.triangles, tooMany)),
             Catch::StartsWith(reason));
}

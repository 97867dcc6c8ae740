#include <catch2/catch.hpp>

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

} // namespace

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

#include <numeric>

#include <catch2/catch.hpp>

#include "skinning/bind/welded.h"
#include "skinning/elastic/limb_elasticity.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

const Vec3 up(0.0, 1.0, 0.0);

/// Ends at these heights, still beside that.
std::vector<Vec3> atHeights(const std::vector<double>& heights) {
  std::vector<Vec3> ends;
  ends.reserve(heights.size());
  for (const double height : heights) {
    ends.emplace_back(7.0, height, -2.0);
  }
  return ends;
}

void checkNear(const std::vector<double>& is, const std::vector<double>& wanted) {
  REQUIRE(is.size() == wanted.size());
  for (std::size_t i = 0; i < is.size(); ++i) {
    INFO(i);
    CHECK(is[i] == Approx(wanted[i]).margin(1e-12));
  }
}

} // namespace

TEST_CASE("What is low touches the ground for all of that time, and fades in and out around it") {
  // At a rate of 15 the fade is one frame to either side.
  const std::vector<Vec3> ends = atHeights({1, 1, 1, 1, 0, 0, 1, 1, 1, 1});
  checkNear(touchingWeights(ends, 15.0, 1.0, up), {0, 0, 1.0 / 3, 2.0 / 3, 1, 1, 2.0 / 3, 1.0 / 3, 0, 0});
  // At the ends of a clip it goes on as it is there.
  checkNear(touchingWeights(atHeights({0, 1, 1, 1}), 15.0, 1.0, up), {1, 2.0 / 3, 1.0 / 3, 0});
  checkNear(touchingWeights(atHeights({1, 1, 1, 0}), 15.0, 1.0, up), {0, 1.0 / 3, 2.0 / 3, 1});
  checkNear(touchingWeights(ends, 15.0, 1.0, up, {.fadeSeconds = 0.0}), {0, 0, 0, 0, 1, 1, 0, 0, 0, 0});
  CHECK(touchingWeights({}, 15.0, 1.0, up).empty());
}

TEST_CASE("Low is what lies at most six hundredths of a limb above the lowest place or the ground") {
  const auto low = [](const std::vector<double>& heights,
                      const PlantedSettings& settings = {.fadeSeconds = 0.0}) {
    return touchingWeights(atHeights(heights), 30.0, 2.0, up, settings);
  };
  checkNear(low({3.0, 3.1199, 3.1201}), {1, 1, 0});
  checkNear(low({3.1201, 3.1199, 3.0}), {0, 1, 1}); // the first is not the lowest
  checkNear(low({3.0, 3.3}, {.height = 0.2, .fadeSeconds = 0.0}), {1, 1});
  checkNear(low({3.0, 1.0, 0.9}, {.ground = 0.9, .fadeSeconds = 0.0}), {0, 1, 1});
  checkNear(low({3.0, 3.0}, {.ground = 0.0, .fadeSeconds = 0.0}), {0, 0});
  // Along another axis the heights do not count.
  checkNear(touchingWeights(atHeights({3, 0, 9}), 30.0, 2.0, Vec3(1.0, 0.0, 0.0), {.fadeSeconds = 0.0}),
            {1, 1, 1});
}

TEST_CASE("A foot stands where it is low and slow, by how far it gets from frame to frame around each") {
  // At a rate of 10 and limbs of 1, slow is at most 0.35 in a second.
  const auto standing = [](const std::vector<double>& xs, double seconds = 0.0) {
    std::vector<Vec3> ends;
    ends.reserve(xs.size());
    for (const double x : xs) {
      ends.emplace_back(x, 0.0, 0.0);
    }
    return plantedWeights(ends, 10.0, 1.0, up, {.fadeSeconds = seconds});
  };
  checkNear(standing({0, 0.034, 0.068, 0.102}), {1, 1, 1, 1});
  checkNear(standing({0, 0.036, 0.072, 0.108}), {0, 0, 0, 0});
  checkNear(standing({0, 0, 0, 1, 2, 2, 2}), {1, 1, 0, 0, 0, 1, 1});
  checkNear(standing({0, 1, 0}), {0, 1, 0}); // back where it was
  checkNear(standing({0, 0, 0, 0, 9, 9, 9, 9}, 0.1), {1, 1, 2.0 / 3, 1.0 / 3, 1.0 / 3, 2.0 / 3, 1, 1});
  checkNear(standing({5}), {1});
  CHECK(standing({}).empty());
}

TEST_CASE("A body's mass is shared by those limbs that stand, as much as each does") {
  using Rows = std::vector<std::vector<double>>;
  CHECK(sharedMass({}, 60.0).empty());
  CHECK(sharedMass({{0.5, 1.0, 0.0}}, 60.0) == Rows{{60.0, 60.0, 0.0}});
  CHECK(sharedMass({{0.25, 1.0}, {0.75, 0.0}, {1.0, 1.0}}, 80.0) ==
        Rows{{10.0, 40.0}, {30.0, 0.0}, {40.0, 40.0}});
}

TEST_CASE("A limb's segments are cylinders of their lengths and widths") {
  const std::vector<LimbSegment> segments = limbSegments({2.0, 3.0}, {1.0, 4.0});
  REQUIRE(segments.size() == 2);
  CHECK(segments[0].length == 2.0);
  CHECK(segments[1].width == 4.0);
  CHECK(segments[0].volume == Approx(0.5 * pi));
  CHECK(segments[1].volume == Approx(12.0 * pi));
  CHECK(limbSegments({}, {}).empty());
}

TEST_CASE("Vertices at one place are one, by the first of them, the first and the last of all among them") {
  using Leaders = std::vector<std::uint32_t>;
  CHECK(weldedVertices({}).empty());
  CHECK(weldedVertices(std::vector<glm::vec3>{{1, 2, 3}, {1, 2, 3}}) == Leaders{0, 1}); // without any extent
  const std::vector<glm::vec3> places{{0, 0, 0},  {10, 0, 0}, {0, 0, 0}, {5, 5, 5},
                                      {10, 0, 0}, {0, 0, 0},  {5, 5, 5}};
  CHECK(weldedVertices(places) == Leaders{0, 1, 0, 3, 1, 0, 3});
}

TEST_CASE("Vertices are one within some hundred-thousandths of the mesh, wherever they lie, and not beyond") {
  const auto areOne = [](float at, float apart) {
    // The box is 100 wide: a hundred-thousandth of its diagonal is a thousandth.
    const std::vector<glm::vec3> places{{-50, 0, 0}, {at, 0, 0}, {at + apart, 0, 0}, {50, 0, 0}};
    const std::vector<std::uint32_t> leaders = weldedVertices(places);
    CHECK(leaders[0] == 0);
    CHECK(leaders[1] == 1);
    CHECK(leaders[3] == 3);
    return leaders[2] == 1;
  };
  for (int step = 0; step < 20; ++step) {
    const float at = -1.0F + 0.00013F * static_cast<float>(step);
    INFO(at);
    CHECK(areOne(at, 0.0004F));
    CHECK_FALSE(areOne(at, 0.0011F));
  }
}

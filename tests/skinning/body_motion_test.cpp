// How the segments of a body without branches move: what is measured of one that is moved by a known map.
#include <cmath>
#include <numeric>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "skinning/compress/body_motion.h"
#include "skinning/sequence/topology.h"
#include "tests/support/skinning/shapes.h"

using namespace stretch;
using namespace stretch::skinning;

namespace {

constexpr int segments = 10;

/// A tube along x, 10 long and 1 thick, that a map moves in the second frame.
MeshSequence mappedTube(const Mat3& map, const Vec3& shift) {
  MeshSequence sequence = test::still(test::tube(10.0, 0.5, 60, 16));
  const std::vector<glm::vec3> rest = sequence.positions;
  for (const glm::vec3& place : rest) {
    sequence.positions.emplace_back(map * Vec3(place) + shift);
  }
  return sequence;
}

BodyMotion analysed(const MeshSequence& sequence) {
  const Result<BodyMotion> body = analyseBody(sequence, segments);
  REQUIRE(body);
  REQUIRE(body->segmentCount() == static_cast<std::size_t>(segments));
  REQUIRE(body->joints.size() == sequence.frameCount());
  return *body;
}

double farthest(const Mat3& a, const Mat3& b) {
  double most = 0.0;
  for (glm::length_t column = 0; column < 3; ++column) {
    most = std::max(most, glm::length(a[column] - b[column]));
  }
  return most;
}

} // namespace

TEST_CASE(
    "a body that is turned, stretched and moved as a whole has that turn and stretch in every segment") {
  const Quat turn = glm::angleAxis(0.7, glm::normalize(Vec3(1.0, 2.0, 3.0)));
  Mat3 stretch(1.0);
  stretch[0][0] = 0.8;
  stretch[1][1] = 1.5;
  const Mat3 map = glm::mat3_cast(turn) * stretch;
  const Vec3 shift(3.0, -2.0, 5.0);
  const BodyMotion body = analysed(mappedTube(map, shift));
  for (std::size_t s = 0; s < body.segmentCount(); ++s) {
    CAPTURE(s);
    CHECK(farthest(body.motion(0, s).stretch, Mat3(1.0)) < 1e-4);
    CHECK(farthest(glm::mat3_cast(body.motion(0, s).rotation), Mat3(1.0)) < 1e-4);
    CHECK(farthest(body.motion(1, s).stretch, stretch) < 1e-4);
    CHECK(farthest(glm::mat3_cast(body.motion(1, s).rotation), glm::mat3_cast(turn)) < 1e-4);
  }
  for (std::size_t joint = 0; joint <= body.segmentCount(); ++joint) {
    CAPTURE(joint);
    const Vec3 wanted = map * body.joints[0][joint] + shift;
    CHECK(glm::length(body.joints[1][joint] - wanted) < 0.01);
  }
}

TEST_CASE("joints of a straight body run along its middle from end to end, evenly") {
  const BodyMotion body = analysed(mappedTube(Mat3(1.0), Vec3(0.0)));
  REQUIRE(body.joints[0].size() == body.segmentCount() + 1);
  const bool isTurned = body.joints[0].front().x > 5.0;
  for (std::size_t joint = 0; joint <= body.segmentCount(); ++joint) {
    const Vec3& place = body.joints[0][joint];
    const auto along = static_cast<double>(joint);
    CHECK(place.x == Approx(isTurned ? 10.0 - along : along).margin(0.15));
    CHECK(std::hypot(place.y, place.z) < 0.02);
  }
}

TEST_CASE("the volumes of a body's segments are even along a tube and make up what the surface encloses") {
  const MeshSequence sequence = mappedTube(Mat3(1.0), Vec3(0.0));
  const BodyMotion body = analysed(sequence);
  const double whole = enclosedVolume(sequence.frame(0), sequence.triangles);
  CHECK(whole == Approx(10.0 * 8.0 * 0.25 * std::sin(pi / 8.0)).epsilon(0.01)); // about a prism of 16 sides
  REQUIRE(body.volumes.size() == body.segmentCount());
  CHECK(std::accumulate(body.volumes.begin(), body.volumes.end(), 0.0) == Approx(whole));
  for (std::size_t s = 1; s + 1 < body.segmentCount(); ++s) {
    CHECK(body.volumes[s] == Approx(0.1 * whole).epsilon(0.05));
  }
  MeshSequence inwards = sequence;
  for (Triangle& triangle : inwards.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  const double inside = enclosedVolume(inwards.frame(0), inwards.triangles);
  CHECK(inside == Approx(-whole));
  const BodyMotion turned = analysed(inwards);
  for (std::size_t s = 0; s < body.segmentCount(); ++s) {
    CHECK(turned.volumes[s] == Approx(body.volumes[s]));
  }
}

TEST_CASE("a tube is as thick along its whole length as it was made") {
  const MeshSequence sequence = mappedTube(Mat3(1.0), Vec3(0.0));
  const BodyMotion body = analysed(sequence);
  REQUIRE(body.widths.size() == body.segmentCount());
  for (std::size_t s = 2; s + 2 < body.segmentCount(); ++s) {
    CHECK(body.widths[s] == Approx(body.widths[4]).epsilon(0.02));
    CHECK(body.widths[s] == Approx(1.0).epsilon(0.25));
  }
}

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "skinning/bind/bind_weights.h"
#include "tests/support/refusal.h"
#include "tests/support/skinning/shapes.h"
#include "tests/support/skinning/weight_of.h"

using namespace stretch;
using skinning::BindJoint;
using skinning::Influences;
using test::Shape;
using test::weightOf;

namespace {

std::vector<Influences> bound(const Shape& shape, const std::vector<BindJoint>& joints) {
  const auto result = skinning::bindWeights(shape.positions, shape.triangles, joints);
  if (!result) {
    FAIL(result.error().line());
  }
  return result->influences;
}

void add(Shape& shape, const Shape& other, const glm::vec3& offset) {
  const auto first = static_cast<std::uint32_t>(shape.positions.size());
  for (const glm::vec3& position : other.positions) {
    shape.positions.push_back(position + offset);
  }
  for (const Triangle& t : other.triangles) {
    shape.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

constexpr double cell = 0.05;

Shape box(const glm::ivec3& size) {
  return test::cubes({0, 0, 0}, size, cell, [&](int x, int y, int z) {
    return x >= 0 && y >= 0 && z >= 0 && x < size.x && y < size.y && z < size.z;
  });
}

// 20 cells up: hips from 12 on, two legs below that are 3 cells wide with a gap of `gap` cells; cells count
// in twentieths of the height.
Shape trousers(double gap) {
  Shape shape;
  add(shape, box({7, 8, 3}), {0, 12 * static_cast<float>(cell), 0});
  const Shape leg = box({3, 12, 3});
  const auto aside = static_cast<float>(cell * (0.5 - 0.5 * gap));
  add(shape, leg, {aside, 0, 0});
  add(shape, leg, {4 * static_cast<float>(cell) - aside, 0, 0});
  return shape;
}

// Hips, then thigh and shin of each side, from the left leg (smaller x) to the right one.
std::vector<BindJoint> legBones() {
  return {{Vec3(3.5, 16, 1.5) * cell, -1}, {Vec3(2, 12, 1.5) * cell, 0}, {Vec3(2, 6, 1.5) * cell, 1},
          {Vec3(2, 0.5, 1.5) * cell, 2},   {Vec3(5, 12, 1.5) * cell, 0}, {Vec3(5, 6, 1.5) * cell, 4},
          {Vec3(5, 0.5, 1.5) * cell, 5}};
}

const std::vector<BindJoint> tubeBones{{Vec3(0, 0, 0), -1}, {Vec3(5, 0, 0), 0}, {Vec3(9.5, 0, 0), 1}};

} // namespace

TEST_CASE("Every vertex of a bound body follows at most four joints, and all of its weight is given out") {
  for (const Influences& row : bound(trousers(0.5), legBones())) {
    CHECK(std::accumulate(row.weights.begin(), row.weights.end(), 0.0F) == Approx(1.0F).margin(1e-6));
    CHECK(std::count_if(row.weights.begin(), row.weights.end(), [](float w) { return w > 0.0F; }) <= 4);
    CHECK(std::is_sorted(row.weights.begin(), row.weights.end(), std::greater<>()));
  }
}

TEST_CASE("A bone owns its part of a tube, and two bones share the bend between them step by step") {
  const Shape tube = test::tube(10.0, 1.0, 80, 12);
  const std::vector<Influences> rows = bound(tube, tubeBones);
  for (std::size_t v = 0; v < rows.size(); ++v) {
    const auto x = static_cast<double>(tube.positions[v].x);
    CHECK((x > 3.5 || weightOf(rows[v], 0) > 0.99));
    CHECK((x < 6.5 || weightOf(rows[v], 0) < 0.01));
    CHECK((std::abs(x - 5.0) > 0.01 || std::abs(weightOf(rows[v], 0) - 0.5) < 0.1));
  }
  constexpr std::size_t sides = 12;
  for (std::size_t v = 0; v + sides < 80 * sides; ++v) { // from ring to ring, an eighth of the radius
    CHECK(std::abs(weightOf(rows[v], 0) - weightOf(rows[v + sides], 0)) < 0.2);
  }
}

TEST_CASE("A leg follows nothing of the other leg, however near they stand") {
  for (const double gap : {1.0, 0.2, 0.01}) {
    const Shape shape = trousers(gap);
    const std::vector<Influences> rows = bound(shape, legBones());
    for (std::size_t v = 0; v < rows.size(); ++v) {
      const glm::vec3& place = shape.positions[v];
      if (place.y > 8 * static_cast<float>(cell)) {
        continue; // where the legs begin, hips and both thighs are neighbours
      }
      const bool isLeft = place.x < 3.5F * static_cast<float>(cell);
      INFO("gap " << gap << ", vertex at " << place.x << " " << place.y);
      CHECK(weightOf(rows[v], isLeft ? 4 : 1) + weightOf(rows[v], isLeft ? 5 : 2) +
                weightOf(rows[v], isLeft ? 6 : 3) <
            1e-6);
    }
  }
}

TEST_CASE("A hand that lies on a thigh does not take it along") {
  // A trunk with a thigh of 6 cells to the front and an arm that comes down from the shoulder onto it.
  Shape shape = box({6, 24, 6});
  add(shape, box({6, 6, 18}), {0, 0, 6 * static_cast<float>(cell)});
  const float above = (6.0F + 0.02F) * static_cast<float>(cell);
  add(shape, box({2, 2, 12}), {2 * static_cast<float>(cell), above, 8 * static_cast<float>(cell)});
  add(shape, box({2, 14, 2}),
      {2 * static_cast<float>(cell), above + 2 * static_cast<float>(cell), 8 * static_cast<float>(cell)});
  const Vec3 shoulder = Vec3(3, 22, 3) * cell;
  const std::vector<BindJoint> joints{{Vec3(3, 3, 3) * cell, -1}, {shoulder, 0},
                                      {Vec3(3, 21, 9) * cell, 1}, {Vec3(3, 7, 9) * cell, 2},
                                      {Vec3(3, 3, 8) * cell, 0},  {Vec3(3, 3, 22) * cell, 4}};
  const std::vector<Influences> rows = bound(shape, joints);
  const std::size_t trunk = box({6, 24, 6}).positions.size();
  const std::size_t thigh = box({6, 6, 18}).positions.size();
  for (std::size_t v = trunk; v < trunk + thigh; ++v) {
    CHECK(weightOf(rows[v], 2) + weightOf(rows[v], 3) < 1e-6);
  }
}

TEST_CASE("A helmet follows the head as one piece") {
  Shape shape = test::tube(10.0, 1.0, 40, 12);
  const std::size_t body = shape.positions.size();
  Shape helmet = test::sphere(2);
  for (glm::vec3& position : helmet.positions) {
    position *= 1.4F;
  }
  add(shape, helmet, {9.2F, 0, 0});
  const std::vector<BindJoint> joints{{Vec3(0, 0, 0), -1}, {Vec3(4, 0, 0), 0}, {Vec3(7.6, 0, 0), 1}};
  const std::vector<Influences> rows = bound(shape, joints);
  for (std::size_t v = body; v < rows.size(); ++v) {
    CHECK(weightOf(rows[v], 2) == Approx(1.0));
  }
  CHECK(weightOf(rows[12 * 20], 1) > 0.5); // the body below bends on
}

TEST_CASE("An ear follows the head that it sits on, however near the arm is") {
  // A trunk, a head wider than it, and an arm that reaches out close under the head.
  const auto at = [](double x, double y, double z) { return glm::vec3(Vec3(x, y, z) * cell); };
  Shape shape = box({6, 20, 6});
  add(shape, box({22, 10, 6}), at(-8, 20.02, 0));
  add(shape, box({14, 4, 4}), at(6.02, 15.98, 1));
  const std::size_t body = shape.positions.size();
  add(shape, box({4, 3, 2}), at(11.5, 23, 2));
  const std::vector<BindJoint> joints{{Vec3(3, 2, 3) * cell, -1},
                                      {Vec3(3, 16, 3) * cell, 0},
                                      {Vec3(3, 21, 3) * cell, 1},
                                      {Vec3(5, 18, 3) * cell, 1},
                                      {Vec3(16, 18, 3) * cell, 3}};
  const std::vector<Influences> rows = bound(shape, joints);
  for (std::size_t v = body; v < rows.size(); ++v) {
    CHECK(weightOf(rows[v], 2) == Approx(1.0));
  }
}

TEST_CASE("Holes, turned triangles and faces inside hardly change what a body follows") {
  const Shape whole = test::tube(10.0, 1.0, 40, 16);
  Shape broken = whole;
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < broken.triangles.size(); ++i) {
    if (i % 17 != 0) {
      kept.push_back(broken.triangles[i]);
    }
    if (i % 5 == 0 && !kept.empty()) {
      std::swap(kept.back()[0], kept.back()[1]);
    }
  }
  broken.triangles = kept;
  Shape inside = test::tube(8.0, 0.4, 20, 8);
  add(broken, inside, {1, 0, 0});
  const std::vector<Influences> good = bound(whole, tubeBones);
  const std::vector<Influences> rows = bound(broken, tubeBones);
  for (std::size_t v = 0; v < good.size(); ++v) {
    CHECK(std::abs(weightOf(rows[v], 0) - weightOf(good[v], 0)) < 0.25);
  }
}

TEST_CASE("Vertices that a file splits along a seam move together") {
  Shape shape = test::tube(10.0, 1.0, 40, 12);
  const std::size_t count = shape.positions.size();
  add(shape, test::tube(10.0, 1.0, 40, 12), {0, 0, 0});
  const std::vector<Influences> rows = bound(shape, tubeBones);
  for (std::size_t v = 0; v < count; ++v) {
    CHECK(rows[v] == rows[v + count]);
  }
}

TEST_CASE("A body is bound alike in millimetres and in kilometres") {
  const Shape shape = trousers(0.5);
  const std::vector<Influences> rows = bound(shape, legBones());
  for (const double size : {1e-4, 1e5}) {
    Shape other = shape;
    for (glm::vec3& position : other.positions) {
      position *= static_cast<float>(size);
    }
    std::vector<BindJoint> joints = legBones();
    for (BindJoint& joint : joints) {
      joint.place *= size;
    }
    const std::vector<Influences> scaled = bound(other, joints);
    double sum = 0.0;
    for (std::size_t v = 0; v < rows.size(); ++v) {
      for (std::size_t joint = 0; joint < joints.size(); ++joint) {
        sum += std::abs(weightOf(rows[v], joint) - weightOf(scaled[v], joint));
      }
    }
    CHECK(sum / static_cast<double>(rows.size()) < 0.03); // cubes at the surface may fall otherwise by
                                                          // rounding
  }
}

TEST_CASE("A flat sheet and a single triangle are bound too") {
  const Shape sheet = test::plane(10, 0.0);
  const std::vector<BindJoint> across{{Vec3(0, 0, 0.5), -1}, {Vec3(0.5, 0, 0.5), 0}, {Vec3(1, 0, 0.5), 1}};
  const std::vector<Influences> rows = bound(sheet, across);
  for (std::size_t v = 0; v < rows.size(); ++v) {
    CHECK((sheet.positions[v].x > 0.3F || weightOf(rows[v], 0) > 0.9));
  }
  const Shape one{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}}};
  CHECK(bound(one, across).size() == 3);
}

TEST_CASE("Binding ends when it is told to, and says what it took") {
  const Shape tube = test::tube(10.0, 1.0, 40, 12);
  const auto stopped = skinning::bindWeights(tube.positions, tube.triangles, tubeBones, {},
                                             [](double share) { return share < 0.5; });
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().what == "the binding was stopped");
  double last = 0.0;
  const auto done =
      skinning::bindWeights(tube.positions, tube.triangles, tubeBones, {}, [&last](double share) {
        CHECK(share >= last);
        last = share;
        return true;
      });
  REQUIRE(done.ok());
  CHECK(last == 1.0);
  CHECK(done->cubes > 1000);
  CHECK(done->bytes > 64 * done->cubes);
}

TEST_CASE("What cannot be bound is said in one line") {
  const Shape tube = test::tube(10.0, 1.0, 10, 8);
  const std::string noJoints = "there are no joints to bind to; give a skeleton";
  const std::string noFaces = "there is no triangle to bind; give a mesh with faces";
  CHECK(test::refusal(skinning::bindWeights(tube.positions, tube.triangles, {})) == noJoints);
  CHECK(test::refusal(skinning::bindWeightsOnSurface(tube.positions, tube.triangles, {})) == noJoints);
  CHECK(test::refusal(skinning::bindWeights(tube.positions, {}, tubeBones)) == noFaces);
  CHECK(test::refusal(skinning::bindWeightsOnSurface(tube.positions, {}, tubeBones)) == noFaces);
  const std::vector<BindJoint> tooMany(65536, tubeBones.front());
  CHECK(test::refusal(skinning::bindWeights(tube.positions, tube.triangles, tooMany)) ==
        "more joints than a skin can name; bind to fewer");
  const std::vector<BindJoint> asManyAsFit(65535, tubeBones.front());
  CHECK(test::refusal(skinning::bindWeights(tube.positions, {}, asManyAsFit)) == noFaces);
  const std::vector<glm::vec3> point(3, glm::vec3(1.0F));
  CHECK(test::refusal(skinning::bindWeights(point, {{0, 1, 2}}, tubeBones)) ==
        "the mesh has no extent; bind a mesh with a body");
  Shape far = tube;
  for (glm::vec3& position : far.positions) {
    position.x = 1e30F; // where single precision knows no tube
  }
  CHECK(test::refusal(skinning::bindWeights(far.positions, far.triangles, tubeBones)) ==
        "the mesh is too far from the origin for its size; move it to the origin");
}

TEST_CASE("A bone that ends a million bodies away is followed within the body alone, at once") {
  const Shape tube = test::tube(10.0, 1.0, 40, 12);
  std::vector<BindJoint> joints = tubeBones;
  joints.back().place = Vec3(1e7, 0, 0);
  const std::vector<Influences> rows = bound(tube, joints);
  for (std::size_t v = 0; v < rows.size(); ++v) {
    const bool isBeyond = tube.positions[v].x > 5.0F;
    if (std::abs(tube.positions[v].x - 5.0F) > 1.0F) {
      CHECK((weightOf(rows[v], 0) < 0.5) == isBeyond);
    }
  }
}

TEST_CASE("A twist joint has no part of the bone beyond the joint that its own bone ends at") {
  const Shape tube = test::tube(10.0, 1.0, 40, 12);
  // Upper arm, its twist joint, elbow, wrist.
  const std::vector<BindJoint> joints{
      {Vec3(0, 0, 0), -1}, {Vec3(2.5, 0, 0), 0}, {Vec3(5, 0, 0), 0}, {Vec3(9.5, 0, 0), 2}};
  const std::vector<Influences> rows = bound(tube, joints);
  for (std::size_t v = 0; v < rows.size(); ++v) {
    if (tube.positions[v].x > 6.5F) {
      CHECK(weightOf(rows[v], 1) < 0.05);
    }
  }
}

TEST_CASE("On a closed surface weights go by the way over it, an open one is refused") {
  Shape tube = test::tube(10.0, 1.0, 40, 12);
  const auto rows = skinning::bindWeightsOnSurface(tube.positions, tube.triangles, tubeBones);
  REQUIRE(rows.ok());
  CHECK(weightOf(rows->influences[0], 0) > 0.9);
  CHECK(weightOf(rows->influences[39 * 12], 0) < 0.1);
  tube.triangles.pop_back();
  const auto open = skinning::bindWeightsOnSurface(tube.positions, tube.triangles, tubeBones);
  REQUIRE_FALSE(open.ok());
  CHECK(open.error().line().find("not closed: 3 of its edges") != std::string::npos);
}

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "skinning/bind/voxel_body.h"

using namespace stretch;

namespace {

struct Boxes {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;

  // A box whose sides are cut into `parts` each way.
  void add(const Vec3& low, const Vec3& high, int parts) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        addSide(low, high, axis, side, parts);
      }
    }
  }

private:
  void addSide(const Vec3& low, const Vec3& high, int axis, int side, int parts) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    const auto row = static_cast<std::uint32_t>(parts + 1);
    for (int i = 0; i <= parts; ++i) {
      for (int j = 0; j <= parts; ++j) {
        Vec3 share(0.0);
        share[axis] = side;
        share[(axis + 1) % 3] = static_cast<double>(i) / parts;
        share[(axis + 2) % 3] = static_cast<double>(j) / parts;
        positions.emplace_back(low + share * (high - low));
      }
    }
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      for (std::uint32_t j = 0; j + 1 < row; ++j) {
        const std::uint32_t corner = first + i * row + j;
        triangles.push_back({corner, corner + row, corner + 1});
        triangles.push_back({corner + 1, corner + row, corner + row + 1});
      }
    }
  }
};

std::size_t cubesOf(const Boxes& boxes, int along) {
  const auto body = skinning::voxelBody(boxes.positions, boxes.triangles, along);
  return body ? body->cellCount() : 0;
}

int alongOf(const Boxes& boxes, int along) {
  const auto body = skinning::voxelBody(boxes.positions, boxes.triangles, along);
  return body ? body->grid.counts[1] : 0;
}

} // namespace

TEST_CASE("A cube of 24 vertices is filled with as few cubes as it needs, one of many triangles with more") {
  Boxes plain;
  plain.add(Vec3(-0.5), Vec3(0.5), 1);
  REQUIRE(plain.positions.size() == 24);
  CHECK(cubesOf(plain, 110) < 300'000);
  CHECK(cubesOf(plain, 140) < 300'000);
  CHECK(cubesOf(plain, 140) > 100'000);
  Boxes fine;
  fine.add(Vec3(-0.5), Vec3(0.5), 24);
  CHECK(cubesOf(fine, 110) > 1'000'000);
}

TEST_CASE("A thin body of few triangles keeps every cube that is asked for") {
  Boxes person;
  person.add({-0.2, 0.8, -0.1}, {0.2, 1.5, 0.1}, 1);
  person.add({-0.1, 1.5, -0.1}, {0.1, 1.8, 0.1}, 1);
  person.add({-0.2, 0.0, -0.1}, {-0.05, 0.8, 0.1}, 1);
  person.add({0.05, 0.0, -0.1}, {0.2, 0.8, 0.1}, 1);
  CHECK(alongOf(person, 110) > 110);
  CHECK(alongOf(person, 60) > 60);
}

TEST_CASE(
    "A mesh whose triangles join any vertices with any others is refused, and not looked at for minutes") {
  Boxes body;
  body.add(Vec3(-0.5), Vec3(0.5), 36);
  REQUIRE(cubesOf(body, 110) > 10'000);
  const auto count = static_cast<std::uint32_t>(body.positions.size());
  std::uint32_t next = 1;
  for (Triangle& triangle : body.triangles) {
    for (std::uint32_t& vertex : triangle) {
      next = next * 1664525U + 1013904223U;
      vertex = (next >> 8U) % count;
    }
  }
  const auto refused = skinning::voxelBody(body.positions, body.triangles, 110);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().what.find("cross the whole mesh") != std::string::npos);
}

TEST_CASE("A tube of strips as long as itself is filled as one of short strips, however many there are") {
  const auto tube = [](std::uint32_t strips) {
    Boxes made;
    for (std::uint32_t i = 0; i <= strips; ++i) {
      const double angle = 2.0 * pi * i / strips;
      for (const double y : {0.0, 1.0}) {
        made.positions.emplace_back(0.08 * std::cos(angle), y, 0.08 * std::sin(angle));
      }
    }
    for (std::uint32_t i = 0; i < 2 * strips; i += 2) {
      made.triangles.push_back({i, i + 1, i + 2});
      made.triangles.push_back({i + 2, i + 1, i + 3});
    }
    return made;
  };
  const auto few = static_cast<double>(cubesOf(tube(60), 110));
  const auto many = static_cast<double>(cubesOf(tube(3000), 110));
  REQUIRE(few > 0.0);
  CHECK(std::abs(many / few - 1.0) < 0.01);
}

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <glm/geometric.hpp>

#include "assets/dummy/body.h"
#include "assets/dummy/dummy.h"
#include "tests/support/assets/dummy_fixture.h"

using namespace stretch;
using namespace stretch::assets;

namespace {

/// Vertices at one place are one vertex: they are doubled where two colours meet.
std::vector<int> weld(const SkinnedMesh& mesh) {
  std::map<std::tuple<double, double, double>, int> places;
  std::vector<int> welded;
  for (const SkinnedVertex& vertex : mesh.vertices) {
    const Vec3& p = vertex.position;
    welded.push_back(places.try_emplace({p.x, p.y, p.z}, static_cast<int>(places.size())).first->second);
  }
  return welded;
}

Vec3 corner(const SkinnedMesh& mesh, const std::array<int, 3>& triangle, std::size_t i) {
  return mesh.vertices[static_cast<std::size_t>(triangle[i])].position;
}

double volume(const SkinnedMesh& mesh) {
  double sum = 0.0;
  for (const auto& triangle : mesh.triangles) {
    sum += glm::dot(corner(mesh, triangle, 0),
                    glm::cross(corner(mesh, triangle, 1), corner(mesh, triangle, 2))) /
           6.0;
  }
  return sum;
}

} // namespace

TEST_CASE("The bundled character is what its program makes, byte for byte") {
  CHECK(writeGlb(makeDummy()) == committedDummy());
}

TEST_CASE("The dummy has five to ten thousand vertices, and every row of weights sums to exactly 1") {
  std::size_t count = 0;
  for (const Part& part : madeDummy().parts) {
    count += part.mesh.vertices.size();
    for (const SkinnedVertex& vertex : part.mesh.vertices) {
      const auto& weights = vertex.influences.weights;
      REQUIRE(weights[0] + weights[1] + weights[2] + weights[3] == 1.0);
      REQUIRE(*std::min_element(weights.begin(), weights.end()) >= 0.0);
    }
  }
  CHECK(count >= 5000);
  CHECK(count <= 10000);
}

TEST_CASE("The dummy's body is one closed surface") {
  const SkinnedMesh& body = madeDummy().parts[0].mesh;
  const std::vector<int> welded = weld(body);
  std::set<std::pair<int, int>> edges;
  for (const auto& triangle : body.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = welded[static_cast<std::size_t>(triangle[i])];
      const int to = welded[static_cast<std::size_t>(triangle[(i + 1) % 3])];
      REQUIRE(from != to);
      REQUIRE(edges.emplace(from, to).second);
    }
  }
  for (const auto& [from, to] : edges) {
    REQUIRE(edges.contains({to, from}));
  }
  CHECK(volume(body) > 0.05);
}

TEST_CASE("No triangle of the dummy's body is degenerate") {
  const SkinnedMesh& body = madeDummy().parts[0].mesh;
  for (const auto& triangle : body.triangles) {
    const Vec3 a = corner(body, triangle, 0);
    const Vec3 b = corner(body, triangle, 1);
    const Vec3 c = corner(body, triangle, 2);
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    const double height = glm::length(glm::cross(b - a, c - a)) / longest;
    REQUIRE(height > 1e-5);
  }
}

TEST_CASE("The dummy stands on the ground, 1.75 m tall, its left on +X") {
  Vec3 low(1e9);
  Vec3 high(-1e9);
  for (const SkinnedVertex& vertex : madeDummy().parts[0].mesh.vertices) {
    low = glm::min(low, vertex.position);
    high = glm::max(high, vertex.position);
  }
  CHECK(low.y == Approx(0.0).margin(0.002));
  CHECK(high.y == Approx(1.75).margin(0.06));
  CHECK(jointPosition(madeDummy().skeleton, "LeftHand").x > 0.4);
}

TEST_CASE("An elbow bent by 120 degrees keeps the arm's volume") {
  const Character& dummy = madeDummy();
  for (const std::string side : {"Left", "Right"}) {
    SkinnedMesh bent = dummy.parts[0].mesh;
    const double straight = volume(bent);
    const int elbow = jointIndex(dummy.skeleton, side + "ForeArm");
    bendJoint(bent, dummy.skeleton, elbow, 120.0);
    // The arm's share, by which the loss is measured: a cylinder as thick as the elbow and as long as the
    // arm.
    const double arm = pi * 0.045 * 0.045 * 0.52;
    CHECK(std::abs(volume(bent) - straight) / arm < 0.08);
  }
}

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/dummy/dummy.h"
#include "core/anim/sampling.h"
#include "tests/support/assets/dummy_fixture.h"

using namespace stretch;
using namespace stretch::assets;

namespace {

const Primitive& bodyOf(const gltf::Loaded& dummy) {
  return dummy.scene->meshes[0].primitives[0];
}

std::vector<Vec3> positionsOf(const Primitive& mesh) {
  return {mesh.positions.begin(), mesh.positions.end()};
}

/// Vertices at one place are one vertex: they are doubled where two colours meet.
std::vector<int> weld(const Primitive& mesh) {
  std::map<std::tuple<float, float, float>, int> places;
  std::vector<int> welded;
  for (const glm::vec3& p : mesh.positions) {
    welded.push_back(places.try_emplace({p.x, p.y, p.z}, static_cast<int>(places.size())).first->second);
  }
  return welded;
}

double volume(const Primitive& mesh, const std::vector<Vec3>& positions) {
  double sum = 0.0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return positions[mesh.indices[i + k]]; };
    sum += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0;
  }
  return sum;
}

} // namespace

TEST_CASE("The bundled characters are what their program makes, byte for byte") {
  const std::vector<BundledFile> files = bundledFiles();
  CHECK(files.size() == 3);
  for (const BundledFile& file : files) {
    CAPTURE(file.name);
    CHECK(writeGlb(file.character) == bundledBytes(file.name));
  }
}

TEST_CASE("The dummy has five to ten thousand vertices, and every row of weights sums to exactly 1") {
  const gltf::Loaded dummy = loadedDummy();
  std::size_t count = 0;
  for (const Primitive& primitive : dummy.scene->meshes[0].primitives) {
    count += primitive.positions.size();
    for (const VertexInfluences& influences : primitive.influences) {
      const auto& weights = influences.weights;
      REQUIRE(weights[0] + weights[1] + weights[2] + weights[3] == 1.0F);
      REQUIRE(*std::min_element(weights.begin(), weights.end()) >= 0.0F);
    }
  }
  CHECK(count >= 5000);
  CHECK(count <= 10000);
}

TEST_CASE("The dummy's body is one closed surface") {
  const gltf::Loaded dummy = loadedDummy();
  const Primitive& body = bodyOf(dummy);
  const std::vector<int> welded = weld(body);
  std::set<std::pair<int, int>> edges;
  for (std::size_t i = 0; i < body.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const int from = welded[body.indices[i]];
    const int to = welded[body.indices[next]];
    REQUIRE(from != to);
    REQUIRE(edges.emplace(from, to).second);
  }
  for (const auto& [from, to] : edges) {
    REQUIRE(edges.contains({to, from}));
  }
  CHECK(volume(body, positionsOf(body)) > 0.05);
}

TEST_CASE("No triangle of the dummy's body is degenerate") {
  const gltf::Loaded dummy = loadedDummy();
  const Primitive& body = bodyOf(dummy);
  for (std::size_t i = 0; i < body.indices.size(); i += 3) {
    const Vec3 a(body.positions[body.indices[i]]);
    const Vec3 b(body.positions[body.indices[i + 1]]);
    const Vec3 c(body.positions[body.indices[i + 2]]);
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    const double height = glm::length(glm::cross(b - a, c - a)) / longest;
    REQUIRE(height > 1e-5);
  }
}

TEST_CASE("The dummy stands on the ground, 1.75 m tall, its left on +X") {
  const gltf::Loaded dummy = loadedDummy();
  Vec3 low(1e9);
  Vec3 high(-1e9);
  for (const Vec3& position : positionsOf(bodyOf(dummy))) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  CHECK(low.y == Approx(0.0).margin(0.002));
  CHECK(high.y == Approx(1.75).margin(0.06));
  const std::vector<Mat4> worlds = worldMatrices(*dummy.scene, restPose(*dummy.scene));
  CHECK(positionOf(worlds[at(nodeNamed(*dummy.scene, "LeftHand"))]).x > 0.4);
}

TEST_CASE("An elbow or knee bent by 120 degrees keeps the limb's volume") {
  const gltf::Loaded dummy = loadedDummy();
  const Primitive& body = bodyOf(dummy);
  const double straight = volume(body, positionsOf(body));
  // The joint's surroundings, by which a loss is measured: a cylinder three radii long on either side.
  struct Bend {
    const char* joint;
    double radius;
  };
  const auto bend = GENERATE(Bend{"LeftForeArm", 0.045}, Bend{"RightForeArm", 0.045}, Bend{"LeftLeg", 0.057},
                             Bend{"RightLeg", 0.057});
  const double around = pi * bend.radius * bend.radius * 6.0 * bend.radius;
  const NodeIndex joint = nodeNamed(*dummy.scene, bend.joint);
  const double change = (volume(body, bent(*dummy.scene, body, joint, 120.0)) - straight) / around;
  CAPTURE(bend.joint, change);
  CHECK(std::abs(change) < 0.12);
}

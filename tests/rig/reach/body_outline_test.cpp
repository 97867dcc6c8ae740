#include "rig/reach/body_outline.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "tests/support/nodes.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// A ball of radius 1 on a node that is turned, scaled and moved: so many vertices that not all are needed.
Scene ball(double size) {
  Scene scene;
  const NodeIndex node = addNode(scene, "ball", NodeIndex::none, Vec3(3.0, 5.0, -2.0));
  scene.nodes[at(node)].rest.rotation = axisAngle(glm::normalize(Vec3(1, 2, 3)), 0.7);
  scene.nodes[at(node)].rest.scale = Vec3(size);
  Primitive primitive;
  Row row(4);
  while (primitive.positions.size() < 4000) {
    const Vec3 point = row.vector(1.0);
    const double length = glm::length(point);
    if (length > 0.1 && length < 1.0) {
      primitive.positions.emplace_back(point / length);
    }
  }
  scene.nodes[at(node)].mesh = 0;
  scene.meshes.push_back({"ball", {primitive}, {}});
  return scene;
}

} // namespace

TEST_CASE("an outline of few points reaches nearly as far as the mesh in every direction") {
  const double size = GENERATE(1.0, 0.02);
  const Scene scene = ball(size);
  const BodyOutline outline = outlineOf(scene);
  REQUIRE(outline.points.size() == 1);
  const std::vector<Vec3>& points = outline.points.front();
  CHECK(points.size() < 1000);
  Row row(8);
  for (int i = 0; i < 200; ++i) {
    const Vec3 direction = glm::normalize(row.vector(1.0));
    double reach = 0.0;
    for (const Vec3& point : points) {
      reach = std::max(reach, glm::dot(point, direction));
    }
    CAPTURE(direction.x, direction.y, direction.z);
    CHECK(reach > 0.92);
    CHECK(reach < 1.0 + 1e-6);
  }
  const FrameState frame = frameOf(scene, restPose(scene), 0.0);
  const std::optional<double> lowest = lowestOf(outline, {NodeIndex(0)}, frame);
  REQUIRE(lowest);
  CHECK(*lowest == Approx(5.0 - size).margin(0.05 * size));
  CHECK_FALSE(lowestOf(outline, {}, frame));
  CHECK(outlined(outline, {NodeIndex(0)}) == std::vector<NodeIndex>{NodeIndex(0)});
}

TEST_CASE("a mesh on a node that is scaled to nothing has no outline") {
  const BodyOutline outline = outlineOf(ball(0.0));
  CHECK(outline.points.front().empty());
  CHECK(outlined(outline, {NodeIndex(0)}).empty());
}

TEST_CASE("a vertex that alone sticks out of a mesh is in its outline, the first and the last as well") {
  Scene scene = ball(1.0);
  std::vector<glm::vec3>& vertices = scene.meshes.front().primitives.front().positions;
  const std::size_t lone = GENERATE_COPY(std::size_t{0}, std::size_t{1}, vertices.size() - 1);
  vertices[lone] = {0.0F, 4.0F, 0.0F};
  const std::vector<Vec3> points = outlineOf(scene).points.front();
  CHECK(std::ranges::any_of(points,
                            [](const Vec3& point) { return glm::length(point - Vec3(0, 4, 0)) < 1e-5; }));
}

TEST_CASE("a part of the body is as low as its stretched mesh") {
  Scene scene;
  const NodeIndex bone = addNode(scene, "bone", NodeIndex::none, Vec3(0.0, 5.0, 0.0));
  Primitive primitive;
  primitive.positions = {{0.0F, -1.0F, 0.0F}, {0.2F, 0.5F, 0.0F}, {0.0F, 0.5F, 0.2F}};
  scene.nodes[at(bone)].mesh = 0;
  scene.meshes.push_back({"bone", {primitive}, {}});
  const BodyOutline outline = outlineOf(scene);
  FrameState frame = frameOf(scene, restPose(scene), 0.0);
  CHECK(lowestOf(outline, {bone}, frame).value() == Approx(4.0));
  frame.stretch.assign(1, Mat3(1.0));
  frame.stretch[0][1][1] = 3.0;
  CHECK(lowestOf(outline, {bone}, frame).value() == Approx(2.0));
}

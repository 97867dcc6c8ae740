#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/support/row.h"
#include "ui/render/picking/picking.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

// Looks along -Z from (0, 0, 10); one unit at the origin is 100 pixels.
View straightView(double pixelsPerPoint = 1.0) {
  Camera camera;
  camera.target = Vec3(0.0);
  camera.distance = 10.0;
  camera.projection = ProjectionKind::orthographic;
  camera.fieldOfViewRadians = 2.0 * std::atan(0.4);
  return makeView(camera, {800.0, 800.0, pixelsPerPoint});
}

Vec2 pixelsOf(const View& view, const Vec3& point) {
  return projectToPixels(view, point)->pixels;
}

} // namespace

TEST_CASE("A sphere takes the mouse up to 20 points away and no farther") {
  const View view = straightView();
  const std::vector<Vec3> spheres{{0.0, 0.0, 0.0}};
  CHECK(pickSphere(view, spheres, {419.9, 400.0}) == 0U);
  CHECK_FALSE(pickSphere(view, spheres, {420.1, 400.0}));
}

TEST_CASE("The hit radius of a sphere grows with the display scale") {
  const std::vector<Vec3> spheres{{0.0, 0.0, 0.0}};
  CHECK(pickSphere(straightView(2.0), spheres, {439.0, 400.0}) == 0U);
  CHECK_FALSE(pickSphere(straightView(2.0), spheres, {441.0, 400.0}));
}

TEST_CASE("Of spheres apart on the screen the nearest to the mouse is picked") {
  const View view = straightView();
  const std::vector<Vec3> spheres{{0.0, 0.0, 5.0}, {0.25, 0.0, 0.0}};
  CHECK(pickSphere(view, spheres, {416.0, 400.0}) == 1U);
  CHECK(pickSphere(view, spheres, {408.0, 400.0}) == 0U);
}

TEST_CASE("Of crowded spheres the one that is seen under the mouse is picked") {
  const View view = straightView();
  const std::vector<Vec3> spheres{{0.0, 0.0, 0.0}, {0.04, 0.0, 2.0}, {0.08, 0.0, -2.0}};
  CHECK(pickSphere(view, spheres, pixelsOf(view, spheres[0])) == 1U);
  CHECK(pickSphere(view, spheres, pixelsOf(view, spheres[0]) - Vec2(6.0, 0.0)) == 0U);
}

TEST_CASE("A sphere behind the eye is never picked") {
  Camera camera;
  camera.target = Vec3(0.0);
  const View view = makeView(camera, {800.0, 800.0, 1.0});
  const std::vector<Vec3> spheres{view.eye - view.forward};
  CHECK_FALSE(pickSphere(view, spheres, {400.0, 400.0}));
}

TEST_CASE("Axis handles keep their length on the screen and are hit along it") {
  Camera camera;
  camera.yawRadians = 0.6;
  camera.pitchRadians = 0.4;
  camera.distance = GENERATE(0.5, 5.0, 500.0);
  const View view = makeView(camera, {800.0, 800.0, 1.0});
  AxisHandles handles;
  handles.origin = camera.target;
  const std::array<Vec3, 3> tips = handleTips(view, handles);
  const Vec2 origin = pixelsOf(view, handles.origin);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec2 tip = pixelsOf(view, tips[axis]);
    CHECK(glm::length(tip - origin) > 20.0);
    CHECK(glm::length(tip - origin) < 1.1 * handles.lengthPoints);
    CHECK(pickAxis(view, handles, origin + 0.7 * (tip - origin)) == axis);
  }
  CHECK_FALSE(pickAxis(view, handles, origin + Vec2(150.0, 150.0)));
}

TEST_CASE("An axis that points at the viewer cannot be hit, and the origin belongs to no axis") {
  const View view = straightView();
  CHECK_FALSE(pickAxis(view, AxisHandles{}, {400.0, 400.0}));
  CHECK(pickAxis(view, AxisHandles{}, {460.0, 400.0}) == 0U);
  CHECK(pickAxis(view, AxisHandles{}, {400.0, 340.0}) == 1U);
}

TEST_CASE("The hit on a polyline names segment, fraction and point") {
  const View view = straightView();
  const std::vector<Vec3> line{{-2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  const auto hit = pickPolyline(view, line, {450.0, 404.0});
  REQUIRE(hit);
  CHECK(hit->segment == 1U);
  CHECK(hit->fraction == Approx(0.25));
  CHECK(hit->pointWorld.x == Approx(0.5));
  CHECK(hit->distancePixels == Approx(4.0));
  CHECK_FALSE(pickPolyline(view, line, {450.0, 411.0}));
  CHECK_FALSE(pickPolyline(view, std::vector<Vec3>{{0.0, 0.0, 0.0}}, {400.0, 400.0}));
}

TEST_CASE("A hit on a polyline in perspective lies under the mouse") {
  Camera camera;
  camera.target = Vec3(0.0);
  const View view = makeView(camera, {800.0, 800.0, 1.0});
  const std::vector<Vec3> line{{-1.0, 0.2, -6.0}, {0.8, 0.3, 3.0}};
  const Vec2 expected = pixelsOf(view, line[0] + 0.4 * (line[1] - line[0]));
  const auto hit = pickPolyline(view, line, expected);
  REQUIRE(hit);
  CHECK(hit->fraction == Approx(0.4));
}

TEST_CASE("Of bones that cross on the screen the front one is picked, else the nearest") {
  const View view = straightView();
  const std::vector<BoneSegment> bones{{NodeIndex(3), {-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}},
                                       {NodeIndex(7), {0.0, -1.0, 1.0}, {0.0, 1.0, 1.0}},
                                       {NodeIndex(9), {-1.0, 0.5, -1.0}, {1.0, 0.5, -1.0}}};
  CHECK(pickBone(view, bones, {401.0, 400.0}) == 1U);
  CHECK(pickBone(view, bones, {470.0, 402.0}) == 0U);
  CHECK(pickBone(view, bones, {470.0, 352.0}) == 2U);
  CHECK_FALSE(pickBone(view, bones, {470.0, 375.0}));
}

TEST_CASE("Of pieces of a line that are all within reach the nearest is hit, and none beyond the reach") {
  const View view = straightView();
  // Comes down to 5 pixels above the middle, then to 2 pixels below it, then leaves.
  const std::vector<Vec3> line{{-0.5, 0.05, 0.0}, {0.5, 0.05, 0.0}, {0.5, -0.02, 0.0}, {-0.5, -0.02, 0.0}};
  const auto hit = pickPolyline(view, line, {400.0, 400.0});
  REQUIRE(hit);
  CHECK(hit->segment == 2);
  CHECK(hit->fraction == Approx(0.5).margin(1e-6));
  CHECK(hit->distancePixels == Approx(2.0).margin(0.01));
  const std::vector<Vec3> turned(line.rbegin(), line.rend());
  CHECK(pickPolyline(view, turned, {400.0, 400.0})->segment == 0);
  CHECK(pickPolyline(view, line, {400.0, 384.9})->segment == 0);
  CHECK_FALSE(pickPolyline(view, line, {400.0, 384.0}));
  CHECK_FALSE(pickPolyline(view, std::vector<Vec3>{{0.0, 0.0, 0.0}}, {400.0, 400.0}));
}

TEST_CASE("Everything is picked alike on a display of twice the scale") {
  const View view = straightView();
  Camera camera;
  camera.target = Vec3(0.0);
  camera.distance = 10.0;
  camera.projection = ProjectionKind::orthographic;
  camera.fieldOfViewRadians = 2.0 * std::atan(0.4);
  const View doubled = makeView(camera, {1600.0, 1600.0, 2.0});
  test::Row row(91);
  std::size_t picked = 0;
  for (int round = 0; round < 400; ++round) {
    std::vector<Vec3> spheres;
    std::vector<BoneSegment> bones;
    for (std::size_t i = 0; i < 6; ++i) {
      spheres.push_back(row.vector(0.2));
      bones.push_back({NodeIndex(i), row.vector(0.3), row.vector(0.3)});
    }
    const AxisHandles handles{row.vector(0.2)};
    const Vec2 mouse(400.0 + row.around(60.0), 400.0 + row.around(60.0));
    CAPTURE(round);
    CHECK(pickSphere(view, spheres, mouse) == pickSphere(doubled, spheres, 2.0 * mouse));
    CHECK(pickBone(view, bones, mouse) == pickBone(doubled, bones, 2.0 * mouse));
    CHECK(pickAxis(view, handles, mouse) == pickAxis(doubled, handles, 2.0 * mouse));
    const auto hit = pickPolyline(view, spheres, mouse);
    const auto hitDoubled = pickPolyline(doubled, spheres, 2.0 * mouse);
    REQUIRE(hit.has_value() == hitDoubled.has_value());
    if (hit) {
      CHECK(hit->segment == hitDoubled->segment);
      CHECK(2.0 * hit->distancePixels == Approx(hitDoubled->distancePixels));
    }
    picked += pickBone(view, bones, mouse) ? 1 : 0;
  }
  CHECK(picked > 100);
}

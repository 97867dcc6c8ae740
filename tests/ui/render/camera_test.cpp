#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>

#include "ui/render/view/camera.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

const Viewport wide{1280.0, 720.0, 1.0};

Camera someCamera(ProjectionKind projection) {
  Camera camera;
  camera.target = {0.3, 1.1, -0.2};
  camera.distance = 3.5;
  camera.yawRadians = 0.7;
  camera.pitchRadians = -0.3;
  camera.projection = projection;
  return camera;
}

double pixelsBetween(const View& view, const Vec3& a, const Vec3& b) {
  return glm::length(projectToPixels(view, a)->pixels - projectToPixels(view, b)->pixels);
}

Box unitBody() {
  Box box;
  box.add({-0.4, 0.0, -0.2});
  box.add({0.4, 1.8, 0.2});
  return box;
}

} // namespace

TEST_CASE("The target of a camera lies in the middle of the viewport") {
  const ProjectionKind projection = GENERATE(ProjectionKind::perspective, ProjectionKind::orthographic);
  const Camera camera = someCamera(projection);
  const auto centre = projectToPixels(makeView(camera, wide), camera.target);
  REQUIRE(centre);
  CHECK(centre->pixels.x == Approx(640.0));
  CHECK(centre->pixels.y == Approx(360.0));
  CHECK(centre->depth == Approx(3.5));
}

TEST_CASE("The front view shows the character's left (+X) on the right and up on top") {
  const Camera front = lookFrom({}, ViewDirection::front);
  const View view = makeView(front, wide);
  const Vec2 middle = projectToPixels(view, front.target)->pixels;
  CHECK(projectToPixels(view, front.target + Vec3(0.1, 0, 0))->pixels.x > middle.x + 1.0);
  CHECK(projectToPixels(view, front.target + Vec3(0, 0.1, 0))->pixels.y < middle.y - 1.0);
  CHECK(view.forward.z == Approx(-1.0));
}

TEST_CASE("A character that faces -Z is seen from -Z in its front view") {
  CHECK(makeView(lookFrom({}, ViewDirection::front, pi), wide).forward.z == Approx(1.0));
}

TEST_CASE("The top view looks straight down with the front of the character at the bottom") {
  const Camera top = lookFrom({}, ViewDirection::top);
  const View view = makeView(top, wide);
  CHECK(view.forward.y == Approx(-1.0));
  CHECK(projectToPixels(view, top.target + Vec3(0, 0, 0.1))->pixels.y > 361.0);
}

TEST_CASE("The ray through a pixel meets the point that was projected there") {
  const ProjectionKind projection = GENERATE(ProjectionKind::perspective, ProjectionKind::orthographic);
  const View view = makeView(someCamera(projection), wide);
  const Vec3 point(0.9, 1.6, 0.4);
  const Ray ray = rayThroughPixel(view, projectToPixels(view, point)->pixels);
  const Vec3 offset = point - ray.origin;
  CHECK(glm::length(offset - glm::dot(offset, ray.direction) * ray.direction) < 1e-9);
  CHECK(glm::dot(offset, ray.direction) > 0.0);
}

TEST_CASE("Nothing behind a perspective eye is projected") {
  const Camera camera = someCamera(ProjectionKind::perspective);
  const View view = makeView(camera, wide);
  CHECK_FALSE(projectToPixels(view, view.eye - 0.5 * view.forward));
  CHECK_FALSE(projectToPixels(view, view.eye));
}

TEST_CASE("unitsPerPixel moves a point by one pixel") {
  const ProjectionKind projection = GENERATE(ProjectionKind::perspective, ProjectionKind::orthographic);
  const View view = makeView(someCamera(projection), wide);
  const Vec3 point(0.4, 0.6, 0.5);
  CHECK(pixelsBetween(view, point, point + unitsPerPixel(view, point) * viewUp(view)) == Approx(1.0));
  CHECK(pixelsBetween(view, point, point + unitsPerPixel(view, point) * viewRight(view)) == Approx(1.0));
}

TEST_CASE("Changing between perspective and orthographic keeps sizes at the target") {
  const Camera perspective = someCamera(ProjectionKind::perspective);
  const Camera orthographic = someCamera(ProjectionKind::orthographic);
  CHECK(unitsPerPixel(makeView(perspective, wide), perspective.target) ==
        Approx(unitsPerPixel(makeView(orthographic, wide), orthographic.target)));
}

TEST_CASE("Panning keeps the grabbed point under the mouse") {
  const Camera camera = someCamera(ProjectionKind::perspective);
  const Camera moved = panned(camera, wide, {50.0, -30.0});
  const Vec2 pixels = projectToPixels(makeView(moved, wide), camera.target)->pixels;
  CHECK(pixels.x == Approx(690.0));
  CHECK(pixels.y == Approx(330.0));
}

TEST_CASE("Zooming keeps the point under the mouse where it is") {
  const ProjectionKind projection = GENERATE(ProjectionKind::perspective, ProjectionKind::orthographic);
  const Camera camera = someCamera(projection);
  const Vec2 mouse(200.0, 500.0);
  const Vec3 under = pointInViewPlane(makeView(camera, wide), camera.target, mouse);
  const Camera closer = zoomed(camera, wide, 0.5, mouse);
  CHECK(closer.distance == Approx(1.75));
  const Vec2 after = projectToPixels(makeView(closer, wide), under)->pixels;
  CHECK(after.x == Approx(mouse.x));
  CHECK(after.y == Approx(mouse.y));
}

TEST_CASE("Orbiting stops at the poles and keeps target and distance") {
  const Camera camera = someCamera(ProjectionKind::perspective);
  const Camera above = orbited(camera, wide, {0.0, 1e6});
  CHECK(above.pitchRadians == Approx(0.5 * pi));
  CHECK(above.target == camera.target);
  CHECK(above.distance == camera.distance);
  CHECK(glm::length(viewUp(makeView(above, wide))) == Approx(1.0));
  CHECK(orbited(camera, wide, {0.0, -1e6}).pitchRadians == Approx(-0.5 * pi));
}

TEST_CASE("A fitted box fills the viewport and stays inside it") {
  const ViewDirection direction =
      GENERATE(ViewDirection::front, ViewDirection::side, ViewDirection::top, ViewDirection::threeQuarter);
  const double margin = 0.1;
  const Box box = unitBody();
  const View view = makeView(fitted(lookFrom({}, direction), wide, box, margin), wide);
  Vec2 largest(0.0);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 point((corner & 1U) != 0 ? box.maximum.x : box.minimum.x,
                     (corner & 2U) != 0 ? box.maximum.y : box.minimum.y,
                     (corner & 4U) != 0 ? box.maximum.z : box.minimum.z);
    const Vec2 pixels = projectToPixels(view, point)->pixels;
    largest.x = std::max(largest.x, std::abs(pixels.x / 1280.0 - 0.5));
    largest.y = std::max(largest.y, std::abs(pixels.y / 720.0 - 0.5));
  }
  CHECK(std::max(largest.x, largest.y) == Approx(0.5 - margin).epsilon(1e-6));
}

TEST_CASE("Fitting nothing changes nothing, fitting a point still gives a usable distance") {
  const Camera camera = someCamera(ProjectionKind::perspective);
  CHECK(fitted(camera, wide, Box{}) == camera);
  Box point;
  point.add({1.0, 2.0, 3.0});
  CHECK(fitted(camera, wide, point).distance == 1.0);
}

TEST_CASE("A viewport without area is treated as one pixel") {
  const View view = makeView(someCamera(ProjectionKind::perspective), {0.0, 0.0, 1.0});
  CHECK(std::isfinite(view.projection[0][0]));
  CHECK(std::isfinite(unitsPerPixel(view, {0.0, 0.0, 0.0})));
}

TEST_CASE("Dragging along an axis follows the mouse") {
  const View view = makeView(someCamera(ProjectionKind::perspective), wide);
  const Vec3 origin(0.2, 1.0, 0.1);
  const Vec3 axis(0.0, 1.0, 0.0);
  const Vec2 pixels = projectToPixels(view, origin + 0.37 * axis)->pixels;
  CHECK(positionAlongAxis(view, origin, axis, pixels) == Approx(0.37));
  CHECK(positionAlongAxis(view, origin, rayThroughPixel(view, {640.0, 360.0}).direction, {640.0, 360.0}) ==
        0.0);
}

TEST_CASE("A camera that looks straight down from a place whose direction is rounded has an angle") {
  CHECK(lookingFrom({}, {0.0, 1.0 + 1e-12, 0.0}).pitchRadians == Approx(0.5 * pi));
  CHECK(lookingFrom({}, {0.0, -1.0 - 1e-12, 0.0}).pitchRadians == Approx(-0.5 * pi));
}

TEST_CASE("Zooming ends before the distance is nothing, and before it is without end") {
  const Camera camera = someCamera(ProjectionKind::perspective);
  CHECK(zoomed(camera, wide, 1e-12, {640.0, 360.0}).distance == 1e-6);
  CHECK(zoomed(camera, wide, 1e12, {640.0, 360.0}).distance == 1e9);
}

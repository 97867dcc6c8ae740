#include "ui/render/picture/controller_handles.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "ui/render/overlay/controller_drawing.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

View seenFrom(double distance, double pixelsPerPoint = 1.0) {
  Camera camera;
  camera.target = Vec3(0.0);
  camera.distance = distance;
  camera.yawRadians = 0.6;
  camera.pitchRadians = 0.5;
  return makeView(camera, {1600.0, 1600.0, pixelsPerPoint});
}

Vec2 screenPlace(const View& view, const Vec3& point) {
  return projectToPixels(view, point)->pixels;
}

double pixelLength(const View& view, const ControllerHandles& handles, const HandlePart& part) {
  const std::vector<Vec3> points = pointsOf(view, handles, part);
  return glm::distance(screenPlace(view, points.front()), screenPlace(view, points[points.size() / 2]));
}

} // namespace

TEST_CASE("Handles of a controller keep their size on the screen at any distance, and grow with its scale") {
  const ControllerHandles handles;
  for (const HandlePart& part : partsOf(handles)) {
    const double near = pixelLength(seenFrom(2.0), handles, part);
    CHECK(pixelLength(seenFrom(40.0), handles, part) == Approx(near).epsilon(0.1));
    CHECK(pixelLength(seenFrom(40.0, 2.0), handles, part) == Approx(2.0 * near).epsilon(0.1));
  }
}

TEST_CASE("In a small picture the handles are small enough to be seen whole") {
  const Camera camera{.target = Vec3(0.0), .distance = 5.0};
  const View view = makeView(camera, {480.0, 250.0, 2.0});
  for (const HandlePart& part : partsOf({})) {
    for (const Vec3& point : pointsOf(view, {}, part)) {
      const Vec2 place = screenPlace(view, point);
      CHECK((place.x > 0.0 && place.x < 480.0 && place.y > 0.0 && place.y < 250.0));
    }
  }
}

TEST_CASE("While a handle is held the others step back, and the far half of a ring always does") {
  const View view = seenFrom(5.0);
  const auto alphas = [](const Polyline& line) {
    const auto [least, most] =
        std::minmax_element(line.points.begin(), line.points.end(),
                            [](const LinePoint& a, const LinePoint& b) { return a.color.a < b.color.a; });
    return std::pair(least->color.a, most->color.a);
  };
  // For each axis its ring, then its square; then the arrows.
  const Overlay free = drawControllerHandles(view, {}, std::nullopt);
  REQUIRE((free.lines.size() == 6 && free.arrows.size() == 3));
  CHECK(alphas(free.lines[0]).second == 1.0F);
  CHECK(alphas(free.lines[0]).first == Approx(0.22));
  CHECK(alphas(free.lines[1]).first == 1.0F); // A square has no far half.
  CHECK(free.arrows[0].color.a == 1.0F);
  const Overlay ring = drawControllerHandles(view, {}, HandlePart{HandleKind::ring, 1});
  CHECK(alphas(ring.lines[2]).second == 1.0F);
  CHECK(ring.lines[2].points.front().widthPoints > ring.lines[0].points.front().widthPoints);
  CHECK(alphas(ring.lines[0]).second == Approx(0.45));
  CHECK(alphas(ring.lines[3]).second == Approx(0.45));
  CHECK(ring.arrows[1].color.a == Approx(0.45));
  const Overlay arrow = drawControllerHandles(view, {}, HandlePart{HandleKind::axis, 2});
  CHECK(arrow.arrows[2].color.a == 1.0F);
  CHECK(arrow.arrows[2].headPoints > arrow.arrows[0].headPoints);
  CHECK(arrow.arrows[0].color.a == Approx(0.45));
  CHECK(alphas(arrow.lines[4]).second == Approx(0.45)); // The ring about the same axis.
}

TEST_CASE("A controller has handles only for what it can do") {
  const auto count = [](bool moves, bool turns) { return partsOf({Vec3(0.0), moves, turns}).size(); };
  CHECK(count(true, true) == 9);
  CHECK(count(true, false) == 6);
  CHECK(count(false, true) == 3);
  const View view = seenFrom(5.0);
  const ControllerHandles turning{Vec3(0.0), false, true};
  const ControllerHandles both;
  const Vec2 onArrow = screenPlace(view, pointsOf(view, both, {HandleKind::axis, 0})[1]);
  CHECK(pickHandle(view, both, onArrow) == HandlePart{HandleKind::axis, 0});
  CHECK_FALSE(pickHandle(view, turning, onArrow));
}

TEST_CASE("The mouse takes the arrow, square or near half of a ring that it is on") {
  const View view = seenFrom(5.0);
  const ControllerHandles handles;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<Vec3> square = pointsOf(view, handles, {HandleKind::plane, axis});
    CHECK(pickHandle(view, handles, screenPlace(view, 0.5 * (square[0] + square[2]))) ==
          HandlePart{HandleKind::plane, axis});
    const std::vector<Vec3> ring = pointsOf(view, handles, {HandleKind::ring, axis});
    const auto nearer = [&](const Vec3& p, const Vec3& q) {
      return glm::distance(view.eye, p) < glm::distance(view.eye, q);
    };
    const auto [nearest, farthest] = std::minmax_element(ring.begin(), ring.end(), nearer);
    CHECK(pickHandle(view, handles, screenPlace(view, *nearest)) == HandlePart{HandleKind::ring, axis});
    CHECK(pickHandle(view, handles, screenPlace(view, *farthest)) != HandlePart{HandleKind::ring, axis});
  }
  CHECK_FALSE(pickHandle(view, handles, {5.0, 5.0}));
}

TEST_CASE(
    "Controllers are thin lines of one width with an edge, the one under the mouse is thicker and last") {
  ControllerPicture left;
  left.lines = {{Vec3(0.0), Vec3(1.0)}};
  left.side = BodySide::left;
  left.hovered = true;
  ControllerPicture right;
  right.lines = {{Vec3(2.0), Vec3(3.0)}};
  right.side = BodySide::right;
  const ControllerStyle style = controllerStyle(darkPalette());
  const Overlay overlay = drawControllers(seenFrom(5.0), std::vector<ControllerPicture>{left, right}, style);
  REQUIRE(overlay.lines.size() == 2);
  CHECK(overlay.lines[0].points.front().world == Vec3(2.0));
  CHECK(overlay.lines[0].points.front().color == style.right);
  CHECK(overlay.lines[0].points.front().widthPoints == style.widthPoints);
  CHECK(overlay.lines[0].outlined);
  CHECK(overlay.lines[0].depth == OverlayDepth::faded);
  CHECK(overlay.lines[1].points.front().widthPoints > style.widthPoints);
}

TEST_CASE("Rings of joints that stand close together shrink from afar, but not the one that is meant") {
  ControllerPicture finger;
  finger.ring = Vec3(0.0);
  finger.ringRoom = 0.02;
  ControllerPicture meant = finger;
  meant.hovered = true;
  const ControllerStyle style = controllerStyle(darkPalette());
  const auto radius = [&](const ControllerPicture& picture, double distance) {
    const std::vector<ControllerPicture> one{picture};
    return drawControllers(seenFrom(distance), one, style).markers.front().radiusPoints;
  };
  CHECK(radius(finger, 100.0) == style.leastRingPoints);
  CHECK(radius(finger, 0.05) == style.ringPoints);
  CHECK(radius(finger, 3.0) > radius(finger, 100.0));
  CHECK(radius(meant, 100.0) == style.ringPoints);
}

TEST_CASE("Sides of the body differ in colour in every theme") {
  for (const Palette& palette : {darkPalette(), lightPalette(), highContrastPalette()}) {
    const ControllerStyle style = controllerStyle(palette);
    CHECK(glm::length(style.left - style.right) > 0.4F);
    CHECK(glm::length(style.left - style.centre) > 0.4F);
    CHECK(glm::length(style.right - style.centre) > 0.4F);
  }
}

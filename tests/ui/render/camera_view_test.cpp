#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "core/math/transform.h"
#include "ui/render/picture/image_edits.h"
#include "ui/render/view/camera_view.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

constexpr Viewport wideWindow{1600.0, 900.0, 1.0};

ThroughCamera looking(CameraKind kind, double aspect) {
  ThroughCamera through;
  through.lens.kind = kind;
  through.lens.fieldOfViewRadians = 0.6;
  through.lens.halfHeight = 2.0;
  through.lens.aspect = aspect;
  const Mat4 world = toMatrix({Vec3(3.0, 1.0, 2.0), axisAngle(Vec3(0.0, 1.0, 0.0), 0.7), Vec3(1.0)});
  through.place = cameraPlace(kind, world).value();
  through.reach = 4.0;
  return through;
}

// Where a point lies in the camera's own picture: -1 to 1 across and up.
Vec2 inOwnPicture(const ThroughCamera& through, const Vec3& point) {
  const Vec2 place = inPicture(through.place, point).value();
  const double half = through.lens.kind == CameraKind::perspective ? std::tan(0.3) : through.lens.halfHeight;
  return {place.x / (half * through.lens.aspect.value()), place.y / half};
}

} // namespace

TEST_CASE("through the file's camera a point lies in the picture where the camera has it, whatever the "
          "window's shape") {
  for (const CameraKind kind : {CameraKind::perspective, CameraKind::orthographic}) {
    for (const double aspect : {0.5, 16.0 / 9.0, 3.0}) {
      CAPTURE(static_cast<int>(kind), aspect);
      const ThroughCamera through = looking(kind, aspect);
      const View view = viewThrough(through, wideWindow);
      const PixelBox frame = frameIn(wideWindow, aspect);
      const Vec3 point = through.place.position + 4.0 * through.place.forward + 0.3 * through.place.right +
                         0.2 * through.place.up;
      const Vec2 own = inOwnPicture(through, point);
      const Vec2 pixels = projectToPixels(view, point).value().pixels;
      const Vec2 size = frame.high - frame.low;
      CHECK(pixels.x == Approx(frame.low.x + 0.5 * (1.0 + own.x) * size.x));
      CHECK(pixels.y == Approx(frame.low.y + 0.5 * (1.0 - own.y) * size.y));
      CHECK(size.x / size.y == Approx(aspect));
      CHECK((frame.low.x >= 0.0 && frame.low.y >= 0.0 && frame.high.x <= 1600.0 && frame.high.y <= 900.0));
      CHECK(placeOf(view).kind == kind);
      CHECK(glm::length(placeOf(view).position - through.place.position) < 1e-9);
      CHECK(glm::length(placeOf(view).forward - through.place.forward) < 1e-9);
      CHECK(glm::length(placeOf(view).right - through.place.right) < 1e-9);
    }
  }
}

TEST_CASE("a camera without a shape of its own shows as much above and below in a window of any shape") {
  for (const CameraKind kind : {CameraKind::perspective, CameraKind::orthographic}) {
    ThroughCamera through = looking(kind, 1.0);
    through.lens.aspect.reset();
    const double half = kind == CameraKind::perspective ? 4.0 * std::tan(0.3) : 2.0;
    const Vec3 top = through.place.position + 4.0 * through.place.forward + half * through.place.up;
    for (const Viewport& window : {wideWindow, Viewport{900.0, 1600.0, 1.0}}) {
      CHECK(projectToPixels(viewThrough(through, window), top)->pixels.y == Approx(0.0).margin(1e-6));
    }
  }
}

TEST_CASE("the safe frame is the middle of the picture, and all of the window's where there is no camera") {
  const PixelBox safe = frameIn(wideWindow, std::nullopt, 0.9);
  CHECK(glm::length(safe.low - Vec2(80.0, 45.0)) < 1e-9);
  CHECK(glm::length(safe.high - Vec2(1520.0, 855.0)) < 1e-9);
}

TEST_CASE("taking the hand to a file's camera begins where it stands, as far as one without roll can") {
  const ThroughCamera through = looking(CameraKind::perspective, 1.0);
  const View free = makeView(orbitingFrom(through), wideWindow);
  CHECK(glm::length(free.eye - through.place.position) < 1e-9);
  CHECK(glm::length(free.forward - through.place.forward) < 1e-9);
  CHECK(orbitingFrom(through).fieldOfViewRadians == 0.6);
  const ThroughCamera flat = looking(CameraKind::orthographic, 1.0);
  const Vec3 above = flat.place.position + flat.place.up;
  CHECK(projectToPixels(makeView(orbitingFrom(flat), wideWindow), above)->pixels.y ==
        Approx(projectToPixels(viewThrough(flat, wideWindow), above)->pixels.y));
}

TEST_CASE("a rectangle is outlined inside the picture, one pixel thick, and cut off outside") {
  Image image = filled(40, 30, glm::vec3(0.0F));
  outline(image, {{10.0, 5.0}, {60.0, 25.0}}, glm::vec3(1.0F));
  const auto red = [&](int x, int y) { return image.rgba[4 * static_cast<std::size_t>(y * 40 + x)]; };
  CHECK(red(10, 5) == 255);
  CHECK(red(39, 5) == 255);
  CHECK(red(10, 24) == 255);
  CHECK(red(11, 6) == 0);
  CHECK(red(9, 5) == 0);
  CHECK(red(39, 15) == 0);
}

TEST_CASE("an outline is two pixels thick in a picture of 1080 lines, and is cut off at the left as well") {
  const auto redOf = [](const Image& image, int x, int y) {
    return image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
  };
  Image tall = filled(8, 1080, glm::vec3(0.0F));
  outline(tall, {{1.0, 10.0}, {7.0, 500.0}}, glm::vec3(1.0F));
  CHECK(redOf(tall, 3, 11) == 255);
  CHECK(redOf(tall, 3, 12) == 0);
  Image cut = filled(40, 30, glm::vec3(0.0F));
  outline(cut, {{-5.0, 5.0}, {20.0, 25.0}}, glm::vec3(1.0F));
  CHECK(redOf(cut, 0, 5) == 255);
  CHECK(redOf(cut, 19, 10) == 255);
  CHECK(redOf(cut, 0, 10) == 0);
  CHECK(redOf(cut, 35, 4) == 0); // Nothing runs on from one line into the one before.
}

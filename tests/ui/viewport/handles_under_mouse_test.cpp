// Arrows, squares and rings of a controller under the mouse.
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/ui/controllers_under_mouse.h"
#include "ui/viewport/tools.h"

using namespace stretch;
using namespace stretch::ui;
using test::ControllersUnderMouse;

TEST_CASE("Handles of a controller are marked while the mouse is on them, and let go of when it leaves") {
  ControllersUnderMouse stage;
  stage.clickAt(stage.placeOf("left-hand"));
  const auto handles = controllerHandles(stage.session(), stage.viewport.controllers);
  REQUIRE(handles);
  const Vec2 at = stage.pixelsOf(stage.placeOf("left-hand"));
  Vec2 onHandle = at;
  for (double up = 20.0; up < 90.0 && !stage.viewport.hoveredHandle; up += 2.0) {
    onHandle = at - Vec2(0.0, up);
    stage.pointAt(onHandle);
  }
  REQUIRE(stage.viewport.hoveredHandle);
  CHECK(stage.viewport.hoveredHandle->axis == 1);
  stage.pointAt(Vec2(60.0, 560.0));
  CHECK_FALSE(stage.viewport.hoveredHandle);
  stage.pointAt(onHandle);
  stage.over = false;
  stage.frame();
  CHECK_FALSE(stage.viewport.hoveredHandle);
  CHECK(stage.viewport.hoveredController.empty());
}

TEST_CASE("An arrow of a controller moves it along its axis only") {
  ControllersUnderMouse stage;
  stage.clickAt(stage.placeOf("left-hand"));
  const Vec3 before = stage.placeOf("left-hand");
  const Vec2 at = stage.pixelsOf(before);
  for (double up = 30.0; up < 90.0; up += 2.0) {
    stage.pointAt(at - Vec2(0.0, up));
    if (stage.viewport.hoveredHandle && stage.viewport.hoveredHandle->kind == HandleKind::axis) {
      break;
    }
  }
  REQUIRE(stage.viewport.hoveredHandle);
  REQUIRE(stage.viewport.hoveredHandle->kind == HandleKind::axis);
  const Vec2 from = stage.viewport.mousePixels;
  stage.drag(from, from + Vec2(25.0, 30.0));
  const Vec3 moved = stage.placeOf("left-hand") - before;
  CHECK(moved.x == Approx(0.0).margin(1e-6));
  CHECK(moved.z == Approx(0.0).margin(1e-6));
  CHECK(glm::distance(stage.pixelsOf(before + moved), at) == Approx(30.0).margin(1.0));
  CHECK(moved.y < 0.0);
}

TEST_CASE(
    "Each handle moves or turns along the world's axes, however what carries the hand is turned, and stays "
    "marked while it is held") {
  ControllersUnderMouse stage;
  app::selectController(stage.session(), "spine-top", false);
  REQUIRE(startControllerTool(stage.session(), stage.tool, {app::PullMotion::turn, {}, {}, false}));
  for (const char* const key : {"Y", "4", "0", "Enter"}) {
    REQUIRE(pressToolKey(stage.session(), stage.tool, {*app::parseChord(key), 0}));
  }
  app::selectController(stage.session(), "left-hand", false);
  stage.viewport.camera.yawRadians = 0.7;
  stage.viewport.camera.pitchRadians = 0.5;
  stage.frame();
  const auto handles = controllerHandles(stage.session(), stage.viewport.controllers);
  REQUIRE(handles);
  REQUIRE(partsOf(*handles).size() == 9);
  for (const HandlePart& part : partsOf(*handles)) {
    CAPTURE(static_cast<int>(part.kind), part.axis);
    bool isOver = false;
    std::vector<Vec3> points = pointsOf(stage.viewport.view, *handles, part);
    if (part.kind == HandleKind::plane) {
      points = {0.5 * (points[0] + points[2])}; // the middle of its square
    }
    for (const Vec3& point : points) {
      isOver = isOver || pickHandle(stage.viewport.view, *handles, stage.pixelsOf(point)) == part;
      if (isOver) {
        stage.pointAt(point);
        break;
      }
    }
    REQUIRE(isOver);
    REQUIRE(stage.viewport.hoveredHandle == part);
    const Vec2 from = stage.viewport.mousePixels;
    const Vec3 before = stage.placeOf("left-hand");
    stage.press();
    stage.pointAt(from + Vec2(-20.0, 14.0));
    stage.pointAt(from + Vec2(-31.0, 25.0));
    CHECK(stage.viewport.hoveredHandle == part);
    const auto* const held = std::get_if<ControllerTool>(&stage.tool);
    REQUIRE(held != nullptr);
    CHECK(held->modal.motion ==
          (part.kind == HandleKind::ring ? app::PullMotion::turn : app::PullMotion::move));
    const Vec3 moved = stage.placeOf("left-hand") - before;
    CHECK((glm::length(moved) > 0.01) == (part.kind != HandleKind::ring));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool isFree = part.kind == HandleKind::axis    ? axis == part.axis
                          : part.kind == HandleKind::plane ? axis != part.axis
                                                           : false;
      CHECK((isFree || std::abs(moved[static_cast<int>(axis)]) < 1e-6));
    }
    stage.release();
    stage.session().undo();
    stage.frame();
  }
}

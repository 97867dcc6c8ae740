#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/ui/mouse_stage.h"
#include "ui/viewport/cube_marker.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

const Vec2 cubeCentre{800.0 - 46.0, 46.0};
constexpr double halfEdge = 20.0;

/// The boxer from the front, with an arm selected.
struct CubeUnderMouse : test::MouseStage {
  CubeUnderMouse() : MouseStage(test::boxer()) { app::selectLimb(session(), "left-arm", false); }
};

} // namespace

TEST_CASE("A click on the view cube looks from the part that was clicked and keeps the selection") {
  CubeUnderMouse stage;
  struct Part {
    Vec2 place; // In half edges, y down.
    double yaw, pitch;
    ProjectionKind projection;
    const char* name;
  };
  const Part part = GENERATE(Part{{0.8, 0.0}, 0.25 * pi, 0.0, ProjectionKind::perspective, "front left"},
                             Part{{-0.8, 0.0}, -0.25 * pi, 0.0, ProjectionKind::perspective, "front right"},
                             Part{{0.0, -0.8}, 0.0, 0.25 * pi, ProjectionKind::perspective, "front top"},
                             Part{{0.0, 0.8}, 0.0, -0.25 * pi, ProjectionKind::perspective, "front under"},
                             Part{{0.0, 0.0}, 0.0, 0.0, ProjectionKind::orthographic, "front"});
  stage.pointAt(cubeCentre + halfEdge * part.place);
  REQUIRE(stage.viewport.look.hoveredPart);
  CHECK(nameOf(*stage.viewport.look.hoveredPart) == part.name);
  CHECK(stage.viewport.hoveredLimb.empty());
  stage.click();
  CHECK(stage.viewport.camera.yawRadians == Approx(part.yaw));
  CHECK(stage.viewport.camera.pitchRadians == Approx(part.pitch));
  CHECK(stage.viewport.camera.projection == part.projection);
  CHECK(stage.session().view().selection.limbs() == std::vector<std::string>{"left-arm"});
}

TEST_CASE("A drag on the view cube turns the view, and looks from no part at its end") {
  CubeUnderMouse stage;
  stage.drag(cubeCentre, cubeCentre - Vec2(100.0, 0.0));
  CHECK(stage.viewport.camera.yawRadians > 0.3);
  CHECK(stage.viewport.camera.yawRadians < 0.6);
  CHECK(stage.viewport.camera.pitchRadians == Approx(0.0).margin(1e-9));
  CHECK(stage.viewport.gesture == ViewportGesture::none);
  CHECK(stage.session().view().selection.limbs() == std::vector<std::string>{"left-arm"});
}

TEST_CASE("Nothing of the view cube is under the mouse beside it, while it is switched off, and in a small "
          "picture") {
  CubeUnderMouse stage;
  const auto isFound = [&](const Vec2& pixels) {
    stage.pointAt(pixels);
    return stage.viewport.look.hoveredPart.has_value();
  };
  CHECK(isFound(cubeCentre + Vec2(19.0, 0.0)));
  CHECK_FALSE(isFound(cubeCentre + Vec2(21.0, 0.0)));
  CHECK_FALSE(isFound(cubeCentre - Vec2(0.0, 21.0)));
  stage.over = false;
  CHECK_FALSE(isFound(cubeCentre));
  stage.over = true;
  stage.ui.overlays.viewCube = false;
  CHECK_FALSE(isFound(cubeCentre));
  stage.ui.overlays.viewCube = true;
  stage.viewport.box.min = {445.0F, 0.0F};
  CHECK_FALSE(isFound(cubeCentre));
  stage.viewport.box.min = {435.0F, 0.0F};
  CHECK(isFound(cubeCentre));
}

TEST_CASE("The right button on the view cube opens the menu of the view, and the middle one moves it") {
  CubeUnderMouse stage;
  stage.pointAt(cubeCentre);
  stage.click(ImGuiMouseButton_Right);
  CHECK(stage.viewport.camera.yawRadians == 0.0);
  CHECK(stage.ui.menu.asked == MenuTarget::viewport);
  const Vec3 before = stage.viewport.camera.target;
  stage.drag(cubeCentre, cubeCentre + Vec2(50.0, 0.0), ImGuiMouseButton_Middle);
  CHECK(stage.viewport.camera.target.x < before.x);
  CHECK(stage.viewport.camera.yawRadians == 0.0);
}

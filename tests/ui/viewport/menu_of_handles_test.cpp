#include <algorithm>

#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "tests/support/ui/mouse_stage.h"
#include "ui/viewport/tools.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The boxer at its punch.
struct HandlesUnderMouse : test::MouseStage {
  HandlesUnderMouse() : MouseStage(test::boxer()) {
    session().view().frame = 20.0;
    frame();
  }
  [[nodiscard]] Vec2 placeOf(const std::string& id) {
    const auto& placed = session().controllersAt(20.0);
    const auto found = std::ranges::find(placed, id, &rig::PlacedController::id);
    REQUIRE(found != placed.end());
    return pixelsOf(found->placeWorld);
  }
};

} // namespace

TEST_CASE("A right click on a handle opens the menu of the controllers that it moves, which stay selected") {
  HandlesUnderMouse stage;
  const std::vector<std::string> selected{"left-foot", "left-hand"};
  app::selectControllers(stage.session(), selected);
  stage.frame();
  const Vec2 at = stage.placeOf("left-hand");
  for (double up = 20.0; up < 90.0 && !stage.viewport.hoveredHandle; up += 2.0) {
    stage.pointAt(at - Vec2(0.0, up));
  }
  REQUIRE(stage.viewport.hoveredHandle);
  stage.click(ImGuiMouseButton_Right);
  CHECK(stage.ui.menu.asked == MenuTarget::controller);
  CHECK(stage.session().view().selection.controllers() == selected);
}

TEST_CASE("A right click on an arrow of a selected sphere opens the menu of the spheres") {
  HandlesUnderMouse stage;
  stage.session().view().rangeEnd = 10.0;
  app::selectLimb(stage.session(), "left-arm", false);
  REQUIRE(startExaggerate(stage.session(), stage.tool));
  REQUIRE(pressToolKey(stage.session(), stage.tool, {*app::parseChord("Enter"), 0}));
  const int trail = stage.session().document().trails.front().id;
  const app::PlacedSphere sphere = app::placedSpheres(stage.session(), trail).at(2);
  stage.session().view().selection.editTrails().spheres = {sphere.frame};
  stage.frame();
  const Vec2 at = stage.pixelsOf(sphere.positionWorld);
  for (double up = 14.0; up < 90.0 && !stage.viewport.hoveredAxis; up += 2.0) {
    stage.pointAt(at - Vec2(0.0, up));
  }
  REQUIRE(stage.viewport.hoveredAxis);
  stage.click(ImGuiMouseButton_Right);
  CHECK(stage.ui.menu.asked == MenuTarget::sphere);
  CHECK(stage.session().view().selection.spheres() == std::vector{sphere.frame});
  // Likewise on the end of a tangent.
  REQUIRE_FALSE(stage.viewport.tangents.handles.empty());
  for (const ShownTangent& tangent : stage.viewport.tangents.handles) {
    stage.ui.menu.asked = MenuTarget::viewport;
    stage.pointAt(tangent.tipWorld);
    REQUIRE(stage.viewport.hoveredTangent);
    stage.click(ImGuiMouseButton_Right);
    CHECK(stage.ui.menu.asked == MenuTarget::sphere);
    CHECK(stage.session().view().selection.spheres() == std::vector{sphere.frame});
  }
}

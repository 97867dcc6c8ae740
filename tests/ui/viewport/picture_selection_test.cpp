// What the viewport marks: what is selected, and what lies under the mouse.
#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "ui/viewport/shown/shown_controllers.h"
#include "ui/viewport/viewport_scene.h"

using namespace stretch;
using namespace stretch::ui;

TEST_CASE("What is selected and what is under the mouse is marked in the picture, each by itself") {
  app::Session session(test::boxer());
  session.view().selection.editTrails() = {
      .limbs = {"left-arm", "right-arm"}, .trail = 7, .spheres = {2.0, 5.0}};
  ViewportState viewport;
  const PictureSelection selected = selectionOf(session, viewport);
  CHECK(selected.limbs == std::vector<std::string>{"left-arm", "right-arm"});
  CHECK(selected.trail == 7);
  CHECK(selected.spheres == std::vector<double>{2.0, 5.0});
  CHECK_FALSE(selected.everyTrail);
  CHECK(selected.hoveredLimb.empty());
  CHECK(selected.hoveredTrail == 0);
  CHECK_FALSE((selected.hoveredSphere || selected.hoveredAxis || selected.activeHandle || selected.tipFrame));
  CHECK_FALSE(selected.weightsOf.exists());
  viewport.hoveredLimb = "neck";
  viewport.hoveredTrail = 4;
  viewport.hoveredSphere = 9.0;
  viewport.hoveredAxis = 1;
  viewport.hoveredHandle = HandlePart{HandleKind::ring, 2};
  viewport.tipFrame = 11.0;
  viewport.weightsOf = NodeIndex(3);
  const PictureSelection hovered = selectionOf(session, viewport);
  CHECK(hovered.limbs == selected.limbs);
  CHECK(hovered.hoveredLimb == "neck");
  CHECK(hovered.hoveredTrail == 4);
  CHECK(hovered.hoveredSphere == 9.0);
  CHECK(hovered.hoveredAxis == 1U);
  CHECK(hovered.activeHandle == HandlePart{HandleKind::ring, 2});
  CHECK(hovered.tipFrame == 11.0);
  CHECK(hovered.weightsOf == NodeIndex(3));
}

TEST_CASE("Of controllers the selected one and the one under the mouse are drawn as such, the last one with "
          "handles") {
  app::Session session(test::boxer());
  app::selectController(session, "left-hand", false);
  ViewportState viewport;
  ViewportOverlays overlays;
  overlays.controllers = true;
  viewport.controllers = shownControllers(session, overlays);
  viewport.hoveredController = "right-hand";
  const PictureSelection marked = selectionOf(session, viewport);
  REQUIRE(marked.controllers.size() == viewport.controllers.size());
  for (std::size_t i = 0; i < marked.controllers.size(); ++i) {
    const std::string& id = viewport.controllers[i].placed.id;
    CAPTURE(id);
    CHECK(marked.controllers[i].selected == (id == "left-hand"));
    CHECK(marked.controllers[i].hovered == (id == "right-hand"));
  }
  REQUIRE(marked.controllerHandles);
  CHECK(marked.controllerHandles->origin == findShown(viewport.controllers, "left-hand")->placed.placeWorld);
}

#include <catch2/catch.hpp>

#include <sstream>

#include "app/commands/keys/keys.h"
#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "ui/viewport/tools.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

struct Stage {
  app::Session session{test::boxer()};
  Tool tool;

  Stage() {
    session.view().rangeEnd = 10.0;
    app::selectLimb(session, "left-arm", false);
  }
  void type(const std::string& keys) {
    std::istringstream words(keys);
    for (std::string word; words >> word;) {
      REQUIRE(pressToolKey(session, tool, {*app::parseChord(word), 0}));
    }
  }
  [[nodiscard]] const rig::TrailSettings& settings() const {
    return session.document().trails.front().settings;
  }
};

/// From the front, one unit a hundred pixels or so.
View frontView() {
  Camera camera;
  camera.target = Vec3(0.0, 1.0, 0.0);
  camera.projection = ProjectionKind::orthographic;
  return makeView(camera, {800.0, 600.0, 1.0});
}

} // namespace

TEST_CASE("Exaggerate previews at once, and Enter makes one undo step of it") {
  Stage stage;
  REQUIRE(startExaggerate(stage.session, stage.tool));
  REQUIRE(stage.session.document().trails.size() == 1);
  CHECK(stage.settings().scale == 2.0);
  stage.type("3 Y");
  CHECK(stage.settings().scale == 3.0);
  CHECK(stage.session.atBegin().trails.empty());
  EditorStatus running;
  describeTool(stage.tool, running);
  CHECK(running.modalText == "left arm x3.00, axes X Z");
  CHECK_FALSE(running.keyHints.empty());
  stage.type("Enter");
  CHECK_FALSE(isRunning(stage.tool));
  CHECK(stage.session.history().undoLabel() == "Exaggerate");
  CHECK(stage.session.view().selection.trail() == stage.session.document().trails.front().id);
  stage.session.undo();
  CHECK(stage.session.document().trails.empty());
  CHECK_FALSE(stage.session.history().canUndo());
  EditorStatus over;
  describeTool(stage.tool, over);
  CHECK(over.modalText.empty());
}

TEST_CASE("Esc leaves nothing of an exaggeration") {
  Stage stage;
  REQUIRE(startExaggerate(stage.session, stage.tool));
  stage.type("4 X Esc");
  CHECK(stage.session.document().trails.empty());
  CHECK_FALSE(stage.session.history().canUndo());
  CHECK(stage.session.view().selection.trail() == 0);
}

TEST_CASE("Exaggerate needs a limb") {
  Stage stage;
  stage.session.view().selection.editTrails().limbs.clear();
  CHECK_FALSE(startExaggerate(stage.session, stage.tool));
  CHECK_FALSE(isRunning(stage.tool));
}

TEST_CASE("Dragging a sphere moves it under the mouse, one step of undo a drag") {
  Stage stage;
  REQUIRE(startExaggerate(stage.session, stage.tool));
  stage.type("Enter");
  const int trail = stage.session.view().selection.trail();
  stage.session.view().selection.editTrails().spheres = {5.0};
  const View view = frontView();
  const Vec3 before = app::placedSpheres(stage.session, trail)[1].positionWorld;
  const auto from = projectToPixels(view, before);
  REQUIRE(from);
  REQUIRE(startGrab(stage.session, stage.tool, {from->pixels, 5.0, std::nullopt, true, 0.0}));
  const Vec2 to = from->pixels + Vec2(40.0, -25.0);
  REQUIRE(moveToolMouse(stage.session, stage.tool, view, from->pixels + Vec2(10.0, 0.0)));
  REQUIRE(moveToolMouse(stage.session, stage.tool, view, to));
  const auto after = projectToPixels(view, app::placedSpheres(stage.session, trail)[1].positionWorld);
  REQUIRE(after);
  CHECK(glm::distance(after->pixels, to) < 0.5);
  finishTool(stage.session, stage.tool, true);
  CHECK(stage.settings().spheres.size() == 1);
  stage.session.undo();
  CHECK(stage.settings().spheres.empty());
}

TEST_CASE("A limb that is pulled has its own trail selected, whichever was selected before") {
  Stage stage;
  REQUIRE(startExaggerate(stage.session, stage.tool));
  stage.type("Enter");
  const int trailOfArm = stage.session.view().selection.trail();
  app::selectLimb(stage.session, "right-arm", false);
  REQUIRE(startExaggerate(stage.session, stage.tool));
  stage.type("Enter");
  REQUIRE(stage.session.view().selection.trail() != trailOfArm);
  stage.session.view().frame = 5.0;
  REQUIRE(
      startLimbGrab(stage.session, stage.tool, "left-arm", {{100.0, 100.0}, 5.0, std::nullopt, true, 0.0}));
  CHECK(stage.session.view().selection.trail() == trailOfArm);
  REQUIRE(moveToolMouse(stage.session, stage.tool, frontView(), {140.0, 100.0}));
  finishTool(stage.session, stage.tool, true);
  CHECK(stage.session.history().undoLabel() == "Pull the left arm");
  CHECK(app::findTrail(stage.session.document(), trailOfArm)->settings.spheres.size() == 1);
}

TEST_CASE("A press that does not move the mouse is no drag") {
  Stage stage;
  REQUIRE(startExaggerate(stage.session, stage.tool));
  stage.type("Enter");
  stage.session.view().selection.editTrails().spheres = {5.0};
  REQUIRE(startGrab(stage.session, stage.tool, {{100.0, 100.0}, 5.0, std::nullopt, true, 0.0}));
  REQUIRE(moveToolMouse(stage.session, stage.tool, frontView(), {101.0, 100.0}));
  finishTool(stage.session, stage.tool, true);
  CHECK(stage.session.history().undoLabel() == "Exaggerate");
}

TEST_CASE("An axis handle moves along its axis only, the wheel takes the neighbours along") {
  Stage stage;
  REQUIRE(startExaggerate(stage.session, stage.tool));
  stage.type("Enter");
  stage.session.view().selection.editTrails().spheres = {5.0};
  const View view = frontView();
  REQUIRE(startGrab(stage.session, stage.tool, {{100.0, 100.0}, 5.0, 1, true, 0.0}));
  REQUIRE(moveToolMouse(stage.session, stage.tool, view, {170.0, 40.0}));
  REQUIRE(stage.settings().spheres.size() == 1);
  CHECK(stage.settings().spheres[0].offset.x == Approx(0.0).margin(1e-9));
  CHECK(stage.settings().spheres[0].offset.y > 0.0);
  REQUIRE(turnFalloff(stage.session, stage.tool, 25.0));
  CHECK(stage.settings().spheres.size() > 1);
  finishTool(stage.session, stage.tool, false);
  CHECK(stage.settings().spheres.empty());
}

TEST_CASE("The wheel widens a pull up to ten heights of the character, and gives it up below a fiftieth") {
  Stage stage; // The boxer is 1.8 high.
  REQUIRE(startExaggerate(stage.session, stage.tool));
  stage.type("Enter");
  stage.session.view().selection.editTrails().spheres = {5.0};
  REQUIRE(startGrab(stage.session, stage.tool, {{100.0, 100.0}, 5.0, std::nullopt, true, 0.0}));
  const auto radiusAfter = [&](double steps) {
    REQUIRE(turnFalloff(stage.session, stage.tool, steps));
    return std::get<GrabTool>(stage.tool).falloffRadius;
  };
  CHECK(radiusAfter(1.0) == Approx(0.02 * 1.8 * 1.2)); // It begins at the least one.
  CHECK(radiusAfter(2.0) == Approx(0.02 * 1.8 * 1.2 * 1.2 * 1.2));
  CHECK(radiusAfter(100.0) == Approx(18.0));
  CHECK(radiusAfter(-1.0) == Approx(15.0));
  CHECK(radiusAfter(-100.0) == 0.0);
}

TEST_CASE("The mouse moves keys by its way from where it began, and scales them about the playhead") {
  const auto begin = [](Stage& stage, app::KeysModal::Kind kind) {
    const std::vector<app::KeyRow> rows = app::rowsOfSelection(stage.session);
    app::pickKeys(stage.session, app::keysBetween(stage.session.document(), 0, rows, 4.0, 11.0), false);
    app::KeysModal modal;
    modal.kind = kind;
    modal.valuesShown = false;
    modal.aboutFrame = 6.0;
    REQUIRE(startKeys(stage.session, stage.tool, modal));
  };
  const auto mouseAt = [](Stage& stage, double frame, double value) {
    REQUIRE(moveKeysMouse(stage.session, stage.tool, {frame, value}));
    return std::get<KeysTool>(stage.tool).modal;
  };
  Stage moving;
  begin(moving, app::KeysModal::Kind::move);
  CHECK(mouseAt(moving, 10.0, 0.5).mouseFrames == 0.0);
  const app::KeysModal moved = mouseAt(moving, 13.0, 0.75);
  CHECK(moved.mouseFrames == 3.0);
  CHECK(moved.mouseValue == 0.25);
  Stage scaling;
  begin(scaling, app::KeysModal::Kind::scale);
  CHECK(mouseAt(scaling, 10.0, 0.0).mouseFactor == Approx(1.0));
  CHECK(mouseAt(scaling, 14.0, 0.0).mouseFactor == Approx(2.0));
  CHECK(mouseAt(scaling, 8.0, 0.0).mouseFactor == Approx(0.5));
  Stage atPlayhead; // There a frame of the mouse is a tenth.
  begin(atPlayhead, app::KeysModal::Kind::scale);
  CHECK(mouseAt(atPlayhead, 6.25, 0.0).mouseFactor == Approx(1.0));
  CHECK(mouseAt(atPlayhead, 9.25, 0.0).mouseFactor == Approx(1.3));
}

TEST_CASE("Grab by keys: G X 0.2 Enter") {
  Stage stage;
  REQUIRE(startExaggerate(stage.session, stage.tool));
  stage.type("Enter");
  stage.session.view().selection.editTrails().spheres = {10.0};
  REQUIRE(startGrab(stage.session, stage.tool, {}));
  stage.type("X 0 . 2 Enter");
  REQUIRE(stage.settings().spheres.size() == 1);
  CHECK(stage.settings().spheres[0].offset.x == Approx(0.2));
}

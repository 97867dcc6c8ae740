#include <algorithm>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/app/boxer.h"
#include "ui/viewport/shown/shown_controllers.h"
#include "ui/viewport/tools.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

struct PosedBoxer {
  app::Session session{test::boxer()};
  ViewportOverlays overlays;
  Tool tool;

  PosedBoxer() {
    overlays.controllers = true;
    session.view().frame = 10.0;
  }
  [[nodiscard]] Vec3 place(const std::string& id) {
    for (const rig::PlacedController& placed : session.controllersAt(session.view().frame)) {
      if (placed.id == id) {
        return placed.placeWorld;
      }
    }
    FAIL("no controller " << id);
    return {};
  }
  void press(const std::string& keys) {
    std::istringstream words(keys);
    for (std::string word; words >> word;) {
      REQUIRE(pressToolKey(session, tool, {*app::parseChord(word), 0}));
    }
  }
};

View boxersFront() {
  Camera camera;
  camera.target = Vec3(0.0, 1.0, 0.0);
  camera.projection = ProjectionKind::orthographic;
  return makeView(camera, {800.0, 600.0, 1.0});
}

} // namespace

TEST_CASE("Controllers are shown while they are switched on or one is selected, and not over the original") {
  PosedBoxer boxer;
  CHECK_FALSE(shownControllers(boxer.session, boxer.overlays).empty());
  boxer.session.view().showOriginal = true;
  CHECK(shownControllers(boxer.session, boxer.overlays).empty());
  boxer.session.view().showOriginal = false;
  boxer.overlays.controllers = false;
  CHECK(shownControllers(boxer.session, boxer.overlays).empty());
  app::selectController(boxer.session, "left-hand", false);
  CHECK_FALSE(shownControllers(boxer.session, boxer.overlays).empty());
}

TEST_CASE("The controller whose line is nearest to the mouse is taken, up to 20 points away") {
  PosedBoxer boxer;
  const View view = boxersFront();
  const std::vector<ShownController> shown = shownControllers(boxer.session, boxer.overlays);
  for (const char* id : {"left-hand", "right-hand", "left-elbow"}) {
    const ShownController* const one = findShown(shown, id);
    REQUIRE(one != nullptr);
    const Vec3 point = one->picture.knob ? *one->picture.knob : one->picture.lines.front().front();
    CHECK(pickController(view, shown, projectToPixels(view, point)->pixels) == id);
  }
  CHECK_FALSE(pickController(view, shown, {3.0, 3.0}));
}

TEST_CASE("G moves the selected controller by what is typed, in one undo step, and Escape puts it back") {
  PosedBoxer boxer;
  app::selectController(boxer.session, "left-hand", false);
  const Vec3 before = boxer.place("left-hand");
  REQUIRE(startControllerTool(boxer.session, boxer.tool, {}));
  boxer.press("Y . 1");
  CHECK(boxer.place("left-hand").y == Approx(before.y + 0.1));
  boxer.press("Esc");
  CHECK(boxer.session.history().position() == 0);
  CHECK(glm::length(boxer.place("left-hand") - before) < 1e-9);
  REQUIRE(startControllerTool(boxer.session, boxer.tool, {}));
  boxer.press("Y . 1 Enter");
  CHECK(boxer.session.history().position() == 1);
  CHECK(boxer.session.history().undoLabel() == "Move the left hand");
  CHECK(boxer.place("left-hand").y == Approx(before.y + 0.1));
  boxer.session.undo();
  CHECK(glm::length(boxer.place("left-hand") - before) < 1e-9);
}

TEST_CASE("Locators are moved and turned by what is typed, with their counterparts while they mirror") {
  app::Document document = test::boxer();
  for (const char* const name : {"spine", "leftHand", "rightHand"}) {
    rig::Locator locator;
    locator.name = name;
    locator.position = Vec3(name[0] == 'l' ? 1.0 : name[0] == 'r' ? -1.0 : 0.0, 1.5, 0.0);
    document.locators.list.push_back(locator);
  }
  const app::PullMotion motion = GENERATE(app::PullMotion::move, app::PullMotion::turn);
  const bool mirrors = GENERATE(false, true);
  CAPTURE(motion == app::PullMotion::turn, mirrors);
  app::Session session(document);
  session.view().showLocators = true;
  session.view().mirrorLocators = mirrors;
  session.view().cameraAxes = Mat3(1.0);
  app::selectLocators(session, {"leftHand"});
  const auto press = [&](Tool& tool, const std::string& keys) {
    std::istringstream words(keys);
    for (std::string word; words >> word;) {
      REQUIRE(pressToolKey(session, tool, {*app::parseChord(word), 0}));
    }
  };
  Tool tool;
  REQUIRE(startControllerTool(session, tool, {motion, {}, {}, false}));
  press(tool, "Z 3 0");
  const auto isPut = [&](const char* name, double step) {
    const rig::Locator& before = *rig::findLocator(document.locators, name);
    const rig::Locator& after = *rig::findLocator(session.document().locators, name);
    const bool moves = motion == app::PullMotion::move;
    const double angle = moves ? 0.0 : step * pi / 180.0;
    CAPTURE(name);
    CHECK(glm::length(after.position - before.position - Vec3(0.0, 0.0, moves ? std::abs(step) : 0.0)) <
          1e-9);
    if (!moves) {
      CHECK(glm::length(after.orientation * Vec3(1.0, 0.0, 0.0) -
                        Vec3(std::cos(angle), std::sin(angle), 0.0)) < 1e-9);
    }
  };
  isPut("leftHand", 30.0);
  isPut("rightHand", mirrors ? -30.0 : 0.0);
  isPut("spine", 0.0);
  press(tool, "Esc");
  CHECK(session.document().locators == document.locators);
  REQUIRE(startControllerTool(session, tool, {motion, {}, {}, false}));
  press(tool, "Z 3 0 Enter");
  isPut("leftHand", 30.0);
  CHECK(session.history().undoLabel() ==
        (motion == app::PullMotion::move ? "Move leftHand" : "Turn leftHand"));
  session.undo();
  CHECK(session.document().locators == document.locators);
}

TEST_CASE("A controller that is dragged stays under the mouse") {
  PosedBoxer boxer;
  app::selectController(boxer.session, "left-hand", false);
  const View view = boxersFront();
  boxer.session.view().cameraAxes = Mat3(1.0);
  const Vec2 from = projectToPixels(view, boxer.place("left-hand"))->pixels;
  REQUIRE(startControllerTool(boxer.session, boxer.tool, {app::PullMotion::move, {}, from, true}));
  const Vec2 to = from + Vec2(-20.0, -35.0);
  REQUIRE(moveToolMouse(boxer.session, boxer.tool, view, to));
  CHECK(glm::distance(projectToPixels(view, boxer.place("left-hand"))->pixels, to) < 0.5);
  REQUIRE(moveToolMouse(boxer.session, boxer.tool, view, from));
  finishTool(boxer.session, boxer.tool, true);
  CHECK(boxer.session.history().position() == 0);
}

TEST_CASE("The mouse turns a controller about the ring that it holds, more than once around") {
  PosedBoxer boxer;
  app::selectController(boxer.session, "spine-top", false);
  const View view = boxersFront();
  const Vec2 centre = projectToPixels(view, boxer.place("spine-top"))->pixels;
  const auto around = [&](double degrees) {
    const double angle = degrees * pi / 180.0;
    return centre + 60.0 * Vec2(std::cos(angle), -std::sin(angle));
  };
  REQUIRE(startControllerTool(boxer.session, boxer.tool,
                              {app::PullMotion::turn, {2, false, false}, around(0.0), true}));
  for (double degrees = 10.0; degrees <= 400.0; degrees += 10.0) {
    REQUIRE(moveToolMouse(boxer.session, boxer.tool, view, around(degrees)));
  }
  EditorStatus status;
  describeTool(boxer.tool, status);
  CHECK(status.modalText == "spine top turned about Z by 400.0°");
  finishTool(boxer.session, boxer.tool, false);
}

TEST_CASE("A ring that is seen from behind turns the other way, and one from its edge along the drag") {
  PosedBoxer boxer;
  app::selectController(boxer.session, "spine-top", false);
  Camera camera;
  camera.target = Vec3(0.0, 1.0, 0.0);
  camera.projection = ProjectionKind::orthographic;
  camera.yawRadians = pi;
  const View behind = makeView(camera, {800.0, 600.0, 1.0});
  const auto turnedBy = [&](const View& view, int axis, const Vec2& from, const Vec2& to) {
    REQUIRE(startControllerTool(boxer.session, boxer.tool,
                                {app::PullMotion::turn, {axis, false, false}, from, true}));
    REQUIRE(moveToolMouse(boxer.session, boxer.tool, view, to));
    const double radians = std::get<ControllerTool>(boxer.tool).modal.mouseRadians;
    finishTool(boxer.session, boxer.tool, false);
    return radians;
  };
  const Vec3 place = boxer.place("spine-top");
  // A quarter, to the left as it is seen: from the right up.
  for (const View& view : {boxersFront(), behind}) {
    const Vec2 centre = projectToPixels(view, place)->pixels;
    const double facing = view.forward.z < 0.0 ? 1.0 : -1.0;
    CHECK(turnedBy(view, 2, centre + Vec2(60.0, 0.0), centre - Vec2(0.0, 60.0)) == Approx(facing * 0.5 * pi));
  }
  // The front of a ring about the upright axis goes along with the mouse, a radian on 66 points.
  const Vec2 centre = projectToPixels(boxersFront(), place)->pixels;
  CHECK(turnedBy(boxersFront(), 1, centre, centre + Vec2(66.0, 0.0)) == Approx(1.0).epsilon(0.01));
  CHECK(turnedBy(boxersFront(), 0, centre, centre + Vec2(0.0, 66.0)) == Approx(1.0).epsilon(0.01));
}

TEST_CASE("With auto-key off what is moved is shown and not keyed, and Escape restores it") {
  PosedBoxer boxer;
  boxer.session.view().autoKey = false;
  app::selectController(boxer.session, "left-hand", false);
  const Vec3 before = boxer.place("left-hand");
  REQUIRE(startControllerTool(boxer.session, boxer.tool, {}));
  boxer.press("Y . 1 Enter");
  CHECK(boxer.session.document().adjustments.empty());
  CHECK(boxer.place("left-hand").y == Approx(before.y + 0.1));
  REQUIRE(startControllerTool(boxer.session, boxer.tool, {}));
  boxer.press("Y . 2 Esc");
  CHECK(boxer.place("left-hand").y == Approx(before.y + 0.1));
  boxer.session.view().frame = 11.0;
  CHECK(boxer.session.frameAt(11.0).timeSeconds > 0.0);
  boxer.session.view().frame = 10.0;
  CHECK(glm::length(boxer.place("left-hand") - before) < 1e-9);
}

TEST_CASE("Turning what only moves is refused with a line that says what turns") {
  PosedBoxer boxer;
  app::selectController(boxer.session, "left-elbow", false);
  const Status done =
      startControllerTool(boxer.session, boxer.tool, {app::PullMotion::turn, {}, Vec2(0.0), false});
  REQUIRE_FALSE(done);
  CHECK(done.error().line().find("select") != std::string::npos);
  CHECK_FALSE(isRunning(boxer.tool));
}

TEST_CASE("Rings have room for half the way to the nearest other one, and are marked each by itself") {
  const auto ringAt = [](const char* id, double x) {
    ShownController shown;
    shown.placed.id = id;
    shown.picture.ring = Vec3(x, 1.0, 0.0);
    return shown;
  };
  ShownController pole;
  pole.placed.id = "pole";
  pole.picture.knob = Vec3(0.1, 1.0, 0.0);
  const std::vector<ControllerPicture> pictures =
      controllerPictures({ringAt("a", 0.0), ringAt("b", 1.0), ringAt("c", 3.0), pole}, {"b"}, "c");
  REQUIRE(pictures.size() == 4);
  CHECK(pictures[0].ringRoom == 0.5);
  CHECK(pictures[1].ringRoom == 0.5);
  CHECK(pictures[2].ringRoom == 1.0);
  CHECK_FALSE(pictures[3].ringRoom);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    CAPTURE(i);
    CHECK(pictures[i].selected == (i == 1));
    CHECK(pictures[i].hovered == (i == 2));
  }
  CHECK_FALSE(controllerPictures({ringAt("a", 0.0), pole}, {}, "")[0].ringRoom);
}

TEST_CASE("A box takes a controller on its edge, and none beside any of its sides") {
  PosedBoxer boxer;
  const View view = boxersFront();
  const Vec2 hand = projectToPixels(view, boxer.place("left-hand"))->pixels;
  const std::vector<ShownController> one{
      *findShown(shownControllers(boxer.session, boxer.overlays), "left-hand")};
  CHECK(controllersInBox(view, one, hand, hand).size() == 1);
  for (const Vec2& aside : {Vec2(20.0, 0.0), Vec2(-20.0, 0.0), Vec2(0.0, 20.0), Vec2(0.0, -20.0)}) {
    CAPTURE(aside.x, aside.y);
    CHECK(controllersInBox(view, one, hand + aside - Vec2(10.0), hand + aside + Vec2(10.0)).empty());
  }
}

TEST_CASE("A box selects the controllers that stand in it") {
  PosedBoxer boxer;
  const View view = boxersFront();
  const std::vector<ShownController> shown = shownControllers(boxer.session, boxer.overlays);
  const Vec2 hand = projectToPixels(view, boxer.place("left-hand"))->pixels;
  const std::vector<std::string> inside = controllersInBox(view, shown, hand - Vec2(3.0), hand + Vec2(3.0));
  CHECK(std::ranges::find(inside, "left-hand") != inside.end());
  CHECK(std::ranges::find(inside, "right-hand") == inside.end());
}

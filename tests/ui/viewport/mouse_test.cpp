#include <algorithm>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/commands/table/selection.h"
#include "core/anim/frames.h"
#include "tests/support/app/boxer.h"
#include "tests/support/ui/controllers_under_mouse.h"
#include "tests/support/ui/mouse_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/viewport/tools.h"

using namespace stretch;
using namespace stretch::ui;
using test::ControllersUnderMouse;

namespace {

/// The boxer with an exaggerated trail of its left arm, which is selected.
struct PunchUnderMouse : test::MouseStage {
  PunchUnderMouse() : MouseStage(test::boxer()) {
    session().view().rangeEnd = 10.0;
    session().view().frame = 20.0;
    app::selectLimb(session(), "left-arm", false);
    REQUIRE(startExaggerate(session(), tool));
    REQUIRE(pressToolKey(session(), tool, {*app::parseChord("Enter"), 0}));
    frame();
  }
  [[nodiscard]] int trail() const { return open.character()->document().trails.front().id; }
  [[nodiscard]] std::vector<app::PlacedSphere> spheres() { return app::placedSpheres(session(), trail()); }
  [[nodiscard]] Vec2 sphereAt(std::size_t i) { return pixelsOf(spheres().at(i).positionWorld); }
  [[nodiscard]] std::vector<double> selectedSpheres() const {
    return open.character()->view().selection.spheres();
  }
  void select(const std::vector<std::size_t>& which) {
    std::vector<double> frames;
    frames.reserve(which.size());
    for (const std::size_t i : which) {
      frames.push_back(spheres().at(i).frame);
    }
    session().view().selection.editTrails().spheres = frames;
  }
  /// The one whose disc no other one covers.
  [[nodiscard]] std::size_t lonely() {
    std::size_t best = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < spheres().size(); ++i) {
      double nearest = 1e9;
      for (std::size_t j = 0; j < spheres().size(); ++j) {
        nearest = i == j ? nearest : std::min(nearest, glm::distance(sphereAt(i), sphereAt(j)));
      }
      best = nearest > most ? i : best;
      most = std::max(most, nearest);
    }
    return best;
  }
};

} // namespace

TEST_CASE("A box takes the spheres that stand inside it, drawn from any corner, and no others") {
  PunchUnderMouse stage;
  const Vec2 at = stage.sphereAt(stage.lonely());
  const double frame = stage.spheres()[stage.lonely()].frame;
  struct Box {
    const char* says;
    Vec2 from, to;
    bool takes;
  };
  const Box box = GENERATE(
      Box{"from the upper left", {-20, -40}, {20, 40}, true},
      Box{"from the lower right", {15, 40}, {-20, -40}, true},
      Box{"from the lower left", {-20, 40}, {20, -40}, true},
      Box{"from the upper right", {20, -40}, {-20, 40}, true},
      Box{"left of it", {-60, -40}, {-20, 40}, false}, Box{"right of it", {20, -40}, {60, 40}, false},
      Box{"above it", {-20, -80}, {20, -40}, false}, Box{"below it", {-20, 40}, {20, 80}, false});
  INFO(box.says);
  stage.select({});
  stage.drag(at + box.from, at + box.to);
  CHECK(stage.selectedSpheres() == (box.takes ? std::vector{frame} : std::vector<double>{}));
}

TEST_CASE("A box drops the spheres picked before, with Shift or Ctrl it adds and names none twice") {
  PunchUnderMouse stage;
  const std::size_t lonely = stage.lonely();
  const std::size_t other = lonely == 0 ? 1 : 0;
  const Vec2 at = stage.sphereAt(lonely);
  const double frame = stage.spheres()[lonely].frame;
  const double otherFrame = stage.spheres()[other].frame;
  stage.select({other});
  stage.drag(at - Vec2(20, 40), at + Vec2(20, 40));
  CHECK(stage.selectedSpheres() == std::vector{frame});
  stage.select({other});
  (GENERATE(true, false) ? stage.shift : stage.control) = true;
  stage.drag(at - Vec2(20, 40), at + Vec2(20, 40));
  CHECK(stage.selectedSpheres() == std::vector{otherFrame, frame});
  stage.drag(at - Vec2(20, 40), at + Vec2(20, 40));
  CHECK(stage.selectedSpheres() == std::vector{otherFrame, frame});
  stage.drag(at - Vec2(20, 80), at - Vec2(-20, 40));
  CHECK(stage.selectedSpheres() == std::vector{otherFrame, frame});
}

TEST_CASE(
    "A click beside everything lets go of the spheres, the next one of the limb, with Shift of nothing") {
  PunchUnderMouse stage;
  stage.select({stage.lonely()});
  const Vec2 nowhere(100.0, 500.0);
  stage.pointAt(nowhere);
  stage.shift = true;
  stage.click();
  CHECK(stage.selectedSpheres().size() == 1);
  stage.shift = false;
  stage.click();
  CHECK(stage.selectedSpheres().empty());
  CHECK(stage.session().view().selection.trail() == stage.trail());
  CHECK(stage.session().view().selection.limbs() == std::vector<std::string>{"left-arm"});
  stage.click();
  CHECK(stage.session().view().selection.trail() == 0);
  CHECK(stage.session().view().selection.limbs().empty());
}

TEST_CASE("A press that moves three points is a click, and one that moves five is a box") {
  PunchUnderMouse stage;
  stage.select({stage.lonely()});
  stage.drag({100, 500}, {103, 500});
  CHECK(stage.selectedSpheres().empty());
  CHECK(stage.session().view().selection.trail() == stage.trail());
  stage.drag({100, 500}, {105, 500});
  CHECK(stage.session().view().selection.trail() == stage.trail());
  stage.drag({100, 500}, {103, 500});
  CHECK(stage.session().view().selection.trail() == 0);
}

TEST_CASE("A double click on a trail adds a sphere there, at a whole frame where frames snap") {
  PunchUnderMouse stage;
  const ShownTrail& shown = stage.viewport.shown.trails.front();
  const Vec3 between = pointOnTrail(shown, 7.3, true);
  for (const app::PlacedSphere& sphere : stage.spheres()) {
    REQUIRE(glm::distance(stage.pixelsOf(between), stage.pixelsOf(sphere.positionWorld)) > 25.0);
  }
  stage.ui.time.timeline.snapToFrames = GENERATE(true, false);
  const double wanted = stage.ui.time.timeline.snapToFrames ? 7.0 : 7.3;
  stage.pointAt(between);
  CHECK(stage.viewport.hoveredTrail == stage.trail());
  stage.click();
  CHECK(stage.spheres().size() == 3);
  stage.doubleClick();
  REQUIRE(stage.spheres().size() == 4);
  CHECK(stage.spheres()[2].frame == Approx(wanted).margin(stage.ui.time.timeline.snapToFrames ? 1e-9 : 0.03));
}

TEST_CASE("A click picks a sphere alone, with Shift it joins those that are picked, and again it goes") {
  PunchUnderMouse stage;
  const Vec2 at = stage.sphereAt(2);
  stage.select({0});
  stage.pointAt(at);
  CHECK(stage.viewport.hoveredSphere == 10.0);
  stage.click();
  CHECK(stage.selectedSpheres() == std::vector{10.0});
  stage.select({0});
  stage.shift = true;
  stage.click();
  CHECK(stage.selectedSpheres() == std::vector{0.0, 10.0});
  stage.click();
  CHECK(stage.selectedSpheres() == std::vector{0.0});
}

TEST_CASE("Pressing one of several picked spheres keeps them all and makes it the last, and a drag takes all "
          "along") {
  PunchUnderMouse stage;
  stage.session().view().selection.editTrails().spheres = {10.0, 5.0};
  const Vec2 at = stage.sphereAt(2);
  const Vec2 other = stage.sphereAt(1);
  stage.drag(at, at + Vec2(0.0, -60.0));
  CHECK(stage.selectedSpheres() == std::vector{5.0, 10.0});
  CHECK(glm::distance(stage.sphereAt(2), at + Vec2(0.0, -60.0)) < 0.5);
  CHECK(glm::distance(stage.sphereAt(1), other + Vec2(0.0, -60.0)) < 0.5);
  CHECK(stage.session().history().canUndo());
  stage.session().undo();
  CHECK(glm::distance(stage.sphereAt(2), at) < 0.01);
  CHECK_FALSE(stage.session().document().trails.empty());
}

TEST_CASE("The right button takes a running pull back, and the left one keeps it") {
  PunchUnderMouse stage;
  stage.select({2});
  const Vec2 at = stage.sphereAt(2);
  stage.pointAt(at);
  REQUIRE(startGrab(stage.session(), stage.tool, {at, std::nullopt, std::nullopt, false, 0.0}));
  stage.pointAt(at + Vec2(0.0, -30.0));
  CHECK(glm::distance(stage.sphereAt(2), at) == Approx(30.0).margin(0.5));
  const bool keeps = GENERATE(true, false);
  const int button = keeps ? ImGuiMouseButton_Left : ImGuiMouseButton_Right;
  stage.press(button);
  CHECK_FALSE(isRunning(stage.tool));
  stage.release(button);
  CHECK(glm::distance(stage.sphereAt(2), at) == Approx(keeps ? 30.0 : 0.0).margin(0.5));
  CHECK(stage.ui.menu.asked == MenuTarget::nothing);
}

TEST_CASE(
    "The wheel widens what a pull takes along, and without one it comes nearer to what is under the mouse") {
  PunchUnderMouse stage;
  stage.select({2});
  const Vec2 at = stage.sphereAt(2);
  stage.pointAt(at);
  const double before = stage.viewport.camera.distance;
  REQUIRE(startGrab(stage.session(), stage.tool, {at, std::nullopt, std::nullopt, false, 0.0}));
  stage.turnWheel(3.0F);
  CHECK(stage.viewport.falloffRadius > 0.0);
  CHECK(stage.viewport.camera.distance == before);
  finishTool(stage.session(), stage.tool, false);
  const Vec3 under = stage.spheres()[2].positionWorld;
  stage.turnWheel(1.0F);
  stage.frame();
  CHECK(stage.viewport.camera.distance == Approx(0.88 * before));
  CHECK(glm::distance(stage.pixelsOf(under), at) < 1.0);
  stage.over = false;
  stage.turnWheel(1.0F);
  CHECK(stage.viewport.camera.distance == Approx(0.88 * before));
}

TEST_CASE("Buttons and keys turn, shift and bring nearer as the chosen style says") {
  struct Move {
    NavigationStyle style;
    int button;
    bool shift, control, alt;
    ViewportGesture gesture;
  };
  using enum ViewportGesture;
  const auto maya = NavigationStyle::maya;
  const auto blender = NavigationStyle::blender;
  const Move move = GENERATE_COPY(Move{maya, ImGuiMouseButton_Left, false, false, true, orbit},
                                  Move{maya, ImGuiMouseButton_Right, false, false, true, zoom},
                                  Move{maya, ImGuiMouseButton_Middle, false, false, true, pan},
                                  Move{maya, ImGuiMouseButton_Middle, false, false, false, pan},
                                  Move{maya, ImGuiMouseButton_Left, false, false, false, boxSelect},
                                  Move{maya, ImGuiMouseButton_Right, false, false, false, pressMenu},
                                  Move{blender, ImGuiMouseButton_Middle, false, false, false, orbit},
                                  Move{blender, ImGuiMouseButton_Middle, true, false, false, pan},
                                  Move{blender, ImGuiMouseButton_Middle, false, true, false, zoom},
                                  Move{blender, ImGuiMouseButton_Left, false, false, true, orbit},
                                  Move{blender, ImGuiMouseButton_Right, false, false, true, zoom});
  PunchUnderMouse stage;
  stage.ui.navigation = move.style;
  stage.shift = move.shift;
  stage.control = move.control;
  stage.alt = move.alt;
  const Camera before = stage.viewport.camera;
  stage.pointAt(Vec2(100.0, 500.0));
  stage.press(move.button);
  CHECK(stage.viewport.gesture == move.gesture);
  stage.pointAt(Vec2(140.0, 500.0));
  const Camera& after = stage.viewport.camera;
  CHECK((after.yawRadians != before.yawRadians) == (move.gesture == orbit));
  CHECK((after.distance < before.distance) == (move.gesture == zoom));
  CHECK((after.target != before.target) == (move.gesture == pan || move.gesture == zoom));
  stage.release(move.button);
  CHECK(stage.viewport.gesture == ViewportGesture::none);
}

TEST_CASE("A right click opens the menu of what lies under the mouse, and selects it") {
  PunchUnderMouse stage;
  const Vec3 sphere = stage.spheres()[2].positionWorld;
  const Vec3 onTrail = pointOnTrail(stage.viewport.shown.trails.front(), 7.3, true);
  const auto clickRight = [&](const Vec2& at) {
    stage.ui.menu = {};
    stage.pointAt(at);
    stage.click(ImGuiMouseButton_Right);
    return stage.ui.menu.asked;
  };
  CHECK(clickRight(stage.pixelsOf(sphere)) == MenuTarget::sphere);
  CHECK(stage.selectedSpheres() == std::vector{10.0});
  stage.session().view().selection.dropSpheres();
  CHECK(clickRight(stage.pixelsOf(onTrail)) == MenuTarget::trail);
  stage.session().view().selection = {};
  CHECK(clickRight({100.0, 500.0}) == MenuTarget::viewport);
  CHECK(stage.session().view().selection == app::Selection{});
  stage.drag({100.0, 500.0}, {160.0, 500.0}, ImGuiMouseButton_Right);
  stage.ui.menu = {};
  stage.drag({100.0, 500.0}, {160.0, 500.0}, ImGuiMouseButton_Right);
  CHECK(stage.ui.menu.asked == MenuTarget::nothing);
}

TEST_CASE("A click picks a controller alone, with Shift or Ctrl it joins the others, and again it goes") {
  ControllersUnderMouse stage;
  stage.clickAt(stage.placeOf("left-hand"));
  CHECK(stage.selected() == std::vector<std::string>{"left-hand"});
  stage.clickAt(stage.placeOf("right-hand"));
  CHECK(stage.selected() == std::vector<std::string>{"right-hand"});
  (GENERATE(true, false) ? stage.shift : stage.control) = true;
  stage.clickAt(stage.placeOf("left-elbow"));
  CHECK(stage.selected() == std::vector<std::string>{"right-hand", "left-elbow"});
  stage.shift = stage.control = false;
  stage.pointAt(Vec2(60.0, 560.0));
  stage.click();
  CHECK(stage.selected().empty());
}

TEST_CASE("A right click on one of several controllers keeps them all, on another one takes that alone") {
  ControllersUnderMouse stage;
  app::selectControllers(stage.session(), {"left-elbow", "right-elbow"});
  stage.clickAt(stage.placeOf("left-elbow"), ImGuiMouseButton_Right);
  CHECK(stage.ui.menu.asked == MenuTarget::controller);
  CHECK(stage.selected() == std::vector<std::string>{"left-elbow", "right-elbow"});
  stage.clickAt(stage.placeOf("left-hand"), ImGuiMouseButton_Right);
  CHECK(stage.selected() == std::vector<std::string>{"left-hand"});
}

TEST_CASE("A box takes the controllers in it, with Shift those picked before stay, and none is named twice") {
  ControllersUnderMouse stage;
  const Vec2 at = stage.pixelsOf(stage.placeOf("right-hand"));
  const Vec2 corner(30.0, 60.0);
  app::selectControllers(stage.session(), {"left-hand"});
  stage.drag(at - corner, at + Vec2(15.0, 60.0));
  CHECK(stage.selected() == std::vector<std::string>{"right-hand"});
  app::selectControllers(stage.session(), {"left-hand"});
  stage.shift = true;
  stage.drag(at - corner, at + Vec2(15.0, 60.0));
  CHECK(stage.selected() == std::vector<std::string>{"left-hand", "right-hand"});
  stage.drag(at - corner, at + Vec2(15.0, 60.0));
  CHECK(stage.selected() == std::vector<std::string>{"left-hand", "right-hand"});
}

TEST_CASE("Dragging a controller moves it under the mouse, one that only turns is turned") {
  ControllersUnderMouse stage;
  const Vec2 from = stage.pixelsOf(stage.placeOf("left-hand"));
  stage.pointAt(from);
  stage.press();
  stage.pointAt(from + Vec2(-10.0, 20.0));
  const auto* const moving = std::get_if<ControllerTool>(&stage.tool);
  REQUIRE(moving != nullptr);
  CHECK(moving->modal.motion == app::PullMotion::move);
  stage.pointAt(from + Vec2(-30.0, 40.0));
  stage.release();
  CHECK_FALSE(isRunning(stage.tool));
  CHECK(glm::distance(stage.pixelsOf(stage.placeOf("left-hand")), from + Vec2(-30.0, 40.0)) < 1.0);
  CHECK(stage.session().history().canUndo());
}

TEST_CASE("Dragging a controller that cannot move turns it") {
  test::MouseStage stage(test::PanelDriver::bundledCharacter());
  stage.ui.overlays.controllers = stage.ui.overlays.skeleton = true;
  stage.frame();
  bool found = false;
  for (const ShownController& shown : std::vector(stage.viewport.controllers)) {
    stage.pointAt(shown.placed.placeWorld);
    found = !shown.placed.moves && stage.viewport.hoveredController == shown.placed.id;
    if (found) {
      break;
    }
  }
  REQUIRE(found);
  stage.press();
  stage.pointAt(stage.viewport.mousePixels + Vec2(0.0, 20.0));
  const auto* const turned = std::get_if<ControllerTool>(&stage.tool);
  REQUIRE(turned != nullptr);
  CHECK(turned->modal.motion == app::PullMotion::turn);
  stage.release();
  CHECK_FALSE(isRunning(stage.tool));
}

TEST_CASE(
    "The hand under the mouse is where the pose of now has it: after an edit, keyed or not, the original") {
  test::MouseStage stage(test::PanelDriver::bundledCharacter());
  app::Session& session = stage.session();
  session.view().autoKey = GENERATE(true, false);
  const rig::Limb arm = *app::findLimb(session.document(), "left-arm");
  const auto hand = [&] { return Vec3(session.shownAt(session.view().frame).worlds[at(arm.endNode)][3]); };
  const auto isUnderMouse = [&](const Vec3& world) {
    stage.pointAt(Vec2(60.0, 560.0));
    stage.pointAt(world);
    return stage.viewport.hoveredLimb == "left-arm" && stage.viewport.hoveredEnd;
  };
  session.view().frame = 0.0;
  stage.frame();
  const Vec3 before = hand();
  CHECK(isUnderMouse(before));
  app::selectController(session, "left-hand", false);
  REQUIRE(startControllerTool(session, stage.tool, {app::PullMotion::move, {}, {400.0, 300.0}, true}));
  REQUIRE(moveToolMouse(session, stage.tool, stage.viewport.view, Vec2(440.0, 180.0)));
  finishTool(session, stage.tool, true);
  app::clearControllers(session);
  const Vec3 moved = hand();
  REQUIRE(glm::distance(stage.pixelsOf(moved), stage.pixelsOf(before)) > 60.0);
  CHECK(isUnderMouse(moved));
  CHECK_FALSE(isUnderMouse(before));
  session.view().showOriginal = true;
  CHECK(isUnderMouse(before));
  CHECK_FALSE(isUnderMouse(moved));
  session.view().showOriginal = false;
  CHECK(isUnderMouse(moved));
}

TEST_CASE("A limb that was corrected is the one under the mouse") {
  test::MouseStage stage(test::PanelDriver::bundledCharacter());
  app::Session& session = stage.session();
  const rig::Limb arm = *app::findLimb(session.document(), "left-arm");
  const Vec3 hand(session.shownAt(session.view().frame).worlds[at(arm.endNode)][3]);
  stage.pointAt(hand);
  CHECK(stage.viewport.hoveredLimb == "left-arm");
  app::Document without = session.document();
  std::erase_if(without.body.limbs, [](const rig::Limb& limb) { return limb.id == "left-arm"; });
  session.edit(without, "Correct limbs");
  stage.pointAt(Vec2(60.0, 560.0));
  stage.pointAt(hand);
  CHECK(stage.viewport.hoveredLimb != "left-arm");
}

TEST_CASE("Limbs are picked by their bones: alone, with Shift together, a right click keeps several") {
  test::MouseStage stage(test::boxer());
  app::Session& session = stage.session();
  const FrameState pose = session.shownAt(session.view().frame);
  const auto middleOf = [&](const char* id) {
    const rig::Limb& limb = *app::findLimb(session.document(), id);
    const auto place = [&](std::size_t i) { return Vec3(pose.worlds[at(limb.joints[i])][3]); };
    return glm::mix(place(0), place(1), 0.5);
  };
  stage.clickAt(middleOf("left-arm"));
  CHECK(session.view().selection.limbs() == std::vector<std::string>{"left-arm"});
  stage.shift = true;
  stage.clickAt(middleOf("right-arm"));
  CHECK(session.view().selection.limbs() == std::vector<std::string>{"left-arm", "right-arm"});
  stage.shift = false;
  stage.clickAt(middleOf("left-arm"), ImGuiMouseButton_Right);
  CHECK(stage.ui.menu.asked == MenuTarget::limb);
  CHECK(session.view().selection.limbs() == std::vector<std::string>{"left-arm", "right-arm"});
  app::selectLimb(session, "right-arm", false);
  stage.clickAt(middleOf("left-arm"), ImGuiMouseButton_Right);
  CHECK(session.view().selection.limbs() == std::vector<std::string>{"left-arm"});
  stage.clickAt(middleOf("right-arm"));
  CHECK(session.view().selection.limbs() == std::vector<std::string>{"right-arm"});
}

TEST_CASE(
    "Tangents are those of the sphere picked last, follow an edit, and are marked under the mouse alone") {
  PunchUnderMouse stage;
  stage.select({2});
  stage.frame();
  const auto& handles = stage.viewport.tangents.handles;
  REQUIRE_FALSE(handles.empty());
  const Vec3 sphere = stage.spheres()[2].positionWorld;
  CHECK(glm::distance(handles.front().handle.sphereWorld, sphere) < 1e-6);
  stage.pointAt(handles.front().tipWorld);
  CHECK(stage.viewport.hoveredTangent == 0);
  stage.pointAt(Vec2(60.0, 560.0));
  CHECK_FALSE(stage.viewport.hoveredTangent);
  stage.select({1});
  stage.frame();
  REQUIRE_FALSE(handles.empty());
  CHECK(glm::distance(handles.front().handle.sphereWorld, stage.spheres()[1].positionWorld) < 1e-6);
  REQUIRE(
      startGrab(stage.session(), stage.tool, {stage.sphereAt(1), std::nullopt, std::nullopt, false, 0.0}));
  stage.pointAt(stage.sphereAt(1) + Vec2(0.0, -50.0));
  stage.pointAt(stage.viewport.mousePixels + Vec2(0.0, -10.0));
  finishTool(stage.session(), stage.tool, true);
  stage.frame();
  CHECK(glm::distance(handles.front().handle.sphereWorld, stage.spheres()[1].positionWorld) < 1e-6);
  stage.session().view().selection.dropSpheres();
  stage.frame();
  CHECK(handles.empty());
}

TEST_CASE("The hand under the mouse is that of the frame that is shown") {
  test::MouseStage stage(test::PanelDriver::bundledCharacter());
  app::Session& session = stage.session();
  const rig::Limb arm = *app::findLimb(session.document(), "left-arm");
  const auto handAt = [&](double frame) {
    session.view().frame = frame;
    return Vec3(session.shownAt(frame).worlds[at(arm.endNode)][3]);
  };
  const Vec3 atStart = handAt(0.0);
  double far = 0.0;
  double shown = 0.0;
  for (double frame = 1.0; frame < 60.0; frame += 1.0) {
    const double pixels = glm::distance(stage.pixelsOf(handAt(frame)), stage.pixelsOf(atStart));
    shown = pixels > far ? frame : shown;
    far = std::max(far, pixels);
  }
  REQUIRE(far > 30.0);
  session.view().frame = 0.0;
  stage.pointAt(atStart);
  CHECK(stage.viewport.hoveredLimb == "left-arm");
  const Vec3 later = handAt(shown);
  stage.pointAt(Vec2(60.0, 560.0));
  stage.pointAt(later);
  CHECK(stage.viewport.hoveredLimb == "left-arm");
  CHECK(stage.viewport.hoveredEnd);
}

TEST_CASE("While the clip plays nothing is marked under the mouse, and a press of either button finds it") {
  for (const int button : {int(ImGuiMouseButton_Left), int(ImGuiMouseButton_Right)}) {
    CAPTURE(button);
    PunchUnderMouse stage;
    stage.session().view().selection = {};
    const Vec2 trail = stage.sphereAt(stage.lonely());
    stage.ui.time.timeline.playing = true;
    stage.pointAt(trail);
    CHECK(stage.viewport.hoveredTrail == 0);
    stage.click(button);
    CHECK(stage.session().view().selection.trail() == stage.trail());
  }
}

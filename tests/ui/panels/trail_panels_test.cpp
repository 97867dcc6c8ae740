// What the panels of a trail and of weight make of what is typed, chosen and dragged.
#include <algorithm>
#include <string>
#include <utility>

#include <catch2/catch.hpp>

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "skinning/elastic/moduli.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/work.h"

using namespace stretch;
using test::PanelDriver;

namespace {

/// The bundled character with a selected trail of the left arm, of frames 4 to 24.
struct TrailRows : PanelDriver {
  explicit TrailRows(const rig::TrailSettings& wanted = startingSettings())
      : PanelDriver(documentWith(wanted)) {
    app::selectTrail(session(), 1);
    frames(3);
  }
  static rig::TrailSettings startingSettings() {
    return test::withNewTrail(PanelDriver::bundledCharacter(), {.startFrame = 4.0, .endFrame = 24.0})
        .trails.front()
        .settings;
  }
  static app::Document documentWith(const rig::TrailSettings& wanted) {
    app::Document document =
        test::withNewTrail(PanelDriver::bundledCharacter(), {.startFrame = 4.0, .endFrame = 24.0});
    document.trails.front().settings = wanted;
    return document;
  }
  [[nodiscard]] app::Session& session() { return *open.character(); }
  [[nodiscard]] const rig::TrailSettings& settings() { return session().document().trails.front().settings; }
  void typeInto(const std::string& field, const std::string& text) {
    click(field);
    type(text);
    pressKey(ImGuiKey_Enter);
    frames(2);
  }
  void choose(const std::string& list, const std::string& entry) {
    click(list);
    click(list + "/" + entry);
  }
  /// Puts the mouse where a part of a widget is: from its left and lower edge, 0..1.
  void pointAt(const std::string& widget, float across, float up) {
    const ui::Item* const item = find(widget);
    REQUIRE(item != nullptr);
    ImGui::GetIO().MousePos = {item->min.x + across * (item->max.x - item->min.x),
                               item->max.y - up * (item->max.y - item->min.y)};
    frame();
  }
  [[nodiscard]] float pixelsPerFrame(const std::string& bar) {
    return (centreOf(bar + "/end").x - centreOf(bar + "/start").x) / 20.0F;
  }
};

} // namespace

TEST_CASE("An end of a trail's range that is typed beyond the other end stops one frame beside it") {
  TrailRows panels;
  SECTION("the first frame") {
    panels.typeInto("trail/range-start", "40");
    CHECK(panels.settings().startFrame == 23.0);
    CHECK(panels.settings().endFrame == 24.0);
  }
  SECTION("the last frame") {
    panels.typeInto("trail/range-end", "2");
    CHECK(panels.settings().startFrame == 4.0);
    CHECK(panels.settings().endFrame == 5.0);
  }
}

TEST_CASE(
    "A drag anywhere in the transition takes the nearer point along, and a double click takes one away") {
  TrailRows panels;
  const std::string curve = "trail/remap-curve/curve";
  const auto drag = [&](float from, float to, float up) {
    panels.pointAt(curve, from, 0.5F);
    panels.pressMouse();
    panels.pointAt(curve, to, up);
    panels.releaseMouse();
    panels.frames(40);
  };
  drag(0.2F, 0.3F, 0.2F);
  CHECK(panels.settings().easeIn.percent == Approx(0.3).margin(0.011));
  CHECK(panels.settings().easeIn.value == Approx(0.2).margin(0.011));
  CHECK(panels.settings().easeOut.percent == 0.0);
  drag(0.8F, 0.6F, 0.9F);
  CHECK(panels.settings().easeOut.percent == Approx(0.4).margin(0.011));
  CHECK(panels.settings().easeOut.value == Approx(0.9).margin(0.011));
  CHECK(panels.settings().easeIn.percent == Approx(0.3).margin(0.011));
  // The points stand at 0.3 and 0.6 now: what is nearer is told by that.
  drag(0.4F, 0.25F, 0.1F);
  CHECK(panels.settings().easeIn.percent == Approx(0.25).margin(0.011));
  CHECK(panels.settings().easeOut.percent == Approx(0.4).margin(0.011));
  panels.doubleClick("trail/remap-curve/ease-out");
  CHECK(panels.settings().easeOut.percent == 0.0);
  CHECK(panels.settings().easeIn.percent == Approx(0.25).margin(0.011));
  panels.frames(40);
  panels.doubleClick("trail/remap-curve/ease-in");
  CHECK(panels.settings().easeIn.percent == 0.0);
  CHECK_FALSE(panels.session().isDragging());
}

TEST_CASE("The camera that judges a trail is a view by its name, the one that is seen now, or none") {
  rig::TrailSettings wanted = TrailRows::startingSettings();
  wanted.sight.keepDepth = false;
  TrailRows panels(wanted);
  panels.session().view().camera.position = Vec3(1.0, 2.0, 3.0);
  panels.choose("trail/camera", "Front");
  CHECK(panels.settings().sight.camera == "front");
  CHECK_FALSE(panels.settings().sight.view);
  panels.choose("trail/camera", "This view");
  CHECK(panels.settings().sight.camera.empty());
  REQUIRE(panels.settings().sight.view);
  CHECK(panels.settings().sight.view->position == Vec3(1.0, 2.0, 3.0));
  panels.session().view().camera.position = Vec3(7.0, 7.0, 7.0); // The kept one stays what it is.
  panels.frames(2);
  CHECK(panels.settings().sight.view->position == Vec3(1.0, 2.0, 3.0));
  panels.click("trail/camera");
  CHECK(panels.find("trail/camera/This view") == nullptr);
  panels.click("trail/camera/Kept view");
  CHECK(panels.settings().sight.view->position == Vec3(7.0, 7.0, 7.0));
  panels.choose("trail/camera", "None");
  CHECK_FALSE(panels.settings().sight.hasCamera());
  CHECK_FALSE(panels.settings().sight.keepDepth);
}

TEST_CASE("What counts as seen takes the view that is seen now, where no camera was chosen before") {
  const bool hasCamera = GENERATE(false, true);
  rig::TrailSettings wanted = TrailRows::startingSettings();
  wanted.sight.camera = hasCamera ? "side" : "";
  TrailRows panels(wanted);
  panels.session().view().camera.position = Vec3(1.0, 2.0, 3.0);
  panels.click("trail/as_seen");
  CHECK(panels.settings().sight.asSeen);
  CHECK(panels.settings().sight.view.has_value() == !hasCamera);
  CHECK(panels.settings().sight.camera == (hasCamera ? "side" : ""));
}

TEST_CASE("Pulled spheres go along with a bar that is moved, and stay where only an end of it is") {
  rig::TrailSettings wanted = TrailRows::startingSettings();
  wanted.spheres = {{10.0, Vec3(0.0, 0.1, 0.0)}, {14.0, Vec3(0.1, 0.0, 0.0)}};
  TrailRows panels(wanted);
  const std::string bar = "timeline/trail-1";
  const float pixels = panels.pixelsPerFrame(bar);
  panels.drag(bar + "/body", 3.0F * pixels, 0.0F);
  REQUIRE(panels.settings().startFrame == 7.0);
  REQUIRE(panels.settings().spheres.size() == 2);
  CHECK(panels.settings().spheres[0].frame == 13.0);
  CHECK(panels.settings().spheres[1].frame == 17.0);
  panels.drag(bar + "/end", 4.0F * pixels, 0.0F);
  CHECK(panels.settings().endFrame == 31.0);
  panels.drag(bar + "/start", 2.0F * pixels, 0.0F);
  CHECK(panels.settings().startFrame == 9.0);
  CHECK(panels.settings().spheres[0].frame == 13.0);
  CHECK(panels.settings().spheres[1].frame == 17.0);
}

TEST_CASE("A bar that is moved takes those of its selected group along that have its range, and no others") {
  const double otherStart = GENERATE(4.0, 3.0);
  const double otherEnd = GENERATE(24.0, 20.0);
  const bool isSelected = GENERATE(true, false);
  CAPTURE(otherStart, otherEnd, isSelected);
  PanelDriver driver(std::nullopt);
  test::withGroup({driver.open, driver.ui, driver.status});
  app::Session& session = *driver.open.character();
  const int first = session.document().trails[0].id;
  rig::TrailSettings other = session.document().trails[1].settings;
  other.startFrame = otherStart;
  other.endFrame = otherEnd;
  const Result<app::Document> changed =
      app::setTrailSettings(session.document(), session.document().trails[1].id, other);
  REQUIRE(changed);
  session.edit(*changed, "Change the range");
  if (!isSelected) {
    app::selectLimb(session, session.document().trails[0].limb, false);
  }
  driver.frames(3);
  const std::string bar = "timeline/trail-" + std::to_string(first);
  const float pixels = (driver.centreOf(bar + "/end").x - driver.centreOf(bar + "/start").x) / 20.0F;
  driver.drag(bar + "/body", 3.0F * pixels, 0.0F);
  CHECK(session.document().trails[0].settings.startFrame == 7.0);
  CHECK(session.document().trails[0].settings.endFrame == 27.0);
  const bool goesAlong = isSelected && otherStart == 4.0 && otherEnd == 24.0;
  CHECK(session.document().trails[1].settings.startFrame == (goesAlong ? 7.0 : otherStart));
  CHECK(session.document().trails[1].settings.endFrame == (goesAlong ? 27.0 : otherEnd));
}

namespace {

/// The left arm with weight.
struct WeightRows : PanelDriver {
  WeightRows() : PanelDriver(std::nullopt) {
    test::withWeight({open, ui, status});
    frames(3);
  }
  [[nodiscard]] app::Session& session() { return *open.character(); }
  [[nodiscard]] app::WeightedLimb entry() { return *app::findWeight(session().document(), "left-arm", 0); }
  [[nodiscard]] double modulusOf(std::size_t bone) {
    const skinning::SegmentModuli moduli{std::nullopt, entry().settings.moduli};
    return moduli.at(bone, -1.0);
  }
  void typeInto(const std::string& field, const std::string& text) {
    click(field);
    type(text);
    pressKey(ImGuiKey_Enter);
    frames(2);
  }
  void reset(const std::string& field) {
    clickRight(field);
    click(field + "/Reset");
  }
};

} // namespace

TEST_CASE("A bone of a range that shares one modulus is changed alone, and reset leaves the others theirs") {
  WeightRows panels;
  constexpr double shared = 5e4;
  app::WeightedLimb wanted = panels.entry();
  wanted.settings.moduli = {{0, 1, shared}};
  panels.session().edit(*app::setWeight(panels.session().document(), wanted), "Change the moduli");
  panels.frames(3);
  panels.drag("weight/bone-0", 20.0F, 0.0F);
  CHECK(panels.modulusOf(0) > shared);
  CHECK(panels.modulusOf(1) == shared);
  panels.reset("weight/bone-0");
  CHECK(panels.modulusOf(0) == -1.0);
  CHECK(panels.modulusOf(1) == shared);
}

TEST_CASE("The range of weight keeps a frame of length, and is the whole clip where it reaches both ends") {
  WeightRows panels;
  const double last = app::lastFrame(panels.session().document(), 0);
  const auto range = [&] { return panels.entry().settings.rangeFrames; };
  REQUIRE_FALSE(range());
  panels.typeInto("weight/range-start", "900");
  CHECK(range() == Vec2(last - 1.0, last));
  panels.typeInto("weight/range-start", "0");
  CHECK_FALSE(range());
  panels.typeInto("weight/range-end", "0");
  CHECK(range() == Vec2(0.0, 1.0));
  panels.typeInto("weight/range-end", "900");
  CHECK_FALSE(range());
  panels.typeInto("weight/range-start", "3");
  panels.typeInto("weight/range-end", "7");
  panels.reset("weight/range-start");
  CHECK(range() == Vec2(0.0, 7.0));
  panels.reset("weight/range-end");
  CHECK_FALSE(range());
}

TEST_CASE(
    "What is told of how a trail is seen is that of the selected trail, from where it is looked at now") {
  CameraPlace front;
  front.position = Vec3(0.0, 1.0, 5.0);
  CameraPlace side;
  side.position = Vec3(5.0, 1.0, 0.0);
  side.forward = Vec3(-1.0, 0.0, 0.0);
  side.right = Vec3(0.0, 0.0, -1.0);
  const auto show = [](PanelDriver& driver, std::size_t trail, const CameraPlace& camera) {
    app::Session& session = *driver.open.character();
    session.view().camera = camera;
    app::selectTrail(session, session.document().trails[trail].id);
    driver.frames(3);
    return std::pair(driver.ui.trails.seen.text, driver.ui.trails.look.warnings);
  };
  const auto toldAfresh = [&](std::size_t trail, const CameraPlace& camera) {
    PanelDriver driver(std::nullopt);
    test::withTwoTrails({driver.open, driver.ui, driver.status});
    return show(driver, trail, camera);
  };
  const auto first = toldAfresh(0, front);
  const auto second = toldAfresh(1, front);
  const auto fromTheSide = toldAfresh(1, side);
  REQUIRE_FALSE(first.first.empty());
  PanelDriver driver(std::nullopt);
  test::withTwoTrails({driver.open, driver.ui, driver.status});
  CHECK(show(driver, 0, front) == first);
  CHECK(show(driver, 1, front) == second);
  CHECK(driver.ui.trails.seen.trailId == driver.open.character()->document().trails[1].id);
  CHECK(show(driver, 1, side) == fromTheSide);
  CHECK(driver.ui.trails.seen.camera == side);
  CHECK(show(driver, 0, front) == first);
}

// What each text of the status bar tells under the mouse, whole and where it is cut.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/pose/offset_edits.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/editor_stage.h"
#include "tests/support/ui/panel_driver.h"

using namespace stretch;

namespace {

std::string toldUnder(test::PanelDriver& driver, const std::string& id) {
  driver.frames(2);
  CAPTURE(id);
  REQUIRE(driver.find(id) != nullptr);
  CHECK(driver.find(id)->explained);
  driver.moveTo(id);
  driver.frames(40);
  return test::tooltipWords();
}

} // namespace

TEST_CASE("Each text of the status bar tells under the mouse what it stands for") {
  test::PanelDriver driver(test::PanelDriver::bundledCharacter());
  CHECK_THAT(toldUnder(driver, "status/selection"), Catch::Contains("What is selected"));
  driver.ui.overlays.shadeAs = ui::ShadeAs::three;
  CHECK_THAT(toldUnder(driver, "status/shade-as"), Catch::Contains("turn normals"));
  driver.status.busyText = "Binding";
  driver.status.busyFraction = 0.5F;
  CHECK_THAT(toldUnder(driver, "status/busy"), Catch::Contains("Work in progress"));
  driver.status.modalText = "left arm x3.00";
  CHECK_THAT(toldUnder(driver, "status/modal"), Catch::Contains("Esc restores"));
  CHECK(driver.find("status/selection") == nullptr); // the tool names its limb itself
}

TEST_CASE("A text of the status bar that is cut is read whole under the mouse, and leaves room for the first "
          "keys") {
  test::PanelDriver driver(test::PanelDriver::bundledCharacter());
  driver.status.modalText = "left arm";
  for (int i = 0; i < 24; ++i) {
    driver.status.modalText += ", axis " + std::to_string(i);
  }
  driver.status.keyHints = {
      {"Enter", "keep"}, {"Esc", "restore"}, {"X", "axis x"}, {"Y", "axis y"}, {"Z", "axis z"}};
  CHECK_THAT(toldUnder(driver, "status/modal"), Catch::Contains("axis 23"));
  for (const char* const key : {"Enter", "Esc", "X", "Y"}) {
    CAPTURE(key);
    CHECK(driver.find(std::string("status/hint/") + key) != nullptr);
  }
  CHECK(driver.find("status/hint/Z") == nullptr);
  driver.status.modalText = "left arm";
  CHECK_THAT(toldUnder(driver, "status/modal"), Catch::Contains("What is being done"));
  CHECK(driver.find("status/hint/Z") != nullptr);
}

TEST_CASE("What a pose makes a limb do wrong is told in the status bar too, while a controller is selected") {
  test::PanelDriver driver(test::PanelDriver::bundledCharacter());
  app::Session& session = *driver.open.character();
  app::selectController(session, "left-hand", false);
  driver.frames(2);
  CHECK(driver.find("status/warnings") == nullptr);
  for (int axis = 0; axis < 6 && session.pops().empty(); ++axis) { // in some direction its arm turns
    app::ControllerOffset moved{"left-hand", Vec3(0.0), Vec3(0.0)};
    moved.move[axis % 3] = axis < 3 ? 0.5 : -0.5;
    const Result<app::Document> posed = app::setOffsets(session.document(), 0, 20.0, {&moved, 1}, {}, {});
    REQUIRE(posed);
    CHECK(session.edit(*posed, "Move the left hand"));
  }
  driver.frames(2);
  REQUIRE_FALSE(session.pops().empty());
  CHECK_THAT(toldUnder(driver, "status/warnings"), Catch::Contains(session.pops().front().limb.substr(5)));
  driver.requested.clear();
  driver.click("status/warnings");
  CHECK(driver.requested == std::vector<std::string>{app::command::warningNext});
  driver.requested.clear();
  driver.click("status/selection");
  CHECK(driver.requested.empty());
  app::selectLimb(session, "left-leg", false);
  driver.frames(2);
  CHECK(driver.find("status/warnings") == nullptr); // which is of the controllers' panel
}

TEST_CASE("The key that moves a selected controller is hinted at") {
  test::EditorStage stage;
  stage.openBoxer();
  stage.press("Alt+1");
  CHECK(stage.shell.items.find("status/hint/G") != nullptr);
}

TEST_CASE("The status bar names what is selected while it is little, and counts it where it is much") {
  test::PanelDriver driver(test::PanelDriver::bundledCharacter());
  app::Session& session = *driver.open.character();
  const auto isTold = [&](const char* text) {
    driver.frames(2);
    const float top = driver.find("status/selection")->min.y;
    const ImDrawData& drawn = *ImGui::GetDrawData();
    for (int i = 0; i < drawn.CmdListsCount; ++i) {
      const std::vector<test::DrawnWords> words = test::wordsOf(*drawn.CmdLists[i]);
      if (std::ranges::any_of(
              words, [&](const test::DrawnWords& one) { return one.at.y >= top && one.text == text; })) {
        return true;
      }
    }
    return false;
  };
  CHECK(isTold("Nothing selected"));
  app::selectControllers(session, {"left-hand", "right-hand", "left-foot", "right-foot"});
  CHECK(isTold("Left hand, right hand, left foot, right foot"));
  app::selectControllers(session, {"left-hand", "right-hand", "left-foot", "right-foot", "left-elbow"});
  CHECK(isTold("5 controllers"));
  app::selectLimb(session, "left-arm", false);
  app::selectLimb(session, "right-leg", true);
  CHECK(isTold("Left arm, right leg"));
  session.view().selection.editTrails().spheres = {10.0};
  CHECK(isTold("Left arm, right leg, sphere at frame 10"));
  session.view().selection.editTrails().spheres = {10.0, 14.5};
  CHECK(isTold("Left arm, right leg, 2 spheres"));
}

TEST_CASE("The name of the open file tells under the mouse whether all of its work is saved") {
  test::PanelDriver driver(test::PanelDriver::bundledCharacter());
  driver.frames(2);
  CHECK(driver.find("menu-bar/file") == nullptr);
  driver.status.fileName = "punch.glb";
  CHECK_THAT(toldUnder(driver, "menu-bar/file"), Catch::Contains("Everything is saved."));
  driver.status.unsaved = true;
  CHECK_THAT(toldUnder(driver, "menu-bar/file"), Catch::Contains("Holds work that is not saved yet."));
}

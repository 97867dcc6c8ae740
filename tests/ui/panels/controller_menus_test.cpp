#include <catch2/catch.hpp>

#include "app/commands/pose/posing.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "tests/support/ui/editor_stage.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/work.h"
#include "ui/panels/body/controller_panel.h"

using namespace stretch;
using test::PanelDriver;

TEST_CASE(
    "A right click on a controller in the diagram opens its menu, and keeps or selects the controller") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  app::Session& session = *driver.open.character();
  const bool isSelected = GENERATE(true, false);
  if (isSelected) {
    app::selectControllers(session, {"right-foot", "left-foot"});
  } else {
    app::selectLimb(session, "left-leg", false);
  }
  driver.frames(2);
  driver.clickRight("limb/left-foot");
  CHECK(driver.ui.menu.target == ui::MenuTarget::controller);
  CHECK(session.view().selection.controllers() == (isSelected
                                                       ? std::vector<std::string>{"right-foot", "left-foot"}
                                                       : std::vector<std::string>{"left-foot"}));
}

TEST_CASE("A right click on a limb in the diagram still opens the limb's menu") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.frames(2);
  driver.clickRight("limb/left-leg");
  CHECK(driver.ui.menu.target == ui::MenuTarget::limb);
}

TEST_CASE("A selected foot is pinned from its own menu and from the panel") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  app::selectController(*driver.open.character(), "left-foot", false);
  driver.frames(2);
  REQUIRE(driver.find(app::command::holdPin) != nullptr);
  driver.click(app::command::holdPin);
  CHECK(driver.requested == std::vector<std::string>{app::command::holdPin});
  driver.requested.clear();
  driver.clickRight("limb/left-foot");
  const std::string entry = std::string("context/") + app::command::holdPin;
  REQUIRE(driver.find(entry) != nullptr);
  driver.click(entry);
  CHECK(driver.requested == std::vector<std::string>{app::command::holdPin});
}

TEST_CASE("What is typed for a controller is keyed and seen, where it was posed without a key before") {
  test::EditorStage stage;
  stage.openBoxer();
  stage.press("Alt+1");
  stage.press("Shift+S");
  REQUIRE(app::poseAll(stage.session(), {{{"left-hand", Vec3(0.1, 0.2, 0.0), Vec3(0.0)}}, {}}, "Move"));
  stage.press("Shift+S");
  stage.frames(2);
  stage.click("controller/move-Y");
  stage.type("0.5");
  stage.pressWidgetKey(ImGuiKey_Enter);
  CHECK(app::offsetAt(stage.session().document(), 0, stage.session().view().frame, "left-hand").move.y ==
        Approx(0.5));
  CHECK(app::shownOffset(stage.session(), "left-hand").move == Vec3(0.1, 0.5, 0.0));
  CHECK(stage.session().view().unkeyed.empty());
}

TEST_CASE(
    "The mark of a key tells where controllers have one: at the playhead, at other frames, or nowhere") {
  PanelDriver driver(std::nullopt);
  test::withControllers({driver.open, driver.ui, driver.status}); // Both hands, at frame 12.
  app::Session& session = *driver.open.character();
  const auto mark = [&](const std::vector<std::string>& ids) { return ui::keyMarkOf(session, ids); };
  CHECK(mark({"left-hand"}) == ui::KeyMark::here);
  CHECK(mark({"right-foot", "left-hand"}) == ui::KeyMark::here);
  CHECK(mark({"right-foot"}) == ui::KeyMark::none);
  session.view().frame = 13.0;
  CHECK(mark({"right-foot", "left-hand"}) == ui::KeyMark::elsewhere);
  CHECK(mark({"right-foot"}) == ui::KeyMark::none);
  session.view().clip = 1;
  CHECK(mark({"left-hand"}) == ui::KeyMark::none);
}

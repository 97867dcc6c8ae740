// What the dialog of a retime makes of what is typed and pressed.
#include <string>

#include <catch2/catch.hpp>

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "tests/support/ui/panel_driver.h"

using namespace stretch;

namespace {

/// Frames 20 to 30 of the bundled character's clip, which ends at 60, are to be retimed.
struct RetimeAsked : test::PanelDriver {
  RetimeAsked() : PanelDriver(PanelDriver::bundledCharacter()) {
    for (const int key : {ImGuiKey_LeftArrow, ImGuiKey_RightArrow}) {
      ImGui::GetIO().KeyMap[key] = key + 1;
    }
    ui.time.retime = {.open = true, .firstFrame = 20.0, .lastFrame = 30.0, .newFrames = 10.0};
    frames(4);
  }
  void typeInto(const std::string& field, const std::string& text) {
    click(field);
    type(text);
    pressKey(ImGuiKey_Enter);
    frames(2);
  }
  [[nodiscard]] double newFrames() const { return ui.time.retime.newFrames; }
  [[nodiscard]] const std::string& told() const { return ui.time.retime.ends; }
};

} // namespace

TEST_CASE("A speed makes the range of a retime take longer or shorter, and the end of the clip is told") {
  RetimeAsked driver;
  CHECK_FALSE(driver.find("retime/Retime")->enabled);
  driver.typeInto("retime/speed", "50");
  CHECK(driver.newFrames() == Approx(20.0));
  CHECK(driver.told() == "The clip will end at frame 70; now it ends at 60.");
  driver.typeInto("retime/speed", "200");
  CHECK(driver.newFrames() == Approx(5.0));
  CHECK(driver.told() == "The clip will end at frame 55; now it ends at 60.");
  driver.click("retime/after");
  CHECK(driver.told() == "The clip ends at frame 60, as now.");
  driver.click("retime/after");
  driver.typeInto("retime/length", "20");
  driver.click("retime/Retime");
  CHECK_FALSE(driver.ui.time.retime.open);
  const app::Session& session = *driver.open.character();
  CHECK(app::lastFrame(session.document(), 0) == Approx(70.0));
  CHECK(session.history().undoLabel() == "Retime the clip: frames 20 to 30 take 20");
}

TEST_CASE("Left and Right take a frame from a retime and add one, from whole frames on, and one is left") {
  RetimeAsked driver;
  driver.ui.time.retime.newFrames = 2.4;
  driver.frames(2);
  driver.pressKey(ImGuiKey_RightArrow);
  CHECK(driver.newFrames() == 3.0);
  driver.pressKey(ImGuiKey_LeftArrow);
  CHECK(driver.newFrames() == 2.0);
  driver.pressKey(ImGuiKey_LeftArrow);
  driver.pressKey(ImGuiKey_LeftArrow);
  CHECK(driver.newFrames() == 1.0);
  driver.click("retime/length"); // The arrows are the field's while it is typed in.
  driver.pressKey(ImGuiKey_RightArrow);
  CHECK(driver.newFrames() == 1.0);
}

TEST_CASE("A limb is retimed alone only where one is selected, and the whole body again by a second click") {
  RetimeAsked driver;
  CHECK_FALSE(driver.find("retime/limb")->enabled);
  app::selectLimb(*driver.open.character(), "left-arm", false);
  driver.frames(2);
  driver.click("retime/limb");
  CHECK(driver.ui.time.retime.limb == "left-arm");
  driver.click("retime/limb");
  CHECK(driver.ui.time.retime.limb.empty());
}

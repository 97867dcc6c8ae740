// The overview of all keys while it waits for a new one.
#include <catch2/catch.hpp>

#include "tests/support/ui/panel_driver.h"

using namespace stretch;

namespace {

/// The overview, which waits for the key of Apply.
struct AwaitedKey : test::PanelDriver {
  AwaitedKey() : PanelDriver(PanelDriver::bundledCharacter()) {
    keys().open = true;
    keys().filter = "apply";
    frames(3);
    click("keys/trail.apply");
    REQUIRE(keys().waitingFor == "trail.apply");
  }
  [[nodiscard]] ui::KeysOverviewState& keys() { return ui.dialogs.keys; }
};

} // namespace

TEST_CASE("A key of a command is taken away by Backspace, and kept by Esc, which leaves the overview open") {
  AwaitedKey driver;
  SECTION("taken away") {
    driver.status.pressedKey = "Backspace";
    driver.frame();
    REQUIRE(driver.ui.answers.keyChange);
    CHECK(driver.ui.answers.keyChange->commandId == "trail.apply");
    CHECK(driver.ui.answers.keyChange->keyText.empty());
  }
  SECTION("kept") {
    driver.status.pressedKey = "Escape";
    driver.pressKey(ImGuiKey_Escape);
    CHECK_FALSE(driver.ui.answers.keyChange);
  }
  CHECK(driver.keys().waitingFor.empty());
  CHECK(driver.keys().open);
}

TEST_CASE("A second click on a key, and closing the overview, end the wait for a new one") {
  AwaitedKey driver;
  if (GENERATE(true, false)) {
    driver.click("keys/trail.apply");
  } else {
    driver.keys().open = false;
    driver.frames(2);
  }
  CHECK(driver.keys().waitingFor.empty());
  driver.status.pressedKey.assign(1, 'T');
  driver.frame();
  CHECK_FALSE(driver.ui.answers.keyChange);
}

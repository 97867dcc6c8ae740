// Drags of panels that end otherwise than by letting go.
#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/work.h"

using namespace stretch;
using test::PanelDriver;

namespace {

/// A field that is held and was moved: of a character's trail, or of a mesh sequence.
struct HeldField {
  explicit HeldField(bool ofSequence) : driver(std::nullopt), isSequence(ofSequence), before(opened()) {
    driver.moveTo(ofSequence ? "sequence/bones" : "trail/scale");
    driver.pressMouse();
    driver.moveBy(40.0F, 0.0F);
    driver.moveBy(20.0F, 0.0F);
    REQUIRE(value() > before);
    REQUIRE(isDragging());
  }
  /// Opens what has the field; its value.
  [[nodiscard]] double opened() {
    const test::Work work{driver.open, driver.ui, driver.status};
    isSequence ? test::withSequence(work) : test::withTrail(work);
    driver.frames(3);
    return value();
  }
  [[nodiscard]] double value() {
    return isSequence ? driver.open.sequence()->document().settings.bones
                      : driver.open.character()->document().trails.front().settings.scale;
  }
  [[nodiscard]] bool isDragging() {
    return driver.open.with(false, [](auto& session) { return session.isDragging(); });
  }
  [[nodiscard]] std::size_t steps() {
    return driver.open.with(std::size_t(0), [](auto& session) { return session.history().position(); });
  }

  PanelDriver driver;
  bool isSequence;
  double before;
};

} // namespace

TEST_CASE("What takes a panel's drag back ends it: letting go afterwards keeps nothing") {
  HeldField held(GENERATE(false, true));
  CAPTURE(held.isSequence);
  REQUIRE(held.driver.open.with(false, [](auto& session) {
    session.cancel();
    return true;
  }));
  held.driver.frame();
  CHECK_FALSE(held.driver.ui.panelDrag);
  held.driver.releaseMouse();
  CHECK(held.value() == held.before);
  CHECK(held.steps() == 0);
  CHECK_FALSE(held.driver.ui.panelDrag);
}

TEST_CASE("Esc takes a panel's drag back, and letting go afterwards keeps nothing") {
  HeldField held(GENERATE(false, true));
  CAPTURE(held.isSequence);
  held.driver.pressKey(ImGuiKey_Escape);
  CHECK(held.value() == held.before);
  held.driver.releaseMouse();
  CHECK(held.value() == held.before);
  CHECK(held.steps() == 0);
  CHECK_FALSE(held.driver.ui.panelDrag);
  CHECK_FALSE(held.isDragging());
}

TEST_CASE("A drag whose field is not drawn any more when the mouse lets go is one step all the same") {
  HeldField held(false);
  const double reached = held.value();
  held.driver.open.character()->view().selection.dropTrail();
  held.driver.releaseMouse();
  held.driver.frames(2);
  CHECK(held.value() == reached);
  CHECK(held.steps() == 1);
  CHECK_FALSE(held.isDragging());
  CHECK_FALSE(held.driver.ui.panelDrag);
}

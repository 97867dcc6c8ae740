#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/panels/rows/shown_holds.h"
#include "ui/panels/rows/timeline_model.h"

using namespace stretch;
using test::PanelDriver;

namespace {

/// The bundled character with both feet and hands pinned: the first of them over the whole clip.
app::Document fourPins() {
  app::Document document = PanelDriver::bundledCharacter();
  for (const char* const limb : {"left-leg", "right-leg", "left-arm", "right-arm"}) {
    const bool isWhole = document.holds.pins.empty();
    rig::Pin pin;
    pin.limb = limb;
    pin.time.rangeFrames = isWhole ? Vec2(0.0, app::lastFrame(document, 0)) : Vec2(5.0, 20.0);
    document.holds.pins.push_back(pin);
  }
  return document;
}

ui::TimelineModel modelOf(PanelDriver& driver, ui::RowDetail detail) {
  ui::PanelContext context{driver.open,      driver.ui,    driver.theme, driver.commands,
                           driver.requested, driver.items, driver.status};
  return ui::timelineModel(context, detail);
}

} // namespace

TEST_CASE("The dope sheet has two rows of holds above its keys, those of the whole clip last, and the others "
          "below") {
  PanelDriver driver(fourPins());
  const ui::TimelineModel sheet = modelOf(driver, ui::RowDetail::everyLimb);
  CHECK(sheet.rowsAbove == 2);
  REQUIRE(sheet.bars.size() == 4);
  std::vector<std::size_t> rows;
  for (const ui::TimelineBar& bar : sheet.bars) {
    rows.push_back(bar.row);
    CHECK((bar.end > 20.0) == (bar.row == 3)); // The one over the whole clip.
  }
  std::ranges::sort(rows);
  CHECK(rows == std::vector<std::size_t>{0, 1, 2, 3});
}

TEST_CASE("Holds over the whole clip, as things in a file's hands, stand below the keys of the dope sheet") {
  app::Document document = fourPins();
  for (rig::Pin& pin : document.holds.pins) {
    pin.time.rangeFrames = Vec2(0.0, app::lastFrame(document, 0));
  }
  PanelDriver driver(document);
  const ui::TimelineModel sheet = modelOf(driver, ui::RowDetail::everyLimb);
  CHECK(sheet.bars.size() == 4);
  CHECK(sheet.rowsAbove == 0);
}

TEST_CASE("The timeline has all holds below the keys") {
  PanelDriver driver(fourPins());
  CHECK(modelOf(driver, ui::RowDetail::selection).rowsAbove == 0);
}

TEST_CASE("A range that is typed digit by digit leaves its other end where it is") {
  PanelDriver driver(fourPins());
  app::Session& session = *driver.open.character();
  app::selectLimb(session, "right-leg", false);
  driver.frames(3);
  REQUIRE(driver.find("holds/1/range-last") != nullptr);
  driver.doubleClick("holds/1/range-last");
  driver.frames(2);
  for (const char* const digit : {"2", "5"}) {
    driver.type(digit);
    driver.frames(2);
  }
  driver.pressKey(ImGuiKey_Enter);
  driver.frames(2);
  CHECK(session.document().holds.pins.at(1).time.rangeFrames == Vec2(5.0, 25.0));
}

TEST_CASE("Neither end of a hold's range is typed past the other, and neither takes the other along") {
  PanelDriver driver(fourPins());
  app::Session& session = *driver.open.character();
  app::selectLimb(session, "right-leg", false);
  driver.frames(3);
  const bool isFirst = GENERATE(true, false);
  driver.click(isFirst ? "holds/1/range-first" : "holds/1/range-last");
  driver.type(isFirst ? "30" : "2");
  driver.pressKey(ImGuiKey_Enter);
  driver.frames(2);
  CHECK(session.document().holds.pins.at(1).time.rangeFrames ==
        (isFirst ? Vec2(20.0, 20.0) : Vec2(5.0, 5.0)));
}

TEST_CASE("Every hold has a bar of its own, which is told apart from those of trails, and is found by it") {
  std::set<int> bars;
  for (const rig::HoldKind kind : {rig::HoldKind::pin, rig::HoldKind::grip, rig::HoldKind::prop}) {
    for (std::size_t index = 0; index < 4; ++index) {
      const app::HoldPlace place{kind, index};
      const int bar = ui::barOfHold(place);
      CHECK(bar < 0);
      CHECK(bars.insert(bar).second);
      CHECK(ui::holdOfBar(bar) == place);
    }
  }
  CHECK_FALSE(ui::holdOfBar(0));
  CHECK_FALSE(ui::holdOfBar(1));
}

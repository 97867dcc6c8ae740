#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/keys/key_row.h"
#include "tests/support/app/run_command.h"
#include "tests/support/ui/panel_driver.h"

using namespace stretch;

TEST_CASE(
    "The rows of the dope sheet below the first hold every key of the clip once, hips and root included") {
  test::PanelDriver driver(test::PanelDriver::bundledCharacter());
  driver.ui.time.tab = ui::BottomTab::dopeSheet;
  driver.frame();
  const ui::KeyRowsState& shown = driver.ui.time.rows;
  std::vector<app::KeyRow> every = app::keyedRows(driver.open.character()->document(), 0);
  REQUIRE(shown.rows.size() > 2);
  CHECK(shown.rows.front().label == "All keys");
  std::vector<app::KeyRow> inRows;
  for (std::size_t i = 1; i < shown.keyed.size(); ++i) {
    inRows.insert(inRows.end(), shown.keyed[i].begin(), shown.keyed[i].end());
  }
  std::ranges::sort(every);
  std::ranges::sort(inRows);
  CHECK(inRows == every);
  const auto hips = std::ranges::find(shown.rows, "Hips and root", &ui::KeyRow::label);
  REQUIRE(hips != shown.rows.end());
  const app::Document& document = driver.open.character()->document();
  const auto keyed = shown.keyed[static_cast<std::size_t>(hips - shown.rows.begin())];
  CHECK(std::ranges::any_of(keyed, [&](const app::KeyRow& row) { return row.node == document.body.hips; }));
  // Keys within a thousandth of a frame stand on it.
  const std::vector<double> expected = app::keyFramesOf(document, 0, keyed.front());
  CHECK(std::ranges::equal(hips->frames, expected,
                           [](double shown, double key) { return std::abs(shown - key) < 1e-3; }));
}

TEST_CASE("All keys of the dope sheet are whole ones, whichever curves the graph showed before") {
  test::PanelDriver driver(test::PanelDriver::bundledCharacter());
  app::Session& session = *driver.open.character();
  app::selectLimb(session, "left-arm", false);
  const auto pickedBits = [&](ui::BottomTab tab) {
    driver.ui.time.tab = tab;
    driver.frames(3);
    REQUIRE(test::run(session, app::command::keysAll).empty());
    REQUIRE_FALSE(app::pickedKeys(session).empty());
    unsigned every = ~0U;
    for (const app::PickedRow& row : app::pickedKeys(session)) {
      for (const app::PickedKey& key : row.keys) {
        every &= key.components;
      }
    }
    return every;
  };
  driver.ui.time.graph.hidden = {true, false, false};
  const unsigned ofCurves = pickedBits(ui::BottomTab::graph);
  CHECK(ofCurves != ~0U); // The curve that is hidden is left out.
  CHECK(pickedBits(ui::BottomTab::dopeSheet) == ~0U);
}

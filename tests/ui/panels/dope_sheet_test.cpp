#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "app/edits/keys/key_row.h"
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

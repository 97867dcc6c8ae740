#include <cmath>

#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "app/schema/trail_schema.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/panels/context/setting_rows.h"
#include "ui/widgets/timeline_detail.h"

using namespace stretch;
using test::PanelDriver;

namespace {

/// The panels with a selected trail of the left arm.
struct Panels {
  Panels()
      : driver(test::withNewTrail(PanelDriver::bundledCharacter(), {.startFrame = 4.0, .endFrame = 24.0})) {
    app::selectTrail(*driver.open.character(), 1);
    driver.frames(2);
  }
  [[nodiscard]] double scale() const {
    return driver.open.character()->document().trails.front().settings.scale;
  }

  PanelDriver driver;
};

/// How far a number lies from the next multiple of a step.
double beside(double value, double step) {
  return std::abs(value - std::round(value / step) * step);
}

} // namespace

TEST_CASE("The scale is dragged in steps of 0.05, with Shift of 0.01") {
  Panels panels;
  for (const float pixels : {7.0F, 13.0F, 23.0F, -31.0F}) {
    const double before = panels.scale();
    panels.driver.drag("trail/scale", pixels, 0.0F);
    CHECK(panels.scale() != before);
    CHECK(beside(panels.scale(), 0.05) < 1e-9);
  }
  bool isFiner = false;
  panels.driver.shift = true;
  for (const float pixels : {7.0F, 13.0F, 23.0F, -31.0F}) {
    panels.driver.drag("trail/scale", pixels, 0.0F);
    CHECK(beside(panels.scale(), 0.01) < 1e-9);
    isFiner = isFiner || beside(panels.scale(), 0.05) > 1e-3;
  }
  CHECK(isFiner);
}

TEST_CASE("The help of a number says what it is, and what the mouse does with it") {
  const app::SettingFacts& scale = *app::findSetting(app::trailSchema(), "scale");
  const ui::Help help = ui::dragHelp(ui::settingHelp(scale));
  CHECK(help.title == "Scale");
  CHECK(help.text.starts_with(scale.help));
  CHECK(help.text.ends_with("Drag (Shift: finer), click to type, right click for a menu."));
}

TEST_CASE("Each part of the timeline that can be dragged says what it is and what dragging does") {
  using ui::TimelinePart;
  for (const auto& [part, title] :
       {std::pair{TimelinePart::rangeStart, "Start of the working range"},
        std::pair{TimelinePart::rangeEnd, "End of the working range"},
        std::pair{TimelinePart::barStart, "Start of the trail"},
        std::pair{TimelinePart::barEnd, "End of the trail"}, std::pair{TimelinePart::release, "Release"}}) {
    const ui::Help help = ui::timeline_detail::helpFor(part, 1);
    CHECK(help.title == title);
    CHECK(help.text.starts_with("Drag it"));
  }
  CHECK(ui::timeline_detail::helpFor(TimelinePart::playhead, 0).text.empty());
}

TEST_CASE("Units stand behind numbers as people write them, and a step of undo says what was changed") {
  app::SettingFacts setting;
  CHECK(ui::unitSuffix(setting).empty());
  setting.unit = "kg/m^3";
  CHECK(ui::unitSuffix(setting) == " kg/m\xC2\xB3");
  setting.unit = "units^2";
  CHECK(ui::unitSuffix(setting) == " units\xC2\xB2");
  setting.unit = "Pa";
  CHECK(ui::unitSuffix(setting) == " Pa");
  setting.row.shownUnit = "kPa";
  CHECK(ui::unitSuffix(setting) == " kPa");
  setting.row.percent = true;
  CHECK(ui::unitSuffix(setting) == " %");
  setting.row.label = "Turn to view";
  CHECK(ui::undoLabel(setting) == "Change the turn to view");
  setting.kind = app::SettingKind::flag;
  CHECK(ui::undoLabel(setting) == "Turn to view");
}

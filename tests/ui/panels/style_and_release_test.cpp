#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "app/edits/trail/style_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/panels/trails/trail_sections.h"

using namespace stretch;
using test::PanelDriver;

namespace {

/// The bundled character, whose clip is a loop here, with a selected trail of the left arm.
struct LoopPanels {
  explicit LoopPanels(double releaseFrames) : driver(document(releaseFrames)) {
    app::selectTrail(*driver.open.character(), 1);
    driver.frames(2);
  }
  static app::Document document(double releaseFrames) {
    app::Document made = test::withNewTrail(app::setLooping(PanelDriver::bundledCharacter(), 0, true),
                                            {.startFrame = 50.0, .endFrame = 55.0});
    made.trails.front().settings.releaseFrames = releaseFrames;
    return made;
  }
  [[nodiscard]] const rig::TrailSettings& settings() const {
    return driver.open.character()->document().trails.front().settings;
  }
  [[nodiscard]] float pixelsPerFrame() const {
    return (driver.find("timeline/trail-1/end")->centre().x -
            driver.find("timeline/trail-1/start")->centre().x) /
           5.0F;
  }

  PanelDriver driver;
};

} // namespace

TEST_CASE("The end of a release that goes on across the seam of a loop is dragged where it is drawn") {
  LoopPanels panels(20.0);
  const float ends = panels.driver.find("timeline/trail-1/release")->centre().x;
  CHECK(ends < panels.driver.find("timeline/trail-1/start")->centre().x);
  panels.driver.drag("timeline/trail-1/release", 4.0F * panels.pixelsPerFrame(), 0.0F);
  CHECK(panels.settings().releaseFrames == Approx(24.0));
  // Back across the seam, without a leap.
  panels.driver.drag("timeline/trail-1/release", -3.0F * panels.pixelsPerFrame(), 0.0F);
  CHECK(panels.settings().releaseFrames == Approx(21.0));
}

TEST_CASE("A release is dragged out across the seam of a loop") {
  LoopPanels panels(2.0);
  panels.driver.drag("timeline/trail-1/release", 4.0F * panels.pixelsPerFrame(), 0.0F);
  CHECK(panels.settings().releaseFrames == Approx(6.0));
}

TEST_CASE("A style that was taken is named until its settings are changed, and none is named by chance") {
  const app::Document before = LoopPanels::document(2.0);
  const std::vector<int> trails{1};
  ui::TrailPanels panels;
  const Result<app::Document> styled = app::applyStyle(before, trails, panels.styles[1]);
  REQUIRE(styled);
  CHECK(ui::shownStyle(panels, *styled, trails).index == -1);
  CHECK(ui::shownStyle(panels, *styled, trails).otherwise == "none yet");
  panels.takenStyle = {before.scene, trails, 1};
  CHECK(ui::shownStyle(panels, *styled, trails).index == 1);
  CHECK(ui::shownStyle(panels, before, trails).index == -1);
  CHECK(ui::shownStyle(panels, before, trails).otherwise == panels.styles[1].name + ", changed");
  CHECK(ui::shownStyle(panels, *styled, {1, 2}).otherwise == "none yet");
  CHECK(ui::shownStyle(panels, *styled, {}).otherwise == "none yet");
  panels.takenStyle.trails = {4, 1};
  CHECK(ui::shownStyle(panels, *styled, trails).index == 1);
}

TEST_CASE(
    "A style whose trails were made for the whole clip is named, whatever scales they got, until one is "
    "changed") {
  app::Document made = LoopPanels::document(2.0);
  ui::TrailPanels panels;
  made.trails.front().settings.scale = 1.37;
  panels.takenStyle = {made.scene, {1}, 1, made.trails};
  CHECK(ui::shownStyle(panels, made, {1}).index == 1);
  made.trails.front().settings.scale = 1.4;
  CHECK(ui::shownStyle(panels, made, {1}).index == -1);
  CHECK(ui::shownStyle(panels, made, {1}).otherwise == panels.styles[1].name + ", changed");
}

TEST_CASE("Each style of the list says whose it is") {
  const std::vector<rig::Style>& styles = rig::builtInStyles();
  const std::vector<ui::Choice> choices = ui::styleChoices(styles);
  REQUIRE(choices.size() == styles.size());
  for (std::size_t i = 0; i < styles.size(); ++i) {
    INFO(styles[i].name);
    CHECK(choices[i].note.starts_with(styles[i].origin == rig::StyleOrigin::measured ? "measured" : "ours"));
  }
}

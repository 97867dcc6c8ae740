#include <algorithm>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/trail_edits.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/panel_driver.h"

using namespace stretch;
using test::PanelDriver;

namespace {

bool shows(const std::string& words) {
  const std::vector<std::string> shown = test::shownWords();
  return std::ranges::any_of(shown,
                             [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

/// The bundled character with a trail of its punching arm, which may be held by a plane at its shoulder.
app::Document punch(bool isStopped) {
  app::Document document =
      test::withNewTrail(PanelDriver::bundledCharacter(), {.startFrame = 21.0, .endFrame = 27.0});
  rig::TrailSettings settings = document.trails.front().settings;
  if (isStopped) {
    settings.axes = {false, false, false};
  }
  return *app::setTrailSettings(document, document.trails.front().id, settings);
}

} // namespace

TEST_CASE("A trail whose limb comes out as long as it was says so in the list, with the reason") {
  PanelDriver idle(punch(true));
  idle.frames(3);
  REQUIRE(idle.ui.trails.idle.why.size() == 1);
  CHECK(shows("no longer"));
  CHECK_FALSE(shows("connected"));
}

TEST_CASE("A trail that makes its limb longer says in the list that it is connected") {
  PanelDriver driver(punch(false));
  driver.frames(3);
  CHECK(driver.ui.trails.idle.why.empty());
  CHECK(shows("connected"));
}

TEST_CASE("A trail that asks for no other length is not told to be in vain") {
  app::Document document = punch(false);
  rig::TrailSettings settings = document.trails.front().settings;
  settings.scale = 1.0;
  PanelDriver driver(*app::setTrailSettings(document, document.trails.front().id, settings));
  driver.frames(3);
  CHECK(driver.ui.trails.idle.why.empty());
  CHECK_FALSE(shows("no longer"));
  CHECK(shows("connected"));
}

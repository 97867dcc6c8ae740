// What the list of trails, and the panel below it, tell of trails and their groups.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "app/edits/trail/trail_edits.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/work.h"

using namespace stretch;
using test::PanelDriver;

namespace {

/// All that the last frame shows, line after line.
std::string allWords() {
  std::string all;
  for (const std::string& words : test::shownWords()) {
    all += words + " ";
  }
  return all;
}

} // namespace

TEST_CASE("A limb of which no trail is selected tells where its own trails lie") {
  PanelDriver driver(std::nullopt);
  test::withTwoTrails({driver.open, driver.ui, driver.status}); // The left arm's, and one of the right arm.
  app::Session& session = *driver.open.character();
  session.view().selection.dropTrail();
  driver.frames(3);
  CHECK_THAT(allWords(), Catch::Contains("Its trails lie at frames 4 to 24: click one"));
  app::selectLimb(session, "left-leg", false);
  driver.frames(3);
  CHECK_THAT(allWords(), !Catch::Contains("Its trails lie"));
  CHECK_THAT(allWords(), Catch::Contains("Make a trail to see its range"));
}

TEST_CASE("The row of a group tells the range and the scale that all of its trails share, and no others") {
  PanelDriver driver(std::nullopt);
  test::withGroup({driver.open, driver.ui, driver.status}); // Two of frames 4 to 24, three times as long.
  app::Session& session = *driver.open.character();
  const int member = session.document().trails[1].id;
  const rig::TrailSettings before = session.document().trails[1].settings;
  const auto shows = [&](const rig::TrailSettings& wanted, const std::string& line) {
    session.edit(*app::setTrailSettings(session.document(), member, wanted), "Change it");
    driver.frames(3);
    const std::vector<std::string> words = test::shownWords();
    return std::ranges::find(words, line) != words.end();
  };
  const std::string range = ", 4\xE2\x80\x93"
                            "24";
  const std::string scale = ", \xC3\x97"
                            "3";
  rig::TrailSettings other = before;
  other.scale = 2.0;
  CHECK(shows(other, "2 trails" + range));
  other.endFrame = 20.0;
  CHECK(shows(other, "2 trails"));
  other.scale = before.scale;
  CHECK(shows(other, "2 trails" + scale));
  other.startFrame = 3.0;
  other.endFrame = before.endFrame;
  CHECK(shows(other, "2 trails" + scale));
  CHECK(shows(before, "2 trails" + range + scale));
}

#include <algorithm>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/ui/editor_stage.h"

using namespace stretch;

namespace {

/// The boxer with two trails of its left arm, from 20 to 30 and from 60 on.
struct ArmWithTrails : test::EditorStage {
  ArmWithTrails() {
    openBoxer();
    session().restore(
        test::withNewTrail(test::withNewTrail(session().document(), {.startFrame = 20.0, .endFrame = 26.0}),
                           {.startFrame = 40.0, .endFrame = 46.0}));
    frames(2);
  }
  [[nodiscard]] std::string label(const char* id) {
    frames(1);
    return std::ranges::find(shell.commandInfos, id, &ui::CommandInfo::id)->label;
  }
};

} // namespace

TEST_CASE("Tab goes to the nearest trail of the selected limb where the playhead stands in none") {
  ArmWithTrails stage;
  const auto [frame, trail] = GENERATE(table<double, std::size_t>({{29.0, 0}, {38.0, 1}, {2.0, 0}}));
  stage.session().view().frame = frame;
  stage.press("1");
  REQUIRE(stage.session().view().selection.trail() == 0);
  stage.press(GENERATE("Tab", "Shift+Tab"));
  CHECK(stage.session().view().selection.trail() == stage.session().document().trails.at(trail).id);
  CHECK(stage.session().view().selection.spheres().size() == 1);
  CHECK(stage.session().view().selection.controllers().empty());
}

TEST_CASE("Tab goes to the controllers where the selected limb has no trail, or a controller is selected") {
  ArmWithTrails stage;
  stage.session().view().frame = 30.0;
  stage.press(GENERATE("2", "Alt+1"));
  stage.press("Tab");
  CHECK(stage.session().view().selection.trail() == 0);
  CHECK_FALSE(stage.session().view().selection.controllers().empty());
}

TEST_CASE("The other foot is matched where a leg is selected, the other hand where an arm is") {
  ArmWithTrails stage;
  stage.press("3");
  CHECK(stage.label(app::command::holdMatch) == "Match the other foot");
  stage.press("1");
  CHECK(stage.label(app::command::holdMatch) == "Match the other hand");
}

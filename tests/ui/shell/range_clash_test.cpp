// The question which trail is meant, where a range that was set shares time with one.
#include <optional>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "tests/support/ui/editor_stage.h"

using namespace stretch;

TEST_CASE("Of two trails that a range may mean the answer says which: the one there or another one") {
  struct Answer {
    const char* button;
    std::optional<app::OverlapChoice> meant;
  };
  for (const Answer& answer :
       {Answer{"clash/Edit", app::OverlapChoice::edit}, Answer{"clash/Another", app::OverlapChoice::beside},
        Answer{"clash/Cancel", {}}}) {
    CAPTURE(answer.button);
    test::EditorStage stage;
    stage.openBoxer();
    stage.press("1");
    stage.session().view().rangeStart = 0.0;
    stage.session().view().rangeEnd = 10.0;
    stage.run(app::command::trailExaggerateOnce);
    stage.frames(2);
    REQUIRE(stage.session().document().trails.size() == 1);
    app::selectTrail(stage.session(), 0);
    stage.session().view().rangeStart = 5.0;
    stage.session().view().rangeEnd = 24.0;
    stage.run(app::command::trailExaggerate);
    stage.frames(3);
    REQUIRE(stage.shell.ui.dialogs.rangeClash);
    CHECK(stage.shell.ui.dialogs.rangeClash->present == Vec2(0.0, 10.0));
    CHECK(stage.shell.ui.dialogs.rangeClash->wanted == Vec2(5.0, 24.0));
    REQUIRE(stage.shell.ui.dialogs.rangeClash->beside);
    stage.click(answer.button);
    stage.frames(3);
    CHECK_FALSE(stage.shell.ui.dialogs.rangeClash);
    CHECK(stage.shell.ui.answers.overlap == answer.meant);
  }
}

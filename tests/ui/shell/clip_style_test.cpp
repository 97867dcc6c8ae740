#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/editor_stage.h"

using namespace stretch;

TEST_CASE(
    "A clip that is to be kept before it is known that nothing of it is exaggerated stays in its dialog") {
  test::EditorStage stage;
  test::withLimb(stage.work());
  stage.run(app::command::clipExaggerate);
  stage.settle();
  ui::ClipStyleState& state = stage.shell.ui.trails.clipStyle;
  const auto keep = [&](double strength) {
    state.strength = strength;
    state.changed = true;
    state.accepted = true;
    stage.frames(2);
    stage.settle();
    stage.frames(2);
    return !state.open;
  };
  CHECK_FALSE(keep(0.0));
  CHECK_FALSE(state.accepted);
  CHECK(ui::whyNothing(state) == "the strength is 0");
  CHECK(stage.session().document().trails.empty());
  CHECK(keep(1.0));
  CHECK_FALSE(stage.session().document().trails.empty());
}

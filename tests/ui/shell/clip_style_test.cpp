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

TEST_CASE("Left and Right go through the styles, Page up and down change the strength, within their ends") {
  test::EditorStage stage;
  test::withLimb(stage.work());
  stage.run(app::command::clipExaggerate);
  stage.settle();
  ui::ClipStyleState& state = stage.shell.ui.trails.clipStyle;
  state.style = 0;
  state.strength = 1.0;
  stage.pressWidgetKey(ImGuiKey_LeftArrow);
  CHECK(state.style == 0);
  stage.pressWidgetKey(ImGuiKey_RightArrow);
  stage.pressWidgetKey(ImGuiKey_RightArrow);
  CHECK(state.style == 2);
  stage.pressWidgetKey(ImGuiKey_LeftArrow);
  CHECK(state.style == 1);
  stage.pressWidgetKey(ImGuiKey_PageUp);
  CHECK(state.strength == Approx(1.1));
  for (int i = 0; i < 15; ++i) {
    stage.pressWidgetKey(ImGuiKey_PageDown);
  }
  CHECK(state.strength == 0.0);
  CHECK(stage.shell.ui.trails.clipStyle.open);
}

TEST_CASE("While the list of styles is open Enter keeps nothing, and the arrows leave the style") {
  test::EditorStage stage;
  test::withLimb(stage.work());
  stage.run(app::command::clipExaggerate);
  stage.settle();
  ui::ClipStyleState& state = stage.shell.ui.trails.clipStyle;
  stage.frames(2);
  stage.click("clip-style/style");
  const int style = state.style;
  stage.pressWidgetKey(ImGuiKey_RightArrow);
  stage.pressWidgetKey(ImGuiKey_Enter);
  CHECK(state.style == style);
  CHECK(state.open);
  CHECK(stage.session().history().position() == 0);
}

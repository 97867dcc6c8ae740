#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "tests/support/ui/editor_stage.h"

using namespace stretch;

namespace {

/// The boxer with as many clips as a pack of motion has, and the last one is another one.
void openManyClips(test::EditorStage& stage) {
  stage.openBoxer();
  app::Document document = stage.session().document();
  std::vector<Clip> clips(20, document.clips->front());
  for (std::size_t i = 0; i < clips.size(); ++i) {
    clips[i].name = i + 1 == clips.size() ? "Roundhouse_Kick" : "Walk_" + std::to_string(i);
  }
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  stage.session().restore(std::move(document));
  stage.frames(2);
}

} // namespace

TEST_CASE("Each pane below the picture is shown by a key of its own, also where it was folded") {
  test::EditorStage stage;
  stage.openBoxer();
  const auto shownBy = [&](const char* key) {
    stage.shell.panes.bottomOpen = false;
    stage.press(key);
    CHECK(stage.shell.panes.bottomOpen);
    return stage.shell.ui.time.tab;
  };
  CHECK(shownBy("F6") == ui::BottomTab::graph);
  CHECK(shownBy("F7") == ui::BottomTab::dopeSheet);
  CHECK(shownBy("F5") == ui::BottomTab::timeline);
}

TEST_CASE("A pane below the picture is found by its name in the palette") {
  test::EditorStage stage;
  stage.openBoxer();
  const auto [typed, tab] = GENERATE(table<const char*, ui::BottomTab>(
      {{"graph", ui::BottomTab::graph}, {"dope", ui::BottomTab::dopeSheet}}));
  stage.press("Ctrl+P");
  stage.type(typed);
  stage.pressWidgetKey(ImGuiKey_Enter);
  CHECK(stage.shell.ui.time.tab == tab);
}

TEST_CASE("A clip is chosen by keys: from the list of clips alone, and from the palette by its name") {
  test::EditorStage stage;
  openManyClips(stage);
  const char* const key = GENERATE("F4", "Ctrl+P");
  stage.press(key);
  REQUIRE(stage.shell.ui.dialogs.palette.open);
  stage.type("kick");
  stage.pressWidgetKey(ImGuiKey_Enter);
  CHECK(stage.session().view().clip == 19);
  CHECK_FALSE(stage.shell.ui.dialogs.palette.open);
}

TEST_CASE("The list of clips begins at the one that is viewed, and the arrows go on from there") {
  test::EditorStage stage;
  openManyClips(stage);
  stage.session().view().clip = 7;
  stage.press("F4");
  CHECK(stage.shell.items.find("palette/clip-8") != nullptr);
  CHECK(stage.shell.items.find(std::string("palette/") + app::command::fileOpen) == nullptr);
  stage.pressWidgetKey(ImGuiKey_DownArrow);
  stage.pressWidgetKey(ImGuiKey_Enter);
  CHECK(stage.session().view().clip == 8);
}

TEST_CASE("A style that is chosen in the palette is looked at on the whole clip") {
  test::EditorStage stage;
  stage.openBoxer();
  stage.press("Ctrl+P");
  stage.type("rubber hose");
  stage.pressWidgetKey(ImGuiKey_Enter);
  stage.settle();
  const ui::TrailPanels& panels = stage.shell.ui.trails;
  CHECK(panels.clipStyle.open);
  CHECK(panels.styles[static_cast<std::size_t>(panels.clipStyle.style)].name == "Rubber hose");
  CHECK(stage.session().isDragging());
}

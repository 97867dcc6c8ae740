#include <catch2/catch.hpp>

#include <filesystem>
#include <vector>

#include "app/commands/table/command_ids.h"
#include "app/edits/trail/trail_edits.h"
#include "tests/support/ui/editor_stage.h"
#include "ui/shell/file_work.h"

using namespace stretch;
using namespace stretch::ui;
namespace command = stretch::app::command;

namespace {

/// The bundled character with work that no file has, and the question what is to become of it.
struct Asked : test::EditorStage {
  Asked() {
    std::filesystem::copy_file(STRETCH_SOURCE_DIR "/assets/dummy.glb", folder / "dummy.glb");
    openFile(shell, {folder / "dummy.glb"});
    frames(2);
    settle();
    session().edit(app::setLooping(session().document(), 0, true), "Loop");
    askToClose();
  }
  void pressAll(const std::vector<int>& keys) {
    for (const int key : keys) {
      pressWidgetKey(key);
    }
  }
  [[nodiscard]] bool isAsking() const { return shell.files.question().kind != app::FileQuestion::Kind::none; }
};

} // namespace

TEST_CASE("Enter stands for Save, and Tab and the arrows go to the other buttons, round and round") {
  Asked stage;
  REQUIRE(stage.isAsking());
  CHECK(stage.shell.ui.dialogs.question.button == 2);
  stage.pressAll({ImGuiKey_Tab});
  CHECK(stage.shell.ui.dialogs.question.button == 0);
  stage.pressAll({ImGuiKey_RightArrow});
  CHECK(stage.shell.ui.dialogs.question.button == 1);
  stage.pressAll({ImGuiKey_LeftArrow, ImGuiKey_LeftArrow});
  CHECK(stage.shell.ui.dialogs.question.button == 2);
}

TEST_CASE("Work is given up by keys alone: to Don't save, and Enter") {
  Asked stage;
  stage.pressAll({ImGuiKey_Tab, ImGuiKey_Enter});
  CHECK(stage.shell.quit);
  CHECK_FALSE(stage.isAsking());
}

TEST_CASE("At Cancel Enter goes on working, and the next question begins at Save again") {
  Asked stage;
  stage.pressAll({ImGuiKey_LeftArrow, ImGuiKey_Enter});
  CHECK_FALSE(stage.shell.quit);
  CHECK_FALSE(stage.isAsking());
  CHECK(app::hasUnsavedWork(stage.shell.open));
  stage.frames(2);
  stage.askToClose();
  CHECK(stage.shell.ui.dialogs.question.button == 2);
}

TEST_CASE("Escape closes what a click has opened beside the dialogs: the colours of a trail") {
  test::EditorStage stage;
  test::withTrail(stage.work());
  stage.frames(2);
  const auto isOpen = [] {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  };
  REQUIRE_FALSE(isOpen());
  stage.click("trails/1/colour");
  CHECK(isOpen());
  stage.pressWidgetKey(ImGuiKey_Escape);
  CHECK_FALSE(isOpen());
}

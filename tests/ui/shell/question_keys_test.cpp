#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/trail_edits.h"
#include "tests/support/ui/editor_stage.h"
#include "tests/support/ui/work.h"
#include "ui/shell/file_work.h"

using namespace stretch;
using namespace stretch::ui;
namespace command = stretch::app::command;

namespace {

/// The bundled character with work that no file has, and the question what is to become of it.
struct Asked : test::EditorStage {
  Asked() {
    openBoxer();
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

TEST_CASE("Which trail is meant is answered by keys alone: Enter edits, one step on it is left") {
  test::EditorStage stage;
  test::withTrail(stage.work());
  app::Session& session = stage.session();
  const rig::Trail trail = *app::selectedTrail(session);
  stage.shell.ui.dialogs.rangeClash =
      app::RangeClash{trail.limb, {trail.settings.startFrame, trail.settings.endFrame}, {1.0, 4.0}, {}};
  stage.frames(3);
  CHECK(stage.shell.ui.dialogs.question.button == 1);
  stage.pressWidgetKey(ImGuiKey_Tab);
  CHECK(stage.shell.ui.dialogs.question.button == 0);
  stage.pressWidgetKey(ImGuiKey_Enter);
  CHECK_FALSE(stage.shell.ui.dialogs.rangeClash);
  CHECK_FALSE(stage.shell.ui.answers.overlap);
}

TEST_CASE("What becomes of a dropped file is answered by keys alone") {
  Asked stage;
  stage.pressAll({ImGuiKey_LeftArrow, ImGuiKey_Enter});
  stage.frames(3);
  const std::filesystem::path other = stage.folder / "other.glb";
  stage.shell.ui.dialogs.dropped = {.path = other, .canBeHeld = false, .hasClips = true};
  stage.frames(3);
  CHECK(stage.shell.ui.dialogs.question.button == 2); // Import
  stage.pressAll({ImGuiKey_RightArrow, ImGuiKey_RightArrow, ImGuiKey_Enter});
  CHECK(stage.shell.ui.dialogs.dropped.path.empty()); // Cancel
  CHECK_FALSE(stage.shell.ui.answers.drop);
  CHECK(app::hasUnsavedWork(stage.shell.open));
}

TEST_CASE("The navigation is chosen by keys alone, Maya's by Enter or Escape and Blender's one step on") {
  for (const auto& [keys, expected] :
       {std::pair(std::vector<int>{ImGuiKey_Enter}, NavigationStyle::maya),
        std::pair(std::vector<int>{ImGuiKey_Tab, ImGuiKey_Enter}, NavigationStyle::blender),
        std::pair(std::vector<int>{ImGuiKey_Tab, ImGuiKey_Escape}, NavigationStyle::maya)}) {
    test::EditorStage stage;
    stage.shell.ui.navigation =
        expected == NavigationStyle::maya ? NavigationStyle::blender : NavigationStyle::maya;
    stage.shell.ui.dialogs.navigationChoiceOpen = true;
    stage.frames(3);
    for (const int key : keys) {
      stage.pressWidgetKey(key);
    }
    CHECK(stage.shell.ui.navigation == expected);
    CHECK_FALSE(stage.shell.ui.dialogs.navigationChoiceOpen);
  }
}

namespace {

/// The bundled character while a video is drawn, which ends only when it is given up.
struct Drawing : Asked {
  Drawing() {
    pressAll({ImGuiKey_LeftArrow, ImGuiKey_Enter});
    frames(3);
    shell.beside.film.path = folder / "shot.mp4";
    shell.beside.film.job =
        std::make_unique<app::Job<std::filesystem::path>>([](const skinning::Proceed& proceed) {
          while (proceed(0.5)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          }
          return Result<std::filesystem::path>(Error{"stopped", "", ""});
        });
    askToClose();
    frames(3);
  }
};

} // namespace

TEST_CASE("Quitting while a video is drawn asks first, and Enter goes on drawing") {
  Drawing stage;
  CHECK_FALSE(stage.shell.quit);
  CHECK(stage.shell.ui.dialogs.lostFilm == "shot.mp4");
  stage.pressAll({ImGuiKey_Enter});
  stage.frames(3);
  CHECK_FALSE(stage.shell.quit);
  CHECK(stage.shell.ui.dialogs.lostFilm.empty());
  CHECK(stage.shell.beside.film.job != nullptr);
}

TEST_CASE("A video that is given up leaves the program to the question about unsaved work") {
  Drawing stage;
  stage.pressAll({ImGuiKey_Tab, ImGuiKey_Enter});
  stage.frames(3);
  CHECK(stage.shell.beside.film.job == nullptr);
  CHECK(stage.isAsking());
  stage.pressAll({ImGuiKey_Tab, ImGuiKey_Enter}); // Don't save
  CHECK(stage.shell.quit);
}

TEST_CASE("What was done to a sequence and not exported is asked for before it goes, and kept by Enter") {
  test::EditorStage stage;
  test::withCompression(stage.work());
  stage.frames(2);
  stage.askToClose();
  REQUIRE(stage.shell.files.question().kind == app::FileQuestion::Kind::unsaved);
  stage.pressWidgetKey(ImGuiKey_Enter); // Cancel
  stage.frames(2);
  CHECK_FALSE(stage.shell.quit);
  CHECK(stage.shell.files.question().kind == app::FileQuestion::Kind::none);
  stage.askToClose();
  stage.pressWidgetKey(ImGuiKey_Tab);
  stage.pressWidgetKey(ImGuiKey_Enter); // Discard
  CHECK(stage.shell.quit);
}

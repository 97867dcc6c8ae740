#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

#include "app/commands/pose/posing.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/files/user_poses.h"
#include "tests/support/ui/editor_stage.h"
#include "ui/render/picture/image_edits.h"
#include "ui/shell/file_work.h"

using namespace stretch;
using namespace stretch::ui;
namespace command = stretch::app::command;

namespace {

constexpr double punchFrame = 27.0;

/// The bundled character at its punch, with the pose of its guard in the library.
struct Library : test::EditorStage {
  Library() {
    test::withLimb(work());
    frames(2);
    settle();
    run(command::selectNone);
    run(command::timeStart);
    run(command::poseKeep);
    settle();
    pressWidgetKey(ImGuiKey_Escape);
    frames(2);
    session().view().frame = punchFrame;
  }
  void open() {
    run(command::poseLibrary);
    frames(3);
  }
  void tryFirst() {
    open();
    click("pose-library/pose-0");
    frames(3);
  }
  [[nodiscard]] PoseLibraryState& library() { return shell.ui.body.library; }
  [[nodiscard]] Vec3 hand() {
    for (const rig::PlacedController& placed : session().controllersAt(punchFrame)) {
      if (placed.id == "left-hand") {
        return placed.placeWorld;
      }
    }
    return Vec3(0.0);
  }
};

} // namespace

TEST_CASE("A pose is kept with a picture of the character and a free name, and the library shows it",
          "[jobs]") {
  Library stage;
  stage.open();
  REQUIRE(stage.library().poses.size() == 1);
  CHECK(stage.library().poses[0].name == "Pose 1");
  CHECK(stage.library().chosen == -1);
  const Result<Image> picture = readImage(app::pictureOfPose(app::posesFolder() / "Pose 1.json"));
  REQUIRE(picture);
  CHECK(picture->width == picture->height);
  stage.run(command::poseKeep);
  stage.settle();
  stage.frames(3);
  REQUIRE(stage.library().poses.size() == 2);
  CHECK(stage.library().poses[1].name == "Pose 2");
  CHECK(stage.library().chosen == 1);
}

TEST_CASE("A chosen pose is seen at once, as far as the slider says, and Esc takes it off again") {
  Library stage;
  const Vec3 before = stage.hand();
  stage.tryFirst();
  const Vec3 guard = stage.hand();
  CHECK(glm::length(guard - before) > 0.2);
  CHECK(stage.session().history().position() == 0);
  stage.library().amount = 0.5;
  stage.library().changed = true;
  stage.frames(2);
  CHECK(glm::length(stage.hand() - before) < 0.9 * glm::length(guard - before));
  CHECK(glm::length(stage.hand() - before) > 0.1 * glm::length(guard - before));
  stage.pressWidgetKey(ImGuiKey_Escape);
  stage.frames(3);
  CHECK_FALSE(stage.library().open);
  CHECK(glm::length(stage.hand() - before) == 0.0);
  CHECK(stage.session().document().adjustments.empty());
}

TEST_CASE("What is taken from the library is one step that says which pose it was") {
  Library stage;
  const Vec3 before = stage.hand();
  stage.tryFirst();
  const Vec3 tried = stage.hand();
  stage.click("pose-library/Pose");
  stage.frames(3);
  CHECK_FALSE(stage.library().open);
  CHECK(glm::length(stage.hand() - tried) < 1e-9);
  CHECK(stage.session().history().undoLabel() == "Take the pose Pose 1");
  CHECK(stage.session().history().position() == 1);
  const auto isHeld = [](const Toast& toast) {
    return toast.text.starts_with("The pose comes in from frame ");
  };
  CHECK(std::ranges::any_of(stage.shell.ui.toasts, isHeld));
  stage.session().undo();
  CHECK(glm::length(stage.hand() - before) == 0.0);
}

TEST_CASE("While auto-key is off a pose of the library is shown without a key") {
  Library stage;
  stage.session().view().autoKey = false;
  const Vec3 before = stage.hand();
  stage.tryFirst();
  stage.click("pose-library/Pose");
  stage.frames(3);
  CHECK(stage.session().document().adjustments.empty());
  CHECK_FALSE(stage.session().view().unkeyed.empty());
  CHECK(glm::length(stage.hand() - before) > 0.2);
}

TEST_CASE("Selected controllers alone take the pose, mirrored from the other side where that is asked for") {
  Library stage;
  app::selectControllers(stage.session(), {"left-hand"});
  stage.tryFirst();
  const Vec3 plain = stage.hand();
  stage.click("pose-library/mirrored");
  stage.frames(3);
  CHECK(stage.library().mirrored);
  CHECK(glm::length(stage.hand() - plain) > 0.02);
  stage.click("pose-library/Pose");
  stage.frames(3);
  for (const rig::Adjustment& adjustment : stage.session().document().adjustments) {
    CHECK_THAT(adjustment.controller, Catch::StartsWith("left-hand"));
  }
  CHECK_FALSE(stage.session().document().adjustments.empty());
}

TEST_CASE("A pose that the character has already can be looked at and not be taken") {
  Library stage;
  stage.session().view().frame = 0.0;
  stage.tryFirst();
  CHECK_FALSE(stage.library().reaches);
  CHECK_THAT(stage.library().remark, Catch::StartsWith("the character stands so already"));
  CHECK_FALSE(stage.shell.items.find("pose-library/Pose")->enabled);
  stage.pressWidgetKey(ImGuiKey_Enter);
  stage.frames(2);
  CHECK(stage.library().open);
}

TEST_CASE("The arrows go through the poses, and a deleted one is gone with its picture") {
  Library stage;
  stage.open();
  stage.run(command::poseKeep);
  stage.settle();
  stage.frames(3);
  CHECK(stage.library().chosen == 1);
  stage.pressWidgetKey(ImGuiKey_LeftArrow);
  CHECK(stage.library().chosen == 0);
  stage.pressWidgetKey(ImGuiKey_LeftArrow);
  CHECK(stage.library().chosen == 0);
  stage.pressWidgetKey(ImGuiKey_RightArrow);
  CHECK(stage.library().chosen == 1);
  stage.click("pose.forget");
  stage.frames(3);
  CHECK(stage.library().poses.size() == 2); // It asks first.
  stage.click("pose.forget");
  stage.frames(3);
  CHECK(stage.library().poses.size() == 1);
  CHECK(stage.library().chosen == -1);
  CHECK_FALSE(std::filesystem::exists(app::pictureOfPose(app::posesFolder() / "Pose 2.json")));
  CHECK_FALSE(stage.shell.items.find("pose.forget")->enabled);
}

TEST_CASE(
    "With auto-key off a tried pose is taken off again, and what was posed before without a key is back") {
  Library stage;
  stage.session().view().autoKey = false;
  REQUIRE(app::poseAll(stage.session(), {{}, {{"left-hand.curl", 1.0}}}, "Fist"));
  const app::UnkeyedPose fist = stage.session().view().unkeyed;
  const Vec3 before = stage.hand();
  stage.tryFirst();
  CHECK(glm::length(stage.hand() - before) > 0.2);
  stage.pressWidgetKey(ImGuiKey_Escape);
  stage.frames(3);
  CHECK(glm::length(stage.hand() - before) == 0.0);
  CHECK(stage.session().view().unkeyed == fist);
  CHECK(stage.session().document().adjustments.empty());
}

TEST_CASE("A pose that is renamed while it is tried can be taken, under its new name") {
  Library stage;
  stage.tryFirst();
  stage.library().typedName = "Guard";
  stage.library().renamed = true;
  stage.frames(3);
  REQUIRE(stage.library().poses[0].name == "Guard");
  CHECK(std::filesystem::exists(app::pictureOfPose(app::posesFolder() / "Guard.json")));
  stage.click("pose-library/Pose");
  stage.frames(3);
  CHECK(stage.session().history().undoLabel() == "Take the pose Guard");
}

TEST_CASE("A pose that is renamed while its picture is drawn gets it, and one that is deleted leaves none",
          "[jobs]") {
  Library stage;
  stage.open();
  stage.run(command::poseKeep);
  SECTION("renamed") {
    stage.library().typedName = "Hook";
    stage.library().renamed = true;
    stage.settle();
    CHECK(std::filesystem::exists(app::posesFolder() / "Hook.png"));
  }
  SECTION("deleted") {
    stage.run(command::poseForget);
    stage.run(command::poseForget);
    stage.settle();
    CHECK(stage.library().poses.size() == 1);
  }
  CHECK_FALSE(std::filesystem::exists(app::posesFolder() / "Pose 2.png"));
}

TEST_CASE("Where another file is opened the library is closed with what it tried, and playing stops for it") {
  Library stage;
  stage.shell.ui.time.timeline.playing = true;
  stage.open();
  CHECK_FALSE(stage.shell.ui.time.timeline.playing);
  stage.click("pose-library/pose-0");
  stage.frames(3);
  REQUIRE(stage.shell.beside.library.begun);
  openFile(stage.shell, {STRETCH_SOURCE_DIR "/assets/dummy_leap.glb"});
  stage.settle();
  stage.frames(3);
  CHECK(stage.shell.files.path().filename() == "dummy_leap.glb");
  CHECK_FALSE(stage.library().open);
  CHECK_FALSE(stage.shell.beside.library.begun);
  CHECK(stage.session().document().adjustments.empty());
}

TEST_CASE("The library opens with whole poses, none of them mirrored or chosen, however it was left") {
  Library stage;
  stage.tryFirst();
  REQUIRE(stage.library().chosen == 0);
  stage.library().amount = 0.3;
  stage.library().mirrored = true;
  stage.pressWidgetKey(ImGuiKey_Escape);
  stage.frames(3);
  REQUIRE_FALSE(stage.library().open);
  stage.open();
  CHECK(stage.library().amount == 1.0);
  CHECK_FALSE(stage.library().mirrored);
  CHECK(stage.library().chosen == -1);
}

TEST_CASE("Page up and down change how far a pose is taken, and Space mirrors it") {
  Library stage;
  stage.tryFirst();
  CHECK(stage.library().amount == 1.0);
  const Vec3 whole = stage.hand();
  stage.pressWidgetKey(ImGuiKey_PageUp); // There is no more than all of it.
  CHECK(stage.library().amount == 1.0);
  for (int i = 0; i < 5; ++i) {
    stage.pressWidgetKey(ImGuiKey_PageDown);
  }
  stage.frames(2);
  CHECK(stage.library().amount == Approx(0.5));
  CHECK(glm::length(stage.hand() - whole) > 0.05);
  stage.pressWidgetKey(ImGuiKey_Space);
  CHECK(stage.library().mirrored);
  stage.pressWidgetKey(ImGuiKey_Space);
  CHECK_FALSE(stage.library().mirrored);
}

TEST_CASE("Space and the switch show the tried pose mirrored at once, and both take it back") {
  Library stage;
  app::selectControllers(stage.session(), {"left-hand"});
  stage.tryFirst();
  const Vec3 plain = stage.hand();
  const bool byKey = GENERATE(true, false);
  const auto turnOver = [&] {
    if (byKey) {
      stage.pressWidgetKey(ImGuiKey_Space);
    } else {
      stage.click("pose-library/mirrored");
    }
    stage.frames(2);
  };
  turnOver();
  CHECK(stage.library().mirrored);
  CHECK(glm::length(stage.hand() - plain) > 0.02);
  turnOver();
  CHECK_FALSE(stage.library().mirrored);
  CHECK(glm::length(stage.hand() - plain) < 1e-9);
}

TEST_CASE("The arrows bring the chosen pose into sight, and the wheel goes on from there") {
  Library stage;
  stage.open();
  stage.library().poses = std::vector<app::LibraryPose>(30, stage.library().poses.front());
  stage.frames(2);
  const auto topOf = [&](int place) {
    const Item* const card = stage.shell.items.find("pose-library/pose-" + std::to_string(place));
    return card == nullptr ? -1e6F : card->min.y;
  };
  const float firstTop = topOf(0);
  ImGui::GetIO().MousePos = stage.shell.items.find("pose-library/pose-0")->centre();
  stage.library().chosen = 26;
  stage.pressWidgetKey(ImGuiKey_RightArrow);
  stage.frames(3);
  REQUIRE(stage.library().chosen == 27);
  CHECK(stage.shell.items.find("pose-library/pose-27") != nullptr);
  CHECK(topOf(0) != firstTop);
  const float shown = topOf(27);
  ImGui::GetIO().MouseWheel = 1.0F;
  stage.frame();
  ImGui::GetIO().MouseWheel = 0.0F;
  stage.frames(3);
  CHECK(topOf(27) > shown + 10.0F);
}

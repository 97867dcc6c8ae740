#include <catch2/catch.hpp>

#include <algorithm>
#include <string_view>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "core/base/file.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/json_text.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/ui/editor_stage.h"
#include "ui/render/picture/image_edits.h"
#include "ui/shell/file_work.h"
#include "ui/shell/film_work.h"
#include "ui/shell/user_settings.h"

using namespace stretch;
using namespace stretch::ui;
namespace command = stretch::app::command;

namespace {

/// The bundled character, opened as a file.
struct Told : test::EditorStage {
  Told() { openBoxer(); }
  [[nodiscard]] bool isTold(std::string_view beginning) const {
    return std::ranges::any_of(shell.ui.toasts,
                               [&](const Toast& toast) { return toast.text.starts_with(beginning); });
  }
};

} // namespace

TEST_CASE("What was told of a file goes with it") {
  Told stage;
  tell(stage.shell, ToastKind::warning, "The left hand goes through the floor");
  stage.openBoxer();
  CHECK_FALSE(stage.isTold("The left hand goes through the floor"));
}

TEST_CASE("What undo tells takes the place of news about what has gone, and warnings stay") {
  Told stage;
  stage.session().edit(app::setLooping(stage.session().document(), 0, true), "Loop");
  tell(stage.shell, ToastKind::info, "The clip goes round now");
  tell(stage.shell, ToastKind::warning, "The left hand goes through the floor");
  stage.run(command::undo);
  CHECK(stage.isTold("Undone: Loop"));
  CHECK_FALSE(stage.isTold("The clip goes round now"));
  CHECK(stage.isTold("The left hand goes through the floor"));
  stage.run(command::redo);
  CHECK(stage.isTold("Redone: Loop"));
  CHECK_FALSE(stage.isTold("Undone: Loop"));
}

TEST_CASE("A pose that is pasted at a first key without a range says how far it reaches") {
  Told stage;
  constexpr std::string_view held = "The pose comes in from frame ";
  constexpr std::string_view heldThroughout = "The pose is held over the whole clip";
  app::Session& session = stage.session();
  session.view().frame = 0.0;
  stage.run(command::poseCopy);
  session.view().frame = 20.0;
  stage.run(command::posePaste);
  CHECK(stage.isTold(held));
  CHECK(session.history().undoLabel().starts_with("Paste the pose"));
  stage.run(command::undo);
  CHECK_FALSE(stage.isTold(held));
  session.view().wholeClip = true;
  stage.run(command::posePaste);
  CHECK(stage.isTold(heldThroughout));
  stage.run(command::undo);
  session.view().wholeClip = false;
  session.view().rangeStart = 15.0;
  session.view().rangeEnd = 25.0;
  stage.run(command::posePaste);
  CHECK_FALSE(stage.isTold(held));
}

TEST_CASE("Copying tells what was copied: a pose, offsets, a trail") {
  Told stage;
  stage.run(command::poseCopy);
  CHECK(stage.isTold("Copied: the pose of the whole character"));
  app::selectController(stage.session(), "left-hand", false);
  stage.run(command::poseCopy);
  CHECK(stage.isTold("Copied: the pose of the left hand"));
  stage.run(command::poseCopyOffsets);
  CHECK(stage.isTold("Copied: the offsets of the left hand"));
  app::selectLimb(stage.session(), "right-leg", false);
  stage.run(command::poseCopy);
  CHECK(stage.isTold("Copied: the pose of the right foot and right knee"));
  stage.run(command::trailToggle);
  stage.run(command::copyTrail);
  CHECK(stage.isTold("Copied: the trail of the right leg"));
}

TEST_CASE("A playblast beside the original shows as much of either side as a playblast alone") {
  const test::TemporaryFolder folder;
  Told stage;
  app::setRangeByHand(stage.session(), {26.0, 27.0});
  const auto filmed = [&](const std::string& name) {
    startFilm(stage.shell, folder / (name + ".png"));
    while (stage.shell.beside.film.job != nullptr) {
      stage.settle();
      updateFilm(stage.shell);
    }
    const Result<Image> picture = readImage(folder / (name + "-0027.png"));
    REQUIRE(picture);
    CHECK(readImage(folder / (name + "-0026.png")));
    CHECK_FALSE(readImage(folder / (name + "-0025.png")));
    return *picture;
  };
  const Image alone = filmed("alone");
  stage.shell.ui.overlays.sideBySide = true;
  const Image both = filmed("both");
  CHECK(both.width == 2 * alone.width);
  CHECK(both.height == alone.height);
  CHECK(stage.isTold("Drawn: " + (folder / "both.png").string() + ", frames 26 to 27, beside the original"));
}

TEST_CASE("A playblast shows what the view shows: from its side, with skeleton, ghosts and safe frame") {
  const test::TemporaryFolder folder;
  Told stage;
  app::setRangeByHand(stage.session(), {27.0, 27.0});
  Shell& shell = stage.shell;
  const auto filmed = [&](const std::string& name) {
    startFilm(shell, folder / (name + ".png"));
    while (shell.beside.film.job != nullptr) {
      stage.settle();
      updateFilm(shell);
    }
    const Result<Image> picture = readImage(folder / (name + "-0027.png"));
    REQUIRE(picture);
    return picture->rgba;
  };
  const std::vector<std::uint8_t> plain = filmed("plain");
  for (bool* const shown :
       {&shell.ui.overlays.skeleton, &shell.ui.overlays.ghosts, &shell.ui.overlays.safeFrame}) {
    *shown = true;
    CHECK(filmed("changed") != plain);
    *shown = false;
  }
  shell.viewport.camera.yawRadians += 0.5;
  CHECK(filmed("turned") != plain);
}

TEST_CASE("The original side of a playblast shows no pin and no weight") {
  const test::TemporaryFolder folder;
  Told stage;
  stage.shell.ui.overlays.sideBySide = true;
  const auto filmed = [&](const std::string& name) {
    app::setRangeByHand(stage.session(), {27.0, 27.0});
    startFilm(stage.shell, folder / (name + ".png"));
    while (stage.shell.beside.film.job != nullptr) {
      stage.settle();
      updateFilm(stage.shell);
    }
    const Result<Image> picture = readImage(folder / (name + "-0027.png"));
    REQUIRE(picture);
    return *picture;
  };
  const auto differing = [](const Image& a, const Image& b, bool right) {
    REQUIRE((a.width == b.width && a.height == b.height));
    int count = 0;
    for (int y = 0; y < a.height; ++y) {
      for (int x = right ? a.width / 2 : 0; x < (right ? a.width : a.width / 2); ++x) {
        const auto at = 4 * static_cast<std::size_t>(y * a.width + x);
        count += std::equal(a.rgba.begin() + static_cast<std::ptrdiff_t>(at),
                            a.rgba.begin() + static_cast<std::ptrdiff_t>(at + 4),
                            b.rgba.begin() + static_cast<std::ptrdiff_t>(at))
                     ? 0
                     : 1;
      }
    }
    return count;
  };
  const Image before = filmed("before");
  app::selectLimb(stage.session(), "left-arm", false);
  app::setRangeByHand(stage.session(), {20.0, 30.0}); // The punch goes from 21 to 27.
  stage.run(command::holdPin);
  REQUIRE(stage.session().document().holds.pins.size() == 1);
  const Image pinned = filmed("pinned");
  CHECK(differing(before, pinned, false) == 0);
  CHECK(differing(before, pinned, true) > 100);
  const app::WeightedLimb soft{"right-arm", 0, true, {}};
  const Result<app::Document> weighty = app::setWeight(stage.session().document(), soft);
  REQUIRE(weighty);
  REQUIRE(stage.session().edit(*weighty, "Weight"));
  const Image weighted = filmed("weighted");
  CHECK(differing(pinned, weighted, false) == 0);
  CHECK(differing(pinned, weighted, true) > 100);
}

TEST_CASE("A range that was only a trail's is not remembered as one that was set by hand") {
  Told stage;
  const auto remembered = [&] {
    keepView(stage.shell);
    const auto text = readText(viewPath(stage.folder / "dummy.glb"));
    REQUIRE(text);
    return gltf::parseAnyJson(*text)["range"];
  };
  app::selectLimb(stage.session(), "left-arm", false);
  stage.run(command::trailToggle);
  REQUIRE(app::isRangeSet(stage.session().view()));
  CHECK(remembered() == gltf::Json{0.0, -1.0});
  app::setRangeByHand(stage.session(), {4.0, 9.0});
  CHECK(remembered() == gltf::Json{4.0, 9.0});
}

TEST_CASE("That undo took a pose without a key is told, and the steps before it stay") {
  Told stage;
  stage.session().edit(app::setLooping(stage.session().document(), 0, true), "Loop");
  stage.press("Alt+1");
  stage.press("Shift+S");
  stage.press("Alt+Up");
  REQUIRE_FALSE(stage.session().view().unkeyed.empty());
  stage.press("Ctrl+Z");
  CHECK(stage.isTold("Undone: the pose without a key"));
  CHECK(stage.session().view().unkeyed.empty());
  CHECK(stage.session().history().undoLabel() == "Loop");
  stage.press("Ctrl+Z");
  CHECK(stage.isTold("Undone: Loop"));
}

TEST_CASE("All that a recipe brought is counted, of whatever kind") {
  Told stage;
  const auto replay = [&](const char* text) {
    REQUIRE(writeText(stage.folder / "some.json", text));
    loadRecipeFile(stage.shell, stage.folder / "some.json");
  };
  const std::string pose = R"({"controller": "left-hand", "keys": [{"frame": 4, "move": [0, 0.2, 0]}]})";
  const std::string trail = R"({"limb": "left-arm", "range": [20, 30], "scale": 2})";
  replay((R"({"version": 1, "trails": [)" + trail + "]}").c_str());
  CHECK(stage.isTold("1 trail from the recipe"));
  replay((R"({"version": 1, "trails": [], "adjustments": [)" + pose + "]}").c_str());
  CHECK(stage.isTold("1 thing from the recipe"));
  replay((R"({"version": 1, "trails": [)" + trail + R"(], "adjustments": [)" + pose + "]}").c_str());
  CHECK(stage.isTold("2 things from the recipe"));
}

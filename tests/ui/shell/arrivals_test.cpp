// What comes from outside while a tool runs or the clip plays: dropped files, finished imports, and commands.
#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "core/gltf/json/json.h"
#include "core/gltf/source/source.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/ui/editor_stage.h"
#include "ui/shell/clip_import.h"
#include "ui/shell/file_work.h"
#include "ui/viewport/tools.h"

using namespace stretch;
namespace command = stretch::app::command;

namespace {

const std::filesystem::path assets = STRETCH_SOURCE_DIR "/assets";

/// The boxer whose left arm is being exaggerated.
struct Exaggerating : test::EditorStage {
  Exaggerating() {
    openBoxer();
    for (const char* const key : {"1", "E", "3"}) {
      press(key);
    }
    frames(2);
    REQUIRE(ui::isRunning(shell.tool));
  }
};

} // namespace

TEST_CASE("A file that is dropped while a tool runs is opened after its work is kept and asked about") {
  Exaggerating stage;
  stage.drop({assets / "dummy_swing.glb"});
  stage.frames(2);
  CHECK_FALSE(ui::isRunning(stage.shell.tool));
  REQUIRE(stage.session().document().trails.size() == 1);
  CHECK(stage.session().document().trails.front().settings.scale == 3.0);
  stage.click("drop/Open");
  stage.frames(2);
  CHECK(stage.shell.files.question().kind == app::FileQuestion::Kind::unsaved);
}

TEST_CASE("A prop that is dropped while a tool runs is held, beside what the tool did") {
  Exaggerating stage;
  stage.drop({STRETCH_SOURCE_DIR "/tests/ui/things/bat.gltf"});
  stage.frames(2);
  stage.click("drop/Hold");
  stage.settle();
  stage.frames(2);
  CHECK(stage.session().document().trails.size() == 1);
  CHECK(stage.session().document().holds.props.size() == 1);
}

TEST_CASE("An imported clip waits for the tool, whether it keys by itself or not") {
  test::EditorStage stage;
  stage.openBoxer();
  if (GENERATE(true, false)) {
    stage.press("Shift+S"); // auto-key off
  }
  for (const char* const key : {"Alt+1", "G", "X", "1"}) {
    stage.press(key);
  }
  REQUIRE(ui::isRunning(stage.shell.tool));
  const std::size_t clips = stage.session().document().clips->size();
  ui::importClip(stage.shell, {assets / "dummy_swing.glb", -1});
  while (!stage.shell.beside.clipImport.job->isFinished()) {
    stage.frames(1);
  }
  stage.frames(3);
  CHECK(stage.session().view().clip == 0);
  CHECK(stage.session().document().clips->size() == clips);
  stage.press("Enter");
  stage.settle();
  CHECK(stage.session().document().clips->size() == clips + 1);
}

TEST_CASE("While the clip plays a range begins and ends on whole frames") {
  test::EditorStage stage;
  stage.openBoxer();
  stage.shell.ui.time.timeline.playing = true;
  stage.session().view().frame = 8.4;
  stage.press("[");
  CHECK(stage.session().view().rangeStart == 8.0);
  stage.shell.ui.time.timeline.playing = true;
  stage.session().view().frame = 15.2;
  stage.press("]");
  CHECK(stage.session().view().rangeEnd == 15.0);
}

TEST_CASE("Controllers of a character without clips are selected as others are") {
  test::EditorStage stage;
  gltf::Source source = *test::openedFile((assets / "dummy.glb").string()).source;
  source.json->erase("animations");
  const std::filesystem::path file = stage.folder / "still.glb";
  REQUIRE(gltf::save(source, file).ok());
  ui::openFile(stage.shell, {file});
  stage.settle();
  stage.frames(2);
  REQUIRE(stage.session().document().clips->empty());
  stage.press(GENERATE("Alt+1", "Tab", "Ctrl+A"));
  stage.frames(2);
  CHECK_FALSE(stage.session().view().selection.controllers().empty());
  CHECK(stage.session().pops().empty());
}

#include <chrono>
#include <thread>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/files/save.h"
#include "app/open_document.h"
#include "tests/support/app/mesh_file.h"
#include "tests/support/skinning/tube_person.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/shell/clip_import.h"
#include "ui/shell/shell_commands.h"

using namespace stretch;
using namespace stretch::ui;

namespace {

/// The editor with a character, whose work goes on beside the window.
struct Working {
  explicit Working(app::Document document) {
    shell.open.open(app::Opened{std::move(document)});
    shell.commands = editorCommands();
    shell.keymap = app::Keymap(app::keyedCommands(shell.commands));
  }

  void press(const char* key) {
    KeyInput input;
    input.press.chord = *app::parseChord(key);
    input.down = true;
    dispatchKey(shell, input);
  }
  void waitUntilDone() {
    while (isBusy(shell)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      updateBinding(shell);
      updateFitting(shell);
      updateClipImport(shell);
    }
  }
  [[nodiscard]] const app::Session& session() const { return *shell.open.character(); }

  Shell shell;
};

app::Document statue() {
  const test::TemporaryFolder folder;
  const test::TubePerson person = test::tubePerson();
  test::writeMeshFile(folder / "person.gltf", person.positions, person.triangles);
  Result<app::Document> document = app::openDocument(folder / "person.gltf");
  REQUIRE(document);
  return std::move(*document);
}

bool changesNothingWhenStopped(Working& working) {
  REQUIRE(isBusy(working.shell));
  working.press("Esc");
  REQUIRE(working.shell.ui.toasts.size() == 1);
  CHECK(working.shell.ui.toasts.front().text == "Stopped: nothing was changed");
  working.waitUntilDone();
  return !working.session().history().canUndo();
}

} // namespace

TEST_CASE("Esc stops fitting locators, and the same again finds them", "[jobs]") {
  Working working(statue());
  runCommand(working.shell, command::locatorsFit);
  CHECK(changesNothingWhenStopped(working));
  CHECK(working.session().document().locators.empty());
  runCommand(working.shell, command::locatorsFit);
  working.waitUntilDone();
  CHECK(working.session().document().locators.list.size() == 22);
}

TEST_CASE("Esc stops binding, and the mesh keeps its weights", "[jobs]") {
  Working working(test::PanelDriver::bundledCharacter());
  const auto source = working.session().document().source;
  working.press("Ctrl+B");
  CHECK(changesNothingWhenStopped(working));
  CHECK(working.session().document().source == source);
}

TEST_CASE("Esc stops importing a clip, and no clip is added", "[jobs]") {
  Working working(test::PanelDriver::bundledCharacter());
  const std::size_t clips = working.session().document().clips->size();
  importClip(working.shell, {STRETCH_SOURCE_DIR "/assets/dummy_swing.glb", -1});
  CHECK(changesNothingWhenStopped(working));
  CHECK(working.session().document().clips->size() == clips);
  importClip(working.shell, {STRETCH_SOURCE_DIR "/assets/dummy_swing.glb", -1});
  working.waitUntilDone();
  CHECK(working.session().document().clips->size() > clips);
}

TEST_CASE("Esc says nothing once nothing is in progress", "[jobs]") {
  Working working(test::PanelDriver::bundledCharacter());
  importClip(working.shell, {STRETCH_SOURCE_DIR "/assets/dummy_swing.glb", -1});
  CHECK(changesNothingWhenStopped(working));
  working.press("Esc");
  CHECK(working.shell.ui.toasts.size() == 1);
}

TEST_CASE("A clip that is ready while something is dragged comes in when the drag is over", "[jobs]") {
  Working working(test::PanelDriver::bundledCharacter());
  importClip(working.shell, {STRETCH_SOURCE_DIR "/assets/dummy_swing.glb", -1});
  app::Session& session = *working.shell.open.character();
  const std::size_t before = session.document().clips->size();
  session.begin("Drag");
  while (working.shell.beside.clipImport.job != nullptr &&
         !working.shell.beside.clipImport.job->isFinished()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  updateClipImport(working.shell);
  CHECK(session.isDragging());
  CHECK(session.document().clips->size() == before);
  session.cancel();
  updateClipImport(working.shell);
  CHECK(session.document().clips->size() > before);
  CHECK(session.history().canUndo());
}

TEST_CASE("A clip for a character that is not open any more is told and left out", "[jobs]") {
  Working working(test::PanelDriver::bundledCharacter());
  importClip(working.shell, {STRETCH_SOURCE_DIR "/assets/dummy_swing.glb", -1});
  Result<app::Document> other = app::openDocument(STRETCH_SOURCE_DIR "/assets/dummy_leap.glb");
  REQUIRE(other);
  working.shell.open.open(app::Opened{std::move(*other)});
  working.waitUntilDone();
  CHECK_FALSE(working.session().history().canUndo());
  REQUIRE(working.shell.ui.toasts.size() == 1);
  CHECK(working.shell.ui.toasts.front().text ==
        "dummy_swing.glb was for a character that is not open any more");
}

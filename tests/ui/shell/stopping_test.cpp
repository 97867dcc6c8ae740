#include <chrono>
#include <thread>

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/files/save.h"
#include "app/locators/locator_edits.h"
#include "app/open_document.h"
#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "tests/support/app/mesh_file.h"
#include "tests/support/skinning/tube_creature.h"
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

app::Document statue(const test::TubePerson& person = test::tubePerson()) {
  const test::TemporaryFolder folder;
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

// What the panel asks for when a choice of its list of bodies is taken.
std::string requestedBy(const app::Document& document, const std::string& choice) {
  test::PanelDriver driver{document};
  driver.open.character()->view().showLocators = true;
  driver.frames(3);
  REQUIRE(driver.find("locators/plan") != nullptr);
  driver.click("locators/plan");
  driver.frames(2);
  driver.click("locators/plan/" + choice);
  REQUIRE(driver.requested.size() == 1);
  return driver.requested.front();
}

void runAndWait(Working& working, const std::string& command) {
  runCommand(working.shell, command);
  working.waitUntilDone();
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

TEST_CASE("The key that binds stops binding, too", "[jobs]") {
  Working working(test::PanelDriver::bundledCharacter());
  const auto source = working.session().document().source;
  working.press("Ctrl+B");
  working.press("Ctrl+B");
  working.waitUntilDone();
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

TEST_CASE("A file's only clip is told by its name, several clips by how many came", "[jobs]") {
  const test::TemporaryFolder folder;
  const app::Document boxer = test::PanelDriver::bundledCharacter();
  const Result<app::NewClips> swing =
      app::clipsFromFile(boxer, {STRETCH_SOURCE_DIR "/assets/dummy_swing.glb", {}, {}});
  REQUIRE(swing);
  REQUIRE(swing->clips.size() == 1);
  const Result<app::Document> more = app::withNewClips(boxer, {swing->clips.front().clip});
  REQUIRE(more);
  REQUIRE(app::saveDocument(*more, folder / "moves.glb", {}));
  REQUIRE(more->clips->size() > 1);
  const auto told = [&](const std::filesystem::path& file) {
    Working working(boxer);
    importClip(working.shell, {file, -1});
    working.waitUntilDone();
    REQUIRE_FALSE(working.shell.ui.toasts.empty());
    return working.shell.ui.toasts.front().text;
  };
  CHECK(told(STRETCH_SOURCE_DIR "/assets/dummy_swing.glb") ==
        more->clips->back().name + " is imported: its keys are as in its file");
  CHECK(told(folder / "moves.glb") == std::to_string(more->clips->size()) + " clips imported");
}

TEST_CASE("Of what a clip could not bring along two lines are told, and how many more there are", "[jobs]") {
  const test::TemporaryFolder folder;
  const Result<app::Document> swing = app::openDocument(STRETCH_SOURCE_DIR "/assets/dummy_swing.glb");
  REQUIRE(swing);
  const auto told = [&](int lost) {
    gltf::Source source = *swing->source;
    gltf::Json json = *source.json;
    json["extensionsUsed"].push_back("KHR_animation_pointer");
    for (int node = 0; node < lost; ++node) {
      const std::string visible =
          "/nodes/" + std::to_string(node) + "/extensions/KHR_node_visibility/visible";
      const gltf::Json target{{"path", "pointer"},
                              {"extensions", {{"KHR_animation_pointer", {{"pointer", visible}}}}}};
      json["animations"][0]["channels"].push_back({{"sampler", 0}, {"target", target}});
    }
    source.json = json;
    REQUIRE(gltf::save(source, folder / "hidden.glb"));
    Working working(test::PanelDriver::bundledCharacter());
    importClip(working.shell, {folder / "hidden.glb", -1});
    working.waitUntilDone();
    REQUIRE_FALSE(working.shell.ui.toasts.empty());
    return working.shell.ui.toasts.back().text;
  };
  // The bat is a line of its own.
  CHECK_THAT(told(1), Catch::Contains("/nodes/0/") && Catch::Contains("Bat") && !Catch::Contains("more)"));
  CHECK_THAT(told(2), Catch::Contains("/nodes/1/") && Catch::EndsWith(" (and 1 more)"));
  CHECK_THAT(told(5), !Catch::Contains("/nodes/2/") && Catch::EndsWith(" (and 4 more)"));
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

namespace {

/// Another character in place of the one that is open, as its file would be opened.
void openLeap(Working& working) {
  Result<app::Document> other = app::openDocument(STRETCH_SOURCE_DIR "/assets/dummy_leap.glb");
  REQUIRE(other);
  working.shell.open.open(app::Opened{std::move(*other)});
}

} // namespace

TEST_CASE("Weights and locators that are ready when another character is open are left out", "[jobs]") {
  const bool binds = GENERATE(false, true);
  Working working(binds ? test::PanelDriver::bundledCharacter() : statue());
  runCommand(working.shell, binds ? command::bindMesh : command::locatorsFit);
  CHECK(statusOf(working.shell).busyText == (binds ? "Binding the mesh" : "Fitting locators"));
  openLeap(working);
  working.waitUntilDone();
  CHECK_FALSE(working.session().history().canUndo());
  CHECK(working.shell.ui.toasts.empty());
}

TEST_CASE("Locators that are found while something is dragged come in when the drag is over", "[jobs]") {
  Working working(statue());
  runCommand(working.shell, command::locatorsFit);
  app::Session& session = *working.shell.open.character();
  session.begin("Drag");
  while (!working.shell.beside.fitting.job->isFinished()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  updateFitting(working.shell);
  CHECK(session.isDragging());
  CHECK(working.shell.beside.fitting.job != nullptr);
  session.cancel();
  updateFitting(working.shell);
  CHECK(working.shell.beside.fitting.job == nullptr);
  CHECK(session.document().locators.list.size() == 22);
  CHECK(session.history().undoLabel() == "Fit locators");
}

TEST_CASE("Weights that are ready while something is dragged come in when the drag is over", "[jobs]") {
  Working working(test::PanelDriver::bundledCharacter());
  app::Session& session = *working.shell.open.character();
  const auto source = session.document().source;
  working.press("Ctrl+B");
  session.begin("Drag");
  while (!working.shell.beside.binding.job->isFinished()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  updateBinding(working.shell);
  CHECK(session.isDragging());
  CHECK(session.document().source == source);
  session.cancel();
  updateBinding(working.shell);
  CHECK(session.document().source != source);
  CHECK(session.history().undoLabel() == "Bind again");
  REQUIRE_FALSE(working.shell.ui.toasts.empty());
  CHECK_THAT(working.shell.ui.toasts.front().text,
             Catch::StartsWith("Bound: ") && Catch::EndsWith("Undo (Ctrl+Z) brings them back"));
}

TEST_CASE("The panel of a mesh fits the locators of the body that is chosen, and undo takes them back",
          "[locators][panels]") {
  Working editor(statue(test::tubeInsect(4)));
  runAndWait(editor, command::locatorsFit);
  REQUIRE(editor.session().document().locators.plan == "spider");
  const rig::Locators before = editor.session().document().locators;
  const std::string request = requestedBy(editor.session().document(), "An insect");
  CHECK(request == command::locatorsFitPrefix + std::string("insect"));
  runAndWait(editor, request);
  CHECK(editor.session().document().locators.plan == "insect");
  runAndWait(editor, command::locatorsReset);
  CHECK(editor.session().document().locators.plan == "insect");
  runAndWait(editor, command::undo);
  CHECK(editor.session().document().locators == before);
  runAndWait(editor, command::undo);
  CHECK(editor.session().document().locators.empty());
}

TEST_CASE("A mesh without locators offers the same bodies", "[locators][panels]") {
  const app::Document mesh = statue(test::tubeQuadruped());
  CHECK(requestedBy(mesh, "A quadruped") == command::locatorsFitPrefix + std::string("quadruped"));
}

TEST_CASE("A creature's locators are moved with their counterparts and built as every one's are",
          "[locators][panels]") {
  Working editor(statue(test::tubeQuadruped()));
  runAndWait(editor, command::locatorsFit);
  const app::Document moved =
      app::moveLocators(editor.session().document(), {"leftHock"}, {0.05, 0.0, 0.0}, true);
  const double before = rig::findLocator(editor.session().document().locators, "rightHock")->position.x;
  CHECK(rig::findLocator(moved.locators, "rightHock")->position.x == Approx(before - 0.05).margin(1e-3));
  runAndWait(editor, command::rigBuild);
  CHECK(editor.session().document().body.plan == "quadruped");
  // With its joints made there is nothing more to choose.
  test::PanelDriver driver{editor.session().document()};
  driver.frames(3);
  CHECK(driver.find("locators/plan") == nullptr);
}

TEST_CASE("What does not show its body is told in the window, and nothing is changed", "[locators][panels]") {
  Working editor(statue(test::tubeStooping()));
  runAndWait(editor, command::locatorsFit);
  CHECK(editor.session().document().locators.empty());
  REQUIRE_FALSE(editor.shell.ui.toasts.empty());
  CHECK(editor.shell.ui.toasts.front().text.find("biped, quadruped, bird, insect, spider") !=
        std::string::npos);
}

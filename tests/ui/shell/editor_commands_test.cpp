#include <catch2/catch.hpp>

#include <filesystem>
#include <regex>
#include <set>

#include "app/commands/table/command_ids.h"
#include "core/base/file.h"
#include "tests/support/app/key_tables.h"
#include "tests/support/ui/editor_stage.h"
#include "ui/shell/shell_commands.h"

using namespace stretch;
using namespace stretch::ui;
namespace fs = std::filesystem;

namespace {

std::string textOf(const fs::path& path) {
  const Result<std::string> text = readText(path);
  REQUIRE(text);
  return *text;
}

/// The ids of app/commands/table/command_ids.h; none is there twice.
std::set<std::string> listedIds() {
  const std::string text = textOf(STRETCH_SOURCE_DIR "/app/commands/table/command_ids.h");
  const std::regex definition("const char\\* \\w+ =\\s+\"([^\"]+)\"");
  std::set<std::string> ids;
  for (std::sregex_iterator found(text.begin(), text.end(), definition), end; found != end; ++found) {
    INFO((*found)[1]);
    CHECK(ids.insert((*found)[1]).second);
  }
  return ids;
}

} // namespace

TEST_CASE("No key of the editor is bound twice, and every command has a name, a sentence of help and an id "
          "of its own") {
  const std::vector<app::Command<Shell>> commands = editorCommands();
  for (const std::string& problem : test::keyProblems(app::keyedCommands(commands))) {
    FAIL_CHECK(problem);
  }
  std::set<std::string> ids;
  for (const app::Command<Shell>& command : commands) {
    INFO(command.id);
    CHECK(ids.insert(command.id).second);
    CHECK_FALSE(command.label.empty());
    CHECK(command.help.size() > 10);
    CHECK(command.help.back() == '.');
    CHECK(command.enabled);
    CHECK(command.run);
  }
}

namespace {

// Keys of the specification's table, and what they run.
const std::pair<const char*, const char*> specifiedKeys[] = {{"1", "limb.left-arm"},
                                                             {"2", "limb.right-arm"},
                                                             {"3", "limb.left-leg"},
                                                             {"4", "limb.right-leg"},
                                                             {"5", "limb.spine"},
                                                             {"6", "limb.neck"},
                                                             {"Shift+1", "limb.left-arm-add"},
                                                             {"0", "limb.none"},
                                                             {"J", command::pickChain},
                                                             {"[", command::rangeStart},
                                                             {"]", command::rangeEnd},
                                                             {"Alt+,", command::rangeStart},
                                                             {"Alt+.", command::rangeEnd},
                                                             {"T", command::trailToggle},
                                                             {"E", command::trailExaggerate},
                                                             {"Tab", command::sphereNext},
                                                             {"Shift+Tab", command::spherePrevious},
                                                             {"G", "sphere.grab"},
                                                             {"B", command::trailBlend},
                                                             {"`", command::trailShowOriginal},
                                                             {"O", command::trailShowOriginal},
                                                             {"C", command::trailConnect},
                                                             {"Shift+C", command::trailFollow},
                                                             {",", command::timeBack},
                                                             {".", command::timeForward},
                                                             {"Ctrl+,", command::timePreviousKey},
                                                             {"Ctrl+.", command::timeNextKey},
                                                             {"Home", command::timeStart},
                                                             {"End", command::timeEnd},
                                                             {"Space", command::timePlay},
                                                             {"H", command::viewGhosts},
                                                             {"K", command::viewSkeleton},
                                                             {"W", command::viewWire},
                                                             {"F", command::viewFrameSelection},
                                                             {"A", command::viewFrameAll},
                                                             {"Numpad 1", command::keptView[0]},
                                                             {"Numpad 3", command::keptView[2]},
                                                             {"Numpad 7", command::keptView[6]},
                                                             {"Numpad 5", command::keptView[4]},
                                                             {"Ctrl+4", command::keepView[3]},
                                                             {"Numpad 0", command::viewCamera},
                                                             {"Enter", command::trailApply},
                                                             {"S", command::poseKey},
                                                             {"Shift+S", command::poseAutoKey},
                                                             {"Delete", "edit.delete"},
                                                             {"Shift+Delete", command::trailDeleteAll},
                                                             {"Ctrl+C", command::copyTrail},
                                                             {"Ctrl+V", command::pasteTrail},
                                                             {"Ctrl+M", command::mirrorTrail},
                                                             {"Ctrl+Z", command::undo},
                                                             {"Ctrl+Shift+Z", command::redo},
                                                             {"Ctrl+Y", command::redo},
                                                             {"Ctrl+O", command::fileOpen},
                                                             {"Ctrl+S", command::fileSave},
                                                             {"Ctrl+Shift+S", command::fileSaveAs},
                                                             {"Ctrl+P", command::palette},
                                                             {"F3", command::palette},
                                                             {"?", command::keys}};

} // namespace

TEST_CASE("Every id of the list has a command, every command an id of the list, and no id is spelled "
          "anywhere else") {
  const std::set<std::string> listed = listedIds();
  REQUIRE(listed.size() > 80);
  std::set<std::string> known;
  for (const app::Command<Shell>& command : editorCommands()) {
    known.insert(command.id);
    // Those of directions, of kept views, of body plans, of their locators and of limbs that are added to the
    // selection are put together.
    const bool puttogether =
        command.id.rfind("view.keep-", 0) == 0 || command.id.rfind("view.kept-", 0) == 0 ||
        command.id.rfind("sphere.nudge-", 0) == 0 || command.id.rfind("controller.nudge-", 0) == 0 ||
        command.id.rfind(command::planPrefix, 0) == 0 ||
        command.id.rfind(command::locatorsFitPrefix, 0) == 0 || command.id.rfind("-add") != std::string::npos;
    INFO(command.id);
    CHECK((puttogether || listed.count(command.id) == 1));
  }
  for (const std::string& id : listed) {
    INFO(id);
    CHECK((id == command::planPrefix || id == command::locatorsFitPrefix || known.count(id) == 1));
  }
  for (const char* room : {"app", "ui"}) {
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(STRETCH_SOURCE_DIR) / room)) {
      const bool isSource = entry.path().extension() == ".cpp";
      const std::string text = isSource ? textOf(entry.path()) : std::string();
      for (const std::string& id : listed) {
        INFO(entry.path() << " spells " << id);
        CHECK(text.find('"' + id + '"') == std::string::npos);
      }
    }
  }
}

TEST_CASE("The keys of the specification's table run what it says") {
  const app::Keymap keymap(app::keyedCommands(editorCommands()));
  for (const auto& [key, id] : specifiedKeys) {
    INFO(key);
    const auto chord = app::parseChord(key);
    REQUIRE(chord);
    CHECK(keymap.commandOf(*chord) == id);
  }
}

TEST_CASE("Without a file only what needs none is on") {
  Shell shell;
  shell.commands = editorCommands();
  for (const app::Command<Shell>& command : shell.commands) {
    INFO(command.id);
    const bool needsFile = command.id.rfind("trail.", 0) == 0 || command.id.rfind("limb.", 0) == 0 ||
                           command.id.rfind("sphere.", 0) == 0 || command.id.rfind("time.", 0) == 0;
    if (needsFile) {
      CHECK_FALSE(command.enabled(shell));
    } else {
      static_cast<void>(command.enabled(shell));
    }
  }
  runCommand(shell, command::trailApply);
  REQUIRE(shell.ui.toasts.size() == 1);
}

TEST_CASE("Whose key was taken is told by its label, and whether it has others") {
  test::EditorStage stage;
  const auto give = [&](const char* command, const char* key) {
    stage.shell.ui.dialogs.keys.open = true;
    stage.shell.ui.dialogs.keys.filter = "apply";
    stage.frames(3);
    stage.click(std::string("keys/") + command);
    stage.press(key);
    stage.frames(2);
    return stage.shell.ui.dialogs.keys.clash;
  };
  CHECK(give(command::trailApply, "T") == "T was the key of \"Motion trail\", which has none now.");
  CHECK(give(command::trailApply, "Ctrl+Y") == "Ctrl+Y was the key of \"Redo\", which has others.");
  CHECK(give(command::trailApply, "Ctrl+Shift+F12").empty());
}

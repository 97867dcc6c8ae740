#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <imgui_internal.h>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "core/math/euler.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/panels/files/file_listing.h"
#include "ui/panels/rows/graph_model.h"

using namespace stretch;
using test::PanelDriver;
namespace fs = std::filesystem;

namespace {

/// A folder of its own with a few files; removed at the end.
struct Folder {
  Folder() : path(fs::temp_directory_path() / ("stretch-engine-file-dialog-" + std::to_string(getpid()))) {
    fs::remove_all(path);
    fs::create_directories(path / "clips");
    for (const char* name : {"Punch.glb", "walk.gltf", "avatar.vrm", "notes.txt", ".hidden.glb"}) {
      std::ofstream(path / name) << "x";
    }
    std::ofstream(path / "clips" / "run.glb") << "x";
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path path;
};

void openFiles(PanelDriver& driver, const Folder& folder, ui::FilePurpose purpose) {
  driver.ui.dialogs.file = {};
  driver.ui.dialogs.file.open = true;
  driver.ui.dialogs.file.purpose = purpose;
  driver.ui.dialogs.file.folder = folder.path;
  driver.frames(3);
}

} // namespace

TEST_CASE("A folder lists folders first, then the files that can be opened") {
  const Folder folder;
  const Result<std::vector<ui::FileEntry>> entries = ui::listFolder(folder.path, ui::FilePurpose::openModel);
  REQUIRE(entries.ok());
  std::vector<std::string> names;
  for (const ui::FileEntry& entry : *entries) {
    names.push_back(entry.name);
  }
  CHECK(names == std::vector<std::string>{"clips", "avatar.vrm", "Punch.glb", "walk.gltf"});
  CHECK_FALSE(ui::listFolder(folder.path / "missing", ui::FilePurpose::openModel).ok());
}

TEST_CASE("A file is opened by a double click, in a folder, and by its typed name") {
  const Folder folder;
  PanelDriver driver(std::nullopt);
  openFiles(driver, folder, ui::FilePurpose::openModel);
  SECTION("click") {
    driver.click("files/entry/Punch.glb");
    CHECK(driver.ui.dialogs.file.open);
    CHECK(driver.ui.dialogs.file.facts.kind == "Binary glTF");
    driver.doubleClick("files/entry/Punch.glb");
    REQUIRE(driver.ui.answers.file);
    CHECK(driver.ui.answers.file->path == folder.path / "Punch.glb");
    CHECK_FALSE(driver.ui.dialogs.file.open);
  }
  SECTION("folder, then click") {
    driver.doubleClick("files/entry/clips");
    driver.doubleClick("files/entry/run.glb");
    REQUIRE(driver.ui.answers.file);
    CHECK(driver.ui.answers.file->path == folder.path / "clips" / "run.glb");
  }
  SECTION("typed") {
    driver.type("punc");
    driver.pressKey(ImGuiKey_Enter);
    REQUIRE(driver.ui.answers.file);
    CHECK(driver.ui.answers.file->path == folder.path / "Punch.glb");
  }
  SECTION("typed after a click elsewhere") {
    driver.click("files/entry/walk.gltf");
    driver.type("pun");
    CHECK(driver.ui.dialogs.file.factsPath.filename() == "Punch.glb");
    driver.pressKey(ImGuiKey_Enter);
    REQUIRE(driver.ui.answers.file);
    CHECK(driver.ui.answers.file->path == folder.path / "Punch.glb");
  }
  SECTION("only the kind that was asked for is listed") {
    CHECK(driver.find("files/entry/avatar.vrm") != nullptr);
    driver.click("files/type/Sequences");
    CHECK(driver.find("files/entry/avatar.vrm") == nullptr);
    CHECK(driver.find("files/entry/clips") != nullptr);
  }
  SECTION("Backspace goes up a folder") {
    driver.doubleClick("files/entry/clips");
    driver.pressKey(ImGuiKey_Backspace);
    driver.frames(2);
    CHECK(driver.ui.dialogs.file.folder == folder.path);
  }
  SECTION("Esc closes without an answer") {
    driver.pressKey(ImGuiKey_Escape);
    driver.frames(2);
    CHECK_FALSE(driver.ui.dialogs.file.open);
    CHECK_FALSE(driver.ui.answers.file);
  }
}

TEST_CASE("A typed path is opened, whatever rows stand in the list") {
  const Folder folder;
  PanelDriver driver(std::nullopt);
  openFiles(driver, folder, ui::FilePurpose::openModel);
  SECTION("though the folder holds one file") {
    driver.doubleClick("files/entry/clips");
    driver.type((folder.path / "walk.gltf").string());
    driver.pressKey(ImGuiKey_Enter);
    REQUIRE(driver.ui.answers.file);
    CHECK(driver.ui.answers.file->path == folder.path / "walk.gltf");
  }
  SECTION("a click on a row takes the place of a typed path") {
    driver.type("/nowhere/else.glb");
    driver.click("files/entry/walk.gltf");
    CHECK(driver.ui.dialogs.file.typed.empty());
    driver.pressKey(ImGuiKey_Enter);
    REQUIRE(driver.ui.answers.file);
    CHECK(driver.ui.answers.file->path == folder.path / "walk.gltf");
  }
}

TEST_CASE("A new folder is made and shown, one that is there already is not") {
  const Folder folder;
  PanelDriver driver(std::nullopt);
  openFiles(driver, folder, ui::FilePurpose::saveModel);
  driver.click("files/new-folder");
  driver.frames(2);
  driver.type("clips");
  driver.pressKey(ImGuiKey_Enter);
  CHECK(driver.ui.dialogs.file.folder == folder.path);
  CHECK_FALSE(driver.ui.dialogs.file.message.empty());
  driver.type("2");
  driver.pressKey(ImGuiKey_Enter);
  driver.frames(2);
  CHECK(driver.ui.dialogs.file.folder == folder.path / "clips2");
  CHECK(fs::is_directory(folder.path / "clips2"));
}

TEST_CASE("Folders of recent files are places, each once") {
  const std::vector<fs::path> files{"/a/x.glb", "/b/y.glb", "/a/z.glb", "/c/w.glb"};
  CHECK(ui::recentFolders(files, 2) == std::vector<fs::path>{"/a", "/b"});
}

TEST_CASE("Endings of files are told in whatever case, and each that can be opened is of one kind") {
  CHECK(ui::hasExtension("/clips/WALK.GLB", {".gltf", ".glb"}));
  CHECK_FALSE(ui::hasExtension("/clips/glb", {".glb"}));
  const std::vector<ui::FileType> types = ui::fileTypesOf(ui::FilePurpose::openModel);
  std::vector<std::string> ofKinds;
  for (std::size_t i = 1; i < types.size(); ++i) {
    ofKinds.insert(ofKinds.end(), types[i].extensions.begin(), types[i].extensions.end());
  }
  std::vector<std::string> all = types.front().extensions;
  std::ranges::sort(ofKinds);
  std::ranges::sort(all);
  CHECK(ofKinds == all);
}

TEST_CASE("A path is typed from the folder that is shown, from the root or from the home folder") {
  CHECK(ui::typedPath("/shots/clips", "run.glb") == "/shots/clips/run.glb");
  CHECK(ui::typedPath("/shots/clips", "../walk.glb") == "/shots/walk.glb");
  CHECK(ui::typedPath("/shots/clips", "/other/a.glb") == "/other/a.glb");
  CHECK(ui::typedPath("/shots/clips", "~") == ui::homeFolder() / "");
  CHECK(ui::typedPath("/shots/clips", "~/a.glb") == ui::homeFolder() / "a.glb");
  CHECK(ui::typedPath("/shots/clips", "~a.glb") == "/shots/clips/~a.glb");
}

TEST_CASE("The size of a file is told in the unit in which it is at least one") {
  CHECK(ui::sizeText(999) == "999 B");
  CHECK(ui::sizeText(1000) == "1 kB");
  CHECK(ui::sizeText(1'000'000) == "1 MB");
  CHECK(ui::sizeText(1'450'000'000) == "1450 MB");
}

TEST_CASE("Saving over a file asks first, and a missing extension is added") {
  const Folder folder;
  PanelDriver driver(std::nullopt);
  openFiles(driver, folder, ui::FilePurpose::saveModel);
  driver.type("Punch");
  driver.pressKey(ImGuiKey_Enter);
  CHECK_FALSE(driver.ui.answers.file);
  CHECK(driver.ui.dialogs.file.confirmOverwrite);
  driver.frames(2);
  driver.click("files/Replace");
  REQUIRE(driver.ui.answers.file);
  CHECK(driver.ui.answers.file->path == folder.path / "Punch.glb");
}

TEST_CASE("Without a name nothing is saved or opened: a name is asked for, and the folder stays as it is") {
  const Folder folder;
  PanelDriver driver(std::nullopt);
  const bool saves = GENERATE(true, false);
  openFiles(driver, folder, saves ? ui::FilePurpose::saveModel : ui::FilePurpose::openModel);
  driver.pressKey(ImGuiKey_Enter);
  CHECK(driver.ui.dialogs.file.open);
  CHECK_FALSE(driver.ui.answers.file);
  CHECK(driver.ui.dialogs.file.message == (saves ? "Type a name for the file." : ""));
  CHECK(driver.ui.dialogs.file.folder == folder.path);
  driver.pressKey(ImGuiKey_Backspace);
  CHECK(driver.ui.dialogs.file.folder == folder.path.parent_path());
}

TEST_CASE("The palette runs what was typed with Enter") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.ui.dialogs.palette.open = true;
  driver.frames(3);
  driver.type("select left arm");
  driver.pressKey(ImGuiKey_Enter);
  CHECK(driver.requested == std::vector<std::string>{"limb.left-arm"});
  CHECK_FALSE(driver.ui.dialogs.palette.open);
}

TEST_CASE("The palette is walked by the arrow keys, runs nothing that is off, and begins anew when it opens "
          "again") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  ui::PaletteState& palette = driver.ui.dialogs.palette;
  palette.open = true;
  driver.frames(3);
  driver.type("select");
  driver.frame();
  driver.pressKey(ImGuiKey_DownArrow);
  driver.pressKey(ImGuiKey_DownArrow);
  CHECK(palette.highlighted == 2);
  driver.pressKey(ImGuiKey_UpArrow);
  CHECK(palette.highlighted == 1);
  driver.pressKey(ImGuiKey_KeyPadEnter);
  REQUIRE(driver.requested.size() == 1);
  CHECK_FALSE(palette.open);
  palette.typed.clear();
  palette.highlighted = 5;
  palette.open = true;
  driver.frames(3);
  CHECK(palette.highlighted == 0);
  driver.requested.clear();
  driver.type("undo"); // There is nothing to undo.
  driver.frame();
  driver.pressKey(ImGuiKey_Enter);
  CHECK(std::ranges::find(driver.requested, app::command::undo) == driver.requested.end());
}

TEST_CASE("Unsaved changes: every way out gives an answer") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.status.question.kind = app::FileQuestion::Kind::unsaved;
  driver.frames(3);
  SECTION("save") {
    driver.click("unsaved/Save");
    CHECK(driver.ui.answers.question == app::FileAnswer::save);
  }
  SECTION("discard") {
    driver.click("unsaved/Don't save");
    CHECK(driver.ui.answers.question == app::FileAnswer::discard);
  }
  SECTION("Esc") {
    driver.pressKey(ImGuiKey_Escape);
    driver.frames(2);
    CHECK(driver.ui.answers.question == app::FileAnswer::cancel);
  }
}

TEST_CASE("A file that another program changed is overwritten, left, or saved elsewhere") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.status.question = {app::FileQuestion::Kind::overwrite, "/a/punch.glb"};
  driver.frames(3);
  SECTION("overwrite") {
    driver.click("overwrite/Overwrite");
    CHECK(driver.ui.answers.question == app::FileAnswer::overwrite);
  }
  SECTION("elsewhere") {
    driver.click("overwrite/Save as");
    CHECK(driver.ui.answers.question == app::FileAnswer::otherName);
  }
  SECTION("Enter decides nothing, Esc leaves it") {
    driver.pressKey(ImGuiKey_Enter);
    CHECK_FALSE(driver.ui.answers.question);
    driver.pressKey(ImGuiKey_Escape);
    CHECK(driver.ui.answers.question == app::FileAnswer::cancel);
  }
}

TEST_CASE("Work that was left behind is restored with Enter") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.status.question = {app::FileQuestion::Kind::restore, "/a/punch.glb"};
  driver.frames(3);
  driver.pressKey(ImGuiKey_Enter);
  CHECK(driver.ui.answers.question == app::FileAnswer::restore);
}

TEST_CASE("The first start asks how the view is turned") {
  PanelDriver driver(std::nullopt);
  driver.ui.dialogs.navigationChoiceOpen = true;
  driver.frames(3);
  driver.click("navigation/blender");
  CHECK(driver.ui.answers.navigation == ui::NavigationStyle::blender);
  CHECK(driver.ui.navigation == ui::NavigationStyle::blender);
}

TEST_CASE("A key is changed in the keys overview") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.ui.dialogs.keys.open = true;
  driver.ui.dialogs.keys.filter = "apply";
  driver.frames(3);
  driver.click("keys/trail.apply");
  CHECK(driver.ui.dialogs.keys.waitingFor == "trail.apply");
  driver.status.pressedKey.assign(1, 'T');
  driver.frame();
  REQUIRE(driver.ui.answers.keyChange);
  CHECK(driver.ui.answers.keyChange->commandId == "trail.apply");
  CHECK(driver.ui.answers.keyChange->keyText == "T");
}

TEST_CASE("A command is found in the keys overview by the key that it has") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  driver.ui.dialogs.keys.open = true;
  driver.frames(3);
  driver.click("keys/filter");
  driver.type("Ctrl+Z");
  driver.frames(2);
  CHECK(driver.find(std::string("keys/") + app::command::undo) != nullptr);
  CHECK(driver.find("keys/trail.apply") == nullptr);
}

TEST_CASE("A limb's joints are chosen from the skeleton, and undo gives the found ones back") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  const rig::Limb before = *app::findLimb(driver.open.character()->document(), "left-arm");
  const NodeIndex forearm = before.joints.back();
  driver.ui.body.jointPick.open = true;
  driver.ui.body.jointPick.limbId = "left-arm";
  driver.frames(3);
  driver.click(fmt::format("joints/{}", forearm.value));
  driver.click(fmt::format("joints/{}", before.endNode.value));
  driver.click("joints/Use them");
  const rig::Limb* after = app::findLimb(driver.open.character()->document(), "left-arm");
  REQUIRE(after != nullptr);
  CHECK(after->joints.front() == forearm);
  CHECK(after->endNode == before.endNode);
  CHECK(driver.open.character()->undo());
  CHECK(*app::findLimb(driver.open.character()->document(), "left-arm") == before);
}

TEST_CASE("A third click in the skeleton begins a chain anew, and two make one that can be used") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  const rig::Limb limb = *app::findLimb(driver.open.character()->document(), "left-arm");
  const ui::JointPick& pick = driver.ui.body.jointPick;
  driver.ui.body.jointPick.open = true;
  driver.frames(3);
  const auto choose = [&](NodeIndex node) { driver.click(fmt::format("joints/{}", node.value)); };
  const auto isComplete = [&] { return driver.find("joints/Use them")->enabled; };
  choose(limb.joints.front());
  CHECK_FALSE(isComplete());
  choose(limb.endNode);
  CHECK((pick.baseNode == limb.joints.front() && pick.endNode == limb.endNode));
  CHECK(isComplete());
  choose(limb.joints.back());
  CHECK((pick.baseNode == limb.joints.back() && !pick.endNode.exists()));
  CHECK_FALSE(isComplete());
  choose(limb.endNode);
  CHECK(isComplete());
}

TEST_CASE("A chain of two joints that do not belong together is refused with a reason") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  const app::Document& document = driver.open.character()->document();
  driver.ui.body.jointPick.open = true;
  driver.ui.body.jointPick.baseNode = app::findLimb(document, "left-arm")->joints.front();
  driver.ui.body.jointPick.endNode = app::findLimb(document, "right-leg")->endNode;
  driver.frames(3);
  driver.click("joints/Use them");
  CHECK_FALSE(driver.ui.body.jointPick.message.empty());
  CHECK(driver.open.character()->document().chains.empty());
}

TEST_CASE("Angles of a turning joint do not jump") {
  Vec3 previous(0.0);
  for (int i = 0; i <= 360; ++i) {
    const double angle = static_cast<double>(i) * pi / 60.0; // three turns
    const Quat rotation = glm::angleAxis(angle, glm::normalize(Vec3(0.3, 1.0, 0.2)));
    const Vec3 angles = eulerNear(rotation, previous);
    const Quat again(angles);
    CHECK(std::abs(glm::dot(again, rotation)) == Approx(1.0).margin(1e-9));
    CHECK(glm::length(angles - previous) < 1.0);
    previous = angles;
  }
}

namespace {

bool showsTooltip() {
  const auto& windows = ImGui::GetCurrentContext()->Windows;
  return std::any_of(windows.begin(), windows.end(), [](const ImGuiWindow* window) {
    return window->WasActive && !window->Hidden && (window->Flags & ImGuiWindowFlags_Tooltip) != 0;
  });
}

bool isWholeInWindow(const ui::Item* item) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  return item != nullptr && item->min.y >= 0.0F && item->max.y <= window.y &&
         item->max.y - item->min.y > 8.0F;
}

} // namespace

TEST_CASE("A dialog that opens under a resting mouse shows no tooltip until the mouse has moved") {
  PanelDriver driver(std::nullopt);
  driver.ui.dialogs.navigationChoiceOpen = true;
  driver.frames(3);
  const ImVec2 card = driver.centreOf("navigation/maya");
  driver.ui.dialogs.navigationChoiceOpen = false;
  driver.pressKey(ImGuiKey_Escape);
  driver.frames(3);
  ImGui::GetIO().MousePos = card;
  driver.frames(60);
  driver.ui.dialogs.navigationChoiceOpen = true;
  driver.frames(90);
  CHECK_FALSE(showsTooltip());
  driver.moveBy(1.0F, 0.0F);
  driver.frames(60);
  CHECK(showsTooltip());
}

TEST_CASE("In a low window a dialog's content scrolls while its title and its buttons stay in sight") {
  PanelDriver driver(std::nullopt);
  ImGui::GetIO().DisplaySize = {640.0F, 300.0F};
  driver.ui.dialogs.settingsOpen = true;
  driver.frames(5);
  CHECK(isWholeInWindow(driver.find("settings/close")));
  CHECK(isWholeInWindow(driver.find("settings/Keys")));
  CHECK(isWholeInWindow(driver.find("settings/Close")));
  CHECK_FALSE(isWholeInWindow(driver.find("settings/on_twos")));
  driver.moveTo("settings/scale/100%");
  for (int i = 0; i < 40; ++i) {
    ImGui::GetIO().MouseWheel = -1.0F;
    driver.frame();
  }
  ImGui::GetIO().MouseWheel = 0.0F;
  driver.frames(2);
  CHECK(isWholeInWindow(driver.find("settings/on_twos")));
  CHECK(isWholeInWindow(driver.find("settings/Close")));
  driver.click("settings/Close");
  CHECK_FALSE(driver.ui.dialogs.settingsOpen);
}

TEST_CASE("A dialog whose content has room does not scroll") {
  PanelDriver driver(std::nullopt);
  ImGui::GetIO().DisplaySize = {1280.0F, 900.0F};
  driver.ui.dialogs.settingsOpen = true;
  driver.frames(5);
  CHECK(isWholeInWindow(driver.find("settings/theme/Dark")));
  CHECK(isWholeInWindow(driver.find("settings/on_twos")));
  const ImGuiWindow* const dialog = ImGui::FindWindowByName("##settings");
  REQUIRE(dialog != nullptr);
  CHECK(dialog->ScrollMax.y == 0.0F);
  CHECK(dialog->DC.ChildWindows.empty());
}

TEST_CASE("A clip of which nothing is exaggerated cannot be kept, and says why") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  ui::ClipStyleState& state = driver.ui.trails.clipStyle;
  rig::Moment moment;
  moment.limb = "left-arm";
  state.open = true;
  state.moments = {moment};
  state.on = {true};
  const auto keep = [&] {
    driver.frames(3);
    driver.click("clip-style/Exaggerate");
    driver.pressKey(ImGuiKey_Enter);
    REQUIRE(driver.find("clip-style/Exaggerate") != nullptr);
    CHECK(driver.find("clip-style/Exaggerate")->explained);
    return state.accepted;
  };
  SECTION("left out") {
    state.made = {{moment, 0, 1.0, false, "the style hardly stretches it"}};
    CHECK(ui::whyNothing(state) == "the style hardly stretches it");
    CHECK_FALSE(keep());
    CHECK_FALSE(driver.find("clip-style/Exaggerate")->enabled);
  }
  SECTION("switched off") {
    state.on = {false};
    CHECK(ui::whyNothing(state) == "every moment is switched off");
    CHECK_FALSE(keep());
  }
  SECTION("not known yet: kept as soon as it is") {
    state.working = true;
    CHECK(ui::whyNothing(state).empty());
    CHECK(keep());
  }
  SECTION("exaggerated") {
    state.made = {{moment, 1, 2.0, false, ""}};
    state.trails = {1};
    CHECK(ui::whyNothing(state).empty());
    CHECK(keep());
    CHECK(driver.find("clip-style/Exaggerate")->enabled);
  }
}

TEST_CASE("A file that is clicked in the list takes what is saved, once replacing it was confirmed") {
  const Folder folder;
  PanelDriver driver(std::nullopt);
  openFiles(driver, folder, ui::FilePurpose::saveModel);
  driver.frames(2);
  driver.click("files/entry/Punch.glb");
  CHECK(driver.ui.dialogs.file.typed == "Punch.glb");
  CHECK_FALSE(driver.ui.dialogs.file.confirmOverwrite);
  driver.frames(2);
  const bool byKey = GENERATE(true, false);
  if (byKey) {
    driver.pressKey(ImGuiKey_Enter);
  } else {
    driver.click("files/Save");
  }
  CHECK(driver.ui.dialogs.file.confirmOverwrite);
  driver.frames(2);
  driver.click("files/Replace");
  REQUIRE(driver.ui.answers.file);
  CHECK(driver.ui.answers.file->path == folder.path / "Punch.glb");
}

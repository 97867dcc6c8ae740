// What the file dialog tells of a file before it is opened.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/support/ui/drawn.h"
#include "tests/support/ui/panel_driver.h"
#include "ui/panels/files/file_facts_pane.h"
#include "ui/panels/files/file_listing.h"

using namespace stretch;
namespace fs = std::filesystem;

namespace {

/// The lines that the pane shows of a file.
std::vector<std::string> linesAbout(const app::FileFacts& facts) {
  test::PanelDriver driver(std::nullopt);
  const fs::path file = "/a/pack.glb";
  driver.ui.dialogs.file.factsPath = file;
  driver.ui.dialogs.file.facts = facts;
  ui::PanelContext context{driver.open,      driver.ui,    driver.theme, driver.commands,
                           driver.requested, driver.items, driver.status};
  ImGui::NewFrame();
  ImGui::SetNextWindowPos({0.0F, 0.0F});
  ImGui::SetNextWindowSize({800.0F, 800.0F});
  ImGui::Begin("facts of a file", nullptr, ImGuiWindowFlags_NoDecoration);
  ui::fileFacts(context, file);
  ImGui::End();
  ImGui::Render();
  return test::shownWords();
}

bool isAmong(const std::vector<std::string>& lines, const std::string& line) {
  return std::ranges::find(lines, line) != lines.end();
}

} // namespace

TEST_CASE(
    "A file tells its meshes, joints and clips, one of each as one, and the first seven clips by name") {
  app::FileFacts facts;
  facts.kind = "Binary glTF";
  facts.bytes = 2'000'000;
  facts.isScene = true;
  facts.meshes = 1;
  facts.joints = 26;
  for (int i = 0; i < 9; ++i) {
    facts.clips.push_back({i == 2 ? "" : "Walk" + std::to_string(i), 1.5});
  }
  const std::vector<std::string> lines = linesAbout(facts);
  for (const char* const line : {"pack.glb", "Binary glTF, 2 MB", "1 mesh, 26 joints",
                                 "9 clips:", "Walk0, 1.5 s", "clip 3, 1.5 s", "Walk6, 1.5 s", "and 2 more"}) {
    CAPTURE(line);
    CHECK(isAmong(lines, line));
  }
  CHECK_FALSE(isAmong(lines, "Walk7, 1.5 s"));
  CHECK_FALSE(isAmong(lines, "With trails and settings of this program"));
  facts.clips.resize(7);
  facts.carriesWork = true;
  const std::vector<std::string> seven = linesAbout(facts);
  CHECK(isAmong(seven, "Walk6, 1.5 s"));
  CHECK(std::ranges::none_of(seven, [](const std::string& line) { return line.starts_with("and "); }));
  CHECK(isAmong(seven, "With trails and settings of this program"));
}

TEST_CASE("A file without a skin or a clip says so, and one that cannot be read says why") {
  app::FileFacts facts;
  facts.kind = "glTF";
  facts.isScene = true;
  facts.meshes = 2;
  const std::vector<std::string> bare = linesAbout(facts);
  CHECK(isAmong(bare, "2 meshes, no skin"));
  CHECK(isAmong(bare, "No clip"));
  facts.joints = 1;
  facts.clips = {{"Walk", 2.0}};
  const std::vector<std::string> one = linesAbout(facts);
  CHECK(isAmong(one, "2 meshes, 1 joint"));
  CHECK(isAmong(one, "1 clip:"));
  facts.problem = "is cut off";
  const std::vector<std::string> broken = linesAbout(facts);
  CHECK(isAmong(broken, "It is cut off."));
  CHECK_FALSE(isAmong(broken, "1 clip:"));
  CHECK(isAmong(linesAbout({}), "It is not there any more."));
}

TEST_CASE("A saved file gets the first ending of its kind where it has none of them, in whatever case") {
  using ui::FilePurpose;
  CHECK(ui::withExtension("/a/punch", FilePurpose::saveModel) == "/a/punch.glb");
  CHECK(ui::withExtension("/a/punch.v2", FilePurpose::saveModel) == "/a/punch.v2.glb");
  CHECK(ui::withExtension("/a/punch.GLTF", FilePurpose::saveModel) == "/a/punch.GLTF");
  CHECK(ui::withExtension("/a/punch.fbx", FilePurpose::exportClean) == "/a/punch.fbx.glb");
  CHECK(ui::withExtension("/a/punch", FilePurpose::saveRecipe) == "/a/punch.json");
  CHECK(ui::withExtension("/a/punch", FilePurpose::saveFilm) == "/a/punch.mp4");
  CHECK(ui::withExtension("/a/punch.png", FilePurpose::saveFilm) == "/a/punch.png");
}

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include "app/files/autosave.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/key_tables.h"
#include "tests/support/app/other_value.h"
#include "tests/support/ui_driver/script.h"
#include "tests/support/ui_driver/script_state.h"
#include "ui/panels/context/view_schema.h"
#include "ui/panels/frame/pane_layout.h"
#include "ui/shell/file_work.h"
#include "ui/shell/user_settings.h"
#include "ui/shell/window/input.h"

using namespace stretch;
using namespace stretch::ui;
namespace fs = std::filesystem;

namespace {

/// A folder of its own that goes with the test, and stands in for the user's.
class UserFolder {
public:
  UserFolder() : path_(fs::temp_directory_path() / ("stretch-shell-test-" + std::to_string(getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
    setenv("XDG_CONFIG_HOME", (path_ / "config").c_str(), 1);
    setenv("XDG_STATE_HOME", (path_ / "state").c_str(), 1);
  }
  UserFolder(const UserFolder&) = delete;
  UserFolder& operator=(const UserFolder&) = delete;
  ~UserFolder() { fs::remove_all(path_); }
  [[nodiscard]] const fs::path& path() const { return path_; }

private:
  fs::path path_;
};

void touch(const fs::path& file) {
  std::ofstream(file) << "x";
}

} // namespace

TEST_CASE("Panes fill the window without gaps and fold away") {
  PaneSizes sizes;
  const PaneRects open = dividePanes(sizes, 1280.0F, 720.0F, 1.0F, 24.0F, 28.0F);
  CHECK(open.left.max.x == open.viewport.min.x);
  CHECK(open.viewport.max.x == open.right.min.x);
  CHECK(open.right.max.x == 1280.0F);
  CHECK(open.viewport.max.y == open.bottom.min.y);
  CHECK(open.bottom.max.y == open.status.min.y);
  CHECK(open.status.max.y == 720.0F);
  sizes.leftOpen = false;
  sizes.bottomOpen = false;
  const PaneRects folded = dividePanes(sizes, 1280.0F, 720.0F, 1.0F, 24.0F, 28.0F);
  CHECK(folded.viewport.min.x == 0.0F);
  CHECK(folded.viewport.max.y == folded.status.min.y);
}

TEST_CASE("In a small window the panes shrink before the viewport") {
  const PaneRects small = dividePanes({}, 640.0F, 400.0F, 2.0F, 48.0F, 56.0F);
  CHECK(small.viewport.width() >= 0.99F * 2.0F * smallestViewport);
  CHECK(small.viewport.height() > 0.0F);
  CHECK(small.left.width() >= 0.0F);
  CHECK(small.right.max.x == 640.0F);
}

TEST_CASE("The graph opens at a third of the window and has a height of its own") {
  PaneSizes sizes;
  CHECK(sizesBeside(sizes, true, 900.0F).bottom == 300.0F);
  CHECK(sizesBeside(sizes, false, 900.0F).bottom == 192.0F);
  // A third of a low window is no less than what the timeline had.
  CHECK(sizesBeside(sizes, true, 480.0F).bottom == 192.0F);
  sizes.graph = 410.0F;
  CHECK(sizesBeside(sizes, true, 900.0F).bottom == 410.0F);
  CHECK(sizesBeside(sizes, false, 900.0F).bottom == 192.0F);
  CHECK_FALSE(showsGraph(app::OpenDocument(), BottomTab::graph)); // nothing is open that has one
  sizes.graph = 10.0F;                                            // as no hand can make it
  CHECK(sizesBeside(sizes, true, 900.0F).bottom == smallestPane);
}

TEST_CASE("Settings survive the file, and a damaged file is harmless") {
  UiState ui;
  ui.theme = ThemeKind::highContrast;
  ui.scale = 1.5F;
  ui.navigation = NavigationStyle::blender;
  ui.overlays.ghostsBefore = 5;
  ui.recentFiles = {"/a/b.glb"};
  ui.closedSections = {"rig/limbs", "trail/section-release"};
  PaneSizes panes;
  panes.left = 300.0F;
  panes.graph = 333.0F;
  panes.bottomOpen = false;
  const std::string text = settingsText(ui, panes, {1000, 700, true});

  UiState read;
  PaneSizes readPanes;
  WindowMemory window;
  readSettings(text, read, readPanes, window);
  CHECK(read.theme == ThemeKind::highContrast);
  CHECK(read.scale == 1.5F);
  CHECK(read.navigation == NavigationStyle::blender);
  CHECK(read.overlays.ghostsBefore == 5);
  CHECK(read.recentFiles == ui.recentFiles);
  readSettings(text, read, readPanes, window); // once more, in place of what is there
  CHECK(read.recentFiles == ui.recentFiles);
  CHECK(read.closedSections == ui.closedSections);
  CHECK(readPanes == panes);
  CHECK(window.maximised);
  CHECK(settingsText(read, readPanes, window) == text);

  for (const char* damaged :
       {"", "[]", "{\"theme\": 99, \"scale\": \"big\", \"panes\": 3, \"recent\": [1, null]}",
        "{\"scale\": 1e999, \"overlays\": {\"ghosts_before\": -7}}"}) {
    INFO(damaged);
    UiState plain;
    readSettings(damaged, plain, readPanes, window);
    CHECK(plain.scale >= 0.5F);
    CHECK(plain.overlays.ghostsBefore >= 0);
    CHECK(static_cast<int>(plain.theme) <= 2);
  }
}

TEST_CASE("Every setting of the view is remembered") {
  UiState ui;
  for (const app::Setting<ViewportOverlays>& setting : overlaySchema()) {
    INFO(setting.name);
    REQUIRE(app::setSetting(setting, test::otherValue(setting), ui.overlays));
  }
  for (const app::Setting<UiState>& setting : windowSchema()) {
    REQUIRE(app::setSetting(setting, test::otherValue(setting), ui));
  }
  PaneSizes panes;
  WindowMemory window;
  const std::string text = settingsText(ui, panes, window);
  UiState read;
  readSettings(text, read, panes, window);
  CHECK(read.overlays == ui.overlays);
  for (const app::Setting<UiState>& setting : windowSchema()) {
    INFO(setting.name);
    CHECK(setting.read(read) == setting.read(ui));
  }
}

TEST_CASE("Panes and a window of settings that no screen has are brought to the nearest that one has") {
  UiState ui;
  PaneSizes panes;
  WindowMemory window;
  readSettings(R"({"panes": {"left": 5000, "right": 1, "bottom": 901, "graph": -3},
                   "window": {"width": 10, "height": 99999}})",
               ui, panes, window);
  CHECK(panes.left == 900.0F);
  CHECK(panes.right == smallestPane);
  CHECK(panes.bottom == 900.0F);
  CHECK(panes.graph == 0.0F); // As high as the window makes it.
  CHECK(window.width == 320);
  CHECK(window.height == 16384);
  readSettings(R"({"window": {"width": 99999, "height": 10}})", ui, panes, window);
  CHECK(window.width == 16384);
  CHECK(window.height == 240);
}

TEST_CASE("Settings of earlier versions name theme and navigation by number") {
  UiState ui;
  PaneSizes panes;
  WindowMemory window;
  readSettings("{\"theme\": 1, \"navigation\": 1, \"overlays\": {\"ghost_step\": 7}}", ui, panes, window);
  CHECK(ui.theme == ThemeKind::light);
  CHECK(ui.navigation == NavigationStyle::blender);
  CHECK(ui.overlays.ghostStepFrames == 7);
}

TEST_CASE("How a file was looked at survives, as far as it still makes sense") {
  const app::Document document = test::boxer();
  app::ViewState view;
  view.frame = 7.0;
  view.selection.editTrails().limbs = {"left-arm", "tail"};
  view.selection.editTrails().trail = 12;
  Camera camera;
  camera.distance = 3.5;
  app::ViewState read;
  ViewBookmark readCamera;
  ViewBookmarks kept;
  readView(viewText(view, {camera}, {}), document, read, readCamera, kept);
  CHECK(kept == ViewBookmarks{});
  CHECK(read.frame == 7.0);
  CHECK(read.selection.limbs() == std::vector<std::string>{"left-arm"});
  CHECK(read.selection.trail() == 0);
  CHECK(readCamera.camera == camera);
  readView("{\"frame\": 1e9, \"clip\": 5, \"camera\": {\"target\": [1, \"x\"]}}", document, read, readCamera,
           kept);
  CHECK(read.frame == 20.0);
  CHECK(read.clip == 0);
}

TEST_CASE("The trail that was worked on is selected again, none where there is none of that number") {
  app::Document document = test::boxer();
  for (const int number : {1, 2}) {
    rig::Trail trail;
    trail.id = number;
    trail.limb = "left-arm";
    document.trails.push_back(trail);
  }
  const auto selectedBy = [&](const std::string& text) {
    app::ViewState view;
    ViewBookmark now;
    ViewBookmarks kept;
    readView(text, document, view, now, kept);
    return view.selection.trail();
  };
  for (const int number : {0, 1, 2}) {
    app::ViewState view;
    view.selection.editTrails().trail = number;
    CHECK(selectedBy(viewText(view, {}, {})) == number);
  }
  for (const char* const text : {R"({})", R"({"trail": 3})", R"({"trail": -1})", R"({"trail": "1"})"}) {
    CAPTURE(text);
    CHECK(selectedBy(text) == 0);
  }
}

TEST_CASE("Recent files are kept once each, the newest first") {
  UiState ui;
  for (int i = 0; i < 20; ++i) {
    rememberRecent(ui, "/folder/" + std::to_string(i) + ".glb");
  }
  rememberRecent(ui, "/folder/15.glb");
  CHECK(ui.recentFiles.size() == 12);
  CHECK(ui.recentFiles[0] == "/folder/15.glb");
  CHECK(ui.recentFiles[1] == "/folder/19.glb");
  CHECK(std::ranges::count(ui.recentFiles, "/folder/15.glb") == 1);
  CHECK(ui.recentFiles.back() == "/folder/8.glb");
  std::string text = "{\"recent\": [";
  for (int i = 0; i < 20; ++i) {
    text += (i == 0 ? "\"/old/" : ", \"/old/") + std::to_string(i) + ".glb\"";
  }
  PaneSizes panes;
  WindowMemory window;
  readSettings(text + "]}", ui, panes, window);
  CHECK(ui.recentFiles.size() == 12);
  CHECK(ui.recentFiles.back() == "/old/11.glb");
}

TEST_CASE("A change by another program shows in the stamp") {
  const UserFolder folder;
  const fs::path file = folder.path() / "a.glb";
  CHECK_FALSE(app::stampOf(file));
  touch(file);
  const auto before = app::stampOf(file);
  REQUIRE(before);
  CHECK(app::stampOf(file) == before);
  std::ofstream(file) << "longer";
  CHECK(app::stampOf(file) != before);
}

TEST_CASE("Texts are replaced whole, and failures leave nothing behind") {
  const UserFolder folder;
  const fs::path file = folder.path() / "deep" / "settings.json";
  REQUIRE(writeText(file, "one"));
  REQUIRE(writeText(file, "two"));
  CHECK(*readText(file) == "two");
  CHECK(std::distance(fs::directory_iterator(file.parent_path()), fs::directory_iterator()) == 1);
  CHECK_FALSE(writeText(file / "below-a-file", "three"));
}

TEST_CASE("Numbers are compared as numbers, the rest as text") {
  CHECK(test::sameState("3", "3.0004"));
  CHECK_FALSE(test::sameState("3", "3.01"));
  CHECK(test::sameState("left-arm", "left-arm"));
  CHECK_FALSE(test::sameState("", "0"));
}

TEST_CASE("Every key of ours is one of the window's") {
  for (const app::Key key : test::allKeys()) {
    INFO(app::keyName(key));
    const auto code = test::toGlfwKey(key);
    REQUIRE(code);
    CHECK(fromGlfwKey(*code) == key);
  }
  CHECK(fromGlfwKey(340) == app::Key::none); // Shift alone.
}

TEST_CASE("Where the view looks from, and the part of time that was worked on, are remembered whole") {
  const app::Document document = test::boxer();
  app::ViewState view;
  view.rangeStart = 3.0;
  view.rangeEnd = 14.0;
  Camera camera;
  camera.target = Vec3(0.5, 1.25, -2.0);
  camera.distance = 7.0;
  camera.yawRadians = 0.75;
  camera.pitchRadians = -0.5;
  camera.projection = GENERATE(ProjectionKind::orthographic, ProjectionKind::perspective);
  app::ViewState read;
  ViewBookmark readCamera;
  ViewBookmarks kept;
  readCamera.camera.projection = camera.projection == ProjectionKind::orthographic
                                     ? ProjectionKind::perspective
                                     : ProjectionKind::orthographic;
  ViewBookmarks views;
  views[2] = ViewBookmark{camera};
  views[8] = ViewBookmark{Camera{}, "Shot"};
  camera.fieldOfViewRadians = 0.9;
  readView(viewText(view, {camera, "Side"}, views), document, read, readCamera, kept);
  CHECK(read.rangeStart == 3.0);
  CHECK(read.rangeEnd == 14.0);
  CHECK(readCamera == ViewBookmark{camera, "Side"});
  CHECK(kept == views);
}

TEST_CASE("Numbers of a remembered view that make no sense leave the view as it is") {
  const app::Document document = test::boxer();
  app::ViewState view;
  ViewBookmark now;
  ViewBookmarks kept;
  Camera& camera = now.camera;
  camera.target = Vec3(1.0, 2.0, 3.0);
  const Camera before = camera;
  readView(
      R"({"frame": -4, "range": [2], "limbs": [3, "left-arm"], "camera": {"target": [1, 2], "yaw": "left"},
          "kept_views": {"1": 3, "0": {"yaw": 1}, "10": {"yaw": 1}}})",
      document, view, now, kept);
  CHECK(kept == ViewBookmarks{});
  CHECK(view.frame == 0.0);
  CHECK(view.rangeStart == app::ViewState{}.rangeStart);
  CHECK(view.selection.limbs() == std::vector<std::string>{"left-arm"});
  CHECK(camera.target == before.target);
  CHECK(camera.yawRadians == before.yawRadians);
}

TEST_CASE("Numbers of a remembered view that lie beyond what there is become the nearest that there is") {
  const app::Document document = test::boxer(); // Its clip ends at frame 20.
  app::ViewState view;
  ViewBookmark now;
  ViewBookmarks kept;
  readView(R"({"range": [30, 99], "camera": {"distance": 0, "pitch": 3, "angle": 9}})", document, view, now,
           kept);
  CHECK(view.rangeStart == 20.0);
  CHECK(view.rangeEnd == 20.0);
  CHECK(now.camera.distance == 1e-6);
  CHECK(now.camera.pitchRadians == Approx(0.5 * pi));
  CHECK(now.camera.fieldOfViewRadians == 3.0);
}

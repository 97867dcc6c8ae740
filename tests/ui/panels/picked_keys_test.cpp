#include <algorithm>

#include <catch2/catch.hpp>

#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "tests/support/ui/editor_stage.h"

using namespace stretch;

namespace {

/// The boxer in the dope sheet or the graph.
struct KeysOfBoxer : test::EditorStage {
  explicit KeysOfBoxer(const char* pane) {
    openBoxer();
    press("1");
    press(pane);
    frames(2);
    REQUIRE(shell.ui.time.tab != ui::BottomTab::timeline);
  }
  [[nodiscard]] int picked() { return static_cast<int>(app::keyCount(app::pickedKeys(session()))); }
  /// A press of the right mouse button where a widget, or a part of one, is.
  void clickRight(const ImVec2& place) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = place;
    frames(2);
    io.MouseDown[1] = true;
    frame();
    io.MouseDown[1] = false;
    frames(3);
  }
  [[nodiscard]] bool offers(const char* command) const {
    const ui::Item* const entry = shell.items.find(std::string("context/") + command);
    return entry != nullptr && entry->enabled;
  }
};

} // namespace

TEST_CASE("A right click on a key of the graph picks it and opens the menu of what is done with it") {
  KeysOfBoxer stage("F6");
  const ui::Item* const key = stage.shell.items.find("graph-key/Z/3");
  REQUIRE(key != nullptr);
  stage.clickRight(key->centre());
  CHECK(stage.picked() == 1);
  using namespace app::command;
  for (const char* const id : {keysDelete, keysCopy, keysSnap, keysFlat, keysStepped, keysFree}) {
    INFO(id);
    CHECK(stage.offers(id));
  }
  stage.click(std::string("context/") + keysDelete);
  CHECK(stage.session().history().undoLabel().starts_with("Delete"));
}

TEST_CASE(
    "A right click on one of several picked keys keeps them all, beside the keys it opens the frame's") {
  KeysOfBoxer stage("F6");
  stage.run(app::command::keysAll);
  const int all = stage.picked();
  REQUIRE(all > 3);
  stage.clickRight(stage.shell.items.find("graph-key/Z/3")->centre());
  CHECK(stage.picked() == all);
  stage.pressWidgetKey(ImGuiKey_Escape);
  const ui::Item* const graph = stage.shell.items.find("graph");
  stage.clickRight({graph->max.x - 4.0F, graph->min.y + 4.0F});
  CHECK(stage.shell.ui.menu.target == ui::MenuTarget::time);
  CHECK(stage.offers(app::command::keysInsert));
  CHECK_FALSE(stage.offers(app::command::keysDelete));
}

TEST_CASE("A right click on a key of the dope sheet picks it and offers to delete, copy, bend and snap it") {
  KeysOfBoxer stage("F7");
  const ui::Item* const sheet = stage.shell.items.find("dope-sheet");
  REQUIRE(sheet != nullptr);
  // The first row holds all keys; the mouse goes along it until it meets one.
  stage.run(app::command::timeStart);
  bool isMet = false;
  for (float x = sheet->min.x + 120.0F; x < sheet->max.x && !isMet; x += 3.0F) {
    for (float y = sheet->min.y + 40.0F; y < sheet->max.y && !isMet; y += 12.0F) {
      stage.clickRight({x, y});
      isMet = stage.shell.ui.menu.target == ui::MenuTarget::key;
      if (!isMet) {
        stage.pressWidgetKey(ImGuiKey_Escape);
      }
    }
  }
  REQUIRE(isMet);
  CHECK(stage.picked() > 0);
  using namespace app::command;
  for (const char* const id : {keysDelete, keysCopy, keysSnap, keysAuto}) {
    INFO(id);
    CHECK(stage.offers(id));
  }
}

TEST_CASE("The menu of keys shows the keys that its commands have over graph and dope sheet") {
  KeysOfBoxer stage("F6");
  const auto keyOf = [&](const char* id) {
    const auto info = std::ranges::find(stage.shell.commandInfos, id, &ui::CommandInfo::id);
    REQUIRE(info != stage.shell.commandInfos.end());
    return info->keyText;
  };
  using namespace app::command;
  CHECK(keyOf(keysDelete) == keyOf(editDelete));
  CHECK(keyOf(keysCopy) == "Ctrl+C");
  CHECK(keyOf(keysGrab) == "G");
  CHECK(keyOf(keysScale) == "S");
  CHECK(keyOf(keysAll) == "Ctrl+A");
}

TEST_CASE("Picked keys are let go of when something else is selected") {
  KeysOfBoxer stage("F7");
  stage.run(app::command::keysAll);
  REQUIRE(stage.picked() > 0);
  const char* const key = GENERATE("2", "0", "Alt+3");
  stage.press(key);
  CHECK(stage.picked() == 0);
}

TEST_CASE("Picked keys are let go of when another clip or another controller of the same limb is looked at") {
  KeysOfBoxer stage("F6");
  app::Session& session = stage.session();
  app::Document document = session.document();
  std::vector<Clip> clips = *document.clips;
  clips.push_back(clips.front());
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  session.restore(std::move(document));
  app::selectControllers(session, {"left-hand"});
  stage.frames(2);
  const app::KeySelection picks{{app::KeyRow{NodeIndex(3), Channel::rotation, {}}, {{0, 1U}}}};
  app::pickKeys(session, picks, false);
  stage.frames(2);
  REQUIRE(stage.picked() == 1);
  SECTION("the clip") {
    session.view().clip = static_cast<int>(session.document().clips->size()) - 1;
  }
  SECTION("the controller") {
    session.view().selection.setControllers({"left-elbow"});
  }
  SECTION("neither") {
    stage.frames(2);
    CHECK(stage.picked() == 1);
    app::pickKeys(session, {}, false);
  }
  stage.frames(2);
  CHECK(stage.picked() == 0);
}

TEST_CASE("Undo brings back what was picked where the same clip is looked at, and nothing in another one") {
  KeysOfBoxer stage("F6");
  app::Session& session = stage.session();
  app::Document document = session.document();
  std::vector<Clip> clips = *document.clips;
  const auto copy = static_cast<int>(clips.size());
  clips.push_back(clips.front());
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  session.restore(std::move(document));
  stage.frames(2);
  stage.click("graph-key/Z/2");
  REQUIRE(stage.picked() == 1);
  const Result<app::EditedKeys> moved =
      app::moveKeys(session.document(), 0, app::pickedKeys(session), {.value = 0.01});
  REQUIRE(moved);
  session.edit(moved->document, "Move");
  app::pickKeys(session, {}, false);
  stage.frames(2);
  const bool looksElsewhere = GENERATE(false, true);
  session.view().clip = looksElsewhere ? copy : 0;
  stage.frames(2);
  stage.press("Ctrl+Z");
  REQUIRE(session.history().position() == 0);
  CHECK(session.view().clip == (looksElsewhere ? copy : 0));
  CHECK(stage.picked() == (looksElsewhere ? 0 : 1));
}

TEST_CASE("Undo brings back no picks of what was undone and done otherwise since") {
  KeysOfBoxer stage("F6");
  app::Session& session = stage.session();
  const auto moveKey = [&](const char* key, double frames) {
    app::pickKeys(session, {}, false);
    stage.click(key);
    const Result<app::EditedKeys> moved =
        app::moveKeys(session.document(), session.view().clip, app::pickedKeys(session), {.frames = frames});
    REQUIRE(moved);
    session.edit(moved->document, "Move");
    app::pickKeys(session, moved->picked, false);
    stage.frames(2);
  };
  moveKey("graph-key/Z/1", 0.25);
  moveKey("graph-key/Z/2", 0.25);
  stage.press("Ctrl+Z");
  CHECK(stage.picked() == 1); // Of the step that stands.
  stage.press("Ctrl+Z");
  // Two other steps within one frame: the first of them had no frame in which its picks could be seen.
  const app::KeySelection all =
      app::allKeys(session.document(), session.view().clip, app::rowsOfSelection(session));
  for (const double value : {0.01, 0.02}) {
    const Result<app::EditedKeys> raised =
        app::moveKeys(session.document(), session.view().clip, all, {.value = value});
    REQUIRE(raised);
    session.edit(raised->document, "Raise");
  }
  app::pickKeys(session, {}, false);
  stage.frames(2);
  stage.press("Ctrl+Z");
  CHECK(session.history().position() == 1);
  CHECK(stage.picked() == 0);
}

TEST_CASE("Undo and redo of a retime bring back what was picked before and after it") {
  KeysOfBoxer stage("F6");
  stage.click("graph-key/Z/3");
  REQUIRE(stage.picked() == 1);
  stage.run(app::command::keysRetime);
  stage.shell.ui.time.retime.newFrames = 0.5 * stage.shell.ui.time.retime.newFrames + 0.25;
  stage.frames(2);
  stage.click("retime/Retime");
  const int after = stage.picked();
  REQUIRE(after > 1);
  CHECK(std::ranges::any_of(stage.shell.ui.toasts, [](const ui::Toast& toast) {
    return toast.text.starts_with("Between frames now, and picked: ");
  }));
  stage.press("Ctrl+Z");
  CHECK(stage.picked() == 1);
  stage.press("Ctrl+Shift+Z");
  CHECK(stage.picked() == after);
  stage.press("Ctrl+Z");
  stage.press("2"); // What was picked belongs to what was selected.
  stage.press("Ctrl+Shift+Z");
  CHECK(stage.picked() == 0);
}

TEST_CASE("The graph shows whole the curves that come into view with another selection") {
  KeysOfBoxer stage("F6");
  stage.press("Alt+1");
  stage.run(app::command::graphFitAll);
  stage.frames(3);
  stage.press("1");
  stage.frames(3);
  const ui::GraphState& graph = stage.shell.ui.time.graph;
  REQUIRE_FALSE(graph.curves.empty());
  for (const ui::Curve& curve : graph.curves) {
    CHECK(std::ranges::all_of(curve.points, [&](const Vec2& point) {
      return point.y >= graph.valueMin && point.y <= graph.valueMax;
    }));
  }
}

TEST_CASE("Retime offers the limb of the selected controller, whose speed stands in the middle at 100 %") {
  KeysOfBoxer stage("F6");
  stage.press("Alt+3");
  stage.run(app::command::keysRetime);
  stage.frames(2);
  const ui::Item* const only = stage.shell.items.find("retime/limb");
  REQUIRE(only != nullptr);
  CHECK(only->enabled);
  stage.click("retime/limb");
  CHECK(stage.shell.ui.time.retime.limb == "left-leg");
}

TEST_CASE(
    "Undo of keys that went past others picks those that were picked, and not the ones in their place") {
  KeysOfBoxer stage("F6");
  stage.click("graph-key/Z/2");
  const app::KeySelection before = app::pickedKeys(stage.session());
  REQUIRE(stage.picked() == 1);
  for (const char* const key : {"G", "9", "Return"}) {
    stage.press(key);
    stage.frames(3);
  }
  REQUIRE(app::pickedKeys(stage.session()) != before); // it is another one in its row now
  stage.press("Ctrl+Z");
  stage.frames(2);
  CHECK(app::pickedKeys(stage.session()) == before);
}

TEST_CASE("A right click while keys are moved opens no menu and picks nothing") {
  KeysOfBoxer stage("F6");
  stage.click("graph-key/Z/2");
  stage.press("G");
  stage.press("1");
  stage.frames(2);
  REQUIRE(stage.session().isDragging());
  const app::KeySelection held = app::pickedKeys(stage.session());
  stage.clickRight(stage.shell.items.find("graph-key/Z/3")->centre());
  CHECK(app::pickedKeys(stage.session()) == held);
  CHECK_FALSE(stage.offers(app::command::keysDelete));
  stage.press("Escape");
}

TEST_CASE("What was picked in one file is forgotten in the next") {
  KeysOfBoxer stage("F6");
  stage.click("graph-key/Z/2");
  stage.frames(2);
  REQUIRE_FALSE(stage.shell.ui.time.picksAt.empty());
  stage.openBoxer();
  stage.frames(1);
  CHECK(stage.shell.ui.time.picksAt.size() <= 1);
}

namespace {

/// The components of every key that is picked, and how many keys are.
std::pair<unsigned, int> pickedComponents(const KeysOfBoxer& stage) {
  unsigned components = 0;
  int keys = 0;
  for (const app::PickedRow& row : stage.shell.open.character()->view().pickedKeys) {
    for (const app::PickedKey& key : row.keys) {
      components |= key.components;
      ++keys;
    }
  }
  return {components, keys};
}

} // namespace

TEST_CASE("All keys of the graph are those of the curves that it shows") {
  KeysOfBoxer stage("F6");
  stage.click("graph/curve/X");
  stage.click("graph/curve/Y");
  stage.run(app::command::keysAll);
  CHECK(pickedComponents(stage).first == 0b100U);
  const int keys = stage.picked();
  REQUIRE(keys > 3);
  stage.click("graph/curve/Z");
  stage.run(app::command::keysAll);
  stage.run(app::command::keysInsert);
  CHECK(stage.picked() == keys); // nothing shows, and both are off
  CHECK(stage.session().history().position() == 0);
  stage.press("F7");
  stage.run(app::command::keysAll);
  CHECK(pickedComponents(stage).first == ~0U);
}

TEST_CASE("All keys of a controller are those of its moves while its turns do not show") {
  KeysOfBoxer stage("F6");
  stage.press("Alt+1");
  stage.press("S");
  stage.frames(2);
  stage.run(app::command::keysAll);
  CHECK(pickedComponents(stage) == std::pair(0b111U, 1));
}

#include <catch2/catch.hpp>

#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/name_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "tests/support/ui/drawn.h"
#include "tests/support/ui/panel_driver.h"
#include "tests/support/ui/work.h"
#include "ui/panels/rows/clip_name.h"

using namespace stretch;
using test::PanelDriver;

namespace {

/// The bundled character with as many clips as a pack of motion has.
app::Document manyClips() {
  app::Document document = PanelDriver::bundledCharacter();
  std::vector<Clip> clips;
  for (int i = 0; i < 76; ++i) {
    clips.push_back(document.clips->front());
    clips.back().name = i == 61 ? "Roundhouse_Kick" : "Walk_" + std::to_string(i);
  }
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  return document;
}

app::Document withTrails(int count) {
  app::Document document = PanelDriver::bundledCharacter();
  for (int i = 0; i < count; ++i) {
    app::NewTrail wanted;
    wanted.limb = "left-arm";
    wanted.settings.startFrame = 4.0 * i;
    wanted.settings.endFrame = 4.0 * i + 4.0;
    document = app::createTrail(document, wanted)->document;
  }
  return document;
}

} // namespace

TEST_CASE("One clip of many is found by a part of its name") {
  PanelDriver driver(manyClips());
  driver.frames(2);
  driver.click("timeline/clip");
  REQUIRE(driver.find("timeline/clip/Walk_1") != nullptr);
  driver.type("kick");
  driver.frames(2);
  CHECK(driver.find("timeline/clip/Walk_1") == nullptr);
  driver.click("timeline/clip/Roundhouse_Kick");
  CHECK(driver.open.character()->view().clip == 61);
}

TEST_CASE("The parts of the transport stand in one row, one after the other, with one clip and with many") {
  const bool many = GENERATE(false, true);
  CAPTURE(many);
  PanelDriver driver(many ? manyClips() : PanelDriver::bundledCharacter());
  driver.frames(3);
  std::vector<const char*> parts{"timeline/loop", "timeline/frame", "timeline/speed", "timeline/rate"};
  if (many) {
    parts.push_back("timeline/clip");
  }
  parts.push_back("timeline/text");
  const ui::Item* last = nullptr;
  for (const char* const part : parts) {
    CAPTURE(part);
    const ui::Item* const item = driver.find(part);
    REQUIRE(item != nullptr);
    if (last != nullptr) {
      CHECK(item->centre().y == Approx(last->centre().y).margin(1.0));
      CHECK(item->min.x >= last->max.x);
    }
    last = item;
  }
}

TEST_CASE("Enter takes the first clip that holds every typed word, and gives the keys back") {
  PanelDriver driver(manyClips());
  driver.frames(2);
  for (const int enter : {ImGuiKey_Enter, ImGuiKey_KeyPadEnter}) {
    ImGui::GetIO().KeyMap[enter] = enter + 1; // Where the driver presses it.
    driver.open.character()->view().clip = 0;
    driver.click("timeline/clip");
    driver.type("kick round");
    driver.pressKey(enter);
    driver.frames(2);
    CHECK(driver.open.character()->view().clip == 61);
    CHECK(driver.find("timeline/clip/search") == nullptr);
    CHECK_FALSE(ImGui::GetIO().WantTextInput);
  }
  driver.click("timeline/clip");
  driver.pressKey(ImGuiKey_Enter);
  driver.frames(2);
  CHECK(driver.open.character()->view().clip == 61); // Nothing was typed, nothing else is taken.
}

TEST_CASE("A search for a clip that finds nothing says so and can be gone on with") {
  PanelDriver driver(manyClips());
  driver.frames(2);
  driver.click("timeline/clip");
  CHECK(driver.find("timeline/clip/none") == nullptr);
  driver.type("kickx");
  driver.frames(2);
  CHECK(driver.find("timeline/clip/none") != nullptr);
  driver.pressKey(ImGuiKey_Enter);
  driver.frames(4);
  CHECK(driver.open.character()->view().clip == 0);
  REQUIRE(driver.find("timeline/clip/none") != nullptr);
  driver.pressKey(ImGuiKey_Backspace);
  driver.frames(2);
  CHECK(driver.find("timeline/clip/none") == nullptr);
  CHECK(driver.find("timeline/clip/Roundhouse_Kick") != nullptr);
}

TEST_CASE("The search for a clip stays beside its field, however few clips it leaves") {
  PanelDriver driver(manyClips());
  const bool listIsAbove = GENERATE(false, true);
  CAPTURE(listIsAbove);
  if (listIsAbove) {
    ImGui::GetIO().DisplaySize.y = 2320.0F; // The field stands at its end.
  }
  driver.frames(2);
  driver.click("timeline/clip");
  const auto distance = [&] {
    const ui::Item* const search = driver.find("timeline/clip/search");
    const ui::Item* const field = driver.find("timeline/clip");
    REQUIRE((search != nullptr && field != nullptr));
    return listIsAbove ? field->min.y - search->max.y : search->min.y - field->max.y;
  };
  const float near = driver.theme.unit() * 2.0F;
  CHECK(distance() >= 0.0F);
  CHECK(distance() < near);
  for (const char* typed : {"kick", "nothing"}) {
    driver.type(typed);
    driver.frames(3);
    CAPTURE(typed);
    CHECK(distance() >= 0.0F);
    CHECK(distance() < near);
  }
}

TEST_CASE("Lists stay inside of the window, however many entries they have") {
  PanelDriver driver(manyClips());
  driver.frames(2);
  for (const char* field : {"timeline/clip", "rig/clip", "trail/style"}) {
    if (driver.find(field) == nullptr) {
      continue;
    }
    driver.click(field);
    driver.frames(2);
    for (const ui::Item& item : driver.items.items) {
      if (item.id.rfind(std::string(field) + "/", 0) == 0) {
        CAPTURE(item.id);
        CHECK(item.min.x >= 0.0F);
        CHECK(item.max.x <= ImGui::GetIO().DisplaySize.x);
        CHECK(item.max.y <= ImGui::GetIO().DisplaySize.y);
      }
    }
    driver.pressKey(ImGuiKey_Escape);
    driver.frames(2);
  }
}

TEST_CASE("A trail is called by its own name, or by its limb's when that is taken away") {
  const app::Document document = withTrails(1);
  const int id = document.trails.front().id;
  const Result<app::Document> named = app::renameTrail(document, id, "  the jab \n");
  REQUIRE(named);
  CHECK(app::trailTitle(*named, named->trails.front()) == "the jab");
  const Result<app::Document> unnamed = app::renameTrail(*named, id, "   ");
  REQUIRE(unnamed);
  CHECK(app::trailTitle(*unnamed, unnamed->trails.front()) == "left arm");
  CHECK(unnamed->trails == document.trails);
  CHECK_FALSE(app::renameTrail(document, 77, "x"));
  // Letters of more than one byte are not cut in half.
  std::string longName;
  for (int i = 0; i < 60; ++i) {
    longName += "\xC3\xA9";
  }
  const std::string kept = app::renameTrail(document, id, longName)->trails.front().name;
  CHECK(kept.size() <= 80);
  CHECK(kept.size() % 2 == 0);
}

TEST_CASE("The history lists what was done and goes to any of it") {
  PanelDriver driver(withTrails(1));
  app::Session& session = *driver.open.character();
  const int id = session.document().trails.front().id;
  for (const char* name : {"one", "two", "three"}) {
    session.edit(*app::renameTrail(session.document(), id, name), std::string("Call it ") + name);
  }
  driver.ui.dialogs.history.open = true;
  driver.frames(4);
  driver.click("history/1");
  CHECK(session.document().trails.front().name == "one");
  driver.click("history/3");
  CHECK(session.document().trails.front().name == "three");
  driver.click("history/0");
  CHECK(session.document().trails.front().name.empty());
  CHECK_FALSE(session.history().canUndo());
}

TEST_CASE(
    "The history is walked by the arrow keys, from where it stands, and Enter of either kind goes there") {
  PanelDriver driver(withTrails(1));
  app::Session& session = *driver.open.character();
  const int id = session.document().trails.front().id;
  for (const char* name : {"one", "two", "three"}) {
    session.edit(*app::renameTrail(session.document(), id, name), std::string("Call it ") + name);
  }
  session.undo();
  ui::HistoryState& history = driver.ui.dialogs.history;
  history.open = true;
  driver.frames(4);
  CHECK(history.highlighted == 2);
  driver.pressKey(ImGuiKey_UpArrow);
  CHECK(history.highlighted == 1);
  driver.pressKey(ImGuiKey_Enter);
  CHECK(session.document().trails.front().name == "one");
  driver.pressKey(ImGuiKey_DownArrow);
  driver.pressKey(ImGuiKey_DownArrow);
  driver.pressKey(ImGuiKey_DownArrow);
  CHECK(history.highlighted == 3);
  driver.pressKey(ImGuiKey_KeyPadEnter);
  CHECK(session.document().trails.front().name == "three");
  driver.pressKey(ImGuiKey_Escape);
  CHECK_FALSE(history.open);
}

TEST_CASE("A trail is renamed by the keypad's Enter, and Esc leaves its name") {
  PanelDriver driver(withTrails(1));
  app::Session& session = *driver.open.character();
  const int id = session.document().trails.front().id;
  const auto rename = [&](const std::string& name, int key) {
    driver.ui.trails.rename = {.open = true, .trail = id, .present = "Left arm", .typed = "Left arm"};
    driver.frames(4);
    driver.type(name); // In the place of the one that is there, which is selected.
    driver.pressKey(key);
    driver.frames(2);
    CHECK_FALSE(driver.ui.trails.rename.open);
    return session.document().trails.front().name;
  };
  CHECK(rename("jab", ImGuiKey_KeyPadEnter) == "jab");
  CHECK(session.history().undoLabel() == "Rename the trail");
  CHECK(rename("hook", ImGuiKey_Escape) == "jab");
  CHECK(rename("hook", ImGuiKey_Enter) == "hook");
}

TEST_CASE("A trail whose name is left as it is shown stays called after its limb, as if nobody had asked") {
  PanelDriver driver(withTrails(1));
  app::Session& session = *driver.open.character();
  driver.ui.trails.rename = {.open = true,
                             .trail = session.document().trails.front().id,
                             .present = "left arm",
                             .typed = "left arm"};
  driver.frames(4);
  driver.pressKey(ImGuiKey_Enter);
  driver.frames(2);
  CHECK_FALSE(driver.ui.trails.rename.open);
  CHECK(session.document().trails.front().name.empty());
  CHECK_FALSE(session.history().canUndo());
}

TEST_CASE("A clip without a name is counted from the first, in every list") {
  CHECK(ui::clipName("", 2) == "Clip 3");
  CHECK(ui::clipName("Walk", 2) == "Walk");
}

namespace {

/// Another file's clips, one of which is asked for.
struct OthersClips : PanelDriver {
  OthersClips() : PanelDriver(PanelDriver::bundledCharacter()) {
    ui.dialogs.clipPick.file = "/a/pack.glb";
    ui.dialogs.clipPick.clips = {{"Idle", 1.0}, {"Walk slow", 2.0}, {"Walk fast", 1.5}, {"", 1.0}};
    frames(4);
  }
  [[nodiscard]] bool isAsking() const { return !ui.dialogs.clipPick.file.empty(); }
  /// Which clip was chosen; -1 all of them, -2 none.
  [[nodiscard]] int chosen() const {
    CHECK((!ui.answers.clip || ui.answers.clip->file == "/a/pack.glb"));
    return ui.answers.clip ? ui.answers.clip->clip : -2;
  }
};

} // namespace

TEST_CASE("One of another file's clips is chosen by keys or by a click, among those that the search leaves") {
  OthersClips driver;
  REQUIRE(driver.isAsking());
  SECTION("the first by Enter") {
    driver.pressKey(ImGuiKey_Enter);
    CHECK(driver.chosen() == 0);
  }
  SECTION("the next by an arrow") {
    driver.pressKey(ImGuiKey_DownArrow);
    driver.pressKey(ImGuiKey_DownArrow);
    driver.pressKey(ImGuiKey_UpArrow);
    driver.pressKey(ImGuiKey_Enter);
    CHECK(driver.chosen() == 1);
  }
  SECTION("the second of two that are found") {
    driver.type("walk");
    driver.pressKey(ImGuiKey_DownArrow);
    driver.pressKey(ImGuiKey_Enter);
    CHECK(driver.chosen() == 2);
  }
  SECTION("one of two that are found by a click") {
    driver.type("walk");
    driver.frames(2);
    CHECK(driver.find("clips/Idle") == nullptr);
    driver.click("clips/Walk fast");
    CHECK(driver.chosen() == 2);
  }
  SECTION("one without a name") {
    driver.click("clips/Clip 4");
    CHECK(driver.chosen() == 3);
  }
  SECTION("the one that the keys are on by the button") {
    driver.pressKey(ImGuiKey_DownArrow);
    driver.click("clips/Import");
    CHECK(driver.chosen() == 1);
  }
  SECTION("all of them") {
    driver.click("clips/All");
    CHECK(driver.chosen() == -1);
  }
  CHECK_FALSE(driver.isAsking());
}

TEST_CASE("No clip of another file is chosen by Cancel and Esc, nor by Enter where the search leaves none") {
  OthersClips driver;
  driver.type("jump");
  driver.frames(2);
  CHECK_FALSE(driver.find("clips/Import")->enabled);
  driver.pressKey(ImGuiKey_Enter);
  CHECK(driver.isAsking());
  const bool byKey = GENERATE(true, false);
  if (byKey) {
    driver.pressKey(ImGuiKey_Escape);
    driver.frames(2);
  } else {
    driver.click("clips/Cancel");
  }
  CHECK_FALSE(driver.isAsking());
  CHECK(driver.chosen() == -2);
}

TEST_CASE("A clip's name that its field cuts is read whole under the mouse") {
  const bool isLong = GENERATE(true, false);
  const std::string name =
      isLong ? "A_name_of_a_clip_that_is_far_too_long_for_the_panel_in_which_it_is" : "Jab";
  app::Document document = PanelDriver::bundledCharacter();
  std::vector<Clip> clips = *document.clips;
  clips.front().name = name;
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  PanelDriver driver(document);
  driver.frames(2);
  driver.moveTo("rig/clip");
  driver.frames(40);
  CHECK_THAT(test::tooltipWords(), Catch::StartsWith(isLong ? name : "Clip"));
}

TEST_CASE("The part of time that is seen stays the same at another rate, and another clip is seen whole") {
  PanelDriver driver(PanelDriver::bundledCharacter());
  app::Session& session = *driver.open.character();
  ui::TimelineState& time = driver.ui.time.timeline;
  driver.frames(2);
  const double before = app::clipOf(session.document(), 0).framesPerSecond;
  REQUIRE(before != 25.0);
  time.viewStart = 12.0;
  time.viewEnd = 24.0;
  driver.frames(2);
  test::run({driver.open, driver.ui, driver.status}, app::command::clipRate25);
  REQUIRE(app::clipOf(session.document(), 0).framesPerSecond == 25.0);
  driver.frames(2);
  CHECK(time.viewStart == Approx(12.0 * 25.0 / before));
  CHECK(time.viewEnd == Approx(24.0 * 25.0 / before));
  session.view().clip = 1;
  driver.frames(2);
  CHECK(time.viewEnd < time.viewStart);
}

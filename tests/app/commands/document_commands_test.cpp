#include <catch2/catch.hpp>

#include <algorithm>

#include "app/commands/table/document_commands.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/keymap.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "core/anim/frames.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// A session driven by keys alone.
class Keyboard {
public:
  explicit Keyboard(Document document) : session(std::move(document)), keymap_(keyedCommands(commands_)) {}

  /// Whether the key's command was enabled and succeeded.
  bool press(const std::string& key) {
    const auto chord = parseChord(key);
    REQUIRE(chord);
    const std::string id = keymap_.commandOf(*chord);
    const auto command =
        std::find_if(commands_.begin(), commands_.end(), [&](const auto& c) { return c.id == id; });
    REQUIRE(command != commands_.end());
    return command->enabled(session) && command->run(session).ok();
  }

  bool run(const std::string& id) {
    const auto command =
        std::find_if(commands_.begin(), commands_.end(), [&](const auto& c) { return c.id == id; });
    REQUIRE(command != commands_.end());
    return command->enabled(session) && command->run(session).ok();
  }

  Session session;

private:
  std::vector<DocumentCommand> commands_ = documentCommands();
  Keymap keymap_;
};

} // namespace

TEST_CASE("Frames and keys are stepped through and held at the clip's ends") {
  Keyboard keyboard(test::boxer());
  const double& frame = keyboard.session.view().frame;
  keyboard.press(".");
  keyboard.press(".");
  CHECK(frame == 2.0);
  keyboard.press("Ctrl+.");
  CHECK(frame == 5.0);
  keyboard.press("Ctrl+,");
  CHECK(frame == 0.0);
  keyboard.press(",");
  CHECK(frame == 0.0);
  keyboard.press("End");
  CHECK(frame == 20.0);
  keyboard.press(".");
  CHECK(frame == 20.0);
  keyboard.session.view().frame = 7.25;
  keyboard.press(",");
  CHECK(frame == 7.0);
}

TEST_CASE("A limb is selected alone, added, taken away, and none") {
  Keyboard keyboard(test::boxer());
  const auto& selected = keyboard.session.view().selection.limbs();
  keyboard.press("1");
  keyboard.press("Shift+2");
  CHECK(selected == std::vector<std::string>{"left-arm", "right-arm"});
  keyboard.press("Shift+1");
  CHECK(selected == std::vector<std::string>{"right-arm"});
  CHECK_FALSE(keyboard.press("3")); // No leg was found.
  keyboard.press("0");
  CHECK(selected.empty());
}

TEST_CASE("The refined punch by keys: range, exaggerate, apply, and everything undone") {
  Keyboard keyboard(test::boxer());
  Session& session = keyboard.session;
  const Document start = session.document();
  keyboard.press("1");
  keyboard.press("Home");
  keyboard.press("[");
  session.view().frame = 10.0;
  keyboard.press("]");

  const Result<ExaggerateTargets> targets = exaggerateTargets(session);
  REQUIRE(targets);
  ExaggerateModal modal = beginExaggerate(findTrail(targets->document, targets->trailIds[0])->settings, 3.0);
  for (const char* key : {"3", "Y", "Enter"}) {
    static_cast<void>(pressKey(modal, KeyPress{*parseChord(key), 0}));
  }
  const Result<Document> exaggerated = exaggeratedWith(*targets, modal);
  REQUIRE(exaggerated);
  session.edit(*exaggerated, "Exaggerate");
  session.view().selection.editTrails().trail = targets->trailIds[0];
  REQUIRE(keyboard.press("Enter"));

  REQUIRE(session.document().trails.size() == 1);
  const rig::Trail& trail = session.document().trails.front();
  CHECK(trail.settings.startFrame == 0.0);
  CHECK(trail.settings.endFrame == 10.0);
  CHECK(trail.settings.scale == 3.0);
  CHECK(trail.connected);
  CHECK(trail.applied);

  CHECK(keyboard.press("Ctrl+Z"));
  CHECK(keyboard.press("Ctrl+Z"));
  CHECK_FALSE(keyboard.press("Ctrl+Z"));
  CHECK(sameDocument(session.document(), start));
  CHECK(keyboard.press("Ctrl+Y"));
  CHECK(keyboard.press("Ctrl+Shift+Z"));
  CHECK(session.document().trails.front().applied);
}

TEST_CASE("Without a range the stroke around the playhead is taken") {
  Keyboard keyboard(test::boxer());
  keyboard.press("1");
  REQUIRE(keyboard.press("T"));
  const rig::Trail& trail = keyboard.session.document().trails.front();
  CHECK(trail.settings.startFrame == 0.0);
  CHECK(trail.settings.endFrame == 10.0);
  CHECK_FALSE(trail.exaggerated);
  CHECK(keyboard.press("T"));
  CHECK_FALSE(keyboard.session.document().trails.front().visible);
}

TEST_CASE("A range that would have no length is refused, and the one that is set stays") {
  Keyboard keyboard(test::boxer());
  ViewState& view = keyboard.session.view();
  view.frame = 0.0;
  CHECK_FALSE(keyboard.press("]"));
  CHECK_FALSE(isRangeSet(view));
  view.frame = 20.0; // the last one
  CHECK_FALSE(keyboard.press("["));
  CHECK_FALSE(isRangeSet(view));
  view.frame = 5.0;
  REQUIRE(keyboard.press("["));
  view.frame = 12.0;
  REQUIRE(keyboard.press("]"));
  view.frame = 0.0;
  CHECK_FALSE(keyboard.press("]"));
  CHECK(view.rangeStart == 5.0);
  CHECK(view.rangeEnd == 12.0);
}

TEST_CASE("Several limbs are exaggerated in one step") {
  Keyboard keyboard(test::boxer());
  keyboard.press("1");
  keyboard.press("Shift+5");
  keyboard.session.view().rangeStart = 0.0;
  keyboard.session.view().rangeEnd = 8.0;
  REQUIRE(keyboard.run("trail.exaggerate-once"));
  CHECK(keyboard.session.document().trails.size() == 2);
  CHECK(targetTrails(keyboard.session).size() == 2);
  REQUIRE(keyboard.press("B"));
  CHECK(keyboard.session.document().trails[0].settings.blend == 1.0);
  CHECK(keyboard.session.document().trails[1].settings.blend == 1.0);
  REQUIRE(keyboard.press("Delete"));
  CHECK(keyboard.session.document().trails.empty());
  CHECK(keyboard.press("Ctrl+Z"));
  CHECK(keyboard.session.document().trails.size() == 2);
}

TEST_CASE("A second trail is made where the playhead stands, the first is edited where it lies") {
  Keyboard keyboard(test::boxer());
  keyboard.session.view().rangeEnd = 8.0;
  keyboard.press("1");
  REQUIRE(keyboard.press("T"));
  keyboard.session.view().frame = 12.0;
  keyboard.press("1");
  CHECK(keyboard.session.view().selection.trail() == 0);
  keyboard.press("[");
  keyboard.press("End");
  keyboard.press("]");
  REQUIRE(keyboard.run("trail.exaggerate-once"));
  REQUIRE(keyboard.session.document().trails.size() == 2);
  CHECK(keyboard.session.document().trails[1].settings.startFrame == 12.0);

  keyboard.session.view().frame = 4.0;
  keyboard.press("1");
  CHECK(keyboard.session.view().selection.trail() == keyboard.session.document().trails[0].id);
  REQUIRE(keyboard.press("]"));
  CHECK(keyboard.session.document().trails[0].settings.endFrame == 4.0);
}

TEST_CASE("Spheres are walked through, nudged and put back by keys") {
  Keyboard keyboard(test::boxer());
  Session& session = keyboard.session;
  session.view().rangeEnd = 10.0;
  keyboard.press("1");
  REQUIRE(keyboard.run("trail.exaggerate-once"));
  CHECK_FALSE(keyboard.press("Right"));
  REQUIRE(keyboard.press("Tab"));
  REQUIRE(keyboard.press("Tab"));
  REQUIRE(session.view().selection.spheres().size() == 1);
  CHECK(sameFrame(session.view().selection.spheres().front(), 5.0));
  CHECK(session.view().frame == 5.0);
  REQUIRE(keyboard.press("Up"));
  REQUIRE(keyboard.press("Shift+Right"));
  const auto& spheres = session.document().trails.front().settings.spheres;
  REQUIRE(spheres.size() == 1);
  CHECK(spheres[0].offset.y == Approx(nudgeUnits(session.document())));
  CHECK(spheres[0].offset.x == Approx(10.0 * nudgeUnits(session.document())));
  REQUIRE(keyboard.press("Alt+Right"));
  REQUIRE(keyboard.press("Shift+Tab"));
  CHECK(session.view().selection.spheres() == std::vector<double>{0.0});
  REQUIRE(keyboard.press("Ctrl+A"));
  CHECK(session.view().selection.spheres().size() == 3);
  REQUIRE(keyboard.press("Delete"));
  CHECK(session.document().trails.front().settings.spheres.empty());
  CHECK(session.document().trails.size() == 1);
}

TEST_CASE("Copy, paste and mirror by keys") {
  Keyboard keyboard(test::boxer());
  keyboard.session.view().rangeEnd = 10.0;
  keyboard.press("1");
  REQUIRE(keyboard.run("trail.exaggerate-once"));
  REQUIRE(keyboard.press("Ctrl+C"));
  keyboard.press("5");
  REQUIRE(keyboard.press("Ctrl+V"));
  CHECK(keyboard.session.document().trails.back().limb == "spine");
  keyboard.press("1");
  REQUIRE(keyboard.press("Ctrl+M"));
  CHECK(keyboard.session.document().trails.back().limb == "right-arm");
  keyboard.press("5");
  CHECK_FALSE(keyboard.press("Ctrl+M"));
}

TEST_CASE("Commands without anything to act on are off") {
  Keyboard keyboard(test::boxer());
  for (const char* key :
       {"T", "C", "B", "Enter", "Delete", "Ctrl+C", "Ctrl+V", "Ctrl+M", "Tab", "Left", "Ctrl+Z"}) {
    INFO(key);
    CHECK_FALSE(keyboard.press(key));
  }
}

TEST_CASE("Key frames of a limb are its own, of none everybody's") {
  const Document document = test::boxer();
  CHECK(keyFrames(document, 0, {"left-arm"}) == std::vector<double>{0, 5, 10, 20});
  CHECK(keyFrames(document, 0, {"right-arm"}).empty());
  CHECK(keyFrames(document, 0, {}).size() == 4);
  CHECK(keyFrames(document, 3, {}).empty());
  CHECK(lastFrame(document, 0) == 20.0);
  CHECK(lastFrame(document, 1) == 0.0);
}

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "app/commands/pose/step_text.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "app/edits/pose/offset_edits.h"
#include "app/edits/trail/group_edits.h"
#include "app/edits/trail/name_edits.h"
#include "app/edits/trail/sphere_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/files/saved_work.h"
#include "app/open_document.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

/// A character that is open, and what its commands say of themselves.
class Menu {
public:
  Menu() { open.open(Opened{Document(test::boxer())}); }

  [[nodiscard]] const DocumentCommand& command(const std::string& id) const {
    const auto found = std::ranges::find(commands, id, &DocumentCommand::id);
    REQUIRE(found != commands.end());
    return *found;
  }
  [[nodiscard]] bool isOn(const std::string& id) const { return isEnabled(command(id), open); }
  [[nodiscard]] bool isTicked(const std::string& id) const { return isChecked(command(id), open); }
  [[nodiscard]] std::string label(const std::string& id) const { return labelNow(command(id), open); }
  void run(const std::string& id) {
    REQUIRE(isOn(id));
    REQUIRE(app::run(command(id), open));
  }
  [[nodiscard]] Session& session() { return *open.character(); }
  [[nodiscard]] const rig::Trail& trail(std::size_t index) { return session().document().trails[index]; }
  /// Exaggerates limbs at once.
  void exaggerate(const std::vector<std::string>& limbs) {
    session().view().selection.editTrails().trail = 0;
    session().view().selection.editTrails().limbs = limbs;
    run(command::trailExaggerateOnce);
  }

  OpenDocument open;
  std::vector<DocumentCommand> commands = documentCommands();
};

/// What the last step of the history is called.
std::string lastStep(Session& session) {
  return stepTexts(session.history()).back();
}

} // namespace

TEST_CASE("A command that is off says what to do first") {
  const Menu menu;
  for (const DocumentCommand& command : menu.commands) {
    INFO(command.id);
    CHECK(isEnabled(command, menu.open) == whyOff(command, menu.open).empty());
  }
  CHECK(whyOff(menu.command(command::trailApply), OpenDocument()) == "open a file first");
}

TEST_CASE("The command that connects a limb is called Disconnect while the limb follows") {
  Menu menu;
  menu.exaggerate({"left-arm"});
  CHECK(menu.label(command::trailConnect) == "Disconnect");
  menu.run(command::trailConnect);
  CHECK(menu.label(command::trailConnect) == "Connect");
  CHECK_FALSE(menu.trail(0).connected);
}

TEST_CASE("The command of motion trails says whether it makes one, hides or shows it") {
  Menu menu;
  menu.session().view().selection.editTrails().limbs = {"left-arm"};
  CHECK(menu.label(command::trailToggle) == "Motion trail");
  menu.run(command::trailToggle);
  CHECK(menu.label(command::trailToggle) == "Hide the trail");
  menu.run(command::trailToggle);
  CHECK_FALSE(menu.trail(0).visible);
  CHECK(menu.label(command::trailToggle) == "Show the trail");
}

TEST_CASE("Switches of trail, clip and weight are ticked while they are on") {
  Menu menu;
  menu.exaggerate({"left-arm"});
  CHECK(menu.isTicked(command::trailFollow));
  menu.run(command::trailFollow);
  CHECK_FALSE(menu.isTicked(command::trailFollow));
  CHECK(menu.isTicked(command::clipRateOwn)); // 30, which has one tick only.
  CHECK_FALSE(menu.isTicked(command::clipRate30));
  menu.run(command::clipRate25);
  CHECK(menu.isTicked(command::clipRate25));
  CHECK_FALSE(menu.isTicked(command::clipRateOwn));
  CHECK_FALSE(menu.isTicked(command::weightToggle));
  menu.run(command::weightToggle);
  CHECK(menu.isTicked(command::weightToggle));
  CHECK(menu.label(command::trailBlend) == "Blend: exaggerated");
  menu.run(command::trailBlend);
  CHECK(menu.label(command::trailBlend) == "Blend: half-way");
}

TEST_CASE("The blend of a trail that exaggerates nothing yet is off, and says so") {
  Menu menu;
  menu.session().view().selection.editTrails().limbs = {"left-arm"};
  menu.run(command::trailToggle);
  REQUIRE_FALSE(menu.trail(0).exaggerated);
  CHECK_FALSE(menu.isOn(command::trailBlend));
  CHECK(whyOff(menu.command(command::trailBlend), menu.open) == "exaggerate the trail first");
  menu.run(command::trailExaggerateOnce);
  CHECK(menu.isOn(command::trailBlend));
}

TEST_CASE(
    "The next warning is the one after the playhead, past the last the first, and none is said to be none") {
  Menu menu;
  menu.open.open(Opened{test::openedFile(STRETCH_SOURCE_DIR "/assets/dummy.glb")});
  const Status none = app::run(menu.command(command::warningNext), menu.open);
  REQUIRE_FALSE(none);
  CHECK(none.error().what == "nothing is warned of");
  Session& session = menu.session();
  for (const auto& [hand, frame] : {std::pair("left-hand", 12.0), std::pair("right-hand", 20.0)}) {
    const std::size_t before = session.pops().size();
    for (int axis = 0; axis < 6 && session.pops().size() == before; ++axis) { // in some direction its arm
                                                                              // turns
      ControllerOffset moved{hand, Vec3(0.0), Vec3(0.0)};
      moved.move[axis % 3] = axis < 3 ? 0.5 : -0.5;
      const Result<Document> posed = setOffsets(session.document(), 0, frame, {&moved, 1}, {}, {});
      REQUIRE(posed);
      REQUIRE(session.edit(*posed, "Move a hand"));
    }
  }
  std::set<double> frames;
  for (const LimbPop& pop : session.pops()) {
    frames.insert(pop.frame);
  }
  REQUIRE(frames.size() > 1);
  session.view().frame = 0.0;
  for (const double frame : frames) {
    menu.run(command::warningNext);
    CHECK(session.view().frame == frame);
  }
  menu.run(command::warningNext);
  CHECK(session.view().frame == *frames.begin());
  CHECK(session.history().undoLabel() == "Move a hand"); // it is no edit
}

TEST_CASE("A step that changes the rate names the rate, not the trails that count in it") {
  Menu menu;
  menu.exaggerate({"left-arm"});
  menu.run(command::clipRate25);
  CHECK(lastStep(menu.session()) == "Change the frame rate \xE2\x80\x93 25 fps");
}

TEST_CASE("A command is on only where it does something") {
  Menu menu;
  menu.exaggerate({"left-arm"});
  menu.run(command::trailApply);
  CHECK_FALSE(menu.isOn(command::trailApply));
  CHECK(menu.isOn(command::trailDeleteAll));
  menu.session().view().selection.editTrails().limbs = {"spine"};
  menu.session().view().selection.editTrails().trail = 0;
  CHECK_FALSE(menu.isOn(command::trailDeleteAll));
  menu.exaggerate({"spine"});
  CHECK_FALSE(menu.isOn(command::mirrorTrail)); // Which has no other side.
}

TEST_CASE("Trails that are one group are not grouped again, and a group is chosen once") {
  Menu menu;
  menu.exaggerate({"left-arm", "right-arm"});
  selectGroup(menu.session(), menu.session().view().selection.trail());
  CHECK_FALSE(menu.isOn(command::trailGroup));
  CHECK_FALSE(menu.isOn(command::trailSelectGroup));
  menu.session().view().selection.editTrails().limbs = {"left-arm"};
  CHECK(menu.isOn(command::trailSelectGroup));
}

TEST_CASE("Trails of one clip keep colours of their own") {
  Menu menu;
  menu.exaggerate({"left-arm", "right-arm"});
  CHECK(menu.trail(0).colour != menu.trail(1).colour);
  selectGroup(menu.session(), menu.trail(0).id);
  menu.run(command::trailNextColour);
  CHECK(menu.trail(0).colour != menu.trail(1).colour);
  // After trails went and came, a new one takes a colour that is free.
  for (int i = 0; i < 5; ++i) {
    menu.exaggerate({"spine"});
    menu.run(command::trailDelete);
  }
  menu.exaggerate({"spine"});
  CHECK(menu.trail(2).colour != menu.trail(0).colour);
  CHECK(menu.trail(2).colour != menu.trail(1).colour);
}

TEST_CASE("The history tells limb and value of what was done") {
  Menu menu;
  menu.exaggerate({"left-arm"});
  Session& session = menu.session();
  CHECK(lastStep(session) == "Exaggerate \xE2\x80\x93 left arm \xC3\x97"
                             "2");
  const int id = menu.trail(0).id;
  rig::TrailSettings settings = menu.trail(0).settings;
  settings.scale = 3.25;
  session.edit(*setTrailSettings(session.document(), id, settings), "Change the scale");
  CHECK(lastStep(session) == "Change the scale \xE2\x80\x93 left arm \xC3\x97"
                             "3.25");
  settings.endFrame += 2.0;
  const std::string range = std::to_string(static_cast<int>(settings.startFrame)) + " to " +
                            std::to_string(static_cast<int>(settings.endFrame));
  session.edit(*setTrailSettings(session.document(), id, settings), "Change the range");
  CHECK(lastStep(session) == "Change the range \xE2\x80\x93 left arm " + range);
  menu.run(command::trailApply);
  CHECK(lastStep(session) == "Apply the new motion \xE2\x80\x93 left arm");
  session.edit(*renameTrail(session.document(), id, "the jab"), "Rename the trail");
  CHECK(lastStep(session) == "Rename the trail \xE2\x80\x93 the jab");
  session.edit(*deleteTrail(session.document(), id), "Delete the trail");
  CHECK(lastStep(session) == "Delete the trail \xE2\x80\x93 the jab " + range);
  menu.exaggerate({"left-arm", "right-arm", "spine"});
  CHECK(lastStep(session) == "Exaggerate \xE2\x80\x93 left arm, right arm and spine \xC3\x97"
                             "2");
}

TEST_CASE("A group has a name of its own, which is saved, undone and gone with the group") {
  Menu menu;
  menu.exaggerate({"left-arm", "right-arm"});
  Session& session = menu.session();
  const int id = menu.trail(1).id;
  const std::vector<int> members = groupMembers(session.document(), id);
  CHECK(groupTitle(session.document(), members) == "left arm and right arm");
  session.edit(*renameGroup(session.document(), id, "  Clap "), "Rename the group");
  CHECK(groupTitle(session.document(), members) == "Clap");
  CHECK(trailTitle(session.document(), menu.trail(1)) == "right arm");
  Document again(test::boxer());
  REQUIRE(restoreWork(workOf(session.document()), again));
  CHECK(groupTitle(again, members) == "Clap");
  const Document apart = takeApart(session.document(), members);
  CHECK(findTrail(apart, id)->groupName.empty());
  CHECK_THAT(test::refusal(renameGroup(apart, id, "Clap")), Catch::Contains("the trail stands alone"));
  REQUIRE(session.undo());
  CHECK(groupTitle(session.document(), members) == "left arm and right arm");
}

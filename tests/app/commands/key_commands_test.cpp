// The clip's own keys by commands: which of them an undone edit gives back, and what is pasted at another
// rate.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/keys/keys.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/selection.h"
#include "app/edits/keys/track_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/app/run_command.h"

using namespace stretch;
using namespace stretch::app;
using test::run;

namespace {

const KeyRow armTurns{NodeIndex(3), Channel::rotation, {}};

/// The first key of the left arm, a value further.
Session withEditedArm() {
  Session session(test::boxer());
  session.view().keyRows = {armTurns};
  CHECK(run(session, command::keysAll).empty());
  REQUIRE(editKeys(session, moveKeys(session.document(), 0, pickedKeys(session), {0.0, 10.0}), "Move"));
  pickKeys(session, {}, false);
  REQUIRE(hasEditedKeys(session.document()));
  return session;
}

/// As the frames are stored, in seconds of single precision, but for that precision.
std::vector<double> framesOf(const Session& session) {
  std::vector<double> frames = keyFramesOf(session.document(), 0, armTurns);
  std::ranges::transform(frames, frames.begin(), [](double frame) { return std::round(1e3 * frame) / 1e3; });
  return frames;
}

} // namespace

TEST_CASE("The source's keys are given back to the limb whose controller is selected, and to no other") {
  Session session = withEditedArm();
  CHECK_FALSE(run(session, command::keysRestore).empty()); // nothing says which
  for (const char* const other : {"hips", "right-hand"}) {
    CAPTURE(other);
    selectController(session, other, false);
    CHECK(run(session, command::keysRestore).empty());
    CHECK(hasEditedKeys(session.document()));
  }
  selectController(session, "left-hand", false);
  CHECK(run(session, command::keysRestore).empty());
  CHECK_FALSE(hasEditedKeys(session.document()));
}

TEST_CASE("Copied keys are as far from one another in time where they are pasted at another rate") {
  Session session(test::boxer()); // keys at 0, 5, 10 and 20 of 30 a second
  pickKeys(session, keysBetween(session.document(), 0, std::vector{armTurns}, 5.0, 10.0), false);
  CHECK(run(session, command::keysCopy).empty());
  CHECK(run(session, command::clipRate24).empty());
  CHECK(framesOf(session) == std::vector{0.0, 4.0, 8.0, 16.0});
  session.view().frame = 20.0;
  CHECK(run(session, command::keysPaste).empty());
  CHECK(framesOf(session) == std::vector{0.0, 4.0, 8.0, 16.0, 20.0, 24.0});
}

TEST_CASE(
    "The source's keys are given back to a joint of its own as well, and where none is named it is asked") {
  Session session(test::openedFile(test::posedCharacter));
  const std::vector<rig::Controller> own = jointControllersOf(session.document());
  REQUIRE_FALSE(own.empty());
  const auto keyed = std::ranges::find_if(own, [&](const rig::Controller& joint) {
    return !keyFramesOf(session.document(), 0, {joint.node, Channel::rotation, {}}).empty();
  });
  REQUIRE(keyed != own.end());
  selectController(session, keyed->id, false);
  const std::vector<KeyRow> rows = rowsOfSelection(session);
  CHECK_FALSE(rows.empty());
  CHECK(std::ranges::all_of(rows, [&](const KeyRow& row) { return row.node == keyed->node; }));
  session.view().selection = {};
  session.view().keyRows = rows;
  CHECK(run(session, command::keysRestore) == "the clip's own keys are as the file has them");
  CHECK(run(session, command::keysAll).empty());
  REQUIRE(editKeys(session, moveKeys(session.document(), 0, pickedKeys(session), {0.0, 10.0}), "Move"));
  pickKeys(session, {}, false);
  CHECK(run(session, command::keysRestore) == "pick keys, or select a limb or a controller first");
  selectController(session, keyed->id, false);
  CHECK(run(session, command::keysRestore).empty());
  CHECK_FALSE(hasEditedKeys(session.document()));
}

TEST_CASE(
    "Of a joint the track of the picked key is given back, and its other ones stay as they were edited") {
  Session session = withEditedArm();
  const std::vector<KeyRow> moves{{NodeIndex(3), Channel::translation, {}}};
  REQUIRE(editKeys(session, insertKeys(session.document(), 0, moves, 5.0), "Insert"));
  pickKeys(session, keysBetween(session.document(), 0, std::vector{armTurns}, 5.0, 5.0), false);
  CHECK(run(session, command::keysRestore).empty());
  const std::vector<Track> edited = editedTracks(session.document(), 0);
  REQUIRE(edited.size() == 1);
  CHECK(edited.front().channel == Channel::translation);
}

TEST_CASE("Copied keys are pasted on the curve that is shown alone, and on their own where several are") {
  const KeyRow otherTurns{NodeIndex(6), Channel::rotation, {}};
  for (const bool alone : {true, false}) {
    Session session(test::boxer());
    pickKeys(session, keysBetween(session.document(), 0, std::vector{armTurns}, 5.0, 10.0), false);
    CHECK(run(session, command::keysCopy).empty());
    session.view().keyRows = alone ? std::vector{otherTurns} : std::vector{otherTurns, armTurns};
    session.view().frame = 12.0;
    CHECK(run(session, command::keysPaste).empty());
    CHECK(keyFramesOf(session.document(), 0, otherTurns).size() == (alone ? 2U : 0U));
    CHECK(keyFramesOf(session.document(), 0, armTurns).size() == (alone ? 4U : 6U));
  }
}

TEST_CASE("With no key picked every key between two frames is snapped, and none is picked then") {
  Session session(test::boxer());
  CHECK(run(session, command::keysSnap) == "open the graph or the dope sheet first");
  session.view().keyRows = {armTurns};
  CHECK_THAT(run(session, command::keysSnap), Catch::StartsWith("every key of the clip stands on a whole"));
  const KeySelection second = keysBetween(session.document(), 0, std::vector{armTurns}, 5.0, 5.0);
  REQUIRE(editKeys(session, moveKeys(session.document(), 0, second, {0.3, 0.0}), "Move"));
  pickKeys(session, {}, false);
  REQUIRE(framesOf(session) == std::vector{0.0, 5.3, 10.0, 20.0});
  CHECK(run(session, command::keysSnap).empty());
  CHECK(framesOf(session) == std::vector{0.0, 5.0, 10.0, 20.0});
  CHECK_FALSE(hasPickedKeys(session));
}

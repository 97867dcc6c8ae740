#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/commands/pose/posing.h"
#include "app/commands/pose/step_text.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/nudges.h"
#include "app/commands/table/selection.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/open_document.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/run_command.h"

using namespace stretch;
using namespace stretch::app;
using test::run;

namespace {

OffsetPose moved(const std::string& id, const Vec3& move) {
  return {{{id, move, Vec3(0.0)}}, {}};
}

Vec3 moveOf(const Session& session, const std::string& id) {
  return shownOffset(session, id).move;
}

Session posed(const std::string& id, const Vec3& move, double frame = 8.0) {
  Session session(test::boxer());
  session.view().frame = frame;
  selectController(session, id, false);
  REQUIRE(poseAll(session, moved(id, move), "Move"));
  return session;
}

} // namespace

TEST_CASE(
    "A pose that is tried while the mouse is down is keyed where keys are made by themselves, else held") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  selectController(session, "left-hand", false);
  const Vec3 move(0.05, -0.1, 0.02);
  const bool autoKey = GENERATE(true, false);
  session.view().autoKey = autoKey;
  session.begin("Move");
  REQUIRE(previewPose(session, moved("left-hand", move)));
  CHECK(session.document().adjustments.empty() != autoKey);
  CHECK(session.view().unkeyed.offsets.empty() == autoKey);
  CHECK(glm::length(moveOf(session, "left-hand") - move) < 1e-9);
  REQUIRE(previewPose(session, moved("left-hand", 2.0 * move)));
  CHECK(glm::length(moveOf(session, "left-hand") - 2.0 * move) < 1e-9);
  CHECK(session.atBegin().adjustments.empty()); // no step yet
  CHECK_FALSE(previewPose(session, moved("left-wing", move)));
}

TEST_CASE("A command that nudges tells which way, how far, and what its key does with nothing to move") {
  NudgeSubject subject;
  subject.idPrefix = "thing.nudge-";
  subject.words = "the thing";
  subject.nudge = [](Session&, const Chord&) { return Success{}; };
  const std::vector<DocumentCommand> commands = nudgeCommands(subject);
  REQUIRE(commands.size() >= 18);
  std::size_t stepping = 0;
  for (const DocumentCommand& one : commands) {
    CAPTURE(one.id, one.help);
    const bool isPlainLeft = one.id == "thing.nudge-left";
    const bool isPlainRight = one.id == "thing.nudge-right";
    const bool steps = one.help.find(" With nothing to move the key ") != std::string::npos;
    stepping += steps ? 1 : 0;
    CHECK((!isPlainLeft || one.help.ends_with("With nothing to move the key steps a frame back.")));
    CHECK((!isPlainRight || one.help.ends_with("With nothing to move the key steps a frame on.")));
    CHECK(steps == !one.otherwise.empty());
    CHECK(one.help.find("the thing") != std::string::npos);
  }
  CHECK(stepping >= 2);
}

TEST_CASE("A selected controller takes limb, trail and spheres out of the selection, and they take it") {
  Session session(test::boxer());
  NewTrail wanted;
  wanted.limb = "left-arm";
  wanted.settings.endFrame = 10.0;
  const Result<CreatedTrail> created = createTrail(session.document(), wanted);
  REQUIRE(created);
  session.edit(created->document, "Make a trail");
  selectTrail(session, created->trailId);
  selectController(session, "hips", false);
  CHECK(session.view().selection.limbs().empty());
  CHECK(session.view().selection.trail() == 0);
  selectController(session, "left-hand", true);
  CHECK(session.view().selection.controllers() == std::vector<std::string>{"hips", "left-hand"});
  selectController(session, "hips", true);
  CHECK(session.view().selection.controllers() == std::vector<std::string>{"left-hand"});
  SECTION("by a limb") {
    selectLimb(session, "right-arm", false);
  }
  SECTION("by a trail") {
    selectTrail(session, created->trailId);
  }
  SECTION("by a trail that comes back") {
    session.undo();
    selectController(session, "hips", false);
    session.redo();
  }
  SECTION("by nothing") {
    CHECK(run(session, command::selectNone).empty());
  }
  CHECK(session.view().selection.controllers().empty());
}

TEST_CASE("A controller whose limb is gone is selected no longer") {
  Session session(test::boxer());
  selectControllers(session, {"hips", "left-hand"});
  Document without = session.document();
  std::erase_if(without.body.limbs, [](const rig::Limb& limb) { return limb.id == "left-arm"; });
  session.edit(without, "Forget the arm");
  CHECK(session.view().selection.controllers() == std::vector<std::string>{"hips"});
}

TEST_CASE("Keys go through the controllers of a limb, and through all of them") {
  Session session(test::boxer());
  const auto selected = [&] { return session.view().selection.controllers(); };
  CHECK(run(session, command::controllersOfLeftArm).empty());
  CHECK(selected() == std::vector<std::string>{"left-hand"});
  CHECK(run(session, command::controllersOfLeftArm).empty());
  CHECK(selected() == std::vector<std::string>{"left-elbow"});
  CHECK(run(session, command::controllersOfLeftArm).empty());
  CHECK(selected() == std::vector<std::string>{"left-hand"});
  CHECK(run(session, std::string(command::controllersOfHips) + "-add").empty());
  CHECK(selected() == std::vector<std::string>{"left-hand", "hips"});
  CHECK(run(session, command::controllersOfLeftLeg) == "this character has no left leg");
  const std::size_t count = controllersOf(session.document()).controllers.size();
  std::set<std::string> seen;
  for (std::size_t i = 0; i < count; ++i) {
    CHECK(run(session, command::controllerNext).empty());
    REQUIRE(selected().size() == 1);
    seen.insert(selected().front());
  }
  CHECK(seen.size() == count);
  const std::string last = selected().front();
  CHECK(run(session, command::controllerNext).empty());
  CHECK(run(session, command::controllerPrevious).empty());
  CHECK(selected().front() == last);
  CHECK(run(session, command::controllersAll).empty());
  CHECK(selected().size() == count);
}

TEST_CASE("What is posed is keyed in the working range, else on the whole clip") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  selectController(session, "hips", false);
  SECTION("in the range") {
    session.view().rangeStart = 4.0;
    session.view().rangeEnd = 12.0;
    REQUIRE(poseAll(session, moved("hips", {0.0, -0.1, 0.0}), "Move"));
    CHECK(session.document().adjustments.front().rangeFrames == Vec2(4.0, 12.0));
    CHECK_FALSE(isWholeClip(session));
  }
  SECTION("on the whole clip by choice") {
    session.view().rangeStart = 4.0;
    session.view().rangeEnd = 12.0;
    CHECK(run(session, command::poseWholeClip).empty());
    REQUIRE(poseAll(session, moved("hips", {0.0, -0.1, 0.0}), "Move"));
    CHECK_FALSE(session.document().adjustments.front().rangeFrames);
    CHECK(run(session, command::poseWholeClip).empty());
    CHECK(session.document().adjustments.front().rangeFrames == Vec2(4.0, 12.0));
  }
  SECTION("beside the range, at either side") {
    session.view().rangeStart = GENERATE(9.0, 2.0);
    session.view().rangeEnd = session.view().rangeStart + 5.0;
    REQUIRE(poseAll(session, moved("hips", {0.0, -0.1, 0.0}), "Move"));
    CHECK_FALSE(session.document().adjustments.front().rangeFrames);
  }
  SECTION("at an end of the range") {
    session.view().rangeStart = GENERATE(8.0, 3.0);
    session.view().rangeEnd = session.view().rangeStart + 5.0;
    REQUIRE(poseAll(session, moved("hips", {0.0, -0.1, 0.0}), "Move"));
    CHECK(session.document().adjustments.front().rangeFrames ==
          Vec2(session.view().rangeStart, session.view().rangeEnd));
  }
  SECTION("without a range") {
    REQUIRE(poseAll(session, moved("hips", {0.0, -0.1, 0.0}), "Move"));
    CHECK_FALSE(session.document().adjustments.front().rangeFrames);
    CHECK(isWholeClip(session));
  }
  CHECK(moveOf(session, "hips").y == Approx(-0.1));
}

TEST_CASE("What is posed at an end of its range is said to go at once there, but for the ends of the clip") {
  const double last = lastFrame(test::boxer(), 0);
  const auto endOf = [](const Vec2& range, double frame, const Vec3& move) {
    Session session(test::boxer());
    session.view().frame = frame;
    session.view().rangeStart = range.x;
    session.view().rangeEnd = range.y;
    selectController(session, "hips", false);
    REQUIRE(poseAll(session, moved("hips", move), "Move"));
    std::string ends =
        std::string(endsAtOnce(session, true) ? "first" : "") + (endsAtOnce(session, false) ? "last" : "");
    session.view().frame = frame + (frame < range.y ? 1.0 : -1.0);
    CHECK_FALSE((endsAtOnce(session, true) || endsAtOnce(session, false))); // no key there
    return ends;
  };
  const Vec3 down(0.0, -0.1, 0.0);
  CHECK(endOf({4.0, 8.0}, 8.0, down) == "last");
  CHECK(endOf({8.0, 12.0}, 8.0, down) == "first");
  CHECK(endOf({4.0, 12.0}, 8.0, down).empty());
  CHECK(endOf({0.0, 8.0}, 0.0, down).empty());
  CHECK(endOf({4.0, last}, last, down).empty());
  CHECK(endOf({4.0, 8.0}, 8.0, Vec3(0.0)).empty());
  Session whole = posed("hips", down);
  CHECK_FALSE((endsAtOnce(whole, true) || endsAtOnce(whole, false)));
  CHECK(heldPoseText(whole).starts_with("The pose is held over the whole clip"));
  Document other = whole.document();
  REQUIRE(other.adjustments.size() == 1);
  other.adjustments.front().clip = 1; // at the same frame of another clip
  whole.edit(other, "Move");
  CHECK(heldPoseText(whole).empty());
}

TEST_CASE("The range keys end what the selection is offset in") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  session.view().rangeStart = 4.0;
  session.view().rangeEnd = 12.0;
  selectController(session, "hips", false);
  REQUIRE(poseAll(session, moved("hips", {0.0, -0.1, 0.0}), "Move"));
  const auto range = [&] { return *session.document().adjustments.front().rangeFrames; };
  session.view().frame = 2.0;
  CHECK(run(session, command::rangeStart).empty());
  CHECK(range() == Vec2(2.0, 12.0));
  session.view().frame = 15.0;
  CHECK(run(session, command::rangeEnd).empty());
  CHECK(range() == Vec2(2.0, 15.0));
  session.view().frame = 9.0;
  CHECK(run(session, command::rangeStart).find("the key at frame 8") != std::string::npos);
  CHECK(range() == Vec2(2.0, 15.0));
}

TEST_CASE("With auto-key off a pose is shown until the playhead moves, and a key keeps it") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  selectController(session, "hips", false);
  CHECK(run(session, command::poseAutoKey).empty());
  const Vec3 before = positionOf(session.frameAt(8.0).worlds[at(session.document().body.hips)]);
  REQUIRE(poseAll(session, moved("hips", {0.0, -0.1, 0.0}), "Move"));
  CHECK(session.document().adjustments.empty());
  CHECK_FALSE(session.history().canUndo());
  const Vec3 shown = positionOf(session.frameAt(8.0).worlds[at(session.document().body.hips)]);
  CHECK(shown.y - before.y == Approx(-0.1));
  CHECK(positionOf(session.frameAt(9.0).worlds[at(session.document().body.hips)]).y == Approx(before.y));
  SECTION("dropped") {
    session.view().frame = 9.0;
    static_cast<void>(session.frameAt(9.0));
    session.view().frame = 8.0;
    CHECK(moveOf(session, "hips") == Vec3(0.0));
  }
  SECTION("keyed") {
    CHECK(run(session, command::poseKey).empty());
    CHECK(session.view().unkeyed.empty());
    CHECK(offsetAt(session.document(), 0, 8.0, "hips").move.y == Approx(-0.1));
    CHECK(session.history().undoLabel() == "Key the hips");
  }
  SECTION("reset") {
    CHECK(run(session, command::poseReset).empty());
    CHECK(moveOf(session, "hips") == Vec3(0.0));
  }
}

TEST_CASE(
    "Where nothing is posed without a key none is set: what is dragged goes on, and nothing is undone") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  REQUIRE(keyUnkeyedPose(session));
  CHECK_FALSE(session.history().canUndo());
  session.begin("Move the hand");
  const Result<Document> pulled =
      setOffsets(session.document(), 0, 8.0, moved("left-hand", {0.1, 0.0, 0.0}).offsets, {}, {});
  REQUIRE(pulled);
  session.preview(*pulled);
  REQUIRE(keyUnkeyedPose(session));
  CHECK(session.isDragging());
  CHECK(session.document().adjustments.size() == 1);
  session.commit();
  CHECK(session.history().undoLabel() == "Move the hand");
  // With something posed it is the pose that is kept, and what is only tried is not.
  CHECK(run(session, command::poseAutoKey).empty());
  REQUIRE(poseAll(session, moved("hips", {0.0, -0.1, 0.0}), "Move"));
  session.begin("Try");
  session.preview(test::boxer());
  REQUIRE(keyUnkeyedPose(session));
  CHECK_FALSE(session.isDragging());
  CHECK(session.document().adjustments.size() == 2);
  CHECK(session.history().undoLabel() == "Key the hips");
}

TEST_CASE("A key is set, gone to and deleted") {
  Session session = posed("hips", {0.0, -0.1, 0.0});
  session.view().frame = 14.0;
  CHECK(run(session, command::poseDeleteKey) == "select a controller that has a key at the playhead");
  CHECK(run(session, command::poseKey).empty());
  CHECK(session.document().adjustments.front().keys.size() == 2);
  session.view().frame = 0.0;
  CHECK(run(session, command::timeNextKey).empty());
  CHECK(session.view().frame == 8.0);
  CHECK(run(session, command::timeNextKey).empty());
  CHECK(session.view().frame == 14.0);
  CHECK(run(session, command::poseKeyStepped).empty());
  CHECK(interpolationHere(session) == rig::KeyInterpolation::stepped);
  CHECK(run(session, command::poseDeleteKey).empty());
  CHECK(session.document().adjustments.front().keys.size() == 1);
}

TEST_CASE("Reset takes the selection's offsets, or everything, at the playhead or over the range") {
  Session session = posed("hips", {0.0, -0.1, 0.0});
  selectController(session, "left-hand", false);
  REQUIRE(poseAll(session, moved("left-hand", {0.1, 0.0, 0.0}), "Move"));
  SECTION("the selection") {
    CHECK(run(session, command::poseReset).empty());
    CHECK(moveOf(session, "left-hand") == Vec3(0.0));
    CHECK(moveOf(session, "hips").y == Approx(-0.1));
  }
  SECTION("the selection over the range") {
    session.view().frame = 3.0;
    CHECK(run(session, command::poseResetRange).empty());
    CHECK(adjustedIds(session.document(), 0) == std::vector<std::string>{"hips"});
  }
  SECTION("everything") {
    CHECK(run(session, command::poseResetRig).empty());
    CHECK(session.document().adjustments.empty());
  }
  SECTION("everything over a range") {
    session.view().rangeStart = 5.0;
    session.view().rangeEnd = 10.0;
    CHECK(run(session, command::poseResetRigRange).empty());
    CHECK(session.document().adjustments.empty());
  }
  SECTION("nothing outside of a range, wherever the playhead stands") {
    session.view().rangeStart = 10.0;
    session.view().rangeEnd = 15.0;
    session.view().frame = 2.0;
    CHECK(run(session, command::poseResetRange).empty());
    CHECK(run(session, command::poseResetRigRange).empty());
    session.view().frame = 8.0;
    CHECK(moveOf(session, "left-hand").x == Approx(0.1));
    CHECK(moveOf(session, "hips").y == Approx(-0.1));
  }
}

TEST_CASE("A pose is mirrored to the other side, in its limb's own space, and sides change places") {
  Session session = posed("left-hand", {0.1, 0.2, 0.3});
  CHECK(run(session, command::poseMirror).empty());
  CHECK(moveOf(session, "right-hand").x == Approx(-0.1));
  CHECK(moveOf(session, "right-hand").y == Approx(0.2));
  CHECK(moveOf(session, "right-hand").z == Approx(0.3));
  CHECK(moveOf(session, "left-hand").x == Approx(0.1));
  REQUIRE(poseAll(session, moved("left-hand", {0.0, 0.5, 0.0}), "Move"));
  selectControllers(session, {"left-hand", "right-hand"});
  CHECK(run(session, command::poseMirror).empty());
  CHECK(moveOf(session, "right-hand").y == Approx(0.5));
  CHECK(moveOf(session, "left-hand").y == Approx(0.2));
}

TEST_CASE("A turn in the middle is mirrored in place: leaning left becomes leaning right") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  selectController(session, "spine-top", false);
  REQUIRE(poseAll(session, {{{"spine-top", Vec3(0.1, 0.0, 0.0), Vec3(0.3, 0.4, 0.5)}}, {}}, "Turn"));
  CHECK(run(session, command::poseMirror).empty());
  const ControllerOffset mirrored = shownOffset(session, "spine-top");
  CHECK(mirrored.move.x == Approx(-0.1));
  CHECK(mirrored.turn.x == Approx(0.3));
  CHECK(mirrored.turn.y == Approx(-0.4));
  CHECK(mirrored.turn.z == Approx(-0.5));
}

TEST_CASE("Offsets are copied from one frame to another, with its attributes, in one step") {
  Session session = posed("left-hand", {0.1, 0.2, 0.3}, 4.0);
  REQUIRE(poseAll(session, {{}, {{"left-arm.stretch", 0.25}}}, "Stretch"));
  CHECK(run(session, command::poseCopyOffsets).empty());
  REQUIRE(run(session, command::poseResetRigRange).empty());
  session.view().frame = 12.0;
  CHECK(run(session, command::posePaste).empty());
  CHECK(moveOf(session, "left-hand").z == Approx(0.3));
  CHECK(shownValue(session, "left-arm.stretch") == Approx(0.25));
  session.undo();
  CHECK(session.document().adjustments.empty());
}

TEST_CASE("Copied offsets fit a character of another size") {
  Session session = posed("left-hand", {0.1, 0.2, 0.3});
  CHECK(run(session, command::poseCopyOffsets).empty());
  Document larger = test::boxer();
  for (rig::Limb& limb : larger.body.limbs) {
    limb.restLength *= 2.0;
  }
  OpenDocument open(Opened(session.document()));
  open.character()->view().copiedPose = session.view().copiedPose;
  open.open(Opened(larger));
  Session& other = *open.character();
  CHECK(run(other, command::posePaste).empty());
  CHECK(moveOf(other, "left-hand").z == Approx(0.6));
}

TEST_CASE("A tween stands between the keys beside the playhead, or past them") {
  Session session = posed("hips", {0.0, 0.1, 0.0}, 4.0);
  CHECK(run(session, command::poseTween) == "move the playhead between two keys of the selected controllers");
  session.view().frame = 12.0;
  REQUIRE(poseAll(session, moved("hips", {0.0, 0.3, 0.0}), "Move"));
  session.view().frame = 8.0;
  CHECK(run(session, command::poseTween).empty());
  CHECK(moveOf(session, "hips").y == Approx(0.2));
  CHECK(tweened(session, 0.0).offsets.front().move.y == Approx(0.1));
  CHECK(tweened(session, 1.5).offsets.front().move.y == Approx(0.4));
}

TEST_CASE("The history says what was posed and at which frame") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  selectController(session, "left-hand", false);
  CHECK(run(session, command::poseKey).empty());
  const auto last = [&] { return stepTexts(session.history()).back(); };
  CHECK(last() == "Key the left hand \xE2\x80\x93 at frame 8");
  selectControllers(session, {"left-hand", "right-hand", "hips", "body"});
  CHECK(run(session, command::poseKey).empty());
  CHECK(last() == "Key 4 controllers \xE2\x80\x93 at frame 8");
  session.view().frame = 9.0;
  REQUIRE(poseAll(session, {{}, {{"left-arm.stretch", 0.5}}}, "Change the left arm stretch"));
  CHECK(last() == "Change the left arm stretch \xE2\x80\x93 at frame 9");
}

TEST_CASE("Arrows nudge the selected controllers in the view plane, by the steps of spheres") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  selectController(session, "hips", false);
  const double step = nudgeUnits(session.document());
  const std::string nudge = controllerNudges;
  CHECK(run(session, nudge + "up").empty());
  CHECK(moveOf(session, "hips").y == Approx(step));
  CHECK(run(session, nudge + "up-far").empty());
  CHECK(moveOf(session, "hips").y == Approx(11.0 * step));
  CHECK(run(session, nudge + "right-fine").empty());
  CHECK(moveOf(session, "hips").x == Approx(0.1 * step));
  selectController(session, "LeftForeArm", false);
  CHECK_FALSE(run(session, nudge + "up").empty());
}

TEST_CASE("Undo takes a pose without a key first, and then what was done before") {
  Session session = posed("hips", {0.0, -0.1, 0.0});
  CHECK(run(session, command::poseAutoKey).empty());
  selectController(session, "left-hand", false);
  REQUIRE(poseAll(session, moved("left-hand", {0.1, 0.0, 0.0}), "Move"));
  CHECK(run(session, command::undo).empty());
  CHECK(moveOf(session, "left-hand") == Vec3(0.0));
  CHECK(moveOf(session, "hips").y == Approx(-0.1));
  CHECK(run(session, command::undo).empty());
  CHECK(session.document().adjustments.empty());
  REQUIRE(poseAll(session, moved("left-hand", {0.1, 0.0, 0.0}), "Move"));
  CHECK(run(session, command::undo).empty());
  CHECK(moveOf(session, "left-hand") == Vec3(0.0));
  CHECK(run(session, command::undo) == "nothing was done yet");
}

TEST_CASE("A pose without a key stays at its place in time when frames are counted at another rate") {
  Session session(test::boxer());
  session.view().frame = 5.0;
  CHECK(run(session, command::poseAutoKey).empty());
  selectController(session, "left-hand", false);
  REQUIRE(poseAll(session, moved("left-hand", {0.1, 0.0, 0.0}), "Move"));
  CHECK(run(session, command::clipRate24).empty());
  CHECK(session.view().frame == 4.0);
  CHECK(moveOf(session, "left-hand").x == Approx(0.1));
}

TEST_CASE("A range that reaches beyond the clip is keyed as far as the clip goes") {
  Session session(test::boxer()); // frames 0 to 20
  session.view().frame = 8.0;
  session.view().rangeStart = -3.0;
  session.view().rangeEnd = 50.0;
  CHECK(keyRange(session).rangeFrames == Vec2(0.0, 20.0));
}

TEST_CASE("Of several ranges the one at the playhead, or the nearest that grows up to it, ends there") {
  const auto hipsOver = [](const Vec2& range, double frame, int clip) {
    rig::OffsetKey key;
    key.frame = frame;
    key.move = Vec3(0.0, 0.1, 0.0);
    return rig::Adjustment{"hips", clip, range, {key}};
  };
  const rig::Adjustment early = hipsOver({2.0, 6.0}, 4.0, 0);
  const rig::Adjustment late = hipsOver({10.0, 14.0}, 12.0, 0);
  const rig::Adjustment other = hipsOver({7.0, 9.0}, 8.0, 1);
  struct Ended {
    bool start;
    double frame;
    Vec2 early;
    Vec2 late;
  };
  for (const Ended& one :
       {Ended{true, 8.0, {2.0, 6.0}, {8.0, 14.0}}, Ended{false, 8.0, {2.0, 8.0}, {10.0, 14.0}},
        Ended{true, 1.0, {1.0, 6.0}, {10.0, 14.0}}, Ended{false, 16.0, {2.0, 6.0}, {10.0, 16.0}},
        Ended{true, 3.0, {3.0, 6.0}, {10.0, 14.0}}}) {
    for (const std::vector<rig::Adjustment>& order :
         {std::vector{early, late, other}, {other, late, early}}) {
      CAPTURE(one.start, one.frame);
      Document document = test::boxer();
      document.clips =
          std::make_shared<const std::vector<Clip>>(std::vector<Clip>(2, document.clips->front()));
      document.adjustments = order;
      Session session(document);
      session.view().frame = one.frame;
      selectController(session, "hips", false);
      REQUIRE(endOffsetsHere(session, one.start));
      CHECK(adjustmentAt(session.document(), 0, 4.0, "hips")->rangeFrames == one.early);
      CHECK(adjustmentAt(session.document(), 0, 12.0, "hips")->rangeFrames == one.late);
      CHECK(*adjustmentAt(session.document(), 1, 8.0, "hips") == other);
    }
  }
}

TEST_CASE("What is posed without a key comes together at a frame, and begins anew at another one") {
  Session session(test::boxer());
  session.view().autoKey = false;
  session.view().frame = 8.0;
  REQUIRE(poseAll(session, moved("hips", {0.0, -0.1, 0.0}), "Move"));
  REQUIRE(poseAll(session, moved("left-hand", {0.1, 0.0, 0.0}), "Move"));
  REQUIRE(poseAll(session, {{}, {{"left-arm.stretch", 0.5}}}, "Stretch"));
  CHECK(moveOf(session, "hips").y == -0.1);
  CHECK(moveOf(session, "left-hand").x == 0.1);
  CHECK(shownValue(session, "left-arm.stretch") == 0.5);
  session.view().frame = 9.0;
  REQUIRE(poseAll(session, moved("hips", {0.0, 0.2, 0.0}), "Move"));
  CHECK(moveOf(session, "hips").y == 0.2);
  CHECK(moveOf(session, "left-hand") == Vec3(0.0));
  CHECK(shownValue(session, "left-arm.stretch") == 1.0);
  session.view().frame = 8.0;
  CHECK(moveOf(session, "hips") == Vec3(0.0));
}

TEST_CASE("How the keys here are passed is told where those of the selection agree") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  selectControllers(session, {"hips", "left-hand"});
  REQUIRE(run(session, command::poseKey).empty());
  CHECK(interpolationHere(session) == rig::KeyInterpolation::automatic);
  selectController(session, "hips", false);
  REQUIRE(run(session, command::poseKeyStepped).empty());
  selectControllers(session, {"left-hand", "right-hand"}); // of which one has no key
  CHECK(interpolationHere(session) == rig::KeyInterpolation::automatic);
  for (const std::vector<std::string>& both :
       {std::vector<std::string>{"hips", "left-hand"}, {"left-hand", "hips"}}) {
    selectControllers(session, both);
    CHECK_FALSE(interpolationHere(session));
  }
}

TEST_CASE("A value gets a key with its hand where it was touched or keyed before, and no other one does") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  selectController(session, "left-hand", false);
  REQUIRE(run(session, command::poseKey).empty());
  CHECK(adjustedIds(session.document(), 0) == std::vector<std::string>{"left-hand"});
  session.view().autoKey = false;
  REQUIRE(poseAll(session, {{}, {{"left-arm.stretch", 0.5}}}, "Stretch"));
  REQUIRE(run(session, command::poseKey).empty());
  CHECK(adjustedIds(session.document(), 0) == std::vector<std::string>{"left-hand", "left-arm.stretch"});
  session.view().frame = 12.0;
  REQUIRE(run(session, command::poseKey).empty());
  CHECK(offsetKeyAt(session.document(), 0, 12.0, "left-arm.stretch") != nullptr);
}

TEST_CASE("A mirrored value gets a key where the other side has another one, and nothing else does") {
  Session session(test::boxer());
  session.view().frame = 8.0;
  selectController(session, "left-hand", false);
  REQUIRE(poseAll(session, {{}, {{"left-arm.stretch", 0.5}}}, "Stretch"));
  CHECK(run(session, command::poseMirror).empty());
  CHECK(shownValue(session, "right-arm.stretch") == 0.5);
  CHECK(adjustedIds(session.document(), 0) ==
        std::vector<std::string>{"left-arm.stretch", "right-arm.stretch"});
}

#include <algorithm>

#include <catch2/catch.hpp>
#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/commands/pose/hold.h"
#include "app/commands/pose/step_text.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/document_commands.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/evaluate/planted_feet.h"
#include "app/recipe/recipe.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/posed_file.h"
#include "tests/support/nodes.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

const DocumentCommand& holdCommand(const std::string& id) {
  static const std::vector<DocumentCommand> commands = documentCommands();
  const auto command = std::ranges::find(commands, id, &DocumentCommand::id);
  REQUIRE(command != commands.end());
  return *command;
}

/// The problem that a command tells; empty when it did its work.
std::string runHold(Session& session, const std::string& id) {
  const DocumentCommand& command = holdCommand(id);
  if (!command.enabled(session)) {
    return command.needs;
  }
  const Status done = command.run(session);
  return done ? std::string() : done.error().line();
}

Vec3 seenEnd(Session& session, const std::string& limb, double frame) {
  return rig::endPosition(*findLimb(session.document(), limb), session.frameAt(frame));
}

/// Over the whole clip, keyed at a frame.
void lowerHips(Session& session, double frame) {
  rig::Adjustment low;
  low.controller = "hips";
  low.keys.resize(1);
  low.keys[0].frame = frame;
  low.keys[0].move = {0.0, -0.1, 0.0};
  const Result<Document> lowered = placeAdjustments(session.document(), std::vector{low});
  REQUIRE(lowered);
  session.edit(*lowered, "Lower the hips");
}

/// The left arm, at frame 5 of the working range 2 to 12.
Session armSelected() {
  Session session(test::boxer());
  session.view().rangeStart = 2.0;
  session.view().rangeEnd = 12.0;
  session.view().frame = 5.0;
  selectLimb(session, "left-arm", false);
  return session;
}

std::string lastHoldStep(const Session& session) {
  const History<Document>& history = session.history();
  return stepText(history.undoLabel(), history.at(history.position() - 1), history.at(history.position()));
}

} // namespace

TEST_CASE("A hand is pinned where it is seen at the playhead, over the working range") {
  Session session = armSelected();
  const Vec3 held = seenEnd(session, "left-arm", 5.0);
  REQUIRE(runHold(session, command::holdPin).empty());
  REQUIRE(session.document().holds.pins.size() == 1);
  for (double frame = 2.0; frame <= 12.0; frame += 1.0) {
    CHECK(glm::length(seenEnd(session, "left-arm", frame) - held) < 1e-9);
  }
  session.undo();
  CHECK(session.document().holds.empty());
}

TEST_CASE("A hand that a trail has moved is pinned where the trail has it") {
  Session session(test::withNewTrail(test::boxer(), {}));
  session.view().rangeStart = 2.0;
  session.view().rangeEnd = 12.0;
  session.view().frame = 8.0;
  selectLimb(session, "left-arm", false);
  const Vec3 held = seenEnd(session, "left-arm", 8.0);
  const Vec3 unmoved = rig::endPosition(*findLimb(session.document(), "left-arm"), session.originalAt(8.0));
  REQUIRE(glm::length(held - unmoved) > 0.1);
  REQUIRE(runHold(session, command::holdPin).empty());
  const Vec2 range = session.document().holds.pins.front().time.rangeFrames;
  REQUIRE(range.y - range.x > 5.0);
  for (double frame = range.x; frame <= range.y; frame += 1.0) {
    CHECK(glm::length(seenEnd(session, "left-arm", frame) - held) < 1e-9);
  }
}

TEST_CASE(
    "A pinned hand stays where it was pinned when the hips are lowered afterwards, at the pin's frame too") {
  Session session = armSelected();
  const Vec3 held = seenEnd(session, "left-arm", 5.0);
  REQUIRE(runHold(session, command::holdPin).empty());
  lowerHips(session, 5.0);
  const Vec3 elbow = seenEnd(session, "spine", 5.0);
  CHECK(glm::length(seenEnd(session, "left-arm", 5.0) - held) < 1e-6);
  session.undo();
  CHECK(glm::length(seenEnd(session, "spine", 5.0) - elbow) > 0.05);
}

TEST_CASE("What was pinned is told with its frames, and what it took the place of") {
  Session session(test::boxer());
  const auto told = [&] { return lastHoldStep(session); };
  selectLimb(session, "left-arm", false);
  session.view().rangeStart = 2.0;
  session.view().rangeEnd = 6.0;
  REQUIRE(runHold(session, command::holdPin).empty());
  CHECK(told() == "Pin \xE2\x80\x93 left arm 2 to 6");
  session.view().rangeStart = 9.0;
  session.view().rangeEnd = 12.0;
  REQUIRE(runHold(session, command::holdPin).empty());
  CHECK(told() == "Pin \xE2\x80\x93 left arm 9 to 12");
  CHECK(session.document().holds.pins.size() == 2);
  session.view().rangeStart = 5.0;
  session.view().rangeEnd = 10.0;
  REQUIRE(runHold(session, command::holdPin).empty());
  CHECK(told() == "Pin \xE2\x80\x93 left arm 5 to 10 in the place of 2 to 6 and 9 to 12");
  REQUIRE(runHold(session, command::holdRemove).empty());
  CHECK(told() == "Take holds away \xE2\x80\x93 left arm 5 to 10");
}

TEST_CASE(
    "A pin outside of the selected trail's range is made around the playhead, between the limb's trails") {
  Document trails = test::withNewTrail(test::boxer(), {"left-arm", 2.0, 6.0});
  const int first = trails.trails.front().id;
  trails = test::withNewTrail(trails, {"left-arm", 14.0, 18.0});
  Session session(test::withNewTrail(trails, {"right-arm", 9.0, 12.0}));
  const double last = lastFrame(session.document(), 0);
  const auto pinned = [&](double frame) {
    session.view().frame = frame;
    selectTrail(session, first);
    session.followSelection();
    REQUIRE(runHold(session, command::holdPin).empty());
    const Vec2 range = session.document().holds.pins.back().time.rangeFrames;
    session.undo();
    return range;
  };
  CHECK(pinned(4.0) == Vec2(2.0, 6.0));
  CHECK(pinned(10.0) == Vec2(6.0, 14.0));
  CHECK(pinned(19.0) == Vec2(18.0, last));
  CHECK(pinned(1.0) == Vec2(0.0, 2.0));
  session.view().selection.dropTrail();
  session.followSelection();
  session.view().rangeStart = 8.0; // by hand, wherever the playhead is
  session.view().rangeEnd = 11.0;
  CHECK(pinned(19.0) == Vec2(8.0, 11.0));
}

TEST_CASE("In a recipe a pin follows its frame where the clip has the hand there, and else keeps its place") {
  Session session = armSelected();
  REQUIRE(runHold(session, command::holdPin).empty());
  const auto pinOf = [&] { return recipeToJson(session.document(), 0)["pins"][0]; };
  CHECK(pinOf()["at"] == 5.0);
  CHECK_FALSE(pinOf().contains("place"));
  lowerHips(session, 5.0);
  CHECK(pinOf().contains("place"));
}

TEST_CASE("A pin over a trail tells that the trail does not show there") {
  Session session(test::withNewTrail(test::boxer(), {}));
  const rig::TrailSettings& trail = session.document().trails.front().settings;
  selectLimb(session, "left-arm", false);
  const auto told = [&] { return lastHoldStep(session); };
  session.view().rangeStart = trail.startFrame;
  session.view().rangeEnd = trail.endFrame;
  REQUIRE(runHold(session, command::holdPin).empty());
  const std::string range = fmt::format("{:g} to {:g}", trail.startFrame, trail.endFrame);
  CHECK(told() == "Pin \xE2\x80\x93 left arm " + range + ", instead of the trail of " + range);
  selectLimb(session, "right-arm", false);
  REQUIRE(runHold(session, command::holdPin).empty());
  CHECK(told().starts_with("Pin \xE2\x80\x93 right arm"));
  CHECK(told().find("trail") == std::string::npos);
  session.undo();
  session.undo();
  session.edit(*setConnected(session.document(), session.document().trails.front().id, false), "Disconnect");
  selectLimb(session, "left-arm", false);
  REQUIRE(runHold(session, command::holdPin).empty());
  CHECK(told().starts_with("Pin"));
  CHECK(told().find("trail") == std::string::npos);
}

TEST_CASE(
    "Without a range a selected hand is pinned over the whole clip, a selected arm over its own stroke") {
  Session session(test::boxer());
  const double last = lastFrame(session.document(), 0);
  selectController(session, "left-hand", false);
  REQUIRE(runHold(session, command::holdPin).empty());
  CHECK(session.document().holds.pins.front().time.rangeFrames == Vec2(0.0, last));
  session.undo();
  selectLimb(session, "left-arm", false);
  const Vec2 stroke = proposedRange(session, *findLimb(session.document(), "left-arm"));
  REQUIRE(stroke.y - stroke.x < last);
  REQUIRE(runHold(session, command::holdPin).empty());
  CHECK(session.document().holds.pins.front().time.rangeFrames == stroke);
}

TEST_CASE("M lets the other hand follow, and lets it go again") {
  Session session(test::boxer());
  session.view().rangeStart = 0.0;
  session.view().rangeEnd = 20.0;
  selectController(session, "left-hand", false);
  REQUIRE(runHold(session, command::holdMatch).empty());
  REQUIRE(session.document().holds.grips.size() == 1);
  CHECK(session.document().holds.grips[0].leader == "left-arm");
  CHECK(session.document().holds.grips[0].follower == "right-arm");
  CHECK(holdCommand(command::holdMatch).checked(session));
  REQUIRE(runHold(session, command::holdMatch).empty());
  CHECK(session.document().holds.empty());
}

TEST_CASE("Holds of a limb are taken away together, and nothing is offered where there are none") {
  Session session(test::boxer());
  CHECK(runHold(session, command::holdPin) == "select an arm or a leg, a hand or a foot");
  selectLimb(session, "spine", false);
  CHECK_FALSE(runHold(session, command::holdPin).empty());
  selectLimb(session, "left-arm", false);
  CHECK(runHold(session, command::holdRemove) == "select a limb that is held");
  REQUIRE(runHold(session, command::holdPin).empty());
  REQUIRE(runHold(session, command::holdMatch).empty());
  REQUIRE(runHold(session, command::holdRemove).empty());
  CHECK(session.document().holds.empty());
}

TEST_CASE("Feet that stand are pinned where they stand, and hold there while the hips move") {
  Document document = test::openedFile(test::posedCharacter);
  rig::Adjustment low;
  low.controller = "hips";
  low.keys.resize(1);
  low.keys[0].move = {0.05, -0.1, 0.0};
  rig::Adjustment carried;
  carried.controller = "left-leg.follow";
  carried.keys.resize(1);
  carried.keys[0].value = 1.0;
  const std::vector<rig::Adjustment> both{low, carried};
  Session session(*placeAdjustments(document, both));
  REQUIRE(runHold(session, command::holdPinFeet).empty());
  REQUIRE_FALSE(session.document().holds.pins.empty());
  for (const rig::Pin& pin : session.document().holds.pins) {
    const Vec3 held = seenEnd(session, pin.limb, pin.atFrame);
    for (double frame = pin.time.rangeFrames.x; frame <= pin.time.rangeFrames.y; frame += 0.5) {
      CHECK(glm::length(seenEnd(session, pin.limb, frame) - held) < 1e-6);
    }
  }
}

TEST_CASE("A foot that is in the air is not pinned") {
  Document document = test::openedFile(STRETCH_SOURCE_DIR "/assets/dummy_leap.glb");
  const Clip& clip = clipOf(document, 0);
  const double last = clip.endSeconds * clip.framesPerSecond;
  const rig::Holds found = plantedFeet(document, 0, Vec2(0.0, last));
  REQUIRE_FALSE(found.pins.empty());
  double pinned = 0.0;
  for (const rig::Pin& pin : found.pins) {
    pinned += pin.time.rangeFrames.y - pin.time.rangeFrames.x;
    const Vec3 start = test::endOf(document, pin.limb, pin.time.rangeFrames.x);
    const Vec3 end = test::endOf(document, pin.limb, pin.time.rangeFrames.y);
    CHECK(glm::length(end - start) < 0.1 * document.body.height);
  }
  CHECK(pinned < 1.8 * last);
}

TEST_CASE("Feet are planted in the clip that is worked in: the same feet at the same frames of its copy") {
  Document document = test::openedFile(STRETCH_SOURCE_DIR "/assets/dummy_leap.glb");
  std::vector<Clip> clips = *document.clips;
  clips.push_back(clips.front());
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  std::vector<rig::Pin> first;
  for (const int clip : {0, 1}) {
    Session session(document);
    session.view().clip = clip;
    REQUIRE(runHold(session, command::holdPinFeet).empty());
    std::vector<rig::Pin> pins = session.document().holds.pins;
    REQUIRE_FALSE(pins.empty());
    for (rig::Pin& pin : pins) {
      CHECK(pin.clip == clip);
      pin.clip = 0;
    }
    first = clip == 0 ? pins : first;
    CHECK(pins == first);
  }
}

TEST_CASE("The bat of the bundled swing is held by both hands, until one lets go") {
  Session session(test::openedFile(STRETCH_SOURCE_DIR "/assets/dummy_swing.glb"));
  session.view().frame = 10.0;
  selectLimb(session, "left-arm", false);
  selectLimb(session, "right-arm", true);
  REQUIRE(runHold(session, command::holdProp).empty());
  REQUIRE(session.document().holds.props.size() == 1);
  CHECK(session.document().holds.props[0].hands.size() == 2);
  CHECK_FALSE(session.document().holds.props[0].boundFrame); // the clip moves it
  selectLimb(session, "right-arm", false);
  session.view().frame = 20.0;
  REQUIRE(runHold(session, command::holdLetGo).empty());
  const std::vector<rig::PropHand>& hands = session.document().holds.props[0].hands;
  const auto right = std::ranges::find(hands, "right-arm", &rig::PropHand::limb);
  REQUIRE(right != hands.end());
  CHECK(right->keys.back().frame == 23.0);
  CHECK(right->keys.back().value == 0.0);
}

TEST_CASE("Of the things that a hand can hold it takes the nearest, wherever that stands in the file") {
  for (const bool nearFirst : {true, false}) {
    for (const char* const arm : {"left-arm", "right-arm"}) {
      CAPTURE(nearFirst, arm);
      Document document = test::boxer();
      Scene scene = *document.scene;
      scene.meshes.resize(1);
      const double side = std::string(arm) == "left-arm" ? 1.0 : -1.0;
      // The hand is 0.8 aside and 1.5 high.
      for (const double apart : nearFirst ? std::vector{0.1, 0.4, 0.7} : std::vector{0.7, 0.4, 0.1}) {
        const NodeIndex thing = test::addNode(scene, apart < 0.2 ? "Near" : "Far", NodeIndex::none,
                                              {side * (0.8 + apart), 1.5, 0.0});
        scene.nodes[at(thing)].mesh = 0;
      }
      test::addNode(scene, "Nothing to see", NodeIndex::none, {side * 0.8, 1.5, 0.0});
      document.scene = std::make_shared<const Scene>(std::move(scene));
      Session session(document);
      selectLimb(session, arm, false);
      REQUIRE(runHold(session, command::holdProp).empty());
      const std::vector<rig::Prop>& props = session.document().holds.props;
      REQUIRE(props.size() == 1);
      const std::string held = props[0].node;
      CHECK((held == "Near" || held == "#" + std::to_string(nearFirst ? 9 : 11)));
      CHECK(props[0].boundFrame == session.view().frame); // it lies still
      REQUIRE(props[0].hands.size() == 1);
      CHECK(props[0].hands[0].limb == arm);
    }
  }
}

TEST_CASE("Of what is selected hands and feet are pinned, and what has neither is passed over") {
  const auto pinned = [](Session& session) {
    session.view().rangeStart = 2.0;
    session.view().rangeEnd = 12.0;
    REQUIRE(runHold(session, command::holdPin).empty());
    std::vector<std::string> limbs;
    for (const rig::Pin& pin : session.document().holds.pins) {
      limbs.push_back(pin.limb);
    }
    return limbs;
  };
  Session limbs(test::boxer());
  selectLimb(limbs, "spine", false);
  CHECK(runHold(limbs, command::holdPin) == "select an arm or a leg, a hand or a foot");
  selectLimb(limbs, "right-arm", true);
  CHECK(pinned(limbs) == std::vector<std::string>{"right-arm"});
  Session controllers(test::boxer());
  selectControllers(controllers, {"hips"});
  CHECK(runHold(controllers, command::holdPin) == "select an arm or a leg, a hand or a foot");
  selectControllers(controllers, {"hips", "left-hand"});
  CHECK(pinned(controllers) == std::vector<std::string>{"left-arm"});
}

TEST_CASE(
    "A limb is taken in the hand where it is known and there is a clip, and is refused by its name else") {
  const Document document = test::openedFile(test::posedCharacter);
  Session session(document);
  session.view().clip = 0;
  const Result<HeldLimb> held = holdLimb(session, "left-arm");
  REQUIRE(held);
  CHECK(findTrail(held->document, held->trailId)->limb == "left-arm");
  CHECK(test::refusal(holdLimb(session, "left-wing")) ==
        "left-wing: there is nothing to pull here; open a file with a clip");
  session.view().clip = 99;
  CHECK(test::refusal(holdLimb(session, "left-arm")) ==
        "left arm: there is nothing to pull here; open a file with a clip");
}

TEST_CASE("A limb is pinned once, and holds a thing, where its hand and its elbow are both selected") {
  Session session(test::openedFile(STRETCH_SOURCE_DIR "/assets/dummy_swing.glb"));
  session.view().frame = 10.0;
  selectControllers(session, {"left-hand", "left-elbow"});
  REQUIRE(runHold(session, command::holdProp).empty());
  REQUIRE(session.document().holds.props.size() == 1);
  CHECK(session.document().holds.props[0].hands.size() == 1);
  REQUIRE(runHold(session, command::holdPin).empty());
  CHECK(session.document().holds.pins.size() == 1);
}

TEST_CASE("A hold whose range would meet another one of its limb is refused, and both stay") {
  Document document = test::boxer();
  rig::Holds pins;
  for (const Vec2& range : {Vec2(0.0, 6.0), Vec2(8.0, 14.0)}) {
    rig::Pin pin;
    pin.limb = "left-arm";
    pin.time.rangeFrames = range;
    pin.atFrame = 0.0;
    pins.pins.push_back(pin);
  }
  const Result<Document> pinned = placeHolds(document, pins);
  INFO(test::refusal(pinned));
  REQUIRE(pinned);
  for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
    rig::Pin wide = pinned->holds.pins[which];
    wide.time.rangeFrames = {5.0, 9.0};
    CHECK_THAT(test::refusal(changeHold(*pinned, {rig::HoldKind::pin, which}, {{wide}, {}, {}})),
               Catch::Contains("held twice at the same time"));
    wide.time.rangeFrames = which == 0 ? Vec2(1.0, 7.0) : Vec2(7.0, 12.0);
    const Result<Document> moved = changeHold(*pinned, {rig::HoldKind::pin, which}, {{wide}, {}, {}});
    REQUIRE(moved);
    CHECK(moved->holds.pins[which] == wide);
    CHECK(moved->holds.pins[1 - which] == pinned->holds.pins[1 - which]);
  }
}

TEST_CASE("A grip is let go from the hand that follows as well") {
  Session session = armSelected();
  CHECK(runHold(session, command::holdMatch).empty());
  REQUIRE(session.document().holds.grips.size() == 1);
  selectLimb(session, session.document().holds.grips.front().follower, false);
  CHECK(runHold(session, command::holdMatch).empty());
  CHECK(session.document().holds.grips.empty());
}

TEST_CASE("A limb is taken over its stroke at the playhead, else over a quarter of a second to either side") {
  struct Taken {
    const char* limb;
    double frame;
    Vec2 range;
  };
  for (const Taken& one : {Taken{"left-arm", 7.0, {0.0, 10.0}}, Taken{"left-arm", 15.0, {10.0, 20.0}},
                           Taken{"right-arm", 10.4, {2.0, 18.0}}, Taken{"right-arm", 3.0, {0.0, 11.0}},
                           Taken{"right-arm", 18.0, {10.0, 20.0}}}) {
    CAPTURE(one.limb, one.frame);
    Session session(test::boxer());
    session.view().frame = one.frame;
    const Result<HeldLimb> held = holdLimb(session, one.limb);
    REQUIRE(held);
    const rig::Trail& trail = *findTrail(held->document, held->trailId);
    CHECK(Vec2(trail.settings.startFrame, trail.settings.endFrame) == one.range);
    CHECK(trail.settings.scale == 1.0);
    CHECK(trail.connected);
  }
}

TEST_CASE("A limb is taken by its trail at the playhead, which moves it then, and beside that by a new one") {
  Session session(test::withNewTrail(test::boxer(), {"left-arm", 4.0, 8.0, 2.0, false}));
  const int present = session.document().trails.front().id;
  for (const double frame : {4.0, 6.0, 8.0}) {
    session.view().frame = frame;
    const Result<HeldLimb> held = holdLimb(session, "left-arm");
    REQUIRE(held);
    CHECK(held->trailId == present);
    CHECK(held->document.trails.front().connected);
    CHECK(held->document.trails.size() == 1);
  }
  session.view().frame = 9.0;
  const Result<HeldLimb> beside = holdLimb(session, "left-arm");
  REQUIRE(beside);
  CHECK(beside->trailId != present);
  CHECK(findTrail(beside->document, beside->trailId)->settings.startFrame == 8.0);
  CHECK(findTrail(beside->document, beside->trailId)->settings.endFrame == 10.0);
}

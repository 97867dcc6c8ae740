#include <catch2/catch.hpp>

#include <algorithm>

#include <glm/geometric.hpp>

#include "app/commands/pose/posing.h"
#include "app/commands/pose/seen_posing.h"
#include "app/commands/table/command_ids.h"
#include "app/commands/table/frames.h"
#include "app/commands/table/selection.h"
#include "app/edits/trail/mirror_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/files/save.h"
#include "app/open_document.h"
#include "core/math/rotation.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/run_command.h"

using namespace stretch;
using namespace stretch::app;
using test::run;

namespace {

Document bundled() {
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  return std::move(opened).value();
}

Document twiceAsLarge() {
  Document document = test::boxer();
  Scene scene = *document.scene;
  for (Node& node : scene.nodes) {
    node.rest.translation *= 2.0;
  }
  document.scene = std::make_shared<const Scene>(std::move(scene));
  document.body.height *= 2.0;
  for (rig::Limb& limb : document.body.limbs) {
    limb.restLength *= 2.0;
  }
  return document;
}

rig::PlacedController placedAt(Session& session, double frame, const std::string& id) {
  const std::vector<rig::PlacedController>& placed = session.controllersAt(frame);
  const auto found = std::ranges::find(placed, id, &rig::PlacedController::id);
  REQUIRE(found != placed.end());
  return *found;
}

double apart(const rig::PlacedController& a, const rig::PlacedController& b) {
  return glm::length(a.placeWorld - b.placeWorld);
}

/// Radians between the ways in which two are turned.
double turnedApart(const rig::PlacedController& a, const rig::PlacedController& b) {
  const Quat between = a.orientationWorld * glm::inverse(b.orientationWorld);
  return 2.0 * glm::length(Vec3(between.x, between.y, between.z));
}

double poleTurnedApart(const rig::PlacedController& a, const rig::PlacedController& b) {
  return angleBetween(a.placeWorld - *a.jointWorld, b.placeWorld - *b.jointWorld);
}

std::vector<rig::PlacedController> allBut(Session& session, double frame, const std::string& left) {
  std::vector<rig::PlacedController> placed = session.controllersAt(frame);
  std::erase_if(placed, [&](const rig::PlacedController& one) { return one.id == left; });
  return placed;
}

constexpr double punchFrame = 27.0;
constexpr double nearby = 1e-4; // units: the boxer is 1.8 high

} // namespace

TEST_CASE("A copied pose is what is seen: pasted at another frame every controller stands and is turned so") {
  Session session(bundled());
  session.view().frame = punchFrame;
  const std::vector<rig::PlacedController> seen = allBut(session, punchFrame, "body");
  REQUIRE(run(session, command::poseCopy).empty());
  session.view().frame = 5.0;
  REQUIRE(apart(placedAt(session, 5.0, "left-hand"), placedAt(session, punchFrame, "left-hand")) > 0.1);
  CHECK(run(session, command::posePaste).empty());
  for (const rig::PlacedController& wanted : seen) {
    INFO(wanted.id);
    const rig::PlacedController now = placedAt(session, 5.0, wanted.id);
    // Of a pole the direction from its joint is the pose, not how far it stands away.
    CHECK(
        (!wanted.moves || (wanted.jointWorld ? poleTurnedApart(now, wanted) : apart(now, wanted)) < nearby));
    CHECK((!wanted.turns || turnedApart(now, wanted) < 1e-3));
  }
  session.undo();
  CHECK(session.document().adjustments.empty());
}

TEST_CASE("A pose that is pasted without a range comes in and goes between the keys of the clip beside it") {
  Session source(bundled());
  Session session(bundled());
  session.view().frame = punchFrame;
  REQUIRE(run(session, command::poseCopy).empty());
  const double frame = GENERATE(0.0, 3.0, 49.0, 60.0);
  session.view().frame = frame;
  REQUIRE(run(session, command::posePaste).empty());
  Vec2 beside(0.0, 60.0);
  for (const double key : keyFrames(session.document(), 0, {})) {
    beside.x = key <= frame - 4.0 ? key : beside.x; // a sixth of a second
    beside.y = key >= frame + 4.0 ? std::min(key, beside.y) : beside.y;
  }
  REQUIRE_FALSE(session.document().adjustments.empty());
  for (const rig::Adjustment& adjustment : session.document().adjustments) {
    REQUIRE(adjustment.rangeFrames);
    CHECK(*adjustment.rangeFrames == beside);
  }
  for (double other = 0.0; other <= 60.0; other += 1.0) {
    CAPTURE(other);
    if (other < beside.x || other > beside.y) {
      CHECK(apart(placedAt(session, other, "left-hand"), placedAt(source, other, "left-hand")) < 1e-9);
    }
  }
  CHECK(heldPoseText(session).starts_with("The pose comes in from frame"));
  session.undo();
  session.view().wholeClip = true;
  REQUIRE(run(session, command::posePaste).empty());
  CHECK_FALSE(session.document().adjustments.front().rangeFrames);
  CHECK(heldPoseText(session).starts_with("The pose is held over the whole clip"));
}

TEST_CASE("A pose that is pasted where the one before it ends gets time of its own") {
  Session session(bundled());
  session.view().frame = punchFrame;
  selectController(session, "left-hand", false);
  REQUIRE(run(session, command::poseCopy).empty());
  session.view().frame = 5.0;
  REQUIRE(run(session, command::posePaste).empty());
  const Vec2 first = *session.document().adjustments.front().rangeFrames;
  session.view().frame = GENERATE_COPY(first.y, first.y - 1.0);
  REQUIRE(run(session, command::posePaste).empty());
  const Vec2 wide = *session.document().adjustments.front().rangeFrames;
  CHECK(wide.x == first.x);
  CHECK(wide.y >= session.view().frame + 4.0);
  CHECK(glm::length(offsetAt(session.document(), 0, session.view().frame + 1.0, "left-hand").move) > 0.05);
  CHECK(heldPoseText(session).find("is gone at " + std::to_string(static_cast<int>(wide.y))) !=
        std::string::npos);
  session.undo();
  CHECK(*session.document().adjustments.front().rangeFrames == first);
}

TEST_CASE("What a trail makes of a limb is seen, and so is copied") {
  Session session(bundled());
  NewTrail wanted;
  wanted.limb = "left-arm";
  wanted.settings.endFrame = punchFrame;
  wanted.settings.scale = 2.0;
  wanted.exaggerated = true;
  wanted.connected = true;
  const Result<CreatedTrail> created = createTrail(session.document(), wanted);
  REQUIRE(created);
  session.edit(created->document, "Make a trail");
  session.view().frame = punchFrame;
  const Vec3 far = placedAt(session, punchFrame, "left-hand").placeWorld;
  selectController(session, "left-hand", false);
  REQUIRE(run(session, command::poseCopy).empty());
  session.view().frame = punchFrame + 12.0;
  CHECK(run(session, command::posePaste).empty());
  CHECK(glm::length(placedAt(session, session.view().frame, "left-hand").placeWorld - far) < nearby);
}

TEST_CASE("A fist is seen, and so is copied, pasted and mirrored") {
  Session session(bundled());
  session.view().frame = punchFrame;
  selectController(session, "left-hand", false);
  REQUIRE(poseAll(session, {{}, {{"left-hand.curl", 1.0}}}, "Make a fist"));
  REQUIRE(run(session, command::poseCopy).empty());
  session.undo();
  session.view().frame = 5.0;
  REQUIRE(shownValue(session, "left-hand.curl") < 0.5);
  CHECK(run(session, command::posePaste).empty());
  CHECK(shownValue(session, "left-hand.curl") == Approx(1.0));
  CHECK(run(session, command::posePasteMirrored).empty());
  CHECK(shownValue(session, "right-hand.curl") == Approx(1.0));
}

TEST_CASE("Of selected controllers alone the pose is copied, the rest stays as the clip has it") {
  Session session(bundled());
  session.view().frame = punchFrame;
  selectController(session, "left-hand", false);
  const rig::PlacedController hand = placedAt(session, punchFrame, "left-hand");
  REQUIRE(run(session, command::poseCopy).empty());
  session.view().frame = 5.0;
  const rig::PlacedController other = placedAt(session, 5.0, "right-hand");
  CHECK(run(session, command::posePaste).empty());
  CHECK(apart(placedAt(session, 5.0, "left-hand"), hand) < nearby);
  CHECK(apart(placedAt(session, 5.0, "right-hand"), other) < 1e-9);
  CHECK(session.history().undoLabel() == "Paste the pose on the left hand");
}

TEST_CASE("Pasted mirrored, the left hand is where the right one was, on the other side of the body") {
  Session session(bundled());
  session.view().frame = punchFrame;
  const rig::PlacedController left = placedAt(session, punchFrame, "left-hand");
  const rig::PlacedController hips = placedAt(session, punchFrame, "hips");
  const Vec3 normal = headingNormal(session.document(), 0, punchFrame);
  REQUIRE(run(session, command::poseCopy).empty());
  session.view().frame = 5.0;
  CHECK(run(session, command::posePasteMirrored).empty());
  const Vec3 from = left.placeWorld - hips.placeWorld;
  const Vec3 mirrored = hips.placeWorld + from - 2.0 * glm::dot(from, normal) * normal;
  CHECK(glm::length(placedAt(session, 5.0, "right-hand").placeWorld - mirrored) < nearby);
  SECTION("and mirrored once more it is the pose itself") {
    REQUIRE(run(session, command::poseCopy).empty());
    session.view().frame = 10.0;
    CHECK(run(session, command::posePasteMirrored).empty());
    const rig::PlacedController again = placedAt(session, 10.0, "left-hand");
    CHECK(apart(again, left) < 1e-2);
    CHECK(turnedApart(again, left) < 2e-2);
  }
}

TEST_CASE("A pose is pasted on a character of another size in lengths of its limbs") {
  Session session(test::boxer());
  session.view().frame = 10.0;
  const rig::PlacedController seen = placedAt(session, 10.0, "left-hand");
  const rig::PlacedController hips = placedAt(session, 10.0, "hips");
  REQUIRE(run(session, command::poseCopy).empty());
  OpenDocument open(Opened(session.document()));
  open.character()->view().copiedPose = session.view().copiedPose;
  open.open(Opened(twiceAsLarge()));
  Session& other = *open.character();
  other.view().frame = 5.0;
  const Vec3 standing = placedAt(other, 5.0, "hips").placeWorld;
  CHECK(run(other, command::posePaste).empty());
  const rig::PlacedController twice = placedAt(other, 5.0, "hips");
  CHECK(twice.placeWorld.y == Approx(2.0 * hips.placeWorld.y).epsilon(1e-4));
  CHECK(twice.placeWorld.x == Approx(standing.x).margin(1e-3));
  const Vec3 reach = placedAt(other, 5.0, "left-hand").placeWorld - twice.placeWorld;
  CHECK(glm::length(reach - 2.0 * (seen.placeWorld - hips.placeWorld)) < 1e-3);
}

TEST_CASE("On a character that faces the other way a pose is turned about the vertical") {
  Session session(bundled());
  session.view().frame = punchFrame;
  const Vec3 hips = placedAt(session, punchFrame, "hips").placeWorld;
  REQUIRE(run(session, command::poseCopy).empty());
  auto& pose = std::get<SeenPose>(*session.view().copiedPose);
  pose.of.reset(); // of another character, that looked the other way
  pose.leftWorld = -pose.leftWorld;
  session.view().frame = 5.0;
  CHECK(run(session, command::posePaste).empty());
  const Vec3 turned = placedAt(session, 5.0, "hips").placeWorld;
  CHECK(turned.y == Approx(hips.y).epsilon(1e-3));
  CHECK(placedAt(session, 5.0, "head").placeWorld.y > turned.y + 0.4);
  CHECK(placedAt(session, 5.0, "left-foot").placeWorld.y < turned.y - 0.4);
}

TEST_CASE("On a character that looks a quarter further round its feet stand a quarter further round") {
  Session session(bundled());
  session.view().frame = punchFrame;
  const Vec3 foot = placedAt(session, punchFrame, "left-foot").placeWorld -
                    placedAt(session, punchFrame, "hips").placeWorld;
  REQUIRE(run(session, command::poseCopy).empty());
  auto& pose = std::get<SeenPose>(*session.view().copiedPose);
  pose.of.reset();
  pose.leftWorld = Vec3(0.0, 0.0, 1.0); // it is (1, 0, 0) here
  session.view().frame = 5.0;
  CHECK(run(session, command::posePaste).empty());
  const Vec3 now = placedAt(session, 5.0, "left-foot").placeWorld - placedAt(session, 5.0, "hips").placeWorld;
  CHECK(glm::length(now - Vec3(foot.z, foot.y, -foot.x)) < 0.02);
}

TEST_CASE("Pasting what stands there already says so, and so does a character without these controllers") {
  Session session(bundled());
  session.view().frame = punchFrame;
  selectController(session, "left-hand", false);
  REQUIRE(run(session, command::poseCopy).empty());
  CHECK(run(session, command::posePaste).find("the character stands so already") != std::string::npos);
  CHECK(session.document().adjustments.empty());
  std::get<SeenPose>(*session.view().copiedPose).controllers.front().id = "tail-tip";
  CHECK(run(session, command::posePaste).find("has none of the controllers that were copied") !=
        std::string::npos);
  REQUIRE(run(session, command::poseCopyOffsets).empty());
  CHECK(run(session, command::posePasteMirrored) == "copy a pose first");
}

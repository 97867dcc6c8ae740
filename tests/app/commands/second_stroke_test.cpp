// Where E acts after an earlier E, on a limb that has a trail elsewhere, and on several limbs.
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "app/edits/trail/trail_edits.h"
#include "app/files/save.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Session dummy() {
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  return Session(std::move(opened).value());
}

const rig::TrailSettings& leading(const ExaggerateTargets& targets) {
  return findTrail(targets.document, targets.trailIds.front())->settings;
}

/// E, as the tool does it: a preview with the trail selected.
ExaggerateTargets begun(Session& session) {
  Result<ExaggerateTargets> targets = exaggerateTargets(session);
  REQUIRE(targets);
  session.begin("Exaggerate");
  session.preview(targets->document);
  selectTrail(session, targets->trailIds.front());
  return std::move(targets).value();
}

} // namespace

TEST_CASE("After E was left by Esc the next E follows the playhead") {
  Session session = dummy();
  selectLimb(session, "left-arm", false);
  const rig::TrailSettings first = leading(begun(session));
  CHECK(isRangeSet(session.view()));
  session.cancel();
  CHECK_FALSE(isRangeSet(session.view()));
  session.view().frame = 31.0;
  const rig::TrailSettings second = leading(begun(session));
  CHECK(second.startFrame >= first.endFrame);
}

TEST_CASE("A range set by hand is there again after E was left by Esc") {
  Session session = dummy();
  selectLimb(session, "left-arm", false);
  setRangeByHand(session, {22.0, 30.0});
  begun(session);
  session.cancel();
  CHECK(session.view().rangeStart == 22.0);
  CHECK(session.view().rangeEnd == 30.0);
}

TEST_CASE("A limb with a trail elsewhere gets another one at the stroke under the playhead") {
  Session session = dummy();
  selectLimb(session, "left-arm", false);
  const ExaggerateTargets punch = begun(session);
  session.commit();
  session.view().frame = 31.0;
  selectLimb(session, "left-arm", false);
  CHECK(session.view().selection.trail() == 0);
  const ExaggerateTargets back = begun(session);
  CHECK(back.trailIds.front() != punch.trailIds.front());
  CHECK(leading(back).startFrame >= leading(punch).endFrame);
  CHECK(session.document().trails.size() == 2);
}

namespace {

/// E on these limbs with the playhead there.
ExaggerateTargets exaggeratedAt(double frame, const std::vector<std::string>& limbs) {
  Session session = dummy();
  session.view().frame = frame;
  for (const std::string& limb : limbs) {
    selectLimb(session, limb, true);
  }
  return begun(session);
}

Vec2 rangeOf(const ExaggerateTargets& targets, const std::string& limb) {
  for (const int id : targets.trailIds) {
    const rig::Trail& trail = *findTrail(targets.document, id);
    if (trail.limb == limb) {
      return {trail.settings.startFrame, trail.settings.endFrame};
    }
  }
  return Vec2(-1.0);
}

} // namespace

TEST_CASE("Limbs that move as one are exaggerated over the range of the one that leads") {
  for (const bool punchFirst : {true, false}) {
    const ExaggerateTargets both =
        exaggeratedAt(0.0, punchFirst ? std::vector<std::string>{"left-arm", "left-leg"}
                                      : std::vector<std::string>{"left-leg", "left-arm"});
    REQUIRE(both.trailIds.size() == 2);
    CHECK(findTrail(both.document, both.trailIds.front())->limb == "left-arm");
    CHECK(rangeOf(both, "left-arm") == Vec2(21.0, 27.0));
    CHECK(rangeOf(both, "left-leg") == Vec2(21.0, 27.0)); // Alone to 29.
  }
}

TEST_CASE("Limbs that strike one after the other are exaggerated each over its own stroke") {
  const ExaggerateTargets both = exaggeratedAt(0.0, {"left-arm", "right-arm"});
  CHECK(rangeOf(both, "left-arm") == Vec2(21.0, 27.0));
  CHECK(rangeOf(both, "right-arm") == Vec2(40.0, 43.0));
  CHECK(findTrail(both.document, both.trailIds.front())->group != 0);
}

TEST_CASE("At the playhead all limbs are exaggerated there, also one that strikes elsewhere") {
  const ExaggerateTargets both = exaggeratedAt(24.0, {"left-arm", "spine"});
  CHECK(rangeOf(both, "left-arm") == Vec2(21.0, 27.0));
  CHECK(rangeOf(both, "spine") == Vec2(21.0, 27.0)); // Alone from 37 to 44.
}

TEST_CASE("A range that was set counts for all limbs") {
  Session session = dummy();
  selectLimb(session, "left-arm", false);
  selectLimb(session, "right-arm", true);
  setRangeByHand(session, {20.0, 45.0});
  const ExaggerateTargets both = begun(session);
  CHECK(rangeOf(both, "left-arm") == Vec2(20.0, 45.0));
  CHECK(rangeOf(both, "right-arm") == Vec2(20.0, 45.0));
}

TEST_CASE("A limb whose stroke has a trail already is exaggerated there beside another one") {
  Session session = dummy();
  selectLimb(session, "left-arm", false);
  const ExaggerateTargets punch = begun(session);
  session.commit();
  selectTrail(session, 0);
  selectLimb(session, "left-arm", false);
  selectLimb(session, "right-arm", true);
  const ExaggerateTargets both = begun(session);
  CHECK(session.document().trails.size() == 2);
  CHECK(std::ranges::count(both.trailIds, punch.trailIds.front()) == 1);
}

TEST_CASE("Another stroke of the limb that leads takes the others to what they do then") {
  Session session = dummy();
  session.view().frame = 42.0;
  selectLimb(session, "left-arm", false);
  selectLimb(session, "right-arm", true);
  const ExaggerateTargets cross = begun(session);
  REQUIRE(rangeOf(cross, "right-arm") == Vec2(40.0, 43.0));
  const Result<ExaggerateTargets> back = movedTo(session, cross, {45.0, 55.0});
  REQUIRE(back);
  CHECK(rangeOf(*back, "right-arm") == Vec2(45.0, 55.0));
  CHECK(rangeOf(*back, "left-arm") == Vec2(45.0, 50.0));
}

TEST_CASE("Of a group the ends of one range are changed, and other ranges stay") {
  Session session = dummy();
  for (const char* const limb : {"left-arm", "right-arm", "left-leg"}) {
    selectLimb(session, limb, true);
  }
  const ExaggerateTargets group = begun(session);
  session.commit();
  const auto idOf = [&](const std::string& limb) {
    return std::ranges::find_if(session.document().trails,
                                [&](const rig::Trail& trail) { return trail.limb == limb; })
        ->id;
  };
  REQUIRE(rangeOf(group, "left-leg") != rangeOf(group, "right-arm"));
  selectTrail(session, idOf("right-arm"));
  CHECK(targetTrails(session).size() == 3);
  CHECK(targetsOfRange(session) == std::vector<int>{idOf("right-arm")});
}

namespace {

/// The boxer's left arm to and fro, by another angle each time.
Document swingingArm() {
  Document document = test::boxer();
  std::vector<Clip> clips = *document.clips;
  clips.front().tracks.front().edit([](Track& track) {
    track.times.clear();
    track.values.clear();
    for (const double angle : {0.0, 1.4, 0.1, 1.3, -0.3}) {
      track.times.push_back(static_cast<float>(track.times.size()) / 3.0F);
      for (const double value : {0.0, -std::sin(0.5 * angle), 0.0, std::cos(0.5 * angle)}) {
        track.values.push_back(static_cast<float>(value));
      }
    }
  });
  clips.front().endSeconds = static_cast<double>(clips.front().tracks.front()->times.back());
  document.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  return document;
}

/// The limb selected, and the range set by hand where one is given.
Session armIn(const Document& document, const std::optional<Vec2>& range) {
  Session session(document);
  session.view().selection.editTrails().limbs = {"left-arm"};
  if (range) {
    setRangeByHand(session, *range);
  }
  return session;
}

Vec2 framesOf(const rig::Moment& stroke) {
  return {stroke.startFrame, stroke.endFrame};
}

} // namespace

TEST_CASE(
    "From each stroke the next and the one before are those beside it in time, but for those with a trail") {
  const auto beside = [](const Document& document, const rig::Moment& stroke, bool forwards) {
    const Session session = armIn(document, framesOf(stroke));
    const Result<ExaggerateTargets> made = exaggerateTargets(session);
    REQUIRE(made);
    return nextStroke(session, *made, forwards);
  };
  const Document document = swingingArm();
  const std::vector<rig::Moment> strokes = Session(document).momentsOf("left-arm");
  const std::size_t count = strokes.size();
  REQUIRE(count >= 3);
  for (std::size_t i = 0; i < count; ++i) {
    CAPTURE(i);
    CHECK(beside(document, strokes[i], true) == framesOf(strokes[(i + 1) % count]));
    CHECK(beside(document, strokes[i], false) == framesOf(strokes[(i + count - 1) % count]));
  }
  const Document taken =
      test::withNewTrail(document, {"left-arm", strokes[1].startFrame, strokes[1].endFrame});
  CHECK(beside(taken, strokes[0], true) == framesOf(strokes[2]));
  CHECK(beside(taken, strokes[2], false) == framesOf(strokes[0]));
}

TEST_CASE(
    "In a range that only touches a trail E makes another one, in one that shares time it goes on with it") {
  const auto trailsAfter = [](const Vec2& trail, const Vec2& range) {
    const Document document = test::withNewTrail(test::boxer(), {"left-arm", trail.x, trail.y});
    const Result<ExaggerateTargets> made = exaggerateTargets(armIn(document, range));
    REQUIRE(made);
    return made->document.trails.size();
  };
  CHECK(trailsAfter({0.0, 10.0}, {10.0, 20.0}) == 2);
  CHECK(trailsAfter({10.0, 20.0}, {0.0, 10.0}) == 2);
  CHECK(trailsAfter({0.0, 10.0}, {9.0, 20.0}) == 1);
  CHECK(trailsAfter({10.0, 20.0}, {0.0, 11.0}) == 1);
}

TEST_CASE("Without a range E goes on with a short trail at the playhead, at both of its ends as well") {
  for (const auto& [frame, trails] :
       {std::pair(9.0, 1U), std::pair(10.0, 1U), std::pair(11.0, 1U), std::pair(6.0, 2U)}) {
    CAPTURE(frame);
    Session session = armIn(test::withNewTrail(test::boxer(), {"left-arm", 9.0, 11.0}), std::nullopt);
    session.view().frame = frame;
    const Result<ExaggerateTargets> made = exaggerateTargets(session);
    REQUIRE(made);
    CHECK(made->document.trails.size() == trails);
  }
}

TEST_CASE("E doubles a path that was only looked at, and leaves a scale that was set as it is") {
  struct Scaled {
    bool wasExaggerated;
    double before;
    double after;
  };
  for (const Scaled& one :
       {Scaled{false, 1.0, firstScale}, Scaled{false, 1.5, 1.5}, Scaled{true, 1.0, 1.0}}) {
    CAPTURE(one.wasExaggerated, one.before);
    Document document = test::withNewTrail(test::boxer(), {});
    rig::Trail& trail = document.trails.front();
    trail.exaggerated = one.wasExaggerated;
    trail.connected = false;
    trail.settings.scale = one.before;
    const int id = trail.id;
    Session session(document);
    selectTrail(session, id);
    const Result<ExaggerateTargets> made = exaggerateTargets(session);
    REQUIRE(made);
    CHECK(findTrail(made->document, id)->settings.scale == one.after);
    CHECK(findTrail(made->document, id)->exaggerated);
    CHECK(findTrail(made->document, id)->connected);
  }
}

TEST_CASE("Where a trail has all of a range another one is refused there by the name of its limb") {
  const Document document = test::withNewTrail(test::boxer(), {"left-arm", 0.0, 20.0});
  CHECK(test::refusal(newTrails(armIn(document, Vec2(2.0, 8.0)), true)) ==
        "left arm: a trail is there already; select it, or set another range");
}

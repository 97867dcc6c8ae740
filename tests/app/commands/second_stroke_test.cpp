// Where E acts after an earlier E, on a limb that has a trail elsewhere, and on several limbs.
#include <catch2/catch.hpp>

#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "app/edits/trail/trail_edits.h"
#include "app/files/save.h"

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

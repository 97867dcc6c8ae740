// From moment to moment: what N selects, and what E makes of it.
#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

#include "app/commands/table/moments.h"
#include "app/commands/table/ranges.h"
#include "app/commands/table/selection.h"
#include "app/commands/trail/exaggerate.h"
#include "app/files/save.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Session bundled(const char* name) {
  Result<Document> opened = openDocument(std::string(STRETCH_SOURCE_DIR "/assets/") + name);
  REQUIRE(opened);
  return Session(std::move(opened).value());
}

using Limbs = std::vector<std::string>;

} // namespace

TEST_CASE("The moments that are shown are a fifth as strong as the strongest, in the order of their tips") {
  const Session session = bundled("dummy.glb");
  const std::vector<rig::Moment> shown = shownMoments(session);
  REQUIRE(shown.size() == 4); // Two punches and two ways back.
  CHECK(shown[0].limb == "left-arm");
  CHECK(shown[0].tipFrame == 27.0);
  CHECK(shown[2].limb == "right-arm");
  CHECK(shown[2].tipFrame == 43.0);
  CHECK(session.moments().size() > shown.size());
  CHECK(session.moments().front() == shown[2]);
}

TEST_CASE("The next moment sets limb, range and playhead, round and round, and back again") {
  Session session = bundled("dummy.glb");
  const auto go = [&](bool forwards) {
    goToMoment(session, *nextMoment(session, forwards));
    return session.view().selection.limbs().front() + ' ' +
           std::to_string(static_cast<int>(session.view().frame));
  };
  CHECK(go(true) == "left-arm 27");
  CHECK(Vec2(session.view().rangeStart, session.view().rangeEnd) == Vec2(21.0, 27.0));
  CHECK(currentMoment(session)->tipFrame == 27.0);
  CHECK(go(true) == "left-arm 33");
  CHECK(go(true) == "right-arm 43");
  CHECK(session.view().selection.limbs() == Limbs{"right-arm"});
  CHECK(go(false) == "left-arm 33");
  CHECK(go(false) == "left-arm 27");
  CHECK(go(false) == "right-arm 50");
  CHECK(go(true) == "left-arm 27");
  session.view().selection.editTrails().limbs = {"spine"};
  session.view().frame = 40.0;
  CHECK_FALSE(currentMoment(session));
  CHECK(go(true) == "right-arm 43");
  session.view().selection.editTrails().limbs = {"spine"};
  session.view().frame = 40.0;
  CHECK(go(false) == "left-arm 33");
}

TEST_CASE("A landing is one of all legs, and its path that of the hips") {
  Session session = bundled("dummy_leap.glb");
  const auto landing = std::ranges::find(session.moments(), rig::MomentKind::landing, &rig::Moment::kind);
  REQUIRE(landing != session.moments().end());
  goToMoment(session, *landing);
  CHECK(session.view().selection.limbs() == Limbs{"left-leg", "right-leg"});
  CHECK(session.view().rangeStart == landing->startFrame);
  CHECK(session.view().frame == landing->tipFrame);
  const std::vector<Vec3> path = pathOfMoment(session, *landing);
  CHECK(path.size() == static_cast<std::size_t>(2.0 * (landing->tipFrame - landing->startFrame)) + 1);
  CHECK(path.front().y - path.back().y > 0.25);
  CHECK(momentText(session.document(), *landing).starts_with("Body: landing from 63 to 68, strength "));
}

TEST_CASE("The path of a stroke is that of the limb's end, at half frames") {
  const Session session = bundled("dummy.glb");
  const rig::Moment jab = shownMoments(session).front();
  const std::vector<Vec3> path = pathOfMoment(session, jab);
  REQUIRE(path.size() == 13);
  CHECK(path.back().z - path.front().z > 0.5); // Forwards.
  CHECK(momentText(session.document(), jab) == "Left arm: stroke from 21 to 27, strength 10");
}

TEST_CASE("Where the limb has a trail at the moment, that is selected with it, and E goes on editing it") {
  Session session = bundled("dummy.glb");
  goToMoment(session, shownMoments(session).front());
  Result<ExaggerateTargets> made = exaggerateTargets(session);
  REQUIRE(made);
  session.begin("Exaggerate");
  session.preview(made->document);
  session.commit();
  selectTrail(session, 0);
  session.view().selection.editTrails().limbs = {};
  goToMoment(session, shownMoments(session).front());
  CHECK(session.view().selection.trail() == made->trailIds.front());
  const Result<ExaggerateTargets> again = exaggerateTargets(session);
  REQUIRE(again);
  CHECK(again->document.trails.size() == 1);
}

TEST_CASE(
    "E without a range goes on with a trail that has most of the proposed stroke, not with one beside it") {
  for (const double end : {26.0, 23.0}) {
    Session session = bundled("dummy.glb");
    selectLimb(session, "left-arm", false);
    setRangeByHand(session, {end - 6.0, end});
    Result<ExaggerateTargets> made = exaggerateTargets(session);
    REQUIRE(made);
    session.begin("Exaggerate");
    session.preview(made->document);
    session.commit();
    session.view().selection.dropTrail();
    session.view().rangeStart = 0.0;
    session.view().rangeEnd = -1.0;
    const Result<ExaggerateTargets> again = exaggerateTargets(session);
    REQUIRE(again);
    CHECK(again->document.trails.size() == (end == 26.0 ? 1 : 2));
  }
}

TEST_CASE("Moments are found again when the clip changes, and are those before while something is dragged") {
  Session session = bundled("dummy.glb");
  const std::size_t punch = session.moments().size();
  session.view().clip = 1;
  CHECK(session.moments().size() != punch);
  session.view().clip = 0;
  CHECK(session.moments().size() == punch);
  session.begin("Drag");
  session.view().clip = 1;
  CHECK(session.moments().size() == punch);
  session.cancel();
  CHECK(session.moments().size() != punch);
}

TEST_CASE("A clip that idles shows no moment") {
  Session session = bundled("dummy.glb");
  session.view().clip = 7;
  CHECK(shownMoments(session).empty());
  CHECK_FALSE(nextMoment(session, true));
}

TEST_CASE("From beside a tip the next moment and the one before are others than the one of that tip") {
  Session session = bundled("dummy.glb"); // with tips at 27, 33, 43 and 50
  const auto tipFrom = [&](double frame, bool forwards) {
    session.view().frame = frame;
    return nextMoment(session, forwards)->tipFrame;
  };
  CHECK(tipFrom(26.4, true) == 27.0);
  CHECK(tipFrom(26.8, true) == 33.0);
  CHECK(tipFrom(27.6, false) == 27.0);
  CHECK(tipFrom(27.2, false) == 50.0);
}

TEST_CASE("A moment is the current one while its limb and both ends of its range are as it has them") {
  Session session = bundled("dummy.glb");
  const auto isCurrent = [&](double start, double end) {
    goToMoment(session, shownMoments(session).front()); // 21 to 27
    session.view().rangeStart += start;
    session.view().rangeEnd += end;
    return currentMoment(session).has_value();
  };
  CHECK(isCurrent(0.0, 0.0));
  CHECK_FALSE(isCurrent(1.0, 0.0));
  CHECK_FALSE(isCurrent(0.0, 1.0));
}

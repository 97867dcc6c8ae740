// Which frames the next trail takes.
#include "app/commands/table/ranges.h"

#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/files/save.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::app;
using stretch::test::Row;

namespace {

Session withLimbs(Document document, const std::vector<std::string>& limbs) {
  Session session(std::move(document));
  session.view().selection.editTrails().limbs = limbs;
  return session;
}

Session bundledBoxer() {
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  return Session(std::move(opened).value());
}

rig::Trail trailOver(const std::string& limb, double start, double end, int id = 1, int clip = 0) {
  rig::Trail trail;
  trail.id = id;
  trail.limb = limb;
  trail.clip = clip;
  trail.settings.startFrame = start;
  trail.settings.endFrame = end;
  return trail;
}

void setRange(Session& session, double start, double end) {
  session.view().rangeStart = start;
  session.view().rangeEnd = end;
}

const rig::Limb& limbOf(const Session& session, const std::string& id) {
  return *findLimb(session.document(), id);
}

Vec2 rangeOf(const rig::Moment& moment) {
  return {moment.startFrame, moment.endFrame};
}

/// The free stretches of whole frames, step by step.
std::vector<Vec2> freeStretches(const std::vector<rig::Trail>& trails, int first, int last) {
  std::vector<Vec2> free;
  for (int frame = first; frame < last; ++frame) {
    const bool taken = std::ranges::any_of(trails, [&](const rig::Trail& trail) {
      return trail.limb == "left-arm" && trail.clip == 0 && trail.settings.startFrame < frame + 1 &&
             frame < trail.settings.endFrame;
    });
    if (!taken && !free.empty() && free.back().y == frame) {
      free.back().y = frame + 1;
    } else if (!taken) {
      free.emplace_back(frame, frame + 1);
    }
  }
  return free;
}

/// The stretch that holds the frame, else the longest, the first of several.
std::optional<Vec2> bestOf(const std::vector<Vec2>& stretches, double frame) {
  std::optional<Vec2> best;
  for (const Vec2& stretch : stretches) {
    if (stretch.x <= frame && frame <= stretch.y) {
      return stretch;
    }
    best = !best || stretch.y - stretch.x > best->y - best->x ? stretch : *best;
  }
  return best;
}

} // namespace

TEST_CASE("What is free of a range is the part with the playhead in it, else the longest") {
  Row row(47);
  int none = 0;
  for (int round = 0; round < 500; ++round) {
    Document document = test::boxer();
    int at = static_cast<int>(row.below(4));
    for (int id = 1; id < 5; ++id) {
      const int end = at + 1 + static_cast<int>(row.below(6));
      document.trails.push_back(trailOver("left-arm", at, end, id));
      document.trails.push_back(trailOver("right-arm", row.below(9), 20.0, id + 10));
      document.trails.push_back(trailOver("left-arm", row.below(9), 20.0, id + 20, 1));
      at = end + static_cast<int>(row.below(4));
    }
    const int first = static_cast<int>(row.below(12));
    const int last = first + 1 + static_cast<int>(row.below(12));
    const double frame = row.below(21);
    const std::optional<Vec2> told = bestOf(freeStretches(document.trails, first, last), frame);
    const std::optional<Vec2> free = freeRange(document, "left-arm", 0, Vec2(first, last), frame);
    CAPTURE(round, first, last, frame);
    CHECK(free == told);
    none += free ? 0 : 1;
  }
  CHECK(none > 5);
}

TEST_CASE("Less than a frame between two trails is no room") {
  Document document = test::boxer();
  document.trails = {trailOver("left-arm", 0.0, 4.0), trailOver("left-arm", 4.9, 20.0, 2)};
  CHECK_FALSE(freeRange(document, "left-arm", 0, Vec2(0.0, 20.0), 4.5));
  document.trails[1].settings.startFrame = 5.0;
  CHECK(freeRange(document, "left-arm", 0, Vec2(0.0, 20.0), 4.5) == Vec2(4.0, 5.0));
}

TEST_CASE("A range clashes with a trail that shares a part of it, of any limb that is selected") {
  Document document = test::boxer();
  document.trails = {trailOver("left-arm", 4.0, 10.0)};
  const auto clashOf = [&](const std::vector<std::string>& limbs, double start, double end) {
    Session session = withLimbs(document, limbs);
    setRange(session, start, end);
    session.view().frame = 12.0;
    return rangeClash(session);
  };
  CHECK_FALSE(clashOf({"left-arm"}, 10.0, 20.0));
  CHECK_FALSE(clashOf({"left-arm"}, 0.0, 4.0));
  CHECK_FALSE(clashOf({"left-arm"}, 4.0, 10.0));
  CHECK_FALSE(clashOf({"left-arm"}, 4.4, 9.6));
  CHECK(clashOf({"left-arm"}, 4.5, 10.0));
  CHECK(clashOf({"left-arm"}, 3.5, 10.0));
  CHECK(clashOf({"left-arm"}, 4.0, 10.5));
  CHECK(clashOf({"left-arm"}, 4.0, 9.5));
  CHECK_FALSE(clashOf({"right-arm"}, 6.0, 20.0));
  CHECK_FALSE(clashOf({}, 6.0, 20.0));
  CHECK_FALSE(clashOf({"left-arm"}, 0.0, -1.0));
  for (const std::vector<std::string>& limbs :
       {std::vector<std::string>{"left-arm"}, {"right-arm", "left-arm"}, {"left-arm", "right-arm"}}) {
    const std::optional<RangeClash> clash = clashOf(limbs, 6.0, 20.0);
    REQUIRE(clash);
    CHECK(clash->limb == "left-arm");
    CHECK(clash->present == Vec2(4.0, 10.0));
    CHECK(clash->wanted == Vec2(6.0, 20.0));
    CHECK(clash->beside == Vec2(10.0, 20.0));
  }
}

TEST_CASE("A selected trail leaves no doubt about a range, and one of another clip has no part in it") {
  Document document = test::boxer();
  document.trails = {trailOver("left-arm", 4.0, 10.0)};
  Session session = withLimbs(document, {"left-arm"});
  setRange(session, 6.0, 20.0);
  REQUIRE(rangeClash(session));
  session.view().selection.editTrails().trail = 1;
  CHECK_FALSE(rangeClash(session));
  document.trails[0].clip = 1;
  Session other = withLimbs(document, {"left-arm"});
  setRange(other, 6.0, 20.0);
  CHECK_FALSE(rangeClash(other));
}

TEST_CASE("A limb that stands still is given half a second about the playhead, within the clip") {
  Session session = withLimbs(test::boxer(), {"spine"});
  for (const auto& [frame, range] : {std::pair{0.0, Vec2(0.0, 8.0)},
                                     {3.0, Vec2(0.0, 11.0)},
                                     {8.0, Vec2(0.0, 16.0)},
                                     {10.4, Vec2(2.0, 18.0)},
                                     {10.6, Vec2(3.0, 19.0)},
                                     {13.0, Vec2(5.0, 20.0)},
                                     {20.0, Vec2(12.0, 20.0)}}) {
    session.view().frame = frame;
    CAPTURE(frame);
    CHECK(proposedRange(session, limbOf(session, "spine")) == range);
    CHECK(workingRange(session, limbOf(session, "spine")) == range);
    CHECK(shownRange(session) == range);
  }
}

TEST_CASE("The range that is shown is the one that is set, cut to the clip, else the limb's, else the clip") {
  Session session = withLimbs(test::boxer(), {"spine", "left-arm"});
  session.view().frame = 10.0;
  for (const auto& [set, shown] : {std::pair{Vec2(3.0, 7.0), Vec2(3.0, 7.0)},
                                   {Vec2(5.0, 5.0), Vec2(5.0, 5.0)},
                                   {Vec2(-4.0, 50.0), Vec2(0.0, 20.0)},
                                   {Vec2(30.0, 50.0), Vec2(20.0, 20.0)},
                                   {Vec2(-9.0, -4.0), Vec2(0.0, 0.0)},
                                   {Vec2(0.0, -1.0), Vec2(2.0, 18.0)}}) {
    setRange(session, set.x, set.y);
    CAPTURE(set.x, set.y);
    CHECK(isRangeSet(session.view()) == (set.y >= set.x));
    CHECK(shownRange(session) == shown);
    CHECK(workingRange(session, limbOf(session, "spine")) == shown);
  }
  session.view().selection.editTrails().limbs.clear();
  CHECK(shownRange(session) == Vec2(0.0, 20.0));
}

TEST_CASE("A range that is set by hand drops the selected trail unless that lies in it") {
  for (const auto& [range, keeps] : {std::pair{Vec2(4.0, 10.0), true},
                                     {Vec2(0.0, 20.0), true},
                                     {Vec2(4.5, 20.0), false},
                                     {Vec2(0.0, 9.5), false}}) {
    Document document = test::boxer();
    document.trails = {trailOver("left-arm", 4.0, 10.0)};
    Session session = withLimbs(document, {"left-arm"});
    session.view().selection.editTrails().trail = 1;
    setRangeByHand(session, range);
    CAPTURE(range.x, range.y);
    CHECK((session.view().selection.trail() == 1) == keeps);
    CHECK(Vec2(session.view().rangeStart, session.view().rangeEnd) == range);
    CHECK(session.view().selection.limbs() == std::vector<std::string>{"left-arm"});
  }
}

TEST_CASE("The proposed moment is the strongest at the clip's start and the nearest one elsewhere") {
  Session session = bundledBoxer();
  const auto tip = [&](double frame) {
    session.view().frame = frame;
    return proposedMoment(session, "left-arm")->tipFrame;
  };
  std::vector<rig::Moment> own = session.momentsOf("left-arm");
  const auto strongest = std::ranges::max_element(own, {}, &rig::Moment::strength);
  CHECK(tip(0.0) == strongest->tipFrame);
  CHECK(tip(0.49) == strongest->tipFrame);
  for (const rig::Moment& moment : own) {
    const double inside = 0.5 * (moment.startFrame + moment.endFrame);
    CHECK(tip(inside) == moment.tipFrame);
  }
  CHECK_FALSE(proposedMoment(session, "no limb"));
}

TEST_CASE("A limb beside a leading one keeps its own stroke unless the two are one movement") {
  Session session = bundledBoxer();
  const rig::Limb& right = limbOf(session, "right-arm");
  const std::vector<rig::Moment> moments = session.momentsOf("right-arm");
  const Vec2 own = rangeOf(*std::ranges::max_element(moments, {}, &rig::Moment::strength));
  const double length = own.y - own.x;
  for (const double shift : {-0.6, -0.35, -0.2, 0.0, 0.2, 0.35}) {
    const Vec2 leading = own + Vec2(shift * length);
    // They share 1 - shift of the length, of 1 + shift that either takes.
    const bool isOne = (1.0 - std::abs(shift)) / (1.0 + std::abs(shift)) >= 0.55;
    session.view().frame = 0.0;
    CAPTURE(shift);
    CHECK(rangeBeside(session, right, leading) == (isOne ? leading : own));
    session.view().frame = 0.5 * (own.x + own.y);
    CHECK(rangeBeside(session, right, leading) == (isOne ? leading : own));
  }
  const Vec2 elsewhere(own.x - length - 4.0, own.x - 4.0);
  session.view().frame = 0.0;
  CHECK(rangeBeside(session, right, elsewhere) != elsewhere);
  session.view().frame = 0.5 * (own.x + own.y);
  CHECK(rangeBeside(session, right, elsewhere) == elsewhere);
}

TEST_CASE("Beside another stroke a limb takes the one that it makes meanwhile, and none from elsewhere") {
  const Session session = bundledBoxer();
  const rig::Limb& left = limbOf(session, "left-arm");
  for (const rig::Moment& moment : session.momentsOf("left-arm")) {
    const Vec2 own = rangeOf(moment);
    const Vec2 longer(own.x - (own.y - own.x), own.y + (own.y - own.x));
    CHECK(rangeBesideStroke(session, left, longer) == own);
    CHECK(rangeBesideStroke(session, left, own + Vec2(0.1)) == own + Vec2(0.1));
  }
  CHECK(rangeBesideStroke(session, limbOf(session, "right-arm"), Vec2(1.0, 3.0)) == Vec2(1.0, 3.0));
  const Session still = withLimbs(test::boxer(), {});
  CHECK(rangeBesideStroke(still, limbOf(still, "spine"), Vec2(4.0, 9.0)) == Vec2(4.0, 9.0));
  CHECK(rangeBeside(still, limbOf(still, "spine"), Vec2(4.0, 9.0)) == Vec2(4.0, 9.0));
}

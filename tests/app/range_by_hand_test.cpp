// The working range that was set by hand, while the ranges of selected trails take its place.
#include <optional>
#include <utility>

#include <catch2/catch.hpp>

#include "app/commands/table/selection.h"
#include "app/edits/trail/trail_edits.h"
#include "app/session.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document withTrails() {
  Document document = test::boxer();
  for (const auto& [start, end] : {std::pair(0.0, 10.0), std::pair(12.0, 18.0)}) {
    NewTrail trail;
    trail.limb = "left-arm";
    trail.settings.startFrame = start;
    trail.settings.endFrame = end;
    const Result<CreatedTrail> created = createTrail(document, trail);
    REQUIRE(created);
    document = created->document;
  }
  return document;
}

struct Work {
  Session session{withTrails()};

  void setRange(const Vec2& range) {
    session.view().rangeStart = range.x;
    session.view().rangeEnd = range.y;
  }
  [[nodiscard]] Vec2 range() { return {session.view().rangeStart, session.view().rangeEnd}; }
  void select(std::size_t trail) { selectTrail(session, session.document().trails[trail].id); }
  void selectNone() {
    session.view().selection.dropTrail();
    session.followSelection();
  }
};

const Vec2 byHand(3.0, 7.0);
const Vec2 none(0.0, -1.0); // As a session begins.

} // namespace

TEST_CASE(
    "A range that was set by hand stays what it is while trails are selected, and comes back after them") {
  Work work;
  CHECK_FALSE(work.session.rangeByHand());
  work.setRange(byHand);
  CHECK(work.session.rangeByHand() == byHand);
  work.select(0);
  CHECK(work.range() == Vec2(0.0, 10.0));
  CHECK(work.session.rangeByHand() == byHand);
  work.select(1);
  CHECK(work.range() == Vec2(12.0, 18.0));
  CHECK(work.session.rangeByHand() == byHand);
  work.selectNone();
  CHECK(work.range() == byHand);
  CHECK(work.session.rangeByHand() == byHand);
}

TEST_CASE("Where no range was set by hand none comes back after a trail") {
  Work work;
  work.select(0);
  CHECK(work.range() == Vec2(0.0, 10.0));
  CHECK_FALSE(work.session.rangeByHand());
  work.selectNone();
  CHECK(work.range() == none);
  CHECK_FALSE(work.session.rangeByHand());
}

TEST_CASE("A range that is set while a trail is selected is one by hand, and stays without it") {
  Work work;
  const bool hadOne = GENERATE(false, true);
  if (hadOne) {
    work.setRange(Vec2(1.0, 2.0));
  }
  work.select(0);
  work.setRange(byHand);
  CHECK(work.session.rangeByHand() == byHand);
  work.session.followSelection(); // The same trail does not take it again.
  CHECK(work.range() == byHand);
  work.select(1);
  CHECK(work.session.rangeByHand() == byHand);
  work.selectNone();
  CHECK(work.range() == byHand);
}

TEST_CASE("A range of one frame is one, at either end of a trail's as well") {
  Work work;
  work.setRange(Vec2(4.0, 4.0));
  CHECK(work.session.rangeByHand() == Vec2(4.0, 4.0));
  work.select(0);
  for (const Vec2& range : {Vec2(0.0, 9.0), Vec2(1.0, 10.0)}) {
    work.setRange(range);
    CHECK(work.session.rangeByHand() == range);
  }
}

TEST_CASE("The working range goes along with the selected trail's, whichever of its ends is moved") {
  const Vec2 moved = GENERATE(Vec2(0.0, 8.0), Vec2(2.0, 10.0));
  Work work;
  work.setRange(byHand);
  work.select(0);
  rig::TrailSettings settings = work.session.document().trails[0].settings;
  settings.startFrame = moved.x;
  settings.endFrame = moved.y;
  const Result<Document> changed =
      setTrailSettings(work.session.document(), work.session.document().trails[0].id, settings);
  REQUIRE(changed);
  REQUIRE(work.session.edit(*changed, "Change the range"));
  work.session.followSelection();
  CHECK(work.range() == moved);
  CHECK(work.session.rangeByHand() == byHand);
  REQUIRE(work.session.undo());
  work.session.followSelection();
  CHECK(work.range() == Vec2(0.0, 10.0));
  CHECK(work.session.rangeByHand() == byHand);
}

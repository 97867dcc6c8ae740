#include <catch2/catch.hpp>

#include "app/commands/table/ranges.h"
#include "app/edits/keys/rate_edits.h"
#include "app/files/save.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Vec2 strokeOf(const Document& document, const char* limb, double frame) {
  const std::vector<rig::Moment> strokes = Session(document).momentsOf(limb);
  const rig::Moment* const stroke = rig::momentAt(strokes, frame);
  REQUIRE(stroke != nullptr);
  return {stroke->startFrame, stroke->endFrame};
}

} // namespace

TEST_CASE("The stroke of a punch goes from where the arm is wound up to where it is out") {
  const Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  CHECK(strokeOf(*opened, "left-arm", 24.0) == Vec2(21.0, 27.0));
  CHECK(strokeOf(*opened, "right-arm", 41.0).x == 40.0);
  CHECK(strokeOf(*opened, "right-arm", 41.0).y == 43.0);
  // Back again is another stroke.
  CHECK(strokeOf(*opened, "left-arm", 31.0).x >= 27.0);
}

TEST_CASE("At the clip's start, where nobody looked for a stroke yet, the strongest one is proposed") {
  Result<Document> opened = openDocument(STRETCH_SOURCE_DIR "/assets/dummy.glb");
  REQUIRE(opened);
  const rig::Limb arm = *findLimb(*opened, "left-arm");
  Session session(std::move(opened).value());
  CHECK(proposedRange(session, arm) == Vec2(21.0, 27.0));
  session.view().frame = 31.0;
  CHECK(proposedRange(session, arm).x >= 27.0);
}

TEST_CASE("Between strokes the strongest near the playhead counts, not the nearest") {
  const std::vector<rig::Moment> strokes{{"left-arm", rig::MomentKind::stroke, 0.0, 4.0, 4.0, 0.3},
                                         {"left-arm", rig::MomentKind::stroke, 8.0, 12.0, 12.0, 6.0}};
  CHECK(rig::momentAt(strokes, 5.0)->startFrame == 0.0);
  CHECK(rig::momentAt(strokes, 5.0, 4.0)->startFrame == 8.0);
  CHECK(rig::momentAt(strokes, 3.0, 4.0)->startFrame == 0.0);
  CHECK(rig::strongestMoment(strokes)->startFrame == 8.0);
  CHECK(rig::momentAt({}, 3.0) == nullptr);
  CHECK(rig::strongestMoment({}) == nullptr);
}

TEST_CASE("A limb that only sways has no stroke, and half a second about the playhead is proposed") {
  Document document = test::boxer();
  Clip clip = document.clips->front();
  clip.tracks.front().edit([](Track& track) { // The arm only sways.
    for (std::size_t i = 0; i < track.values.size(); ++i) {
      track.values[i] = i % 4 == 3 ? 1.0F : 0.02F * track.values[i];
    }
  });
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
  Session session(document);
  const rig::Limb arm = *findLimb(document, "left-arm");
  REQUIRE(session.momentsOf("left-arm").empty());
  session.view().frame = 10.0;
  CHECK(proposedRange(session, arm) == Vec2(2.0, 18.0));
}

TEST_CASE("A stroke is the same at any frame rate, and a limb that rests makes none") {
  Document document = test::boxer();
  const Vec2 at30 = strokeOf(document, "left-arm", 8.0);
  CHECK(at30 == Vec2(0.0, 10.0));
  setFramesPerSecond(document, 120.0);
  const Vec2 at120 = strokeOf(document, "left-arm", 32.0);
  CHECK(at120.x == Approx(4.0 * at30.x).margin(2.0));
  CHECK(at120.y == Approx(4.0 * at30.y).margin(2.0));
  CHECK(Session(document).momentsOf("right-arm").empty());
}

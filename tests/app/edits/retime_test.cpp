#include <functional>
#include <limits>

#include <catch2/catch.hpp>

#include "app/edits/keys/key_edits.h"
#include "app/edits/keys/rate_edits.h"
#include "app/edits/keys/retime.h"
#include "app/edits/keys/track_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/hold_edits.h"
#include "app/edits/pose/offset_edits.h"
#include "app/edits/trail/trail_edits.h"
#include "app/edits/trail/weight_edits.h"
#include "app/files/saved_work.h"
#include "app/things/place.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/random_edits.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

Document placed(const Document& document, const Things& things, Entry entry = Entry::request) {
  const Result<Placed> made = place(document, things, entry);
  if (!made) {
    FAIL(made.error().line());
  }
  return made->document;
}

rig::Trail trailOver(double first, double last) {
  rig::Trail trail;
  trail.limb = "left-arm";
  trail.settings.startFrame = first;
  trail.settings.endFrame = last;
  return trail;
}

rig::Adjustment handOver(double first, double last) {
  rig::Adjustment hand;
  hand.controller = "left-hand";
  hand.rangeFrames = Vec2(first, last);
  for (const double frame : {first + 1.0, last}) {
    rig::OffsetKey key;
    key.frame = frame;
    key.move = {0.01, 0.0, 0.0};
    hand.keys.push_back(key);
  }
  return hand;
}

rig::Pin pinOver(double first, double last) {
  rig::Pin pin;
  pin.limb = "right-arm";
  pin.time.rangeFrames = {first, last};
  pin.atFrame = first;
  return pin;
}

rig::Grip gripOver(double first, double last) {
  rig::Grip grip;
  grip.follower = "left-arm";
  grip.leader = "right-arm";
  grip.time.rangeFrames = {first, last};
  grip.relationFrame = first;
  return grip;
}

/// Two of each kind, one after the other, with nothing in between.
Document twoOfEach() {
  Things things;
  things.trails = {trailOver(2.0, 8.0), trailOver(9.0, 18.0)};
  things.adjustments = {handOver(2.0, 8.0), handOver(9.0, 18.0)};
  things.holds.pins = {pinOver(2.0, 8.0), pinOver(9.0, 18.0)};
  things.holds.grips = {gripOver(2.0, 8.0), gripOver(9.0, 18.0)};
  things.weights = {{"right-arm", 0, true, {}}};
  things.weights[0].settings.rangeFrames = Vec2(2.0, 12.0);
  return placed(test::boxer(), things);
}

std::size_t countOf(const Document& document) {
  std::size_t count = 0;
  eachList(document, [&](const auto& list) { count += list.size(); });
  return count;
}

std::size_t meetingsIn(const Document& document) {
  std::size_t meetings = 0;
  eachList(document, [&](const auto& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        meetings += meets(list[i], list[k]) ? 1 : 0;
      }
    }
  });
  return meetings;
}

// As a file keeps it.
Document reopened(const Document& document) {
  Document opened = document;
  const gltf::Json work = workOf(document);
  if (!work.is_null()) {
    const Status restored = restoreWork(work, opened);
    INFO((restored ? "" : restored.error().line()));
    REQUIRE(restored);
  }
  return opened;
}

bool sameThings(const Document& a, const Document& b) {
  return a.trails == b.trails && a.adjustments == b.adjustments && a.holds == b.holds &&
         a.weights == b.weights;
}

Document cutTo(double lastFrame, Document document) {
  for (const KeyRow& row : keyedRows(document, 0)) {
    const KeySelection late =
        row.isOffset() ? KeySelection{} : keysBetween(document, 0, {&row, 1}, lastFrame + 0.5, 1e6);
    if (!late.empty()) {
      const Result<EditedKeys> without = removeKeys(document, 0, late);
      REQUIRE(without);
      document = without->document;
    }
  }
  const Clip& clip = clipOf(document, 0);
  REQUIRE(clip.endSeconds * clip.framesPerSecond < lastFrame + 0.5);
  return document;
}

} // namespace

TEST_CASE("What a slower range comes to cover gives way where the rest stays, and nothing overlaps") {
  const Document start = twoOfEach();
  const Result<Document> made = retimed(start, 0, {2.0, 8.5, 10.0, false, {}});
  REQUIRE(made);
  CHECK(meetingsIn(*made) == 0);
  CHECK(countOf(*made) == countOf(start));
  CHECK(made->trails[0].settings.endFrame == Approx(2.0 + 6.0 * 10.0 / 6.5));
  CHECK(made->trails[1].settings.startFrame == made->trails[0].settings.endFrame);
  CHECK(made->trails[1].settings.endFrame == 18.0);
  CHECK(made->adjustments[1].rangeFrames->x == made->adjustments[0].rangeFrames->y);
  CHECK(made->adjustments[1].keys.back().frame == 18.0);
  CHECK(made->holds.pins[1].time.rangeFrames == Vec2(12.0, 18.0));
  CHECK(made->holds.grips[1].time.rangeFrames == Vec2(12.0, 18.0));
  CHECK(sameThings(reopened(*made), *made));
  CHECK(setTrailSettings(*made, made->trails[1].id, made->trails[1].settings));
  CHECK(changeHold(*made, {rig::HoldKind::pin, 1}, {{made->holds.pins[1]}, {}, {}}));
}

TEST_CASE("What stays and is not met by anything that a slower range brings is left as it is") {
  Things things;
  things.trails = {trailOver(9.0, 18.0)};
  things.adjustments = {handOver(9.0, 18.0)};
  things.holds.pins = {pinOver(9.0, 18.0)};
  const Document start = placed(test::boxer(), things);
  const Result<Document> made = retimed(start, 0, {2.0, 8.0, 12.0, false, {}});
  REQUIRE(made);
  CHECK(sameThings(*made, start));
}

TEST_CASE("Of what a slower range covers whole nothing is left where the rest stays") {
  Things things;
  things.trails = {trailOver(2.0, 8.0), trailOver(9.0, 11.0)};
  things.holds.pins = {pinOver(2.0, 8.0), pinOver(9.0, 11.0)};
  const Result<Document> made = retimed(placed(test::boxer(), things), 0, {2.0, 8.0, 12.0, false, {}});
  REQUIRE(made);
  REQUIRE(made->trails.size() == 1);
  REQUIRE(made->holds.pins.size() == 1);
  CHECK(made->trails[0].settings.endFrame == 14.0);
  CHECK(made->holds.pins[0].time.rangeFrames.y == 14.0);
}

TEST_CASE(
    "Keys that a slower range comes to cover give way, and a joint that only moves there is held as before") {
  const auto climbing = [](const std::vector<double>& frames) {
    Document document = test::boxer();
    Track track;
    track.node = document.body.hips;
    track.channel = Channel::translation;
    for (const double frame : frames) {
      track.times.push_back(static_cast<float>(frame / clipOf(document, 0).framesPerSecond));
      track.values.insert(track.values.end(), {0.0F, static_cast<float>(frame), 0.0F});
    }
    return setTracks(document, 0, {track});
  };
  const auto keysAfter = [](const Document& document) {
    const Result<Document> made = retimed(document, 0, {2.0, 8.0, 12.0, false, {}});
    INFO(test::refusal(made));
    REQUIRE(made);
    std::vector<std::pair<double, double>> keys;
    for (const RowKey& key : readRow(*made, 0, {document.body.hips, Channel::translation, {}}).keys) {
      keys.emplace_back(std::round(100.0 * key.frame) / 100.0, std::round(100.0 * key.values[1]) / 100.0);
    }
    return keys;
  };
  using Keys = std::vector<std::pair<double, double>>;
  CHECK(keysAfter(climbing({0, 5, 9, 12, 18})) == Keys{{0, 0}, {2, 2}, {8, 5}, {14, 8}, {18, 18}});
  CHECK(keysAfter(climbing({0, 5, 8, 14, 18})) == Keys{{0, 0}, {2, 2}, {8, 5}, {14, 8}, {18, 18}});
  CHECK(keysAfter(climbing({9, 12, 18})) == Keys{{14, 9}, {18, 18}});
  CHECK(keysAfter(climbing({9, 12, 14})) == Keys{{14, 9}});
  CHECK(keysAfter(climbing({12})) == Keys{{14, 12}});
  CHECK(keysAfter(climbing({15, 18})) == Keys{{15, 15}, {18, 18}});
}

TEST_CASE("A trail across the end of a slower range keeps its spheres in order and a release of no less than "
          "nothing") {
  rig::Trail trail = trailOver(2.0, 18.0);
  trail.settings.spheres = {
      {6.0, Vec3(0.1), {}}, {10.0, Vec3(0.1), {}}, {11.0, Vec3(0.1), {}}, {16.0, Vec3(0.1), {}}};
  Things things;
  things.trails = {trail, trailOver(18.0, 19.0)};
  things.trails[1].limb = "right-arm";
  rig::Trail early = trailOver(2.0, 8.0);
  early.limb = "spine";
  early.settings.releaseFrames = 3.0;
  things.trails.push_back(early);
  const Result<Document> made = retimed(placed(test::boxer(), things), 0, {2.0, 10.0, 12.0, false, {}});
  REQUIRE(made);
  std::vector<double> frames;
  for (const rig::SphereOffset& sphere : made->trails[0].settings.spheres) {
    frames.push_back(sphere.frame);
  }
  CHECK(frames == std::vector<double>{8.0, 14.0, 16.0});
  CHECK(*made->trails[2].settings.releaseFrames == Approx(2.0 * 1.5 + 1.0));
}

TEST_CASE("After a clip became shorter its controllers, pins and grips are edited as before") {
  Things things;
  rig::Adjustment hand = handOver(2.0, 16.0);
  hand.rangeFrames.reset();
  rig::Adjustment stretch;
  stretch.controller = "left-arm.stretch";
  stretch.keys = {hand.keys.back()};
  stretch.keys[0].move = Vec3(0.0);
  stretch.keys[0].value = 0.5;
  things.adjustments = {hand, stretch};
  things.holds.pins = {pinOver(12.0, 18.0)};
  things.holds.grips = {gripOver(12.0, 18.0)};
  const Document cut = cutTo(10.0, placed(test::boxer(), things));
  const std::vector<ControllerOffset> offsets{{"left-hand", {0.0, 0.02, 0.0}, {}}};
  const std::vector<AttributeValue> values{{"left-arm.stretch", 0.25}};
  for (const double frame : {0.0, 5.0, 10.0}) {
    const Result<Document> posed = setOffsets(cut, 0, frame, offsets, values, {});
    INFO((posed ? "" : posed.error().line()));
    REQUIRE(posed);
    CHECK(posed->adjustments[0].keys.back() == hand.keys.back());
  }
  rig::Pin pin = cut.holds.pins[0];
  pin.stretch = 0.5;
  CHECK(changeHold(cut, {rig::HoldKind::pin, 0}, {{pin}, {}, {}}));
  pin.time.rangeFrames.x = 4.0;
  CHECK(changeHold(cut, {rig::HoldKind::pin, 0}, {{pin}, {}, {}}));
  rig::Grip grip = cut.holds.grips[0];
  grip.stretch = 0.5;
  CHECK(changeHold(cut, {rig::HoldKind::grip, 0}, {{}, {grip}, {}}));
  const KeyRow row{{}, Channel::translation, "left-hand"};
  const KeySelection first = keysBetween(cut, 0, {&row, 1}, 0.0, 4.0);
  CHECK(moveKeys(cut, 0, first, {1.0, 0.0}));
  SECTION("what is new still has to lie in the clip") {
    CHECK_THAT(test::refusal(setOffsets(cut, 0, 14.0, offsets, values, {})),
               Catch::Contains("the key at frame 14 lies outside of"));
    pin.time.rangeFrames.y = 30.0;
    CHECK_THAT(test::refusal(changeHold(cut, {rig::HoldKind::pin, 0}, {{pin}, {}, {}})),
               Catch::Contains("its range 4 to 30"));
  }
}

TEST_CASE("Of two things that meet in a file the first stays, and the other is left out with a word") {
  gltf::Json work = workOf(twoOfEach());
  for (const char* const list : {"trails", "adjustments", "pins", "grips"}) {
    work[list][1]["range"] = work[list][0]["range"];
  }
  work["adjustments"][1]["keys"] = work["adjustments"][0]["keys"];
  Document opened = test::boxer();
  REQUIRE(restoreWork(work, opened));
  CHECK(opened.trails.size() == 1);
  CHECK(opened.adjustments.size() == 1);
  CHECK(opened.holds.pins.size() == 1);
  CHECK(opened.holds.grips.size() == 1);
  CHECK(opened.warnings.size() == 4);
}

TEST_CASE(
    "Nothing in time meets or is lost over random edits, retimings and rates, and saving keeps it all") {
  std::size_t kept = 0;
  for (const unsigned seed : {11U, 12U, 13U, 14U}) {
    test::Dice dice(seed);
    Document document = placed(twoOfEach(), {});
    for (int i = 0; i < 150; ++i) {
      document = test::randomEdit(document, dice);
      const double from = dice.below(15);
      const double frames = 1.0 + dice.below(6);
      if (dice.below(3) == 0) {
        const Document before = document;
        const Result<Document> made =
            retimed(document, 0, {from, from + frames, 1.0 + dice.below(9), dice.below(2) == 0, {}});
        document = made ? *made : document;
        const bool shorter = countOf(document) < countOf(before);
        CHECK((!shorter || made));
      }
      CAPTURE(seed, i);
      REQUIRE(meetingsIn(document) == 0);
      REQUIRE(checkThings(document, 0));
      REQUIRE(sameThings(reopened(document), document));
      kept += countOf(document);
    }
    const double rate = clipOf(document, 0).framesPerSecond;
    const Document counted = workAtRate(document, 0, 2.0 * rate);
    CHECK(countOf(counted) == countOf(document));
    CHECK(sameThings(workAtRate(counted, 0, rate), document));
  }
  CHECK(kept > 1000);
}

TEST_CASE("Making everything slower, with what comes after moving along, and quicker again changes nothing "
          "in time") {
  const Document start = twoOfEach();
  const Result<Document> slower = retimed(start, 0, {0.0, 20.0, 40.0, true, {}});
  REQUIRE(slower);
  CHECK(countOf(*slower) == countOf(start));
  const Result<Document> back = retimed(*slower, 0, {0.0, 40.0, 20.0, true, {}});
  REQUIRE(back);
  CHECK(sameThings(*back, start));
}

TEST_CASE(
    "A curve in a range that is made slower rises as slowly in every axis, and its slopes outside of the "
    "range stay") {
  // Keys at the frames 0, 6, 12, 18 and 24 whose slopes differ on each side of each key and in each axis.
  const KeyRow row{NodeIndex(4), Channel::translation, {}};
  Track track;
  track.node = row.node;
  track.channel = Channel::translation;
  track.width = 3;
  track.interpolation = Interpolation::cubicSpline;
  for (int key = 0; key < 5; ++key) {
    const auto number = static_cast<float>(key);
    track.times.push_back(number / 5.0F);
    for (const float first : {1.0F + number, 0.1F * number, -2.0F + 0.25F * number}) { // in, value, out
      track.values.insert(track.values.end(), {first, first + 0.25F, first - 0.5F});
    }
  }
  const Document start = setTracks(test::boxer(), 0, {track});
  const std::vector<RowKey> before = readRow(start, 0, row).keys;
  for (const double factor : {2.0, 0.5}) {
    CAPTURE(factor);
    const Result<Document> made = retimed(start, 0, {6.0, 18.0, 12.0 * factor});
    REQUIRE(made);
    const std::vector<RowKey> after = readRow(*made, 0, row).keys;
    REQUIRE(after.size() == 5);
    const std::vector<double> frames{0.0, 6.0, 6.0 + 6.0 * factor, 6.0 + 12.0 * factor, 12.0 + 12.0 * factor};
    for (std::size_t key = 0; key < 5; ++key) {
      CHECK(after[key].frame == Approx(frames[key]).margin(1e-4));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        CAPTURE(key, axis);
        const double in = key == 2 || key == 3 ? factor : 1.0;
        const double out = key == 1 || key == 2 ? factor : 1.0;
        CHECK(after[key].values[axis] == Approx(before[key].values[axis]).margin(1e-6));
        CHECK(after[key].inSlopes[axis] == Approx(before[key].inSlopes[axis] / in).margin(1e-6));
        CHECK(after[key].outSlopes[axis] == Approx(before[key].outSlopes[axis] / out).margin(1e-6));
      }
    }
  }
}

TEST_CASE("A range without a length, with none to get or of a limb that is not there is refused") {
  const Document start = test::boxer();
  const std::string told =
      "the range has no length, or none that it could get; choose a range of frames and a "
      "new length above 0";
  for (const Retime& wanted :
       {Retime{5.0, 5.0, 3.0}, Retime{5.0, 4.0, 3.0}, Retime{-1.0, 4.0, 3.0}, Retime{5.0, 10.0, 0.0},
        Retime{5.0, 10.0, 1.1e6}, Retime{5.0, std::numeric_limits<double>::infinity(), 3.0},
        Retime{5.0, 10.0, std::numeric_limits<double>::quiet_NaN()}}) {
    CHECK(test::refusal(retimed(start, 0, wanted)) == told);
  }
  CHECK(retimed(start, 0, {5.0, 10.0, 1e6}));
  CHECK(retimed(start, 0, {0.0, 10.0, 0.01}));
  Retime limb{5.0, 10.0, 3.0};
  limb.limb = "tail";
  CHECK(test::refusal(retimed(start, 0, limb)) ==
        "tail: there is no such limb; select a limb, or retime the whole body");
}

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "app/commands/table/past_end.h"
#include "app/edits/keys/following_keys.h"
#include "app/edits/keys/key_edits.h"
#include "app/edits/keys/rate_edits.h"
#include "app/edits/keys/retime.h"
#include "app/edits/keys/track_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/evaluate/evaluate.h"
#include "core/anim/sampling.h"
#include "core/math/euler.h"
#include "core/math/rotation.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

const KeyRow armTurns{NodeIndex(3), Channel::rotation, {}};
const KeyRow handRow{NodeIndex::none, Channel::translation, "left-hand"};

Document documentOf(const Result<EditedKeys>& result) {
  INFO((result ? std::string() : result.error().line()));
  REQUIRE(result);
  return result->document;
}

KeySelection oneKey(const KeyRow& row, int key, unsigned components = ~0U) {
  return {{row, {{key, components}}}};
}

const Track& trackAt(const Document& document, const KeyRow& row = armTurns) {
  const Clip& clip = clipOf(document, 0);
  const int index = findTrack(clip, row.node, row.channel);
  REQUIRE(index >= 0);
  return *clip.tracks[static_cast<std::size_t>(index)];
}

std::vector<float> numbersAt(const Track& track, std::size_t key) {
  const std::size_t width = 4;
  return {track.values.begin() + static_cast<std::ptrdiff_t>(key * width),
          track.values.begin() + static_cast<std::ptrdiff_t>((key + 1) * width)};
}

Document withHandKeys() {
  rig::Adjustment adjustment;
  adjustment.controller = "left-hand";
  adjustment.rangeFrames = Vec2(2.0, 16.0);
  for (const double frame : {4.0, 8.0, 12.0}) {
    rig::OffsetKey key;
    key.frame = frame;
    key.move = {0.01 * frame, 0.0, 0.0};
    adjustment.keys.push_back(key);
  }
  const Document document = test::boxer();
  const Result<Document> placed = placeAdjustments(document, {&adjustment, 1});
  INFO((placed ? std::string() : placed.error().line()));
  REQUIRE(placed);
  return *placed;
}

// How far two documents' arms are apart anywhere, radians.
double farthestTurn(const Document& a, const Document& b, double from = 0.0, double to = 25.0) {
  double farthest = 0.0;
  for (double frame = from; frame <= to; frame += 0.25) {
    std::array<double, 4> one{};
    std::array<double, 4> other{};
    sampleTrack(trackAt(a), frame / 30.0, one.data());
    sampleTrack(trackAt(b), frame / 30.0, other.data());
    const double dot =
        std::abs(one[0] * other[0] + one[1] * other[1] + one[2] * other[2] + one[3] * other[3]);
    farthest = std::max(farthest, 2.0 * std::acos(std::min(1.0, dot)));
  }
  return farthest;
}

} // namespace

TEST_CASE("A key of the clip that is moved in time keeps its value, and the others keep theirs by bits",
          "[keys]") {
  const Document start = test::boxer();
  const Document moved = documentOf(moveKeys(start, 0, oneKey(armTurns, 1), {2.0, 0.0}));
  const Track& before = trackAt(start);
  const Track& after = trackAt(moved);
  CHECK(after.values == before.values);
  CHECK(after.times[1] == 7.0F / 30.0F);
  CHECK(after.times[0] == before.times[0]);
  CHECK(after.times[2] == before.times[2]);
  CHECK(after.interpolation == Interpolation::linear);
  CHECK(editedTracks(moved, 0).size() == 1);
  CHECK(*moved.sourceClips == *start.clips);
}

TEST_CASE("A rotation is raised by degrees of one of its angles", "[keys]") {
  const Document start = test::boxer();
  const KeyedRow before = readRow(start, 0, armTurns);
  const Document raised = documentOf(moveKeys(start, 0, oneKey(armTurns, 2, 2U), {0.0, 10.0}));
  const KeyedRow after = readRow(raised, 0, armTurns);
  CHECK(after.keys[2].values[1] == Approx(before.keys[2].values[1] + 10.0).margin(1e-4));
  CHECK(after.keys[2].values[0] == Approx(before.keys[2].values[0]).margin(1e-4));
  CHECK(after.keys[2].values[2] == Approx(before.keys[2].values[2]).margin(1e-4));
  for (const std::size_t key : {0U, 1U, 3U}) {
    CHECK(numbersAt(trackAt(raised), key) == numbersAt(trackAt(start), key));
  }
  CHECK(trackAt(raised).times == trackAt(start).times);
}

TEST_CASE("Angles of a turn beyond half a circle go on where they were", "[keys]") {
  Document document = test::boxer();
  Track track = trackAt(document);
  track.times = {0.0F, 0.2F, 0.4F, 0.6F, 0.8F};
  track.values.clear();
  for (int i = 0; i < 5; ++i) {
    const Quat turn = axisAngle(Vec3(0.0, 0.0, 1.0), 1.5 * i);
    for (const double value : {turn.x, turn.y, turn.z, turn.w}) {
      track.values.push_back(static_cast<float>(value));
    }
  }
  document = setTracks(document, 0, {track});
  const KeyedRow row = readRow(document, 0, armTurns);
  for (int i = 0; i < 5; ++i) {
    CHECK(row.keys[static_cast<std::size_t>(i)].values[2] == Approx(1.5 * i * 180.0 / pi).margin(1e-3));
  }
}

TEST_CASE("A key that comes to stand where another is takes its place, and none leaves the clip's start",
          "[keys]") {
  const Document start = test::boxer();
  const Document onto = documentOf(moveKeys(start, 0, oneKey(armTurns, 1), {5.0, 0.0}));
  CHECK(trackAt(onto).times.size() == 3);
  CHECK(numbersAt(trackAt(onto), 1) == numbersAt(trackAt(start), 1));
  const Document far = documentOf(moveKeys(start, 0, oneKey(armTurns, 1), {-50.0, 0.0}));
  CHECK(trackAt(far).times.front() == 0.0F);
  CHECK(numbersAt(trackAt(far), 0) == numbersAt(trackAt(start), 1));
}

TEST_CASE("A key that is moved past the end makes the clip longer, back it is as it was", "[keys]") {
  const Document start = test::boxer();
  const Document longer = documentOf(moveKeys(start, 0, oneKey(armTurns, 3), {6.0, 0.0}));
  CHECK(clipOf(longer, 0).endSeconds == Approx(26.0 / 30.0));
  const Document back = documentOf(moveKeys(longer, 0, oneKey(armTurns, 3), {-6.0, 0.0}));
  CHECK(sameDocument(back, start));
  CHECK_FALSE(hasEditedKeys(back));
}

TEST_CASE("Keys are scaled around a frame", "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{armTurns};
  const Document scaled = documentOf(scaleKeys(start, 0, allKeys(start, 0, rows), {10.0, 0.5}));
  const std::vector<double> frames = keyFramesOf(scaled, 0, armTurns);
  REQUIRE(frames.size() == 4);
  CHECK(frames[0] == Approx(5.0));
  CHECK(frames[1] == Approx(7.5));
  CHECK(frames[2] == Approx(10.0));
  CHECK(frames[3] == Approx(15.0));
  CHECK(trackAt(scaled).values == trackAt(start).values);
}

TEST_CASE("An inserted key leaves the motion as it is", "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{armTurns};
  const Document inserted = documentOf(insertKeys(start, 0, rows, 7.0));
  CHECK(keyFramesOf(inserted, 0, armTurns).size() == 5);
  CHECK(farthestTurn(start, inserted) < 1e-3);
  const Document curved =
      documentOf(setKeyKind(start, 0, allKeys(start, 0, rows), rig::KeyInterpolation::automatic));
  const Document between = documentOf(insertKeys(curved, 0, rows, 7.0));
  CHECK(farthestTurn(curved, between) < 5e-3);
  const auto lastNumbers = [](const Document& document, std::size_t count) {
    const std::vector<float>& values = trackAt(document).values;
    return std::vector<float>(values.end() - static_cast<std::ptrdiff_t>(count), values.end());
  };
  CHECK(lastNumbers(between, 24) == lastNumbers(curved, 24)); // The auto keys beside it keep their slopes.
}

TEST_CASE("A joint without keys gets its first one where it rests", "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{{NodeIndex(4), Channel::translation, {}}};
  const Document keyed = documentOf(insertKeys(start, 0, rows, 5.0));
  const Track& track = trackAt(keyed, rows.front());
  CHECK(track.values == std::vector<float>{0.3F, 0.0F, 0.0F});
  CHECK(evaluateOriginal(keyed, 0, 0.2).pose.locals[4].translation.x == Approx(0.3));
  const KeySelection first{{rows.front(), {{0}}}};
  const Document raised = documentOf(moveKeys(keyed, 0, {{rows.front(), {{0, 2U}}}}, {0.0, 0.25}));
  CHECK(trackAt(raised, rows.front()).values == std::vector<float>{0.3F, 0.25F, 0.0F});
  CHECK_THAT(test::refusal(removeKeys(keyed, 0, first)),
             Catch::Contains("a track of the clip keeps one key"));
  CHECK(sameDocument(restoreAllTracks(raised), start));
}

TEST_CASE("The last key of a track of the clip is not deleted", "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{armTurns};
  CHECK_THAT(test::refusal(removeKeys(start, 0, allKeys(start, 0, rows))),
             Catch::Contains("a track of the clip keeps one key"));
  CHECK(trackAt(documentOf(removeKeys(start, 0, keysBetween(start, 0, rows, 4.0, 12.0)))).times.size() == 2);
}

TEST_CASE("Copied keys stand at the frame where they are pasted, by value", "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{armTurns};
  const CopiedKeys copied = copyKeys(start, 0, keysBetween(start, 0, rows, 5.0, 10.0));
  const Document pasted = documentOf(pasteKeys(start, 0, copied, 30.0, {}));
  const KeyedRow row = readRow(pasted, 0, armTurns);
  REQUIRE(row.keys.size() == 6);
  CHECK(row.keys[4].frame == Approx(30.0));
  CHECK(row.keys[5].frame == Approx(35.0));
  CHECK(row.keys[5].values[1] == Approx(row.keys[2].values[1]).margin(1e-3));
}

TEST_CASE("Copied keys are pasted on another joint where it is keyed alike, and on their own joint elsewhere",
          "[keys]") {
  const Document start = test::boxer();
  const CopiedKeys copied =
      copyKeys(start, 0, keysBetween(start, 0, std::vector<KeyRow>{armTurns}, 5.0, 10.0));
  const KeyRow otherTurns{NodeIndex(6), Channel::rotation, {}};
  const Document turned = documentOf(pasteKeys(start, 0, copied, 5.0, otherTurns));
  CHECK(readRow(turned, 0, otherTurns).keys.back().values[1] ==
        Approx(readRow(start, 0, armTurns).keys[2].values[1]).margin(1e-3));
  CHECK(trackAt(turned) == trackAt(start));
  for (const KeyRow& unlike : {KeyRow{NodeIndex(6), Channel::translation, {}}, handRow}) {
    const Document own = documentOf(pasteKeys(start, 0, copied, 30.0, unlike));
    CHECK(readRow(own, 0, unlike).keys.empty());
    CHECK(readRow(own, 0, armTurns).keys.size() == 6);
  }
}

TEST_CASE("Of keys that are picked those that are there no more are picked no longer", "[keys]") {
  const Document start = test::boxer();
  const KeyRow gone{NodeIndex(6), Channel::rotation, {}};
  const KeySelection there = stillThere(start, 0, {{armTurns, {{0}, {3, 2U}, {4}, {9}}}, {gone, {{0}}}});
  CHECK(there == KeySelection{{armTurns, {{0}, {3, 2U}}}});
}

TEST_CASE("A tangent on a linear track makes it a cubic one whose other keys run as straight as before",
          "[keys]") {
  const Document start = test::boxer();
  const Document curved = documentOf(setKeyKind(start, 0, oneKey(armTurns, 1), rig::KeyInterpolation::flat));
  CHECK(trackAt(curved).interpolation == Interpolation::cubicSpline);
  CHECK(farthestTurn(start, curved, 10.0, 20.0) < 2e-3);
  CHECK(farthestTurn(start, curved, 0.0, 10.0) > 0.02);
  const KeyedRow row = readRow(curved, 0, armTurns);
  CHECK(row.keys[1].outSlopes[1] == Approx(0.0).margin(1e-3));
  CHECK(row.keys[2].inSlopes[1] == Approx(readRow(start, 0, armTurns).keys[2].inSlopes[1]).epsilon(0.02));
}

TEST_CASE("Auto tangents follow their neighbours, level at extremes and smooth between", "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{armTurns};
  const Document curved =
      documentOf(setKeyKind(start, 0, allKeys(start, 0, rows), rig::KeyInterpolation::automatic));
  const KeyedRow before = readRow(curved, 0, armTurns);
  const double first = before.keys[0].values[1];
  const double third = before.keys[2].values[1];
  const auto secondAt = [&](double value) {
    const double by = value - before.keys[1].values[1];
    return documentOf(moveKeys(curved, 0, oneKey(armTurns, 1, 2U), {0.0, by}));
  };
  const auto slopeAt = [](const Document& document, std::size_t key) {
    const RowKey read = readRow(document, 0, armTurns).keys[key];
    CHECK(read.inSlopes[1] == Approx(read.outSlopes[1]).margin(1e-3));
    return read.outSlopes[1];
  };
  const Document between = secondAt(0.5 * (first + third));
  CHECK(slopeAt(between, 1) == Approx((third - first) / 10.0).margin(2e-2));
  const Document beyond = secondAt(third + (third - first));
  CHECK(slopeAt(beyond, 1) == Approx(0.0).margin(1e-3));
  // The neighbour is no extreme any more once the second key has passed it.
  const double fourth = before.keys[3].values[1];
  const Document passed = secondAt(third + (third - fourth));
  CHECK(slopeAt(passed, 2) == Approx((fourth - third) / 5.0).epsilon(0.5));
  CHECK(std::abs(slopeAt(passed, 2)) > 0.5);
  CHECK(numbersAt(trackAt(passed), 3 * 3) == numbersAt(trackAt(curved), 3 * 3));
}

TEST_CASE("Only keys that were made auto follow, and only where a neighbour moved", "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{armTurns};
  const Document one =
      documentOf(setKeyKind(start, 0, oneKey(armTurns, 2), rig::KeyInterpolation::automatic));
  const Document moved = documentOf(moveKeys(one, 0, oneKey(armTurns, 0, 2U), {0.0, 20.0}));
  const auto numbers = [](const Document& document, std::size_t key) {
    const std::vector<float>& values = trackAt(document).values;
    return std::vector<float>(values.begin() + static_cast<std::ptrdiff_t>(12 * key),
                              values.begin() + static_cast<std::ptrdiff_t>(12 * key + 12));
  };
  CHECK(numbers(moved, 1) == numbers(one, 1));
  CHECK(numbers(moved, 2) == numbers(one, 2));
  const Document beside = documentOf(moveKeys(one, 0, oneKey(armTurns, 3, 2U), {0.0, 20.0}));
  CHECK(numbers(beside, 1) == numbers(one, 1));
  // A tangent that is drawn is the artist's.
  const Document drawn = documentOf(setKeySlope(one, 0, armTurns, {2, ~0U}, TangentSide::both, 4.0));
  const Document after = documentOf(moveKeys(drawn, 0, oneKey(armTurns, 3, 2U), {0.0, 20.0}));
  CHECK(numbers(after, 2) == numbers(drawn, 2));
  CHECK(after.followingKeys.empty());
  CHECK(restoreAllTracks(one).followingKeys.empty());
}

TEST_CASE("A key that is deleted, moved in time or inserted and moved bends auto keys beside it", "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{armTurns};
  const Document curved =
      documentOf(setKeyKind(start, 0, allKeys(start, 0, rows), rig::KeyInterpolation::automatic));
  const auto isAuto = [](const Document& document, std::size_t key) {
    const KeyedRow row = readRow(document, 0, armTurns);
    const RowKey* const next = key + 1 < row.keys.size() ? &row.keys[key + 1] : nullptr;
    for (std::size_t i = 0; i < 3; ++i) {
      const double slope = followingSlope(key > 0 ? &row.keys[key - 1] : nullptr, row.keys[key], next, i);
      CHECK(row.keys[key].outSlopes[i] == Approx(slope).margin(2e-3));
    }
  };
  const Document without = documentOf(removeKeys(curved, 0, oneKey(armTurns, 1)));
  const Document later = documentOf(moveKeys(curved, 0, oneKey(armTurns, 1), {3.0, 0.0}));
  const Document inserted = documentOf(insertKeys(curved, 0, rows, 7.0));
  const Document raised = documentOf(moveKeys(inserted, 0, oneKey(armTurns, 2, 2U), {0.0, 30.0}));
  isAuto(without, 1);
  isAuto(later, 2);
  isAuto(raised, 1);
  isAuto(raised, 3);
  const Result<Document> slower = retimed(curved, 0, {5.0, 10.0, 10.0});
  REQUIRE(slower);
  for (const std::size_t key : {0U, 1U, 2U, 3U}) {
    isAuto(*slower, key);
  }
}

TEST_CASE("A tangent that is dragged has the slope that is asked for", "[keys]") {
  const Document start = test::boxer();
  const Document bent = documentOf(setKeySlope(start, 0, armTurns, {1, 2U}, TangentSide::both, -3.0));
  const KeyedRow row = readRow(bent, 0, armTurns);
  CHECK(row.keys[1].inSlopes[1] == Approx(-3.0).margin(1e-2));
  CHECK(row.keys[1].outSlopes[1] == Approx(-3.0).margin(1e-2));
  const Document broken = documentOf(setKeySlope(bent, 0, armTurns, {1, 2U}, TangentSide::out, 1.0));
  CHECK(readRow(broken, 0, armTurns).keys[1].inSlopes[1] == Approx(-3.0).margin(1e-2));
  CHECK(readRow(broken, 0, armTurns).keys[1].outSlopes[1] == Approx(1.0).margin(1e-2));
}

TEST_CASE("A track of the clip steps as a whole", "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{armTurns};
  CHECK_THAT(test::refusal(setKeyKind(start, 0, oneKey(armTurns, 1), rig::KeyInterpolation::stepped)),
             Catch::StartsWith("a track of the clip steps as a whole"));
  const Document stepped =
      documentOf(setKeyKind(start, 0, allKeys(start, 0, rows), rig::KeyInterpolation::stepped));
  CHECK(trackAt(stepped).interpolation == Interpolation::step);
  CHECK(trackAt(stepped).values == trackAt(start).values);
}

TEST_CASE("Keys between frames are snapped to whole ones", "[keys]") {
  const Document start = test::boxer();
  const Document off = documentOf(moveKeys(start, 0, oneKey(armTurns, 1), {0.3, 0.0}));
  CHECK(keyFramesOf(off, 0, armTurns)[1] == Approx(5.3));
  CHECK(sameDocument(documentOf(snapKeys(off, 0, oneKey(armTurns, 1))), start));
}

TEST_CASE("Both keys of a jump between frames are snapped, and it stays one", "[keys]") {
  Document start = test::boxer();
  std::vector<Clip> clips = *start.clips;
  const double frame = GENERATE(10.4, 14.6); // the second comes to where numbers are coarser
  const auto jumping = static_cast<std::size_t>(findTrack(clips[0], armTurns.node, armTurns.channel));
  clips[0].tracks[jumping].edit([&](Track& track) {
    track.times = {0.0F, static_cast<float>(frame / 30.0), 1.0F};
    track.times.insert(track.times.begin() + 2, std::nextafter(track.times[1], 1.0F));
    track.values = {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.6F, 0.8F,
                    0.0F, 0.6F, 0.0F, 0.8F, 0.0F, 0.0F, 0.0F, 1.0F};
    track.interpolation = Interpolation::linear;
  });
  start.clips = std::make_shared<const std::vector<Clip>>(std::move(clips));
  REQUIRE(keyCount(keysOffFrames(start, 0)) == 2);
  const Document snapped = documentOf(snapKeys(start, 0, keysOffFrames(start, 0)));
  const Track& track = trackAt(snapped);
  REQUIRE(track.times.size() == 4);
  CHECK(track.times[1] == Approx(std::round(frame) / 30.0).epsilon(1e-6));
  CHECK(track.times[2] > track.times[1]);
  CHECK(track.times[2] - track.times[1] < 1e-5F);
  CHECK(numbersAt(track, 1) == numbersAt(trackAt(start), 1));
  CHECK(numbersAt(track, 2) == numbersAt(trackAt(start), 2));
}

TEST_CASE("The keys that stand between frames are found on every row of the clip, those of controllers too",
          "[keys]") {
  const Document start = withHandKeys();
  CHECK(keysOffFrames(start, 0).empty());
  const Document arm = documentOf(moveKeys(start, 0, oneKey(armTurns, 1), {0.3, 0.0}));
  const Document both = documentOf(moveKeys(arm, 0, oneKey(handRow, 2), {-0.25, 0.0}));
  CHECK(keysOffFrames(arm, 0) == oneKey(armTurns, 1));
  CHECK(keyCount(keysOffFrames(both, 0)) == 2);
  CHECK(keysOffFrames(documentOf(snapKeys(both, 0, keysOffFrames(both, 0))), 0).empty());
}

TEST_CASE("Offset keys are edited by the same edits", "[keys]") {
  const Document start = withHandKeys();
  const Document moved = documentOf(moveKeys(start, 0, oneKey(handRow, 1, 1U), {2.0, 0.5}));
  REQUIRE(moved.adjustments.size() == 1);
  const std::vector<rig::OffsetKey>& keys = moved.adjustments[0].keys;
  CHECK(keys[1].frame == 10.0);
  CHECK(keys[1].move.x == Approx(0.58));
  CHECK(keys[0] == start.adjustments[0].keys[0]);
  CHECK(keys[2] == start.adjustments[0].keys[2]);
  CHECK(moved.clips == start.clips);
  const Document far = documentOf(moveKeys(start, 0, oneKey(handRow, 2), {40.0, 0.0}));
  CHECK(far.adjustments[0].keys[2].frame == 16.0);
  const Document flat = documentOf(setKeyKind(start, 0, oneKey(handRow, 1), rig::KeyInterpolation::flat));
  CHECK(flat.adjustments[0].keys[1].interpolation == rig::KeyInterpolation::flat);
  const std::vector<KeyRow> rows{handRow};
  for (const TangentSide side : {TangentSide::in, TangentSide::out, TangentSide::both}) {
    const Document bent = documentOf(setKeySlope(start, 0, handRow, {1, 2U}, side, 0.25));
    CHECK(readRow(bent, 0, handRow).keys[1].inSlopes[1] == Approx(0.25).margin(1e-3));
    CHECK(readRow(bent, 0, handRow).keys[1].outSlopes[1] == Approx(0.25).margin(1e-3));
  }
  CHECK(documentOf(insertKeys(start, 0, rows, 6.0)).adjustments[0].keys.size() == 4);
  CHECK(documentOf(removeKeys(start, 0, allKeys(start, 0, rows))).adjustments.empty());
  const CopiedKeys copied = copyKeys(start, 0, oneKey(handRow, 0));
  CHECK(documentOf(pasteKeys(start, 0, copied, 14.0, {})).adjustments[0].keys.back().move.x == Approx(0.04));
}

TEST_CASE("A range of the whole clip is made slower, and what comes after moves along", "[keys]") {
  const Document start = withHandKeys();
  Retime slower{5.0, 10.0, 10.0};
  const Result<Document> made = retimed(start, 0, slower);
  REQUIRE(made);
  const std::vector<double> frames = keyFramesOf(*made, 0, armTurns);
  REQUIRE(frames.size() == 4);
  CHECK(frames[2] == Approx(15.0));
  CHECK(frames[3] == Approx(25.0));
  CHECK(trackAt(*made).values == trackAt(start).values);
  CHECK(made->adjustments[0].keys[1].frame == Approx(11.0));
  CHECK(made->adjustments[0].rangeFrames->y == Approx(21.0));
  slower.movesAfter = false;
  slower.newFrames = 3.0;
  const Result<Document> alone = retimed(start, 0, slower);
  REQUIRE(alone);
  CHECK(keyFramesOf(*alone, 0, armTurns)[2] == Approx(8.0));
  CHECK(keyFramesOf(*alone, 0, armTurns)[3] == Approx(20.0));
  slower.limb = "right-arm";
  CHECK(sameDocument(*retimed(start, 0, slower), start));
  CHECK_THAT(test::refusal(retimed(start, 0, {5.0, 5.0, 3.0})), Catch::StartsWith("the range has no length"));
}

TEST_CASE("A prop's hands let go at the retimed frame", "[keys][holds]") {
  Document start = test::boxer();
  rig::Prop prop;
  prop.node = "Club";
  prop.boundFrame = 12.0;
  prop.hands = {{"left-arm", {}}};
  for (const auto& [frame, value] : {std::pair(2.0, 1.0), std::pair(8.0, 1.0), std::pair(12.0, 0.0)}) {
    rig::OffsetKey key;
    key.frame = frame;
    key.value = value;
    prop.hands[0].keys.push_back(key);
  }
  start.holds.props = {prop};
  const Result<Document> made = retimed(start, 0, {5.0, 10.0, 10.0});
  REQUIRE(made);
  const std::vector<rig::OffsetKey>& keys = made->holds.props[0].hands[0].keys;
  CHECK(keys[0].frame == 2.0);
  CHECK(keys[1].frame == 11.0);
  CHECK(keys[2].frame == 17.0);
  CHECK(made->holds.props[0].boundFrame == 17.0);
}

TEST_CASE("What will stand past a clip's end is named", "[keys]") {
  Document start = test::boxer();
  rig::Trail trail;
  trail.limb = "right-arm";
  trail.settings.startFrame = 10.0;
  trail.settings.endFrame = 20.0;
  start.trails = {trail};
  CHECK(standingPastEnd(start, 0).empty());
  const double end = keyFramesOf(start, 0, armTurns).back();
  Document cut = start;
  for (const KeyRow& row : keyedRows(start, 0)) {
    const KeySelection late = keysBetween(cut, 0, {&row, 1}, 12.0, end);
    cut = late.empty() ? cut : documentOf(removeKeys(cut, 0, late));
  }
  CHECK(standingPastEnd(cut, 0) == std::vector<std::string>{"trail of right arm (10 to 20)"});
}

TEST_CASE("Outside of a range whose ends lie between keys nothing but the time changes", "[keys]") {
  const Document start = test::boxer();
  const Result<Document> made = retimed(start, 0, {6.0, 9.0, 6.0});
  REQUIRE(made);
  CHECK(farthestTurn(start, *made, 0.0, 6.0) < 1e-3);
  std::array<double, 4> late{};
  std::array<double, 4> before{};
  sampleTrack(trackAt(*made), 18.0 / 30.0, late.data());
  sampleTrack(trackAt(start), 15.0 / 30.0, before.data());
  CHECK(late[1] == Approx(before[1]).margin(1e-4));
}

TEST_CASE("The character moves by its edited keys, and the original is the source's", "[keys]") {
  const Document start = test::boxer();
  const Document raised = documentOf(moveKeys(start, 0, oneKey(armTurns, 2, 2U), {0.0, 30.0}));
  const auto handOf = [](const FrameState& frame) { return Vec3(frame.worlds[5][3]); };
  const double seconds = 10.0 / 30.0;
  const Vec3 source = handOf(evaluateOriginal(start, 0, seconds));
  CHECK(glm::distance(handOf(evaluate(raised, prepareMotion(raised, 0), seconds)), source) > 0.1);
  CHECK(handOf(evaluateOriginal(raised, 0, seconds)) == source);
}

TEST_CASE("Slopes of copied keys are as steep in time where they are pasted at another rate", "[keys]") {
  const Document start =
      documentOf(setKeySlope(withHandKeys(), 0, handRow, {1, 1U}, TangentSide::both, 0.02));
  const CopiedKeys copied = copyKeys(start, 0, oneKey(handRow, 1));
  const Document slower = workAtRate(start, 0, 15.0);
  const KeyedRow row = readRow(documentOf(pasteKeys(slower, 0, copied, 7.0, {})), 0, handRow);
  REQUIRE(row.keys.size() == 4);
  CHECK(row.keys[3].outSlopes[0] == Approx(0.04).epsilon(0.02));
}

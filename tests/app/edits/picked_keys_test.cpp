#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/edits/keys/key_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/offset_edits.h"
#include "app/session.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

// The punch turns the arm about -Y by 0, 0.4, 1.4 and 0.1 radians at the frames 0, 5, 10 and 20.
const KeyRow punchRow{NodeIndex(3), Channel::rotation, {}};
const KeyRow fistRow{NodeIndex::none, Channel::translation, "left-hand"};
const KeyRow lengthRow{NodeIndex::none, Channel::translation, "left-arm.stretch"};
constexpr double radian = 180.0 / pi;

EditedKeys made(const Result<EditedKeys>& result) {
  INFO((result ? std::string() : result.error().line()));
  REQUIRE(result);
  return *result;
}

KeySelection keyOf(const KeyRow& row, int key, unsigned components = ~0U) {
  return {{row, {{key, components}}}};
}

/// Offset keys of the left hand at 4, 8 and 12, between the frames 2 and 16, a hundredth of their frame to
/// the left.
Document withFistKeys() {
  rig::Adjustment adjustment;
  adjustment.controller = "left-hand";
  adjustment.rangeFrames = Vec2(2.0, 16.0);
  for (const double frame : {4.0, 8.0, 12.0}) {
    rig::OffsetKey key;
    key.frame = frame;
    key.move = {0.01 * frame, 0.0, 0.0};
    adjustment.keys.push_back(key);
  }
  const Result<Document> placed = placeAdjustments(test::boxer(), {&adjustment, 1});
  REQUIRE(placed);
  return *placed;
}

/// The left arm's length a quarter of its own at frame 5, between the frames 2 and 9.
Document withLengthKey() {
  const std::vector<AttributeValue> values{{"left-arm.stretch", 0.25}};
  const Result<Document> keyed = setOffsets(test::boxer(), 0, 5.0, {}, values, {Vec2(2.0, 9.0)});
  REQUIRE(keyed);
  return *keyed;
}

const std::vector<rig::OffsetKey>& offsetKeys(const Document& document) {
  REQUIRE(document.adjustments.size() == 1);
  return document.adjustments.front().keys;
}

std::vector<double> offsetFrames(const Document& document) {
  std::vector<double> frames;
  for (const rig::OffsetKey& key : offsetKeys(document)) {
    frames.push_back(key.frame);
  }
  return frames;
}

} // namespace

TEST_CASE("Each side of a tangent of the clip's keys is drawn alone, of the angle that is picked alone",
          "[keys]") {
  const Document start = test::boxer();
  const double came = -0.4 * radian / 5.0;
  const double went = -1.0 * radian / 5.0;
  struct Case {
    TangentSide side;
    double in;
    double out;
  };
  for (const Case& one : {Case{TangentSide::in, 3.0, went}, Case{TangentSide::out, came, 3.0},
                          Case{TangentSide::both, 3.0, 3.0}}) {
    const EditedKeys drawn = made(setKeySlope(start, 0, punchRow, {1, 2U}, one.side, 3.0));
    const RowKey key = readRow(drawn.document, 0, punchRow).keys[1];
    CHECK(key.inSlopes[1] == Approx(one.in).margin(0.02));
    CHECK(key.outSlopes[1] == Approx(one.out).margin(0.02));
    for (const std::size_t other : {0U, 2U}) {
      CHECK(key.inSlopes[other] == Approx(0.0).margin(0.02));
      CHECK(key.outSlopes[other] == Approx(0.0).margin(0.02));
    }
    CHECK(drawn.picked == keyOf(punchRow, 1, 2U));
  }
}

TEST_CASE("A picked key that is no longer there is left out, on either side of its row", "[keys]") {
  const Document start = test::boxer();
  const int key = GENERATE(-1, 4, 1 << 24); // The punch has four.
  const EditedKeys moved = made(moveKeys(start, 0, {{punchRow, {{1, ~0U}, {key, ~0U}}}}, {1.0, 0.0}));
  CHECK(moved.picked == keyOf(punchRow, 1));
  CHECK(readRow(moved.document, 0, punchRow).keys[1].frame == Approx(6.0));
}

TEST_CASE("What was edited stays picked wherever it stands now, and what is new is picked", "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{punchRow};
  CHECK(made(moveKeys(start, 0, keyOf(punchRow, 1, 2U), {7.0, 0.0})).picked == keyOf(punchRow, 2, 2U));
  CHECK(made(moveKeys(start, 0, keyOf(punchRow, 3, 4U), {-12.0, 0.0})).picked == keyOf(punchRow, 2, 4U));
  CHECK(made(moveKeys(start, 0, keyOf(punchRow, 0), {0.0, 1.0})).picked == keyOf(punchRow, 0));
  CHECK(made(setKeyValue(start, 0, keyOf(punchRow, 3, 1U), 2.0)).picked == keyOf(punchRow, 3, 1U));
  CHECK(made(insertKeys(start, 0, rows, 7.0)).picked == keyOf(punchRow, 2));
  CHECK(made(insertKeys(start, 0, rows, 25.0)).picked == keyOf(punchRow, 4));
  CHECK(made(insertKeys(start, 0, rows, 5.0)).picked.empty()); // one stands there
  CHECK(made(removeKeys(start, 0, keyOf(punchRow, 2))).picked.empty());
  const CopiedKeys copied = copyKeys(start, 0, {{punchRow, {{0}, {1}}}});
  CHECK(made(pasteKeys(start, 0, copied, 7.0, {})).picked == KeySelection{{punchRow, {{2}, {4}}}});
  const EditedKeys turned = made(scaleKeys(start, 0, {{punchRow, {{0, 1U}, {1, 2U}, {2, 4U}}}}, {5.0, -1.0}));
  CHECK(turned.picked == KeySelection{{punchRow, {{0, 4U}, {1, 2U}, {2, 1U}}}});
}

TEST_CASE("A typed value goes to what is picked of a key, as it is shown", "[keys]") {
  const Document turned = made(setKeyValue(test::boxer(), 0, keyOf(punchRow, 1, 2U), 30.0)).document;
  const RowKey key = readRow(turned, 0, punchRow).keys[1];
  CHECK(key.values[0] == Approx(0.0).margin(1e-4));
  CHECK(key.values[1] == Approx(30.0).margin(1e-4));
  CHECK(key.values[2] == Approx(0.0).margin(1e-4));
  CHECK(key.frame == Approx(5.0));
  for (std::size_t component = 0; component < 6; ++component) {
    CAPTURE(component);
    const KeySelection one = keyOf(fistRow, 1, 1U << component);
    const rig::OffsetKey offset = offsetKeys(made(setKeyValue(withFistKeys(), 0, one, 0.5)).document)[1];
    Vec3 move(0.08, 0.0, 0.0);
    Vec3 turn(0.0);
    const auto place = static_cast<glm::length_t>(component % 3);
    (component < 3 ? move[place] : turn[place]) = component < 3 ? 0.5 : 0.5 / radian;
    CHECK(glm::length(offset.move - move) < 1e-12);
    CHECK(glm::length(offset.turn - turn) < 1e-12);
  }
  const Document longer = made(setKeyValue(withLengthKey(), 0, keyOf(lengthRow, 0, 1U), 0.5)).document;
  CHECK(offsetKeys(longer)[0].value == 0.5);
}

TEST_CASE("An attribute is one value that is its own where nothing is keyed", "[keys]") {
  const Document document = withLengthKey();
  const KeyedRow row = readRow(document, 0, lengthRow);
  CHECK(row.components == 1);
  REQUIRE(row.keys.size() == 1);
  CHECK(row.keys[0].frame == 5.0);
  CHECK(row.keys[0].values[0] == 0.25);
  REQUIRE(row.parts.size() == 1);
  CHECK(row.parts[0].firstFrame == 2.0);
  CHECK(row.parts[0].lastFrame == 9.0);
  const std::vector<double> frames{1.0, 2.0, 5.0, 9.0, 10.0};
  const std::vector<KeyValues> values = sampleRow(document, 0, lengthRow, frames, {});
  REQUIRE(values.size() == 5);
  for (const std::size_t outside : {0U, 1U, 3U, 4U}) {
    CHECK(values[outside][0] == Approx(1.0));
  }
  CHECK(values[2][0] == Approx(0.25));
  CHECK(readRow(test::boxer(), 0, lengthRow).components == 1);
  CHECK(readRow(withFistKeys(), 0, fistRow).components == 6);
  const Document bent = made(setKeySlope(document, 0, lengthRow, {0, 1U}, TangentSide::both, 0.125)).document;
  CHECK(offsetKeys(bent)[0].valueSlope == 0.125);
  CHECK(offsetKeys(bent)[0].moveSlope == Vec3(0.0));
  CHECK(offsetKeys(bent)[0].turnSlope == Vec3(0.0));
  CHECK(offsetKeys(bent)[0].interpolation == rig::KeyInterpolation::free);
}

TEST_CASE("Drawn slopes of an offset key are kept as they are shown, moves in lengths and turns in degrees",
          "[keys]") {
  for (std::size_t component = 0; component < 6; ++component) {
    CAPTURE(component);
    const PickedKey key{1, 1U << component};
    const Document bent =
        made(setKeySlope(withFistKeys(), 0, fistRow, key, TangentSide::both, 0.25)).document;
    const rig::OffsetKey offset = offsetKeys(bent)[1];
    Vec3 move(0.01, 0.0, 0.0); // The curve rises by a hundredth each frame.
    Vec3 turn(0.0);
    const auto place = static_cast<glm::length_t>(component % 3);
    (component < 3 ? move[place] : turn[place]) = component < 3 ? 0.25 : 0.25 / radian;
    CHECK(glm::length(offset.moveSlope - move) < 1e-5);
    CHECK(glm::length(offset.turnSlope - turn) < 1e-6);
    CHECK(offset.interpolation == rig::KeyInterpolation::free);
  }
}

TEST_CASE("An offset key that is made free goes on as the curve ran, and one that is free keeps its slopes",
          "[keys]") {
  const Document start = withFistKeys();
  const Document free = made(setKeyKind(start, 0, keyOf(fistRow, 1), rig::KeyInterpolation::free)).document;
  CHECK(offsetKeys(free)[1].moveSlope.x == Approx(0.01).epsilon(1e-3));
  CHECK(offsetKeys(free)[0] == offsetKeys(start)[0]);
  const Document drawn = made(setKeySlope(free, 0, fistRow, {1, 1U}, TangentSide::both, -0.3)).document;
  const Document again = made(setKeyKind(drawn, 0, keyOf(fistRow, 1), rig::KeyInterpolation::free)).document;
  CHECK(sameDocument(again, drawn));
  for (const rig::KeyInterpolation kind :
       {rig::KeyInterpolation::flat, rig::KeyInterpolation::linear, rig::KeyInterpolation::stepped,
        rig::KeyInterpolation::automatic}) {
    const Document other = made(setKeyKind(drawn, 0, keyOf(fistRow, 1), kind)).document;
    CHECK(offsetKeys(other)[1].interpolation == kind);
    CHECK(offsetKeys(other)[1].move.x == 0.08);
  }
}

TEST_CASE(
    "A track of the clip is made of steps and of lines again, and the keys of a curve one by one level, "
    "straight or smooth",
    "[keys]") {
  const Document start = test::boxer();
  const std::vector<KeyRow> rows{punchRow};
  const KeySelection all = allKeys(start, 0, rows);
  const Document steps = made(setKeyKind(start, 0, all, rig::KeyInterpolation::stepped)).document;
  CHECK(readRow(steps, 0, punchRow).interpolation == Interpolation::step);
  for (const rig::KeyInterpolation kind :
       {rig::KeyInterpolation::linear, rig::KeyInterpolation::flat, rig::KeyInterpolation::automatic}) {
    const Result<EditedKeys> one = setKeyKind(steps, 0, keyOf(punchRow, 1), kind);
    CHECK(test::refusal(one) == "a track of the clip steps as a whole; pick all of its keys");
  }
  CHECK(sameDocument(made(setKeyKind(steps, 0, keyOf(punchRow, 1), rig::KeyInterpolation::stepped)).document,
                     steps));
  CHECK(sameDocument(made(setKeyKind(steps, 0, all, rig::KeyInterpolation::linear)).document, start));
  // One key that is made straight leaves a straight track as it is.
  CHECK(sameDocument(made(setKeyKind(start, 0, keyOf(punchRow, 1), rig::KeyInterpolation::linear)).document,
                     start));
  const Document level = made(setKeyKind(start, 0, all, rig::KeyInterpolation::flat)).document;
  const KeyedRow levelRow = readRow(level, 0, punchRow);
  CHECK(levelRow.interpolation == Interpolation::cubicSpline);
  for (const RowKey& key : levelRow.keys) {
    CHECK(key.inSlopes[1] == Approx(0.0).margin(1e-3));
    CHECK(key.outSlopes[1] == Approx(0.0).margin(1e-3));
  }
  const Document straight =
      made(setKeyKind(level, 0, keyOf(punchRow, 2), rig::KeyInterpolation::linear)).document;
  const KeyedRow row = readRow(straight, 0, punchRow);
  CHECK(row.interpolation == Interpolation::cubicSpline);
  CHECK(row.keys[2].inSlopes[1] == Approx(-1.0 * radian / 5.0).margin(0.02));
  CHECK(row.keys[2].outSlopes[1] == Approx(1.3 * radian / 10.0).margin(0.02));
  for (const std::size_t other : {0U, 1U, 3U}) {
    CHECK(row.keys[other].inSlopes[1] == Approx(0.0).margin(1e-3));
    CHECK(row.keys[other].outSlopes[1] == Approx(0.0).margin(1e-3));
  }
  // A curve whose keys are all made straight is a track of lines again.
  CHECK(sameDocument(made(setKeyKind(level, 0, all, rig::KeyInterpolation::linear)).document, start));
}

TEST_CASE("Keys that are moved together stay within the time of their row, and as far from each other",
          "[keys]") {
  const Document start = withFistKeys();
  const KeySelection outer{{fistRow, {{0}, {2}}}};
  CHECK(offsetFrames(made(moveKeys(start, 0, outer, {-10.0, 0.0})).document) ==
        std::vector<double>{2.0, 8.0, 10.0});
  CHECK(offsetFrames(made(moveKeys(start, 0, outer, {3.0, 0.0})).document) ==
        std::vector<double>{7.0, 8.0, 15.0});
  // The first comes to where the second stands, which gives way.
  const Document late = made(moveKeys(start, 0, outer, {10.0, 0.0})).document;
  CHECK(offsetFrames(late) == std::vector<double>{8.0, 16.0});
  CHECK(offsetKeys(late)[0].move.x == 0.04);
  CHECK(offsetKeys(late)[1].move.x == 0.12);
  // With a key of the clip that stands at its start nothing goes earlier.
  const KeySelection both{{punchRow, {{0}}}, {fistRow, {{1}}}};
  CHECK(offsetFrames(made(moveKeys(start, 0, both, {-3.0, 0.0})).document) ==
        std::vector<double>{4.0, 8.0, 12.0});
  CHECK(offsetFrames(made(moveKeys(start, 0, both, {3.0, 0.0})).document) ==
        std::vector<double>{4.0, 11.0, 12.0});
}

TEST_CASE("Keys of several rows are pasted as far from each other as they were copied, and in the way gives "
          "way",
          "[keys]") {
  const Document start = withFistKeys();
  const CopiedKeys copied = copyKeys(start, 0, {{punchRow, {{1}}}, {fistRow, {{1}}}});
  const EditedKeys pasted = made(pasteKeys(start, 0, copied, 6.0, {}));
  CHECK(offsetFrames(pasted.document) == std::vector<double>{4.0, 8.0, 9.0, 12.0});
  CHECK(offsetKeys(pasted.document)[2].move.x == Approx(0.08));
  const std::vector<double> frames = keyFramesOf(pasted.document, 0, punchRow);
  REQUIRE(frames.size() == 5);
  CHECK(frames[2] == Approx(6.0));
  CHECK(readRow(pasted.document, 0, punchRow).keys[2].values[1] == Approx(-0.4 * radian).margin(1e-3));
  // What finds no place is left out.
  const EditedKeys late = made(pasteKeys(start, 0, copied, 17.0, {}));
  CHECK(offsetFrames(late.document) == std::vector<double>{4.0, 8.0, 12.0});
  CHECK(keyFramesOf(late.document, 0, punchRow).size() == 5);
  CHECK(late.picked == keyOf(punchRow, 3));
  const CopiedKeys first = copyKeys(start, 0, keyOf(fistRow, 0));
  const Document onto = made(pasteKeys(start, 0, first, 8.0, {})).document;
  CHECK(offsetFrames(onto) == std::vector<double>{4.0, 8.0, 12.0});
  CHECK(offsetKeys(onto)[1].move.x == Approx(0.04));
  CHECK(test::refusal(pasteKeys(start, 0, first, 40.0, {})) ==
        "frame 40: nothing that was copied fits there; copy keys of this character, and paste inside the "
        "range of their controller");
}

TEST_CASE("A key is inserted where its row has time, on the curve, and passed as the key before it",
          "[keys]") {
  const Document start = withFistKeys();
  const std::vector<KeyRow> rows{fistRow};
  const Document between = made(insertKeys(start, 0, rows, 6.0)).document;
  CHECK(offsetFrames(between) == std::vector<double>{4.0, 6.0, 8.0, 12.0});
  CHECK(offsetKeys(between)[1].move.x == Approx(valuesAt(start, 0, fistRow, 6.0, {})[0]));
  CHECK(offsetKeys(between)[1].interpolation == rig::KeyInterpolation::free);
  CHECK(sameDocument(made(insertKeys(start, 0, rows, 8.0)).document, start));
  for (const double edge : {2.0, 16.0}) {
    CHECK(offsetKeys(made(insertKeys(start, 0, rows, edge)).document).size() == 4);
  }
  for (const auto& [outside, told] : {std::pair(1.0, "frame 1: "), std::pair(17.0, "frame 17: ")}) {
    CHECK(test::refusal(insertKeys(start, 0, rows, outside)) ==
          std::string(told) + "no key can stand there; offset keys are set by moving their controller, or "
                              "choose a frame of their range");
  }
  const std::vector<KeyRow> own{punchRow};
  CHECK_THAT(test::refusal(insertKeys(start, 0, own, -1.0)), Catch::StartsWith("frame -1: no key can stand"));
  const Document steps =
      made(setKeyKind(start, 0, keyOf(fistRow, 0), rig::KeyInterpolation::stepped)).document;
  const Document held = made(insertKeys(steps, 0, rows, 6.0)).document;
  CHECK(offsetKeys(held)[1].interpolation == rig::KeyInterpolation::stepped);
  CHECK(offsetKeys(held)[1].move.x == Approx(0.04));
  CHECK(offsetKeys(made(insertKeys(steps, 0, rows, 10.0)).document)[2].interpolation ==
        rig::KeyInterpolation::free);
}

TEST_CASE("Keys between two frames include those on both, and selections are joined key by key", "[keys]") {
  const Document document = withFistKeys();
  const std::vector<KeyRow> rows{punchRow, fistRow};
  CHECK(keysBetween(document, 0, rows, 5.0, 10.0) == KeySelection{{punchRow, {{1}, {2}}}, {fistRow, {{1}}}});
  CHECK(keysBetween(document, 0, rows, 5.01, 9.99) == KeySelection{{fistRow, {{1}}}});
  CHECK(keysBetween(document, 0, rows, 13.0, 19.0).empty());
  CHECK(keyCount(allKeys(document, 0, rows)) == 7);
  const KeySelection a{{punchRow, {{1, 1U}, {3, 1U}}}};
  const KeySelection b{{punchRow, {{0, 2U}, {1, 4U}, {2}}}, {fistRow, {{1}}}};
  CHECK(joined(a, b) == KeySelection{{punchRow, {{0, 2U}, {1, 5U}, {2}, {3, 1U}}}, {fistRow, {{1}}}});
  CHECK(joined({}, b) == b);
  CHECK(joined(b, {}) == b);
}

TEST_CASE("What is picked is called by its row, or by how many there are", "[keys]") {
  const Document document = withFistKeys();
  CHECK(selectionTitle(document, keyOf(fistRow, 1)) == "a key of left hand");
  CHECK(selectionTitle(document, {{punchRow, {{0}, {2}}}}) == "2 keys of LeftArm rotation");
  CHECK(selectionTitle(document, {{punchRow, {{0}, {2}}}, {fistRow, {{1}}}}) == "3 keys of 2 rows");
  CHECK(rowTitle(document, lengthRow) == "left arm stretch");
  CHECK(rowTitle(document, {NodeIndex(4), Channel::translation, {}}) == "LeftForeArm translation");
  CHECK(rowTitle(document, {NodeIndex(4), Channel::scale, {}}) == "LeftForeArm scale");
}

TEST_CASE("Every edit of keys asks for keys", "[keys]") {
  const Document document = test::boxer();
  const std::string told = "no key is picked; click a key in the graph, or draw a box around some";
  CHECK(test::refusal(moveKeys(document, 0, {}, {1.0, 0.0})) == told);
  CHECK(test::refusal(scaleKeys(document, 0, {}, {0.0, 2.0})) == told);
  CHECK(test::refusal(snapKeys(document, 0, {})) == told);
  CHECK(test::refusal(removeKeys(document, 0, {})) == told);
  CHECK(test::refusal(setKeyValue(document, 0, {}, 1.0)) == told);
  CHECK(test::refusal(setKeyKind(document, 0, {}, rig::KeyInterpolation::flat)) == told);
}

TEST_CASE("A key of the clip that is a thousand heights away is refused, one beside that is not", "[keys]") {
  const std::vector<KeyRow> rows{{NodeIndex(4), Channel::translation, {}}};
  const Document keyed = made(insertKeys(test::boxer(), 0, rows, 5.0)).document;
  const auto placed = [&](double value) { return setKeyValue(keyed, 0, keyOf(rows.front(), 0, 2U), value); };
  const std::string far = "LeftForeArm: a key is out of proportion; keep it within a thousand heights of the "
                          "character and a day";
  CHECK(made(placed(1799.0)).picked.size() == 1); // The boxer is 1.8 high.
  CHECK(made(placed(-1799.0)).picked.size() == 1);
  CHECK(test::refusal(placed(1801.0)) == far);
  CHECK(test::refusal(placed(-1801.0)) == far);
  const std::vector<KeyRow> sizes{{NodeIndex(4), Channel::scale, {}}};
  const Document sized = made(insertKeys(test::boxer(), 0, sizes, 5.0)).document;
  CHECK(made(setKeyValue(sized, 0, keyOf(sizes.front(), 0, 2U), 999.0)).picked.size() == 1);
  CHECK(test::refusal(setKeyValue(sized, 0, keyOf(sizes.front(), 0, 2U), 1001.0)) == far);
}

TEST_CASE("Keys stay picked after an edit as far as they are still there, and none of another clip's",
          "[keys]") {
  Document fewer = withFistKeys();
  fewer.adjustments.front().keys.resize(2);
  Document none = fewer;
  none.adjustments.clear();
  const PickedRow arm{punchRow, {{0, ~0U}, {3, ~0U}}};
  const auto left = [&](const Document& edited, int pickedClip) {
    Session session(withFistKeys());
    session.view().pickedKeys = {arm, {fistRow, {{0, 1U}, {1, ~0U}, {2, ~0U}}}};
    session.view().pickedClip = pickedClip;
    session.edit(edited, "Delete keys");
    return session.view().pickedKeys;
  };
  CHECK(left(withFistKeys(), 0) == KeySelection{arm, {fistRow, {{0, 1U}, {1, ~0U}, {2, ~0U}}}});
  CHECK(left(fewer, 0) == KeySelection{arm, {fistRow, {{0, 1U}, {1, ~0U}}}});
  CHECK(left(none, 0) == KeySelection{arm});
  CHECK(left(fewer, 1).empty());
  // What undo takes away is picked no longer, and does not come back with redo.
  Session session(none);
  session.edit(fewer, "Pose");
  session.view().pickedKeys = keyOf(fistRow, 1);
  session.undo();
  CHECK(session.view().pickedKeys.empty());
  session.redo();
  CHECK(session.view().pickedKeys.empty());
}

TEST_CASE("Of a key that was picked in a part the rest stays as the curve has it where it is pasted") {
  const Document start = withFistKeys();
  const CopiedKeys copied = copyKeys(start, 0, keyOf(fistRow, 0, 0b10U));
  for (const double frame : {8.0, 14.0}) {
    CAPTURE(frame);
    const double before = valuesAt(start, 0, fistRow, frame, {})[0];
    const EditedKeys pasted = made(pasteKeys(start, 0, copied, frame, {}));
    CHECK(valuesAt(pasted.document, 0, fistRow, frame, {})[0] == Approx(before));
    CHECK(pasted.picked.front().keys.front().components == 0b10U);
  }
  const CopiedKeys whole = copyKeys(start, 0, keyOf(fistRow, 0));
  CHECK(valuesAt(made(pasteKeys(start, 0, whole, 14.0, {})).document, 0, fistRow, 14.0, {})[0] ==
        Approx(0.04));
}

TEST_CASE("A part of a key that is pasted takes its own slopes along, the rest follows as it did") {
  const Document start =
      made(setKeyKind(test::boxer(), 0, keyOf(punchRow, 1), rig::KeyInterpolation::automatic)).document;
  const auto followingAt = [](const Document& document, std::size_t key) {
    return readRow(document, 0, punchRow).keys.at(key).following;
  };
  REQUIRE(followingAt(start, 1) == 0b111U);
  REQUIRE(followingAt(start, 2) == 0U);
  const CopiedKeys still = copyKeys(start, 0, keyOf(punchRow, 2, 0b100U));
  CHECK(followingAt(made(pasteKeys(start, 0, still, 5.0, {})).document, 1) == 0b011U);
  const CopiedKeys smooth = copyKeys(start, 0, keyOf(punchRow, 1, 0b100U));
  CHECK(followingAt(made(pasteKeys(start, 0, smooth, 10.0, {})).document, 2) == 0b100U);
}

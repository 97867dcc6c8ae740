#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "app/edits/pose/adjustment_edits.h"
#include "app/edits/pose/offset_edits.h"
#include "app/evaluate/evaluate.h"
#include "app/history.h"
#include "core/math/rotation.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

const std::vector<std::string> hipsAlone{"hips"};

/// The hips moved up by a number at a frame.
Document hipsAt(const Document& document, double frame, double up, const KeyRange& range = {}) {
  const std::vector<ControllerOffset> offsets{{"hips", {0.0, up, 0.0}, {}}};
  const Result<Document> changed = setOffsets(document, 0, frame, offsets, {}, range);
  REQUIRE(changed);
  return *changed;
}

double hipsUp(const Document& document, double frame) {
  return offsetAt(document, 0, frame, "hips").move.y;
}

} // namespace

TEST_CASE("A first key in a range acts there alone and runs out at the range's ends") {
  const Document document = hipsAt(test::boxer(), 8.0, -0.2, {Vec2(4.0, 12.0)});
  CHECK(hipsUp(document, 8.0) == Approx(-0.2));
  CHECK(hipsUp(document, 6.0) < -0.05);
  CHECK(hipsUp(document, 4.0) == 0.0);
  CHECK(hipsUp(document, 12.0) == 0.0);
  CHECK(hipsUp(document, 13.0) == 0.0);
}

TEST_CASE("A first key on the whole clip is held to both of its ends") {
  const Document document = hipsAt(test::boxer(), 8.0, -0.2);
  CHECK(hipsUp(document, 0.0) == Approx(-0.2));
  CHECK(hipsUp(document, 20.0) == Approx(-0.2));
}

TEST_CASE("A key inside what is adjusted already joins it, whatever range was asked for") {
  Document document = hipsAt(test::boxer(), 8.0, -0.2, {Vec2(4.0, 12.0)});
  document = hipsAt(document, 10.0, 0.1, {Vec2(9.0, 20.0)});
  REQUIRE(document.adjustments.size() == 1);
  CHECK(document.adjustments.front().keys.size() == 2);
  CHECK(document.adjustments.front().rangeFrames == Vec2(4.0, 12.0));
  CHECK(hipsUp(document, 10.0) == Approx(0.1));
}

TEST_CASE("A key where one stands takes its place and is passed as it was") {
  Document document = hipsAt(test::boxer(), 8.0, -0.2);
  document = setKeyInterpolation(document, 0, 8.0, hipsAlone, rig::KeyInterpolation::stepped);
  document = hipsAt(document, 8.0, 0.3);
  REQUIRE(document.adjustments.front().keys.size() == 1);
  CHECK(document.adjustments.front().keys.front().interpolation == rig::KeyInterpolation::stepped);
  CHECK(hipsUp(document, 8.0) == Approx(0.3));
}

TEST_CASE("Beside another adjustment a key has the room that is left") {
  Document document = hipsAt(test::boxer(), 8.0, -0.2, {Vec2(4.0, 12.0)});
  SECTION("a range is cut") {
    document = hipsAt(document, 14.0, 0.1, {Vec2(2.0, 18.0)});
    CHECK(offsetKeyAt(document, 0, 14.0, "hips") != nullptr);
    CHECK(adjustmentAt(document, 0, 14.0, "hips")->rangeFrames == Vec2(12.0, 18.0));
  }
  SECTION("on the whole clip it is held to the clip's end") {
    document = hipsAt(document, 14.0, 0.1);
    CHECK(hipsUp(document, 20.0) == Approx(0.1));
    CHECK(hipsUp(document, 12.0) == Approx(0.0));
  }
  CHECK(document.adjustments.size() == 2);
  CHECK(hipsUp(document, 8.0) == Approx(-0.2));
  CHECK(hipsUp(document, 10.0) < 0.0);
}

TEST_CASE("What cannot be keyed is refused with its reason, and nothing is changed") {
  Document document = test::boxer();
  // Joints of no limb turn alone.
  std::erase_if(document.body.limbs, [](const rig::Limb& limb) { return limb.id == "right-arm"; });
  const double never = std::numeric_limits<double>::quiet_NaN();
  const auto reason = [&](double frame, const ControllerOffset& offset, const KeyRange& range = {}) {
    return test::refusal(setOffsets(document, 0, frame, {&offset, 1}, {}, range));
  };
  CHECK_THAT(reason(15.0, {"hips", {}, {}}, {Vec2(4.0, 12.0)}),
             Catch::StartsWith("hips: frame 15 lies outside of the range 4 to 12"));
  CHECK_THAT(reason(8.0, {"tail", {}, {}}), Catch::Contains("has no controller 'tail'"));
  const std::string far = "hips: the offset at frame 8 is out of proportion";
  CHECK_THAT(reason(8.0, {"hips", {1e9, 0.0, 0.0}, {}}), Catch::StartsWith(far));
  CHECK_THAT(reason(8.0, {"hips", {}, {700.0, 0.0, 0.0}}), Catch::StartsWith(far));
  const std::string noNumber = "hips: a number of a key is not finite";
  CHECK_THAT(reason(8.0, {"hips", {never, 0.0, 0.0}, {}}), Catch::StartsWith(noNumber));
  CHECK_THAT(reason(never, {"hips", {}, {}}), Catch::StartsWith(noNumber));
  CHECK_THAT(reason(8.0, {"left-elbow", {}, {0.5, 0.0, 0.0}}),
             Catch::StartsWith("left-elbow: moves and does not turn"));
  CHECK_THAT(reason(8.0, {"RightForeArm", {0.5, 0.0, 0.0}, {}}),
             Catch::StartsWith("RightForeArm: turns and does not move"));
  CHECK_THAT(test::refusal(setOffsets(document, 7, 0.0, {}, {}, {})),
             Catch::StartsWith("clip 7: the file has no such clip"));
  const std::vector<AttributeValue> much{{"left-arm.stretch", 1001.0}};
  CHECK_THAT(test::refusal(setOffsets(document, 0, 8.0, {}, much, {})),
             Catch::StartsWith("left-arm.stretch: the value at frame 8 is out of proportion"));
  const std::vector<ControllerOffset> oneIsWrong{{"hips", {0.0, 0.1, 0.0}, {}}, {"tail", {}, {}}};
  CHECK_THAT(test::refusal(setOffsets(document, 0, 8.0, oneIsWrong, {}, {})), Catch::Contains("'tail'"));
}

TEST_CASE("What is keyed is where the character stands at that frame") {
  const Document start = test::boxer();
  const std::vector<ControllerOffset> offsets{{"hips", {0.05, -0.1, 0.02}, {0.0, 0.4, 0.0}}};
  const Result<Document> keyed = setOffsets(start, 0, 5.0, offsets, {}, {Vec2(2.0, 9.0)});
  REQUIRE(keyed);
  const auto hips = [](const Document& document, double frame) {
    const double seconds = frame / clipOf(document, 0).framesPerSecond;
    return evaluate(document, prepareMotion(document, 0), seconds).worlds[at(document.body.hips)];
  };
  const Mat4 moved = hips(*keyed, 5.0);
  const Mat4 source = hips(start, 5.0);
  CHECK(glm::length(positionOf(moved) - positionOf(source) - offsets[0].move) < 1e-6);
  const Quat turn = rotationOf(moved) * glm::inverse(rotationOf(source));
  CHECK(2.0 * std::atan2(turn.y, turn.w) == Approx(0.4).margin(1e-6));
  for (const double outside : {1.0, 10.0}) {
    CHECK(hips(*keyed, outside) == hips(start, outside));
  }
}

TEST_CASE("Several controllers and attributes are one step that undo takes back and redo brings") {
  const Document start = test::boxer();
  History<Document> history(start);
  const std::vector<ControllerOffset> offsets{{"hips", {0.0, -0.1, 0.0}, {0.0, 0.4, 0.0}},
                                              {"left-hand", {0.1, 0.0, 0.0}, {}}};
  const std::vector<AttributeValue> values{{"left-arm.stretch", 0.25}};
  const Result<Document> keyed = setOffsets(start, 0, 5.0, offsets, values, {Vec2(2.0, 9.0)});
  REQUIRE(keyed);
  history.push(*keyed, "Pose");
  CHECK(offsetAt(history.current(), 0, 5.0, "hips") == offsets[0]);
  CHECK(offsetAt(history.current(), 0, 5.0, "left-hand") == offsets[1]);
  CHECK(valueAt(history.current(), 0, 5.0, "left-arm.stretch") == Approx(0.25));
  CHECK(valueAt(history.current(), 0, 1.0, "left-arm.stretch") == 1.0);
  REQUIRE(history.undo());
  CHECK(sameDocument(history.current(), start));
  REQUIRE(history.redo());
  CHECK(sameDocument(history.current(), *keyed));
}

TEST_CASE("A key that is taken away leaves the others, the last one takes its adjustment along") {
  Document document = hipsAt(hipsAt(test::boxer(), 8.0, -0.2), 12.0, 0.1);
  document = removeOffsetKeys(document, 0, 8.0, hipsAlone);
  CHECK(hipsUp(document, 8.0) == Approx(0.1));
  document = removeOffsetKeys(document, 0, 12.0, hipsAlone);
  CHECK(document.adjustments.empty());
  CHECK(sameDocument(removeOffsetKeys(document, 0, 12.0, hipsAlone), document));
}

TEST_CASE("Reset at a frame leaves nothing offset there and the other keys in place") {
  const Document document = hipsAt(hipsAt(test::boxer(), 4.0, -0.2), 12.0, 0.1);
  for (const double frame : {8.0, 12.0}) {
    const Result<Document> reset = resetOffsets(document, 0, frame, hipsAlone);
    REQUIRE(reset);
    CHECK(hipsUp(*reset, frame) == 0.0);
    CHECK(hipsUp(*reset, 4.0) == Approx(-0.2));
  }
  const Result<Document> alone = resetOffsets(hipsAt(test::boxer(), 4.0, -0.2), 0, 4.0, hipsAlone);
  REQUIRE(alone);
  CHECK(alone->adjustments.empty());
}

TEST_CASE("Reset over a range clears it and keeps what is keyed outside") {
  Document document = hipsAt(hipsAt(test::boxer(), 2.0, -0.2), 10.0, 0.1);
  document = hipsAt(document, 18.0, 0.4);
  const Result<Document> reset = resetOffsetsOver(document, 0, {6.0, 14.0}, hipsAlone);
  REQUIRE(reset);
  for (const double frame : {6.0, 10.0, 14.0}) {
    CHECK(hipsUp(*reset, frame) == 0.0);
  }
  CHECK(hipsUp(*reset, 2.0) == Approx(-0.2));
  CHECK(hipsUp(*reset, 18.0) == Approx(0.4));
}

TEST_CASE("A key that becomes free keeps the curve's slope") {
  Document document = hipsAt(hipsAt(hipsAt(test::boxer(), 2.0, 0.0), 8.0, 0.1), 14.0, 0.3);
  const double before = hipsUp(document, 9.0);
  document = setKeyInterpolation(document, 0, 8.0, hipsAlone, rig::KeyInterpolation::free);
  CHECK(offsetKeyAt(document, 0, 8.0, "hips")->moveSlope.y > 0.01);
  CHECK(hipsUp(document, 9.0) == Approx(before).margin(1e-5));
}

TEST_CASE("A range is given to what is adjusted, unless it leaves a key out or reaches another one") {
  Document document = hipsAt(test::boxer(), 8.0, -0.2);
  const Result<Document> local = setOffsetRange(document, 0, 8.0, hipsAlone, {Vec2(4.0, 12.0)});
  REQUIRE(local);
  CHECK(hipsUp(*local, 4.0) == 0.0);
  CHECK_THAT(test::refusal(setOffsetRange(*local, 0, 8.0, hipsAlone, {Vec2(9.0, 12.0)})),
             Catch::StartsWith("hips: the key at frame 8 lies outside of 9 to 12"));
  const Document two = hipsAt(*local, 15.0, 0.1, {Vec2(13.0, 18.0)});
  CHECK_THAT(test::refusal(setOffsetRange(two, 0, 8.0, hipsAlone, {})),
             Catch::StartsWith("hips: another adjustment stands in the way"));
  const Result<Document> whole = setOffsetRange(*local, 0, 8.0, hipsAlone, {});
  REQUIRE(whole);
  CHECK(hipsUp(*whole, 20.0) == Approx(-0.2));
}

namespace {

/// Linear keys of the hips, or of an attribute: moved up, turned by half as much, and the value.
rig::Adjustment linearKeys(const std::string& id, const std::vector<std::pair<double, double>>& keys,
                           const std::optional<Vec2>& range, int clip = 0) {
  rig::Adjustment adjustment{id, clip, range, {}};
  for (const auto& [frame, number] : keys) {
    rig::OffsetKey key;
    key.frame = frame;
    key.move = Vec3(0.0, number, 0.0);
    key.turn = Vec3(0.0, 0.0, 0.5 * number);
    key.value = number;
    key.interpolation = rig::KeyInterpolation::linear;
    adjustment.keys.push_back(key);
  }
  return adjustment;
}

} // namespace

TEST_CASE("What is keyed in one clip neither acts in another one nor takes room there") {
  Document document = test::boxer();
  document.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>(2, document.clips->front()));
  const rig::Adjustment other = linearKeys("hips", {{8.0, 0.3}}, Vec2(4.0, 12.0), 1);
  document.adjustments = {other};
  CHECK(adjustmentAt(document, 0, 8.0, "hips") == nullptr);
  CHECK(hipsUp(document, 8.0) == 0.0);
  CHECK(adjustedIds(document, 0).empty());
  CHECK(adjustedIds(document, 1) == hipsAlone);
  const Document ranged = hipsAt(document, 14.0, 0.1, {Vec2(2.0, 18.0)});
  CHECK(adjustmentAt(ranged, 0, 14.0, "hips")->rangeFrames == Vec2(2.0, 18.0));
  const Result<Document> whole = setOffsetRange(ranged, 0, 14.0, hipsAlone, {});
  REQUIRE(whole);
  CHECK_FALSE(adjustmentAt(*whole, 0, 14.0, "hips")->rangeFrames);
  const Result<Document> reset = resetOffsetsOver(ranged, 0, {0.0, 20.0}, hipsAlone);
  REQUIRE(reset);
  CHECK(reset->adjustments == std::vector<rig::Adjustment>{other});
}

TEST_CASE("Where two ranges meet the one with a key there is meant, else the first") {
  const rig::Adjustment early = linearKeys("hips", {{8.0, 0.1}}, Vec2(4.0, 12.0));
  const rig::Adjustment late = linearKeys("hips", {{12.0, 0.3}, {15.0, 0.2}}, Vec2(12.0, 18.0));
  Document document = test::boxer();
  for (const std::vector<rig::Adjustment>& order : {std::vector{early, late}, {late, early}}) {
    document.adjustments = order;
    REQUIRE(adjustmentAt(document, 0, 12.0, "hips") != nullptr);
    CHECK(*adjustmentAt(document, 0, 12.0, "hips") == late);
    CHECK(hipsUp(document, 12.0) == Approx(0.3));
    document.adjustments[0].keys.front().frame += 1.0;
    document.adjustments[1].keys.front().frame += 1.0;
    CHECK(adjustmentAt(document, 0, 12.0, "hips") == document.adjustments.data());
  }
}

TEST_CASE("Before another adjustment a key on the whole clip is held from the clip's start") {
  const Document document = hipsAt(hipsAt(test::boxer(), 8.0, -0.2, {Vec2(4.0, 12.0)}), 2.0, 0.1);
  REQUIRE(document.adjustments.size() == 2);
  CHECK(adjustmentAt(document, 0, 2.0, "hips")->rangeFrames == Vec2(0.0, 4.0));
  CHECK(hipsUp(document, 0.0) == Approx(0.1));
  CHECK(hipsUp(document, 2.0) == Approx(0.1));
  CHECK(hipsUp(document, 4.0) == Approx(0.0).margin(1e-12));
}

TEST_CASE("A turn alone and a value alone are taken back as a move is, at a frame and over frames") {
  Document document = test::boxer();
  document.adjustments = {
      linearKeys("hips", {{4.0, 0.4}, {8.0, 0.4}, {12.0, 0.4}}, std::nullopt),
      linearKeys("left-arm.stretch", {{4.0, 0.5}, {8.0, 0.5}, {12.0, 0.5}}, std::nullopt)};
  for (rig::OffsetKey& key : document.adjustments[0].keys) {
    key.move = Vec3(0.0);
    key.value = 0.0;
  }
  for (rig::OffsetKey& key : document.adjustments[1].keys) {
    key.move = key.turn = Vec3(0.0);
  }
  const std::vector<std::string> both{"hips", "left-arm.stretch"};
  const auto turnAt = [](const Document& of, double frame) { return offsetAt(of, 0, frame, "hips").turn.z; };
  const auto stretchAt = [](const Document& of, double frame) {
    return valueAt(of, 0, frame, "left-arm.stretch");
  };
  REQUIRE(turnAt(document, 6.0) == Approx(0.2));
  const Result<Document> there = resetOffsets(document, 0, 6.0, both);
  REQUIRE(there);
  CHECK(turnAt(*there, 6.0) == 0.0);
  CHECK(stretchAt(*there, 6.0) == 1.0);
  const Result<Document> between = resetOffsetsOver(document, 0, {6.0, 10.0}, both);
  REQUIRE(between);
  for (const double frame : {6.0, 8.0, 10.0}) {
    CHECK(turnAt(*between, frame) == 0.0);
    CHECK(stretchAt(*between, frame) == Approx(1.0));
  }
  for (const Document& changed : {*there, *between}) {
    CHECK(turnAt(changed, 12.0) == Approx(0.2));
    CHECK(stretchAt(changed, 4.0) == Approx(0.5));
  }
}

TEST_CASE("A key at an end of its range becomes free with the slope that the range has there") {
  Document document = test::boxer();
  document.adjustments = {
      linearKeys("hips", {{4.0, 0.4}, {8.0, 0.0}, {12.0, 0.4}}, Vec2(4.0, 12.0)),
      linearKeys("left-arm.stretch", {{4.0, 0.2}, {8.0, 0.6}, {12.0, 1.0}}, std::nullopt)};
  for (const auto& [frame, slope] : {std::pair(4.0, -0.1), std::pair(12.0, 0.1)}) {
    const Document free = setKeyInterpolation(document, 0, frame, hipsAlone, rig::KeyInterpolation::free);
    const rig::OffsetKey* const key = offsetKeyAt(free, 0, frame, "hips");
    REQUIRE(key != nullptr);
    CHECK(key->interpolation == rig::KeyInterpolation::free);
    CHECK(glm::length(key->moveSlope - Vec3(0.0, slope, 0.0)) < 1e-6);
    CHECK(glm::length(key->turnSlope - Vec3(0.0, 0.0, 0.5 * slope)) < 1e-6);
  }
  const std::vector<std::string> stretch{"left-arm.stretch"};
  const Document free = setKeyInterpolation(document, 0, 8.0, stretch, rig::KeyInterpolation::free);
  CHECK(offsetKeyAt(free, 0, 8.0, "left-arm.stretch")->valueSlope == Approx(0.1).epsilon(1e-6));
}

TEST_CASE("A range may come up to the next one of its controller, from either side") {
  Document document = test::boxer();
  document.adjustments = {linearKeys("hips", {{6.0, 0.1}}, Vec2(4.0, 8.0)),
                          linearKeys("hips", {{14.0, 0.3}}, Vec2(12.0, 18.0))};
  const Result<Document> later = setOffsetRange(document, 0, 6.0, hipsAlone, {Vec2(4.0, 12.0)});
  REQUIRE(later);
  CHECK(adjustmentAt(*later, 0, 6.0, "hips")->rangeFrames == Vec2(4.0, 12.0));
  const Result<Document> earlier = setOffsetRange(document, 0, 14.0, hipsAlone, {Vec2(8.0, 18.0)});
  REQUIRE(earlier);
  CHECK(adjustmentAt(*earlier, 0, 14.0, "hips")->rangeFrames == Vec2(8.0, 18.0));
  CHECK_FALSE(setOffsetRange(document, 0, 6.0, hipsAlone, {Vec2(4.0, 12.5)}));
}

// Keys that are put into rows of several pieces, and work that stands past the end of a clip.
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/commands/table/past_end.h"
#include "app/edits/keys/key_edits.h"
#include "tests/support/app/boxer.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;

namespace {

rig::Adjustment handOver(const std::optional<Vec2>& range,
                         const std::vector<std::pair<double, double>>& keys) {
  rig::Adjustment hand{"left-hand", 0, range, {}};
  for (const auto& [frame, move] : keys) {
    rig::OffsetKey key;
    key.frame = frame;
    key.move = Vec3(move, 0.0, 0.0);
    key.interpolation = rig::KeyInterpolation::linear;
    hand.keys.push_back(key);
  }
  return hand;
}

} // namespace

TEST_CASE("A key is put into the piece of a row that acts at its frame, and none where no piece does") {
  Document start = test::boxer();
  start.adjustments = {handOver(Vec2(0.0, 6.0), {{1.0, 0.1}, {5.0, 0.3}}),
                       handOver(Vec2(8.0, 12.0), {{9.0, 0.5}, {11.0, 0.9}}),
                       handOver(Vec2(14.0, 20.0), {{15.0, 0.2}, {19.0, 0.4}})};
  const std::vector<KeyRow> rows{{{}, Channel::translation, "left-hand"}};
  for (const auto& [frame, piece, move] : {std::tuple(3.0, 0U, 0.2), {10.0, 1U, 0.7}, {16.0, 2U, 0.25}}) {
    CAPTURE(frame);
    const Result<EditedKeys> made = insertKeys(start, 0, rows, frame);
    REQUIRE(made);
    REQUIRE(made->document.adjustments.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(made->document.adjustments[i].keys.size() == (i == piece ? 3U : 2U));
      CHECK(made->document.adjustments[i].rangeFrames == start.adjustments[i].rangeFrames);
    }
    CHECK(made->document.adjustments[piece].keys[1].frame == frame);
    CHECK(made->document.adjustments[piece].keys[1].move.x == Approx(move));
  }
  CHECK_THAT(test::refusal(insertKeys(start, 0, rows, 7.0)), Catch::Contains("no key can stand there"));
  CHECK_THAT(test::refusal(insertKeys(start, 0, rows, -1.0)), Catch::Contains("no key can stand there"));
}

TEST_CASE(
    "What stands past the end of a clip is told with its range, or with its keys where that is all of it") {
  Document document = test::boxer(); // frames 0 to 20
  document.adjustments = {handOver(std::nullopt, {{2.0, 0.1}, {30.0, 0.1}})};
  CHECK(standingPastEnd(document, 0) == std::vector<std::string>{"offsets of left hand (2 to 30)"});
  document.adjustments = {handOver(Vec2(4.0, 24.0), {{5.0, 0.1}, {6.0, 0.1}})};
  CHECK(standingPastEnd(document, 0) == std::vector<std::string>{"offsets of left hand (4 to 24)"});
  document.adjustments = {handOver(std::nullopt, {{2.0, 0.1}, {20.0, 0.1}})};
  CHECK(standingPastEnd(document, 0).empty());
  document.adjustments = {handOver(std::nullopt, {{2.0, 0.1}, {30.0, 0.1}})};
  document.adjustments.front().clip = 1; // which is longer
  CHECK(standingPastEnd(document, 0).empty());
}

TEST_CASE("Keys of several pieces are one row in the order of time, however the pieces are listed") {
  Document document = test::boxer();
  document.adjustments = {handOver(Vec2(14.0, 20.0), {{15.0, 0.2}, {19.0, 0.4}}),
                          handOver(Vec2(0.0, 6.0), {{1.0, 0.1}, {5.0, 0.3}})};
  const std::vector<KeyRow> rows{{{}, Channel::translation, "left-hand"}};
  CHECK(keyFramesOf(document, 0, rows.front()) == std::vector<double>{1.0, 5.0, 15.0, 19.0});
  const KeySelection middle = keysBetween(document, 0, rows, 4.0, 16.0);
  CHECK(middle == KeySelection{{rows.front(), {{1}, {2}}}});
  const Result<EditedKeys> moved = moveKeys(document, 0, middle, {0.5, 0.0});
  REQUIRE(moved);
  CHECK(moved->document.adjustments[0].keys.front().frame == 15.5);
  CHECK(moved->document.adjustments[0].keys.front().move.x == Approx(0.2));
  CHECK(moved->document.adjustments[1].keys.back().frame == 5.5);
  CHECK(moved->document.adjustments[1].keys.back().move.x == Approx(0.3));
}

TEST_CASE("Keys on the whole clip are moved as far as its first and its last frame") {
  Document document = test::boxer(); // frames 0 to 20
  document.adjustments = {handOver(std::nullopt, {{4.0, 0.1}, {8.0, 0.2}})};
  const std::vector<KeyRow> rows{{{}, Channel::translation, "left-hand"}};
  for (const auto& [by, first] : {std::pair(100.0, 16.0), std::pair(-100.0, 0.0)}) {
    const Result<EditedKeys> moved = moveKeys(document, 0, allKeys(document, 0, rows), {by, 0.0});
    REQUIRE(moved);
    CHECK(keyFramesOf(moved->document, 0, rows.front()) == std::vector<double>{first, first + 4.0});
  }
}

TEST_CASE("A joint without keys gets its first turn and its first size as it rests") {
  Document document = test::boxer();
  Scene scene = *document.scene;
  scene.nodes[6].rest.rotation = Quat(0.8, 0.0, 0.0, 0.6);
  scene.nodes[6].rest.scale = Vec3(1.5, 2.0, 0.5);
  document.scene = std::make_shared<const Scene>(std::move(scene));
  const auto firstValues = [&](Channel channel) {
    const KeyRow row{NodeIndex(6), channel, {}};
    const Result<EditedKeys> made = insertKeys(document, 0, std::vector<KeyRow>{row}, 5.0);
    REQUIRE(made);
    const Clip& clip = clipOf(made->document, 0);
    const int track = findTrack(clip, row.node, channel);
    REQUIRE(track >= 0);
    return clip.tracks[static_cast<std::size_t>(track)]->values;
  };
  CHECK(firstValues(Channel::scale) == std::vector<float>{1.5F, 2.0F, 0.5F});
  CHECK(firstValues(Channel::translation) == std::vector<float>{-0.2F, 0.1F, 0.0F});
  const std::vector<float> turn = firstValues(Channel::rotation); // x, y, z, w
  REQUIRE(turn.size() == 4);
  CHECK(turn[2] == Approx(0.6));
  CHECK(turn[3] == Approx(0.8));
}

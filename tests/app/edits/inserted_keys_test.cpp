// Keys that are put into rows of several pieces, and work that stands past the end of a clip.
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
}

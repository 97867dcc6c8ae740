#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/edits/keys/key_edits.h"
#include "app/edits/keys/track_edits.h"
#include "app/edits/pose/adjustment_edits.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

const KeyRow scaledElbowRow{NodeIndex(4), Channel::translation, {}};
const KeyRow scaledHandRow{NodeIndex::none, Channel::translation, "left-hand"};

// Cubic keys at the frames 0, 10 and 20 whose slopes differ on every side of every key and in every
// component.
Document withScaledSlopes() {
  const Document start = test::boxer();
  Track track;
  track.node = scaledElbowRow.node;
  track.channel = Channel::translation;
  track.width = 3;
  track.interpolation = Interpolation::cubicSpline;
  for (int key = 0; key < 3; ++key) {
    const auto number = static_cast<float>(key);
    track.times.push_back(number / 3.0F);
    for (const float first : {1.0F + number, 0.1F * number, -2.0F + number}) { // in, value, out
      track.values.insert(track.values.end(), {first, first + 0.25F, first - 0.5F});
    }
  }
  return setTracks(start, 0, {track});
}

EditedKeys edited(const Result<EditedKeys>& result) {
  INFO((result ? std::string() : result.error().line()));
  REQUIRE(result);
  return *result;
}

KeySelection picked(const KeyRow& row, const std::vector<int>& keys, unsigned components = ~0U) {
  PickedRow selection{row, {}};
  for (const int key : keys) {
    selection.keys.push_back({key, components});
  }
  return {selection};
}

Document withScaledHandKeys(const std::vector<double>& frames) {
  rig::Adjustment adjustment;
  adjustment.controller = "left-hand";
  for (const double frame : frames) {
    rig::OffsetKey key;
    key.frame = frame;
    key.move = {0.01 * frame, 0.002 * frame, 0.0};
    key.interpolation = rig::KeyInterpolation::free;
    key.moveSlope = {0.1, 0.2, 0.3};
    key.turnSlope = {0.4, 0.5, 0.6};
    adjustment.keys.push_back(key);
  }
  const Document start = test::boxer();
  const Result<Document> placed = placeAdjustments(start, {&adjustment, 1});
  INFO((placed ? std::string() : placed.error().line()));
  REQUIRE(placed);
  return *placed;
}

} // namespace

TEST_CASE("Scaled keys have the slopes of the scaled curve, the components that are not scaled keep theirs",
          "[keys]") {
  struct Case {
    double time;
    double value;
    unsigned components;
  };
  const Document start = withScaledSlopes();
  const std::vector<RowKey> before = readRow(start, 0, scaledElbowRow).keys;
  for (const Case& one : {Case{2.0, 1.0, ~0U}, Case{0.5, 1.0, ~0U}, Case{1.0, 3.0, ~0U}, Case{1.0, 3.0, 1U},
                          Case{1.0, -1.0, 2U}, Case{0.5, 3.0, 4U}, Case{-1.0, 1.0, ~0U}, Case{-1.0, 1.0, 1U},
                          Case{-1.0, -1.0, ~0U}, Case{-1.0, -1.0, 2U}, Case{-0.5, 2.0, 5U}}) {
    CAPTURE(one.time, one.value, one.components);
    const KeyScale scale{10.0, one.time, 0.5, one.value};
    const Document scaled =
        edited(scaleKeys(start, 0, picked(scaledElbowRow, {0, 1, 2}, one.components), scale)).document;
    const std::vector<RowKey> after = readRow(scaled, 0, scaledElbowRow).keys;
    REQUIRE(after.size() == 3);
    for (std::size_t key = 0; key < 3; ++key) {
      const bool turned = one.time < 0.0;
      const RowKey& from = before[turned ? 2 - key : key];
      for (std::size_t i = 0; i < 3; ++i) {
        CAPTURE(key, i);
        const double value = (one.components >> i & 1U) != 0 ? one.value : 1.0;
        CHECK(after[key].values[i] == Approx((one.components >> i & 1U) != 0
                                                 ? 0.5 + one.value * (from.values[i] - 0.5)
                                                 : from.values[i])
                                          .margin(1e-5));
        const double in = turned ? from.outSlopes[i] : from.inSlopes[i];
        const double out = turned ? from.inSlopes[i] : from.outSlopes[i];
        CHECK(after[key].inSlopes[i] == Approx(in * value / one.time).margin(1e-5));
        CHECK(after[key].outSlopes[i] == Approx(out * value / one.time).margin(1e-5));
      }
    }
  }
}

TEST_CASE("Offset keys are scaled by the same rule", "[keys]") {
  const Document start = withScaledHandKeys({4.0, 8.0, 12.0});
  const auto keyOf = [&](const KeyScale& scale, unsigned components) {
    return edited(scaleKeys(start, 0, picked(scaledHandRow, {0, 1, 2}, components), scale))
        .document.adjustments[0]
        .keys[1];
  };
  const rig::OffsetKey inX = keyOf({8.0, 1.0, 0.0, 3.0}, 1U);
  CHECK(inX.move.x == Approx(0.24));
  CHECK(inX.move.y == Approx(0.016));
  CHECK(inX.moveSlope.x == Approx(0.3).epsilon(1e-3));
  CHECK(inX.moveSlope.y == Approx(0.2).epsilon(1e-3));
  CHECK(inX.turnSlope.z == Approx(0.6).epsilon(1e-3));
  const rig::OffsetKey slower = keyOf({8.0, 2.0}, 1U);
  CHECK(slower.moveSlope.x == Approx(0.05).epsilon(1e-3));
  CHECK(slower.moveSlope.y == Approx(0.1).epsilon(1e-3));
  CHECK(slower.turnSlope.z == Approx(0.3).epsilon(1e-3));
  const rig::OffsetKey round = keyOf({8.0, -1.0}, ~0U);
  CHECK(round.moveSlope.x == Approx(-0.1).epsilon(1e-3));
  CHECK(round.turnSlope.z == Approx(-0.6).epsilon(1e-3));
}

TEST_CASE("Keys that an edit brings to one frame are one key, and what stays picked is what was picked",
          "[keys]") {
  const Document start = withScaledHandKeys({4.2, 4.4, 8.0, 12.0});
  Document own = withScaledSlopes();
  own = edited(scaleKeys(own, 0, picked(scaledElbowRow, {0, 1, 2}), {0.0, 0.02})).document; // 0, 0.2, 0.4
  const KeyScale toOnePlace{4.0, 0.0};
  struct Case {
    std::string what;
    EditedKeys edited;
    KeyRow row;
    std::vector<double> frames; ///< That stay picked.
  };
  Document ownBeside = own;
  const std::vector<KeyRow> rows{scaledElbowRow};
  ownBeside = edited(insertKeys(ownBeside, 0, rows, 10.0)).document;
  ownBeside = edited(insertKeys(ownBeside, 0, rows, 15.0)).document;
  const std::vector<Case> cases{
      {"snapped offsets", edited(snapKeys(start, 0, picked(scaledHandRow, {0, 1}))), scaledHandRow, {4.0}},
      {"snapped keys of the clip",
       edited(snapKeys(ownBeside, 0, picked(scaledElbowRow, {0, 1, 2}))),
       scaledElbowRow,
       {0.0}},
      {"scaled offsets",
       edited(scaleKeys(start, 0, picked(scaledHandRow, {0, 1}), toOnePlace)),
       scaledHandRow,
       {4.0}},
      {"scaled keys of the clip",
       edited(scaleKeys(ownBeside, 0, picked(scaledElbowRow, {0, 1, 2}), {3.0, 0.0})),
       scaledElbowRow,
       {3.0}},
      {"moved to whole frames",
       edited(moveKeys(start, 0, picked(scaledHandRow, {0, 1}), {1.0, 0.0, true})),
       scaledHandRow,
       {5.0}},
  };
  for (const Case& one : cases) {
    CAPTURE(one.what);
    const std::vector<double> frames = keyFramesOf(one.edited.document, 0, one.row);
    std::vector<double> standing;
    for (const PickedRow& row : one.edited.picked) {
      CHECK(row.row == one.row);
      for (const PickedKey& key : row.keys) {
        REQUIRE(static_cast<std::size_t>(key.key) < frames.size());
        standing.push_back(frames[static_cast<std::size_t>(key.key)]);
      }
    }
    REQUIRE(standing.size() == one.frames.size());
    for (std::size_t i = 0; i < standing.size(); ++i) {
      CHECK(standing[i] == Approx(one.frames[i]).margin(1e-5));
    }
    const std::vector<double> left =
        keyFramesOf(edited(removeKeys(one.edited.document, 0, one.edited.picked)).document, 0, one.row);
    const auto stayed =
        one.row == scaledHandRow ? std::vector<double>{8.0, 12.0} : std::vector<double>{10.0, 15.0};
    REQUIRE(left.size() == stayed.size());
    CHECK(left[0] == Approx(stayed[0]).margin(1e-5));
    CHECK(left[1] == Approx(stayed[1]).margin(1e-5));
  }
}

TEST_CASE("The components of keys that come to one frame are picked together", "[keys]") {
  const Document start = withScaledHandKeys({4.2, 4.4, 8.0});
  const KeySelection two{{scaledHandRow, {{0, 1U}, {1, 4U}}}};
  const EditedKeys snapped = edited(snapKeys(start, 0, two));
  REQUIRE(snapped.picked.size() == 1);
  CHECK(snapped.picked[0].keys == std::vector<PickedKey>{{0, 5U}});
}

// A limb's keys slower or faster, while the rest of the body keeps its time.
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/edits/keys/key_edits.h"
#include "app/edits/keys/key_row.h"
#include "app/edits/keys/retime.h"
#include "app/named.h"
#include "core/math/rotation.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"
#include "tests/support/app/things_of_clip.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double middleFrame = 5.0;

/// Keys at the frames 0, 5, 10 and 20 of every joint of the boxer, and of every controller and attribute that
/// its sides have.
Document allKeyed() {
  Document document = test::boxer();
  std::vector<Track> tracks;
  for (std::size_t node = 0; node < document.scene->nodes.size(); ++node) {
    Track track;
    track.node = NodeIndex(node);
    track.channel = Channel::rotation;
    track.width = 4;
    for (const double frame : {0.0, middleFrame, 10.0, 20.0}) {
      test::addKey(track, frame, axisAngle(Vec3(0.0, 0.0, 1.0), 0.01 * frame));
    }
    tracks.push_back(track);
  }
  document = test::withTracks(document, tracks);
  const rig::ControllerList list = controllersOf(document);
  std::vector<std::string> ids;
  for (const rig::Controller& controller : list.controllers) {
    ids.push_back(controller.id);
  }
  for (const rig::Attribute& attribute : list.attributes) {
    ids.push_back(attribute.id);
  }
  for (const std::string& id : ids) {
    rig::Adjustment adjustment;
    adjustment.controller = id;
    for (const double frame : {0.0, middleFrame, 10.0, 20.0}) {
      rig::OffsetKey key;
      key.frame = frame;
      adjustment.keys.push_back(key);
    }
    document.adjustments.push_back(adjustment);
  }
  return document;
}

} // namespace

TEST_CASE(
    "A limb's joints with its end, and its controllers and values, get another time, and nothing else") {
  Document start = allKeyed();
  const std::string limb = GENERATE("left-arm", "right-arm", "spine");
  CAPTURE(limb);
  start = test::withNewTrail(start, {limb, 5.0, 15.0});
  rig::Pin pin;
  pin.limb = limb;
  pin.time.rangeFrames = {5.0, 12.0};
  start.holds.pins = {pin};
  const Result<Document> made = retimed(start, 0, {0.0, 10.0, 16.0, true, limb});
  REQUIRE(made);
  const rig::Limb& own = *findLimb(start, limb);
  std::size_t mapped = 0;
  for (const KeyRow& row : keyedRows(start, 0)) {
    if (row.isOffset()) {
      continue;
    }
    const bool isOwn = std::ranges::find(own.joints, row.node) != own.joints.end() || row.node == own.endNode;
    CAPTURE(start.scene->nodes[at(row.node)].name);
    CHECK(keyFramesOf(*made, 0, row)[1] == Approx(isOwn ? 8.0 : middleFrame));
    CHECK(keyFramesOf(*made, 0, row).back() == Approx(isOwn ? 26.0 : 20.0));
    mapped += isOwn ? 1 : 0;
  }
  CHECK(mapped == own.joints.size() + 1);
  const rig::ControllerList list = controllersOf(start);
  std::size_t offsets = 0;
  for (std::size_t i = 0; i < start.adjustments.size(); ++i) {
    const std::string& id = start.adjustments[i].controller;
    const rig::Controller* const controller = list.controller(id);
    const bool isOwn = (controller != nullptr ? controller->limb : list.attribute(id)->limb) == limb;
    CAPTURE(id);
    CHECK(made->adjustments[i].keys[1].frame == Approx(isOwn ? 8.0 : middleFrame));
    CHECK(made->adjustments[i].keys.back().frame == Approx(isOwn ? 26.0 : 20.0));
    offsets += isOwn ? 1 : 0;
  }
  CHECK(offsets > 2);
  // Trails and holds stand in the time of the body.
  CHECK(made->trails == start.trails);
  CHECK(made->holds == start.holds);
}

TEST_CASE("Of a clip that gets another time the other clips keep theirs, in every kind of thing") {
  Document start = test::twoPunches();
  const Things first = test::oneOfEach(0, 0.4);
  const Things second = test::oneOfEach(1, 0.4);
  start.trails = {first.trails.front(), second.trails.front()};
  start.adjustments = first.adjustments;
  start.adjustments.insert(start.adjustments.end(), second.adjustments.begin(), second.adjustments.end());
  start.holds = first.holds;
  start.holds.pins.push_back(second.holds.pins.front());
  start.holds.grips.push_back(second.holds.grips.front());
  start.holds.props.push_back(second.holds.props.front());
  start.weights = {first.weights.front(), second.weights.front()};
  for (WeightedLimb& weight : start.weights) {
    weight.settings.rangeFrames = Vec2(2.0, 12.0);
  }
  const int clip = GENERATE(0, 1);
  CAPTURE(clip);
  const Result<Document> made = retimed(start, clip, {0.0, 20.0, 40.0});
  REQUIRE(made);
  CHECK(clipOf(*made, clip).endSeconds == Approx(2.0 * clipOf(start, clip).endSeconds));
  CHECK(clipOf(*made, 1 - clip).endSeconds == clipOf(start, 1 - clip).endSeconds);
  const auto same = [&](const auto& list, const auto& before) {
    REQUIRE(list.size() == before.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      CAPTURE(i);
      CHECK((list[i] == before[i]) == (before[i].clip != clip));
    }
  };
  same(made->trails, start.trails);
  same(made->adjustments, start.adjustments);
  same(made->holds.pins, start.holds.pins);
  same(made->holds.grips, start.holds.grips);
  same(made->holds.props, start.holds.props);
  same(made->weights, start.weights);
}

TEST_CASE("Where what comes after stays, keys that a slower range reaches give way to it, and others stay") {
  const Document start = allKeyed();
  const KeyRow row = keyedRows(start, 0).front();
  const std::vector<RowKey> before = readRow(start, 0, row).keys;
  for (const auto& [newFrames, reaches] : {std::pair(6.0, true), {4.5, false}}) {
    CAPTURE(newFrames);
    const Result<Document> made = retimed(start, 0, {2.0, 5.0, newFrames * (reaches ? 1.5 : 1.0), false});
    REQUIRE(made);
    const std::vector<RowKey> after = readRow(*made, 0, row).keys;
    const double end = 2.0 + newFrames * (reaches ? 1.5 : 1.0);
    std::vector<double> wanted{0.0, 2.0, end};
    wanted.insert(wanted.end(),
                  reaches ? std::initializer_list<double>{20.0} : std::initializer_list<double>{10.0, 20.0});
    REQUIRE(after.size() == wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      CHECK(after[i].frame == Approx(wanted[i]).margin(1e-4));
    }
    CHECK(after[2].values == before[1].values); // as it was at the end of the range
    CHECK(after.back().values == before.back().values);
  }
}

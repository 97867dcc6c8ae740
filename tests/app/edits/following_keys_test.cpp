// Slopes that follow the neighbours, on tracks whose numbers are known.
#include <vector>

#include <catch2/catch.hpp>

#include "app/edits/keys/following_keys.h"
#include "app/edits/keys/track_edits.h"
#include "tests/support/app/boxer.h"

using namespace stretch;
using namespace stretch::app;

namespace {

constexpr double keyRate = 10.0;
constexpr float drawn = 7.0F; // Of every tangent: no slope that neighbours would give.

/// Translations at frames 0, 4, 6 and 9: x as told, y half and z none of it.
Track cubicTrack(const std::vector<double>& xs) {
  const std::vector<double> frames{0.0, 4.0, 6.0, 9.0};
  Track track;
  track.node = NodeIndex(3);
  track.interpolation = Interpolation::cubicSpline;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    track.times.push_back(static_cast<float>(frames[i] / keyRate));
    for (const double value : {7.0, 7.0, 7.0, xs[i], 0.5 * xs[i], 0.0, 7.0, 7.0, 7.0}) {
      track.values.push_back(static_cast<float>(value));
    }
  }
  return track;
}

KeyedRow followingRow(const Track& track, const std::vector<unsigned>& following) {
  KeyedRow row = readTrack(track, keyRate, RowDetail::values);
  for (std::size_t i = 0; i < following.size(); ++i) {
    row.keys[i].following = following[i];
  }
  return row;
}

/// In-tangent and out-tangent of a component of a key, for each frame.
Vec2 slopesOf(const Track& track, std::size_t key, std::size_t component) {
  const auto at = [&](std::size_t part) {
    return static_cast<double>(track.values[9 * key + 3 * part + component]) / keyRate;
  };
  return {at(0), at(2)};
}

void checkSlope(const WrittenTrack& written, std::size_t key, std::size_t component, double wanted) {
  CAPTURE(key, component);
  const Vec2 slopes = slopesOf(written.track, key, component);
  CHECK(slopes.x == Approx(wanted).margin(1e-6));
  CHECK(slopes.y == Approx(wanted).margin(1e-6));
}

constexpr double asDrawn = static_cast<double>(drawn) / keyRate;

/// Fritsch and Butland's mean of the two secants' slopes.
double meanSlope(double framesBefore, double slopeBefore, double framesAfter, double slopeAfter) {
  return 3.0 * (framesBefore + framesAfter) /
         ((2.0 * framesAfter + framesBefore) / slopeBefore + (framesAfter + 2.0 * framesBefore) / slopeAfter);
}

void moveX(KeyedRow& row, std::size_t key, double x) {
  row.keys[key].values[0] = x;
  row.keys[key].values[1] = 0.5 * x;
  row.keys[key].valuesChanged = true;
}

} // namespace

TEST_CASE("A key that follows is level at the ends and at extremes, else the mean of both secants",
          "[keys]") {
  const KeyedRow row = followingRow(cubicTrack({0.0, 1.0, 5.0, 4.0}), {});
  CHECK(followingSlope(nullptr, row.keys[0], &row.keys[1], 0) == 0.0);
  CHECK(followingSlope(&row.keys[2], row.keys[3], nullptr, 0) == 0.0);
  CHECK(followingSlope(nullptr, row.keys[0], nullptr, 0) == 0.0);
  CHECK(followingSlope(&row.keys[1], row.keys[2], &row.keys[3], 0) == 0.0);
  CHECK(followingSlope(&row.keys[0], row.keys[1], &row.keys[2], 0) == Approx(meanSlope(4, 0.25, 2, 2.0)));
  CHECK(followingSlope(&row.keys[0], row.keys[1], &row.keys[2], 1) == Approx(meanSlope(4, 0.125, 2, 1.0)));
  CHECK(followingSlope(&row.keys[0], row.keys[1], &row.keys[2], 2) == 0.0);
}

TEST_CASE("Where a value moves, following components of the key and of its neighbours follow, no others",
          "[keys]") {
  const Track before = cubicTrack({0.0, 1.0, 3.0, 3.5});
  KeyedRow row = followingRow(before, {7U, 1U, 0U, 2U});
  moveX(row, 2, 5.0);
  const WrittenTrack written = writeFollowing(before, row, keyRate);
  checkSlope(written, 0, 0, asDrawn); // No neighbour of what moved.
  checkSlope(written, 1, 0, meanSlope(4, 0.25, 2, 2.0));
  checkSlope(written, 1, 1, asDrawn); // Does not follow.
  checkSlope(written, 2, 0, asDrawn);
  checkSlope(written, 3, 0, asDrawn);
  checkSlope(written, 3, 1, 0.0);
  checkSlope(written, 3, 2, asDrawn);

  KeyedRow own = followingRow(before, {0U, 0U, 3U, 0U});
  moveX(own, 2, 3.2);
  const WrittenTrack moved = writeFollowing(before, own, keyRate);
  checkSlope(moved, 2, 0, meanSlope(2, 1.1, 3, 0.1));
  checkSlope(moved, 2, 1, meanSlope(2, 0.55, 3, 0.05));
}

TEST_CASE("A key that moves in time or goes bends those beside it that follow", "[keys]") {
  const Track before = cubicTrack({0.0, 1.0, 3.0, 3.5});
  KeyedRow later = followingRow(before, {0U, 1U, 1U, 0U});
  later.keys[2].frame = 8.0;
  const WrittenTrack moved = writeFollowing(before, later, keyRate);
  checkSlope(moved, 1, 0, meanSlope(4, 0.25, 4, 0.5));
  checkSlope(moved, 2, 0, meanSlope(4, 0.5, 1, 0.5));

  KeyedRow fewer = followingRow(before, {1U, 1U, 1U, 1U});
  fewer.keys.erase(fewer.keys.begin() + 1);
  const WrittenTrack without = writeFollowing(before, fewer, keyRate);
  checkSlope(without, 0, 0, 0.0);
  checkSlope(without, 1, 0, meanSlope(6, 0.5, 3, 0.5 / 3.0));
  checkSlope(without, 2, 0, asDrawn); // Its neighbour stands where it stood.
}

TEST_CASE("A key that is put onto the curve bends none beside it, one that leaves the curve does", "[keys]") {
  const Track before = cubicTrack({0.0, 1.0, 3.0, 3.5});
  const bool onCurve = GENERATE(true, false);
  KeyedRow row = followingRow(before, {1U, 1U, 1U, 1U});
  RowKey inserted = row.keys[1];
  inserted.frame = 5.0;
  inserted.values[0] = 2.5;
  inserted.origin = -1;
  inserted.following = 0;
  inserted.onCurve = onCurve;
  row.keys.insert(row.keys.begin() + 2, inserted);
  const WrittenTrack written = writeFollowing(before, row, keyRate);
  REQUIRE(written.track.times.size() == 5);
  checkSlope(written, 0, 0, asDrawn);
  checkSlope(written, 1, 0, onCurve ? asDrawn : meanSlope(4, 0.25, 1, 1.5));
  checkSlope(written, 3, 0, onCurve ? asDrawn : meanSlope(1, 0.5, 3, 0.5 / 3.0));
  checkSlope(written, 4, 0, asDrawn);
}

TEST_CASE("Nothing that stands still is bent, and linear keys have no slopes to follow", "[keys]") {
  const Track before = cubicTrack({0.0, 1.0, 3.0, 3.5});
  KeyedRow row = followingRow(before, {7U, 7U, 7U, 7U});
  for (RowKey& key : row.keys) {
    key.valuesChanged = key.slopesChanged = false;
  }
  CHECK(writeFollowing(before, row, keyRate).track == before);
  row.interpolation = Interpolation::linear;
  CHECK(writeFollowing(before, row, keyRate).track == writeTrack(before, row, keyRate).track);
}

TEST_CASE("Keys that follow are remembered by clip, node, channel, time and component", "[keys]") {
  Document document = test::boxer();
  const Track track = cubicTrack({0.0, 1.0, 3.0, 3.5});
  Track scale = track;
  scale.channel = Channel::scale;
  Track other = track;
  other.node = NodeIndex(4);
  const auto remember = [&](int clip, const Track& of, const std::vector<unsigned>& following) {
    const KeyedRow row = followingRow(of, following);
    rememberFollowing(clip, writeFollowing(of, row, keyRate), row, document);
  };
  const auto marked = [&](int clip, const Track& of) {
    KeyedRow row = followingRow(of, {});
    markFollowing(document, clip, of, row);
    std::vector<unsigned> following;
    for (const RowKey& key : row.keys) {
      following.push_back(key.following);
    }
    return following;
  };
  const std::vector<unsigned> none(4, 0U);
  CHECK(marked(0, track) == none);
  remember(0, track, {1U, 0U, 2U, ~0U}); // Components that there are not are no components.
  remember(1, track, {0U, 4U, 0U, 0U});
  remember(0, scale, {0U, 0U, 5U, 0U});
  remember(0, other, {6U, 0U, 0U, 0U});
  REQUIRE(document.followingKeys.size() == 4);
  CHECK(marked(0, track) == std::vector{1U, 0U, 2U, 7U});
  CHECK(marked(1, track) == std::vector{0U, 4U, 0U, 0U});
  CHECK(marked(0, scale) == std::vector{0U, 0U, 5U, 0U});
  CHECK(marked(0, other) == std::vector{6U, 0U, 0U, 0U});
  CHECK(marked(1, other) == none);

  Track later = track;
  later.times[3] += 0.05F; // What was remembered of the key is not of one that stands elsewhere.
  CHECK(marked(0, later) == std::vector{1U, 0U, 2U, 0U});

  remember(0, track, {0U, 3U, 0U, 0U});
  CHECK(marked(0, track) == std::vector{0U, 3U, 0U, 0U});
  CHECK(document.followingKeys.size() == 4);
  remember(0, scale, none);
  remember(0, scale, none);
  CHECK(document.followingKeys.size() == 3);
  CHECK(marked(0, scale) == none);
  CHECK(marked(0, other) == std::vector{6U, 0U, 0U, 0U});

  Track linear = track;
  linear.interpolation = Interpolation::linear;
  linear.values.resize(12);
  remember(0, linear, {1U, 1U, 1U, 1U});
  CHECK(marked(0, track) == none);
  CHECK(document.followingKeys.size() == 2);
}

TEST_CASE("Keys of tracks that are not given back go on following, those of another clip as well") {
  Document document = test::boxer();
  const FollowingKeys arm{0, NodeIndex(3), Channel::rotation, {{0.0F, 7U}}};
  const FollowingKeys moved{0, NodeIndex(3), Channel::translation, {{0.0F, 7U}}};
  const FollowingKeys elbow{0, NodeIndex(4), Channel::rotation, {{0.0F, 7U}}};
  const FollowingKeys other{1, NodeIndex(3), Channel::rotation, {{0.0F, 7U}}};
  document.followingKeys = {arm, moved, elbow, other};
  const Document restored = restoreTracks(document, 0, [](NodeIndex node, Channel channel) {
    return node == NodeIndex(3) && channel == Channel::rotation;
  });
  CHECK(restored.followingKeys == std::vector{moved, elbow, other});
}

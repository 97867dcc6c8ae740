// The clip's own tracks as rows of keys, and back.
#include "app/edits/keys/track_row.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/math/euler.h"
#include "core/math/rotation.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::app;
using stretch::test::Row;

namespace {

constexpr double rate = 24.0;
constexpr double degree = pi / 180.0;
constexpr Channel channels[] = {Channel::translation, Channel::rotation, Channel::scale};
constexpr Interpolation interpolations[] = {Interpolation::step, Interpolation::linear,
                                            Interpolation::cubicSpline};

/// A track of so many uneven keys with values, and tangents where it is cubic, of any size.
Track trackOf(Row& row, Channel channel, Interpolation interpolation, std::size_t keys = 5) {
  Track track;
  track.node = NodeIndex(2);
  track.channel = channel;
  track.interpolation = interpolation;
  track.width = channel == Channel::rotation ? 4 : 3;
  track.sourceChannel = 7;
  const int parts = interpolation == Interpolation::cubicSpline ? 3 : 1;
  double time = 0.5;
  for (std::size_t i = 0; i < keys; ++i, time += row.between(0.1, 0.5)) {
    track.times.push_back(static_cast<float>(time));
    const Quat turn = axisAngle(glm::normalize(row.vector(1.0) + Vec3(1.1)), 0.5 * static_cast<double>(i));
    for (int part = 0; part < parts; ++part) {
      const bool isTurn = channel == Channel::rotation && (parts == 1 || part == 1);
      const Vec4 numbers =
          isTurn ? Vec4(turn.x, turn.y, turn.z, turn.w) : Vec4(row.vector(1.0), row.around(1.0));
      for (std::size_t c = 0; c < static_cast<std::size_t>(track.width); ++c) {
        track.values.push_back(static_cast<float>(numbers[c]));
      }
    }
  }
  return track;
}

Vec4 valueAt(const Track& track, double seconds) {
  Vec4 value(0.0);
  sampleTrack(track, seconds, &value.x);
  return value;
}

Vec3 firstThree(const KeyValues& values) {
  return {values[0], values[1], values[2]};
}

/// Of rotations how far one is turned from the other, whatever their signs; else how far apart they are.
double apart(const Track& track, const Vec4& a, const Vec4& b) {
  return track.channel == Channel::rotation ? angleBetween(Quat(a.w, a.x, a.y, a.z), Quat(b.w, b.x, b.y, b.z))
                                            : glm::length(a - b);
}

double largestMiss(const Track& before, const Track& after) {
  double miss = 0.0;
  for (auto seconds = static_cast<double>(before.times.front());
       seconds < static_cast<double>(before.times.back()); seconds += 0.013) {
    miss = std::max(miss, apart(before, valueAt(before, seconds), valueAt(after, seconds)));
  }
  return miss;
}

} // namespace

TEST_CASE("A row that nobody changed is written back to the last bit", "[keys]") {
  Row row(3);
  for (const Channel channel : channels) {
    for (const Interpolation interpolation : interpolations) {
      for (const std::size_t keys : {1, 2, 6}) {
        const Track track = trackOf(row, channel, interpolation, keys);
        CAPTURE(static_cast<int>(channel), static_cast<int>(interpolation), keys);
        for (const RowDetail detail : {RowDetail::times, RowDetail::values}) {
          const WrittenTrack written = writeTrack(track, readTrack(track, rate, detail), rate);
          CHECK(written.track == track);
          REQUIRE(written.rowKeys.size() == keys);
          CHECK(written.rowKeys.front() == 0);
          CHECK(written.rowKeys.back() == keys - 1);
        }
      }
    }
  }
}

TEST_CASE("A row shows the values of its track at its keys, with the slopes beside them", "[keys]") {
  Row row(5);
  constexpr double step = 1e-5;
  for (const Channel channel : channels) {
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubicSpline}) {
      const Track track = trackOf(row, channel, interpolation);
      const KeyedRow read = readTrack(track, rate, RowDetail::values);
      REQUIRE(read.keys.size() == track.times.size());
      CHECK(read.interpolation == interpolation);
      for (std::size_t i = 0; i < read.keys.size(); ++i) {
        const RowKey& key = read.keys[i];
        const auto seconds = static_cast<double>(track.times[i]);
        CAPTURE(static_cast<int>(channel), static_cast<int>(interpolation), i);
        CHECK(key.frame == seconds * rate);
        CHECK(key.origin == static_cast<int>(i));
        CHECK_FALSE(key.valuesChanged);
        CHECK_FALSE(key.slopesChanged);
        CHECK(key.kind == (interpolation == Interpolation::linear ? rig::KeyInterpolation::linear
                                                                  : rig::KeyInterpolation::free));
        const Vec4 stored = valueAt(track, seconds);
        const Vec3 shown = firstThree(key.values);
        const Quat turned = rotationOf(shown * degree);
        const Vec4 told =
            channel == Channel::rotation ? Vec4(turned.x, turned.y, turned.z, turned.w) : Vec4(shown, 0.0);
        CHECK(apart(track, told, stored) < 1e-6);
        if (interpolation == Interpolation::linear) {
          continue;
        }
        const auto slope = [&](double side) {
          const KeyValues near = trackValues(track, seconds + side * step, key.values);
          return (firstThree(near) - shown) / (side * step * rate);
        };
        const double size =
            1.0 + glm::length(firstThree(key.inSlopes)) + glm::length(firstThree(key.outSlopes));
        CHECK((i == 0 || glm::length(slope(-1.0) - firstThree(key.inSlopes)) < 1e-2 * size));
        CHECK(
            (i + 1 == read.keys.size() || glm::length(slope(1.0) - firstThree(key.outSlopes)) < 1e-2 * size));
      }
    }
  }
}

TEST_CASE("The slopes of a row without tangents go straight to the neighbours, and beyond the ends nowhere",
          "[keys]") {
  Row row(7);
  for (const Channel channel : channels) {
    const KeyedRow read = readTrack(trackOf(row, channel, Interpolation::linear), rate, RowDetail::values);
    for (std::size_t i = 0; i + 1 < read.keys.size(); ++i) {
      const RowKey& from = read.keys[i];
      const RowKey& to = read.keys[i + 1];
      const Vec3 slope = (firstThree(to.values) - firstThree(from.values)) / (to.frame - from.frame);
      CHECK(glm::length(firstThree(from.outSlopes) - slope) < 1e-9);
      CHECK(glm::length(firstThree(to.inSlopes) - slope) < 1e-9);
    }
    CHECK(firstThree(read.keys.front().inSlopes) == Vec3(0.0));
    CHECK(firstThree(read.keys.back().outSlopes) == Vec3(0.0));
    const KeyedRow held = readTrack(trackOf(row, channel, Interpolation::step), rate, RowDetail::values);
    for (const RowKey& key : held.keys) {
      CHECK(key.kind == rig::KeyInterpolation::stepped);
      CHECK(firstThree(key.inSlopes) == Vec3(0.0));
      CHECK(firstThree(key.outSlopes) == Vec3(0.0));
    }
  }
}

TEST_CASE("Shown angles go on round and round without a jump, whichever way and about whichever axis",
          "[keys]") {
  for (const std::size_t axis : {0, 1, 2}) {
    for (const double step : {100.0, -100.0, 170.0}) {
      if (axis == 1 && std::abs(step) > 90.0) {
        continue; // About the middle axis a quarter turn shows as turns of both others.
      }
      Track track;
      track.channel = Channel::rotation;
      track.width = 4;
      Vec3 unit(0.0);
      unit[axis] = 1.0;
      for (int i = 0; i < 9; ++i) {
        const Quat turn = axisAngle(unit, step * i * degree);
        track.times.push_back(static_cast<float>(i));
        track.values.insert(track.values.end(), {static_cast<float>(turn.x), static_cast<float>(turn.y),
                                                 static_cast<float>(turn.z), static_cast<float>(turn.w)});
      }
      const KeyedRow read = readTrack(track, rate, RowDetail::values);
      for (std::size_t i = 0; i < 9; ++i) {
        CAPTURE(axis, step, i);
        CHECK(read.keys[i].values[axis] == Approx(step * static_cast<double>(i)).margin(1e-3));
      }
    }
  }
}

TEST_CASE("Changed values and slopes of a cubic row are those that are read again", "[keys]") {
  Row row(11);
  for (const Channel channel : channels) {
    for (int round = 0; round < 10; ++round) {
      const Track track = trackOf(row, channel, Interpolation::cubicSpline);
      KeyedRow changed = readTrack(track, rate, RowDetail::values);
      const double reach = channel == Channel::rotation ? 30.0 : 1.0;
      for (RowKey& key : changed.keys) {
        for (std::size_t c = 0; c < 3; ++c) {
          key.values[c] += row.around(reach);
          key.inSlopes[c] = row.around(0.2 * reach);
          key.outSlopes[c] = row.around(0.2 * reach);
        }
        key.valuesChanged = key.slopesChanged = true;
      }
      const WrittenTrack written = writeTrack(track, changed, rate);
      CHECK(written.track.times == track.times);
      for (std::size_t i = 0; i < changed.keys.size(); ++i) {
        const RowKey& key = changed.keys[i];
        const auto seconds = static_cast<double>(track.times[i]);
        const KeyValues again = trackValues(written.track, seconds, key.values);
        CAPTURE(static_cast<int>(channel), round, i);
        CHECK(glm::length(firstThree(again) - firstThree(key.values)) < 1e-4 * reach);
        constexpr double step = 1e-4;
        const auto slope = [&](double side) {
          const KeyValues near = trackValues(written.track, seconds + side * step, key.values);
          return (firstThree(near) - firstThree(again)) / (side * step * rate);
        };
        CHECK((i == 0 || glm::length(slope(-1.0) - firstThree(key.inSlopes)) < 0.05 * reach));
        CHECK((i + 1 == changed.keys.size() ||
               glm::length(slope(1.0) - firstThree(key.outSlopes)) < 0.05 * reach));
      }
    }
  }
}

TEST_CASE("A changed key leaves every other one as it was, to the last bit", "[keys]") {
  Row row(13);
  for (const Channel channel : channels) {
    for (const Interpolation interpolation : interpolations) {
      const Track track = trackOf(row, channel, interpolation);
      for (std::size_t which = 0; which < track.times.size(); ++which) {
        KeyedRow changed = readTrack(track, rate, RowDetail::values);
        changed.keys[which].values[1] += 20.0;
        changed.keys[which].valuesChanged = true;
        const Track written = writeTrack(track, changed, rate).track;
        CAPTURE(static_cast<int>(channel), static_cast<int>(interpolation), which);
        REQUIRE(written.values.size() == track.values.size());
        const std::size_t each = track.values.size() / track.times.size();
        for (std::size_t i = 0; i < track.values.size(); ++i) {
          CHECK((i / each == which || written.values[i] == track.values[i]));
        }
        CHECK(apart(track, valueAt(track, static_cast<double>(track.times[which])),
                    valueAt(written, static_cast<double>(track.times[which]))) > 0.1);
      }
    }
  }
}

TEST_CASE("A row that gets tangents runs as it ran without them", "[keys]") {
  Row row(17);
  for (const Channel channel : channels) {
    const Track track = trackOf(row, channel, Interpolation::linear);
    KeyedRow changed = readTrack(track, rate, RowDetail::values);
    changed.interpolation = Interpolation::cubicSpline;
    const Track written = writeTrack(track, changed, rate).track;
    CHECK(written.interpolation == Interpolation::cubicSpline);
    CHECK(written.values.size() == 3 * track.values.size());
    CHECK(largestMiss(track, written) < (channel == Channel::rotation ? 0.02 : 1e-5));
    const std::size_t width = track.values.size() / track.times.size();
    for (std::size_t c = 0; c < width; ++c) {
      CHECK(written.values[c] == 0.0F);                             // Before the first key and
      CHECK(written.values[written.values.size() - 1 - c] == 0.0F); // after the last nothing moves.
    }
  }
}

TEST_CASE("Turns whose signs differ keep their shorter way when they get tangents", "[keys]") {
  Row row(19);
  Track track = trackOf(row, Channel::rotation, Interpolation::linear);
  for (std::size_t i = 4; i < 8; ++i) {
    track.values[i] = -track.values[i];
  }
  KeyedRow changed = readTrack(track, rate, RowDetail::values);
  changed.interpolation = Interpolation::cubicSpline;
  CHECK(largestMiss(track, writeTrack(track, changed, rate).track) < 0.02);
}

TEST_CASE("Of keys at one time the first is written, and each knows its place in the row", "[keys]") {
  Row row(23);
  const Track track = trackOf(row, Channel::translation, Interpolation::linear, 4);
  KeyedRow changed = readTrack(track, rate, RowDetail::values);
  RowKey twin = changed.keys[1];
  twin.origin = -1;
  twin.values = {9.0, 9.0, 9.0};
  changed.keys.insert(changed.keys.begin() + 2, twin);
  const WrittenTrack written = writeTrack(track, changed, rate);
  CHECK(written.track == track);
  CHECK(written.rowKeys == std::vector<std::size_t>{0, 1, 3, 4});
}

TEST_CASE("A key that is moved in time and one that is new stand at their frames", "[keys]") {
  Row row(29);
  for (const Channel channel : channels) {
    const Track track = trackOf(row, channel, Interpolation::linear, 3);
    KeyedRow changed = readTrack(track, rate, RowDetail::values);
    changed.keys[2].frame += 6.0;
    RowKey added;
    added.frame = changed.keys[2].frame + 2.0;
    added.values = {10.0, 20.0, 30.0};
    changed.keys.push_back(added);
    const Track written = writeTrack(track, changed, rate).track;
    REQUIRE(written.times.size() == 4);
    CHECK(written.times[1] == track.times[1]);
    CHECK(static_cast<double>(written.times[2]) * rate == Approx(changed.keys[2].frame));
    CHECK(static_cast<double>(written.times[3]) * rate == Approx(added.frame));
    const KeyValues read = trackValues(written, static_cast<double>(written.times[3]), added.values);
    CHECK(glm::length(firstThree(read) - Vec3(10.0, 20.0, 30.0)) < 1e-4);
    CHECK(apart(track, valueAt(written, static_cast<double>(written.times[2])),
                valueAt(track, static_cast<double>(track.times[2]))) < 1e-6);
  }
}

TEST_CASE("A turn of a cubic track that changes a little moves the curve a little, whatever its signs",
          "[keys]") {
  Row row(31);
  for (const float sign : {1.0F, -1.0F}) {
    Track track = trackOf(row, Channel::rotation, Interpolation::cubicSpline);
    for (float& value : track.values) {
      value *= sign;
    }
    for (std::size_t which = 0; which < track.times.size(); ++which) {
      KeyedRow changed = readTrack(track, rate, RowDetail::values);
      RowKey& key = changed.keys[which];
      key.values[0] += 0.5;
      key.valuesChanged = true;
      const Track written = writeTrack(track, changed, rate).track;
      CAPTURE(sign, which);
      CHECK(largestMiss(track, written) < 3.0 * degree);
      // Its shown slopes are those that it had.
      const RowKey again = readTrack(written, rate, RowDetail::values).keys[which];
      CHECK(glm::length(firstThree(again.inSlopes) - firstThree(key.inSlopes)) < 1e-3);
      CHECK(glm::length(firstThree(again.outSlopes) - firstThree(key.outSlopes)) < 1e-3);
    }
  }
}

TEST_CASE("Shown angles of a cubic track follow it where it turns nearly all around between two keys",
          "[keys]") {
  for (const double step : {270.0, -270.0, 350.0}) {
    Track track;
    track.channel = Channel::rotation;
    track.interpolation = Interpolation::cubicSpline;
    track.width = 4;
    for (int i = 0; i < 3; ++i) {
      const double half = 0.5 * step * i * degree;
      const double speed = 0.5 * step * degree; // of half the angle, a key each second
      track.times.push_back(static_cast<float>(i));
      const auto add = [&](double x, double w) {
        track.values.insert(track.values.end(), {static_cast<float>(x), 0.0F, 0.0F, static_cast<float>(w)});
      };
      add(speed * std::cos(half), -speed * std::sin(half));
      add(std::sin(half), std::cos(half));
      add(speed * std::cos(half), -speed * std::sin(half));
    }
    const KeyedRow read = readTrack(track, rate, RowDetail::values);
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(step, i);
      CHECK(read.keys[i].values[0] == Approx(step * static_cast<double>(i)).margin(1e-3));
      CHECK(read.keys[i].outSlopes[0] == Approx(step / rate).epsilon(1e-3));
    }
  }
}

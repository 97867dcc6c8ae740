// Spans between keys and the source's own curve, against what they say in another way.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/math/rotation.h"
#include "rig/rekey/source_curve.h"
#include "rig/rekey/span_fit.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

Vec4 numbers(Row& row, double reach) {
  const Vec3 first = row.vector(reach);
  return {first.x, first.y, first.z, row.around(reach)};
}

Vec4 asNumbers(const Quat& turn) {
  return {turn.x, turn.y, turn.z, turn.w};
}

Vec4 unit(const Vec4& value) {
  return value / glm::length(value);
}

/// A cubic by its Bezier points, each mixed with the next one until one is left.
Vec4 byMixing(std::vector<Vec4> points, double share) {
  for (; points.size() > 1; points.pop_back()) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      points[i] = (1.0 - share) * points[i] + share * points[i + 1];
    }
  }
  return points.front();
}

/// A cubic track of so many uneven keys, beginning late.
Track cubicTrack(Row& row, Channel channel, std::size_t keys) {
  Track track;
  track.channel = channel;
  track.interpolation = Interpolation::cubicSpline;
  track.width = channel == Channel::rotation ? 4 : 3;
  const double wild = channel == Channel::rotation ? 0.4 : 1.5;
  double time = 0.3;
  for (std::size_t i = 0; i < keys; ++i, time += row.between(0.1, 0.4)) {
    track.times.push_back(static_cast<float>(time));
    const Vec4 value = channel == Channel::rotation
                           ? asNumbers(axisAngle(glm::normalize(row.vector(1.0) + Vec3(1.2)), 0.4 * time))
                           : numbers(row, 2.0);
    for (const Vec4& part : {numbers(row, wild), value, numbers(row, wild)}) {
      for (std::size_t c = 0; c < static_cast<std::size_t>(track.width); ++c) {
        track.values.push_back(static_cast<float>(part[c]));
      }
    }
  }
  return track;
}

/// The curve's piece between two keys at a time, of unit length.
Vec4 pieceAt(const Key& from, const Key& to, double timeSeconds) {
  const double length = static_cast<double>(to.time) - static_cast<double>(from.time);
  const double share = (timeSeconds - static_cast<double>(from.time)) / length;
  return unit(byMixing({from.value, from.value + length / 3.0 * from.outTangent,
                        to.value - length / 3.0 * to.inTangent, to.value},
                       share));
}

const std::vector<std::size_t> twoToFour{2, 3, 4};

} // namespace

TEST_CASE("a cubic span is the Bezier curve of its values and tangents") {
  Row row(13);
  for (int i = 0; i < 40; ++i) {
    ChannelSpan span;
    span.startSeconds = row.around(2.0);
    span.endSeconds = span.startSeconds + row.between(0.1, 3.0);
    span.start = numbers(row, 2.0);
    span.end = numbers(row, 2.0);
    span.isCubic = true;
    span.outTangent = numbers(row, 4.0);
    span.inTangent = numbers(row, 4.0);
    const double third = (span.endSeconds - span.startSeconds) / 3.0;
    for (const double share : {0.0, 0.1, 0.37, 0.5, 0.8, 1.0}) {
      const double time = span.startSeconds + share * 3.0 * third;
      const Vec4 told = byMixing(
          {span.start, span.start + third * span.outTangent, span.end - third * span.inTangent, span.end},
          share);
      for (const Channel channel : {Channel::translation, Channel::rotation, Channel::scale}) {
        CHECK(glm::length(span.at(channel, time) - told) < 1e-9);
      }
    }
  }
}

TEST_CASE("a span without tangents goes straight, and turns evenly about one axis") {
  ChannelSpan span;
  span.startSeconds = 2.0;
  span.endSeconds = 4.0;
  const Vec3 axis = glm::normalize(Vec3(1.0, 2.0, -0.5));
  span.start = asNumbers(axisAngle(axis, 0.2));
  span.end = asNumbers(axisAngle(axis, 1.4));
  for (const double share : {0.0, 0.25, 0.5, 0.9, 1.0}) {
    const Vec4 turned = span.at(Channel::rotation, 2.0 + 2.0 * share);
    CHECK(glm::length(turned - asNumbers(axisAngle(axis, 0.2 + 1.2 * share))) < 1e-12);
    for (const Channel channel : {Channel::translation, Channel::scale}) {
      const Vec4 line = (1.0 - share) * span.start + share * span.end;
      CHECK(glm::length(span.at(channel, 2.0 + 2.0 * share) - line) < 1e-12);
    }
  }
}

TEST_CASE("a fit is judged at every frame and half frame strictly inside its span") {
  Row row(23);
  for (int i = 0; i < 200; ++i) {
    const double rate = std::vector{24.0, 25.0, 30.0, 60.0}[row.below(4)];
    const int first = static_cast<int>(row.below(30));
    const int last = first + static_cast<int>(row.below(12));
    const double aside = row.once(2) ? 0.0 : row.between(0.001, 0.4);
    const double start = (0.5 * first - 0.5 * aside) / rate;
    const double end = (0.5 * last + 0.5 * aside) / rate;
    std::vector<double> told;
    for (int half = aside > 0.0 ? first : first + 1; half < last || (half == last && aside > 0.0); ++half) {
      told.push_back(0.5 * half / rate);
    }
    const std::vector<double> times = checkTimes(rate, start, end);
    CAPTURE(rate, first, last, aside);
    REQUIRE(times.size() == told.size());
    for (std::size_t k = 0; k < times.size(); ++k) {
      CHECK(times[k] == Approx(told[k]).margin(1e-6));
    }
  }
}

TEST_CASE("the slope of the source's curve is how fast its values change, from either side of a key") {
  Row row(29);
  constexpr double step = 1e-5;
  for (const std::size_t keys : twoToFour) {
    for (const Channel channel : {Channel::translation, Channel::rotation, Channel::scale}) {
      const Track track = cubicTrack(row, channel, keys);
      const SourceCurve curve(track);
      std::vector<double> times(track.times.begin(), track.times.end());
      const double first = times.front();
      const double last = times.back();
      times.insert(times.end(), {first - 0.1, first + 0.03, last - 0.03, last + 0.1});
      for (const double time : times) {
        for (const int side : {-1, 1}) {
          const Vec4 change = (curve.value(time + side * step) - curve.value(time)) / (side * step);
          CAPTURE(keys, static_cast<int>(channel), time, side);
          CHECK(glm::length(curve.slope(time, side) - change) < 1e-2 * (1.0 + glm::length(change)));
        }
      }
    }
  }
}

TEST_CASE("a curve that is no cubic spline has no tangents") {
  Row row(31);
  Track track = cubicTrack(row, Channel::translation, 3);
  for (const Interpolation interpolation : {Interpolation::linear, Interpolation::step}) {
    track.interpolation = interpolation;
    track.values.resize(9);
    const SourceCurve curve(track);
    const float time = track.times[1] - 0.02F;
    CHECK(curve.slope(static_cast<double>(time), 1) == Vec4(0.0));
    CHECK(curve.cutAt(time).value == curve.value(static_cast<double>(time)));
    CHECK(curve.cutAt(time).inTangent == Vec4(0.0));
  }
}

TEST_CASE("a cut has the source's own numbers at a key and the curve's between keys, and is no source key") {
  Row row(37);
  for (const std::size_t keys : twoToFour) {
    const Track track = cubicTrack(row, Channel::translation, keys);
    const SourceCurve curve(track);
    for (std::size_t i = 0; i < keys; ++i) {
      const Key own = keyOfSource(track, i);
      CHECK(own.sourceKey == i);
      CHECK(own.time == track.times[i]);
      for (const float aside : {-1.5e-5F, 0.0F, 1.5e-5F}) {
        const Key cut = curve.cutAt(track.times[i] + aside);
        CHECK(cut.time == track.times[i] + aside);
        CHECK(cut.value == own.value);
        CHECK(cut.inTangent == own.inTangent);
        CHECK(cut.outTangent == own.outTangent);
        CHECK_FALSE(cut.sourceKey);
      }
      for (const float aside : {-1e-3F, 1e-3F}) {
        const float time = track.times[i] + aside;
        const Key cut = curve.cutAt(time);
        CHECK(cut.value == curve.value(static_cast<double>(time)));
        CHECK((cut.value == own.value) == (time < track.times.front() || time > track.times.back()));
        CHECK(cut.inTangent == curve.slope(static_cast<double>(time), -1));
        CHECK(cut.outTangent == curve.slope(static_cast<double>(time), 1));
      }
    }
  }
}

TEST_CASE("keys put in beside a cut keep a turning curve where it was, and others need none") {
  Row row(43);
  std::size_t most = 0;
  for (int i = 0; i < 12; ++i) {
    const Track track = cubicTrack(row, Channel::rotation, 3);
    const SourceCurve curve(track);
    const double middle =
        0.5 * static_cast<double>(track.times[1]) + 0.5 * static_cast<double>(track.times[2]);
    const Key cut = curve.cutAt(static_cast<float>(middle));
    for (const bool isFromSource : {true, false}) {
      const Key from = isFromSource ? keyOfSource(track, 1) : cut;
      const Key to = isFromSource ? cut : keyOfSource(track, 2);
      std::vector<Key> keys{from};
      curve.addJoints(from, to, keys);
      keys.push_back(to);
      most = std::max(most, keys.size());
      for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
        REQUIRE(keys[k].time < keys[k + 1].time);
        for (const double share : {0.1, 0.25, 0.5, 0.75, 0.9}) {
          const double time = (1.0 - share) * static_cast<double>(keys[k].time) +
                              share * static_cast<double>(keys[k + 1].time);
          CHECK(glm::length(pieceAt(keys[k], keys[k + 1], time) - curve.value(time)) < 3e-7);
        }
      }
    }
    std::vector<Key> none;
    const Track moved = cubicTrack(row, Channel::translation, 3);
    SourceCurve(moved).addJoints(keyOfSource(moved, 0), keyOfSource(moved, 1), none);
    CHECK(none.empty());
  }
  CHECK(most > 4);
}

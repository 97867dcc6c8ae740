// As few keys as keep every one of them.
#include "rig/retarget/thin_keys.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "core/anim/sampling.h"
#include "core/math/rotation.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

const Vec3 sideways = glm::normalize(Vec3(0.3, 1.0, -0.4));

/// Times that ascend by uneven steps.
std::vector<float> unevenTimes(Row& row, std::size_t count) {
  std::vector<float> times;
  for (double time = 0.25; times.size() < count; time += row.between(0.02, 0.08)) {
    times.push_back(static_cast<float>(time));
  }
  return times;
}

/// The keys that the longest spans keep, each looked for one by one from the key before it; `holds(a, b)`
/// says whether all between two keys are kept.
template <typename Holds>
std::vector<float> longestSpans(const std::vector<float>& times, const Holds& holds) {
  std::vector<float> kept{times.front()};
  for (std::size_t from = 0; from + 1 < times.size();) {
    std::size_t to = from + 1;
    while (to + 1 < times.size() && holds(from, to + 1)) {
      ++to;
    }
    kept.push_back(times[to]);
    from = to;
  }
  return kept;
}

double shareBetween(const std::vector<float>& times, std::size_t from, std::size_t to, std::size_t at) {
  return (static_cast<double>(times[at]) - static_cast<double>(times[from])) /
         (static_cast<double>(times[to]) - static_cast<double>(times[from]));
}

} // namespace

TEST_CASE(
    "keys of a place that bends one way are as far apart as the distance allows, however many there are") {
  Row row(5);
  for (std::size_t count = 1; count <= 70; ++count) {
    const std::vector<float> times = unevenTimes(row, count);
    std::vector<Vec3> places;
    for (const float time : times) {
      const auto t = static_cast<double>(time);
      places.emplace_back(t * t, 1.0 - 2.0 * t, 0.5 * t * t);
    }
    for (const double distance : {0.0005, 0.01, 100.0}) {
      const auto holds = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i <= to; ++i) {
          const Vec3 line = glm::mix(places[from], places[to], shareBetween(times, from, to, i));
          if (glm::length(line - places[i]) > distance) {
            return false;
          }
        }
        return true;
      };
      CAPTURE(count, distance);
      CHECK(thinPlaces(NodeIndex(3), times, places, distance).times == longestSpans(times, holds));
    }
  }
}

TEST_CASE("keys of a turn that speeds up are as far apart as the angle allows, however many there are") {
  Row row(6);
  for (std::size_t count = 2; count <= 60; ++count) {
    const std::vector<float> times = unevenTimes(row, count);
    std::vector<double> angles;
    std::vector<Quat> turns;
    for (const float time : times) {
      angles.push_back(0.6 * static_cast<double>(time) * static_cast<double>(time));
      turns.push_back((row.once(2) ? -1.0 : 1.0) * axisAngle(sideways, angles.back()));
    }
    constexpr double radians = 0.004;
    const auto holds = [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i <= to; ++i) {
        const double share = shareBetween(times, from, to, i);
        if (std::abs(angles[from] + share * (angles[to] - angles[from]) - angles[i]) > radians) {
          return false;
        }
      }
      return true;
    };
    if (angles.back() - angles.front() <= radians) {
      continue;
    }
    CAPTURE(count);
    CHECK(thinTurns(NodeIndex(3), times, turns, radians).times == longestSpans(times, holds));
  }
}

TEST_CASE("a thinned track comes within the distance of every place that it was made of") {
  Row row(17);
  for (int round = 0; round < 30; ++round) {
    const std::vector<float> times = unevenTimes(row, 40);
    std::vector<Vec3> places{Vec3(1.0, 2.0, 3.0)};
    while (places.size() < times.size()) {
      places.push_back(places.back() + row.vector(0.01));
    }
    const Track track = thinPlaces(NodeIndex(3), times, places, 0.02);
    CHECK(track.times.size() < times.size());
    CHECK(track.times.front() == times.front());
    CHECK(track.times.back() == times.back());
    for (std::size_t i = 0; i < times.size(); ++i) {
      Vec3 at(0.0);
      sampleTrack(track, static_cast<double>(times[i]), &at.x);
      CHECK(glm::length(at - places[i]) < 0.02 + 1e-5);
    }
  }
}

TEST_CASE("a thinned track comes within the angle of every turn that it was made of") {
  Row row(18);
  for (int round = 0; round < 30; ++round) {
    const std::vector<float> times = unevenTimes(row, 40);
    std::vector<Quat> turns{axisAngle(sideways, 2.0)};
    while (turns.size() < times.size()) {
      turns.push_back((row.once(2) ? -1.0 : 1.0) *
                      glm::normalize(turns.back() * axisAngle(glm::normalize(row.vector(1.0) + Vec3(0.01)),
                                                              row.around(0.02))));
    }
    const Track track = thinTurns(NodeIndex(3), times, turns, 0.03);
    CHECK(track.times.size() < times.size());
    CHECK(track.times.front() == times.front());
    CHECK(track.times.back() == times.back());
    for (std::size_t i = 0; i < times.size(); ++i) {
      Vec4 at(0.0);
      sampleTrack(track, static_cast<double>(times[i]), &at.x);
      CHECK(angleBetween(Quat(at.w, at.x, at.y, at.z), turns[i]) < 0.03 + 1e-5);
    }
    for (std::size_t i = 4; i < track.values.size(); i += 4) {
      float product = 0.0F;
      for (std::size_t c = 0; c < 4; ++c) {
        product += track.values[i + c] * track.values[i + c - 4];
      }
      CHECK(product > 0.0F);
    }
  }
}

TEST_CASE("a place off the line by the distance goes, one by more stays") {
  const std::vector<float> times{0.0F, 1.0F, 2.0F};
  const auto keysOf = [&](double off) {
    return thinPlaces(NodeIndex(3), times, {Vec3(0.0), Vec3(0.0, off, 0.0), Vec3(0.0)}, 0.5).times;
  };
  CHECK(keysOf(0.5) == std::vector<float>{0.0F, 2.0F});
  CHECK(keysOf(-0.5) == std::vector<float>{0.0F, 2.0F});
  CHECK(keysOf(0.51) == times);
  CHECK(keysOf(-0.51) == times);
}

TEST_CASE("turns that all lie within the angle of the first have one key, whatever their signs") {
  const std::vector<float> times{0.0F, 1.0F, 2.0F};
  const auto keysOf = [&](double second, double third, double sign) {
    return thinTurns(NodeIndex(3), times,
                     {axisAngle(sideways, 1.0), sign * axisAngle(sideways, 1.0 + second),
                      axisAngle(sideways, 1.0 + third)},
                     0.1)
        .times;
  };
  for (const double sign : {1.0, -1.0}) {
    CAPTURE(sign);
    CHECK(keysOf(0.099, -0.099, sign) == std::vector<float>{0.0F});
    CHECK(keysOf(0.0, 0.101, sign) == std::vector<float>{0.0F, 2.0F});
    CHECK(keysOf(0.101, 0.0, sign) == times);
    CHECK(keysOf(-0.101, 0.0, sign) == times);
  }
}

TEST_CASE("thinned tracks are linear ones of the node, places of three numbers and turns of four") {
  const Track places = thinPlaces(NodeIndex(3), {0.5F}, {Vec3(1.0, 2.0, 3.0)}, 0.1);
  CHECK(places.node == NodeIndex(3));
  CHECK(places.channel == Channel::translation);
  CHECK(places.interpolation == Interpolation::linear);
  CHECK(places.width == 3);
  CHECK(places.times == std::vector<float>{0.5F});
  CHECK(places.values == std::vector<float>{1.0F, 2.0F, 3.0F});
  const Track turns = thinTurns(NodeIndex(4), {0.5F}, {Quat(0.8, 0.0, 0.6, 0.0)}, 0.1);
  CHECK(turns.node == NodeIndex(4));
  CHECK(turns.channel == Channel::rotation);
  CHECK(turns.interpolation == Interpolation::linear);
  CHECK(turns.width == 4);
  CHECK(turns.values == std::vector<float>{0.0F, 0.6F, 0.0F, 0.8F});
}

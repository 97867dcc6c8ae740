// Where a limb's end comes to at a stop plane, and where it rests, in closed form.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/motion/stop.h"
#include "tests/support/nodes.h"
#include "tests/support/rig/moving_biped.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// A trail of a limb of length 1, its range from 1 s to 2 s, whose stop is the ground: nothing gets below 0.
SolvedTrail stoppedAtGround(const std::vector<Rest>& rests = {}) {
  SolvedTrail solved;
  solved.limb.restLength = 1.0;
  solved.settings.stopAt = StopPlane{Vec3(5.0, 0.0, -3.0), Vec3(0.0, -2.5, 0.0)};
  solved.rests = rests;
  solved.startSeconds = 1.0;
  solved.endSeconds = 2.0;
  solved.tipSeconds = 2.0;
  solved.windowStartSeconds = 0.5;
  solved.windowEndSeconds = 2.5;
  return solved;
}

double distance(const Vec3& a, const Vec3& b) {
  return glm::length(a - b);
}

/// What is left of a share of the way where it gives way before it comes to all of it.
double givingWay(double wanted) {
  const double most = std::min(wanted, 1.6);
  return wanted <= 0.4 ? wanted : most - (most - 0.4) * (most - 0.4) / 2.4;
}

/// A chain of one bone along +X whose base is moved so far at every frame.
struct SteppedLimb {
  Scene scene;
  Clip clip;
  Limb limb;

  SteppedLimb(const std::vector<double>& places, double framesPerSecond) {
    const NodeIndex base = addNode(scene, "base", NodeIndex::none, Vec3(0.0));
    limb.joints = {base};
    limb.endNode = addNode(scene, "end", base, Vec3(2.0, 0.0, 0.0));
    limb.restLength = 2.0;
    VectorKeys keys;
    for (std::size_t i = 0; i < places.size(); ++i) {
      keys.emplace_back(static_cast<double>(i) / framesPerSecond, Vec3(0.0, places[i], 0.0));
    }
    clip.tracks.emplace_back(vectorTrack(base, Channel::translation, Interpolation::linear, keys));
    clip.framesPerSecond = framesPerSecond;
    setEndsFromKeys(clip);
  }

  [[nodiscard]] std::vector<Rest> rests(const Vec2& rangeSeconds) const {
    const SolvedAdjustments none;
    FrameSource frames(scene, clip, none, {limb.joints[0], limb.endNode}, nullptr);
    return restsIn(clip, limb, rangeSeconds, frames);
  }
};

/// The first and the last frame of every run of short steps between two frames.
std::vector<std::pair<int, int>> quietRuns(const std::vector<double>& places, int first, int last,
                                           double farthest, std::size_t leastSteps) {
  std::vector<std::pair<int, int>> runs;
  for (int from = first; from <= last;) {
    int to = from;
    while (to < last && std::abs(places[static_cast<std::size_t>(to) + 1] -
                                 places[static_cast<std::size_t>(to)]) <= farthest) {
      ++to;
    }
    if (static_cast<std::size_t>(to - from) >= leastSteps) {
      runs.emplace_back(from, to);
    }
    from = to + 1;
  }
  return runs;
}

/// Places that stand, creep and stride, by steps well below and above the farthest of a rest.
std::vector<double> restingPlaces(Row& row, int count, double farthest) {
  std::vector<double> places{0.0};
  while (static_cast<int>(places.size()) < count) {
    const bool rests = row.once(2);
    const auto length = 1 + row.below(9);
    for (std::uint32_t i = 0; i < length && static_cast<int>(places.size()) < count; ++i) {
      places.push_back(places.back() + farthest * (rests ? row.around(0.95) : row.between(1.05, 4.0)));
    }
  }
  return places;
}

} // namespace

TEST_CASE("a target in front of its stop stays, as does one with a stop that has no direction") {
  SolvedTrail solved = stoppedAtGround();
  const StoppedReach reach{{0.0, 1.0, 0.0}, {0.5, 0.6, 0.0}, {1.5, 0.01, 0.2}, 1.5};
  CHECK(stoppedTarget(solved, reach) == reach.wanted);
  StoppedReach touching = reach;
  touching.wanted.y = 0.0;
  CHECK(stoppedTarget(solved, touching) == touching.wanted);
  StoppedReach through = reach;
  through.wanted.y = -0.5;
  CHECK(stoppedTarget(solved, through) != through.wanted);
  solved.settings.stopAt->normal = Vec3(0.0);
  CHECK(stoppedTarget(solved, through) == through.wanted);
}

TEST_CASE("a target beyond its stop slides along it to the wanted length, at most twice as far aside") {
  Row row(41);
  const SolvedTrail solved = stoppedAtGround();
  int longest = 0;
  int limited = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 base(row.around(0.5), row.between(0.1, 1.5), row.around(0.5));
    const StoppedReach reach{base, base + row.vector(1.0), base + row.vector(2.5), 1.5};
    if (reach.wanted.y >= 0.0) {
      continue;
    }
    // What is beyond in the clip comes no farther.
    const double height = std::max(reach.wanted.y, std::min(0.0, reach.original.y));
    const Vec3 aside(reach.wanted.x - base.x, 0.0, reach.wanted.z - base.z);
    const double wanted = distance(reach.wanted, base);
    const double free = std::sqrt(std::max(wanted * wanted - std::pow(base.y - height, 2.0), 0.0));
    const double far = std::min(std::max(free, glm::length(aside)), 2.0 * glm::length(aside));
    const Vec3 told = Vec3(base.x, height, base.z) + glm::normalize(aside) * far;
    longest += far == free ? 1 : 0;
    limited += far < free ? 1 : 0;
    CAPTURE(i);
    CHECK(distance(stoppedTarget(solved, reach), told) < 1e-9);
  }
  CHECK(longest > 20);
  CHECK(limited > 5);
}

TEST_CASE("a limb straight above its stop has no side to slide to") {
  const StoppedReach reach{{0.3, 1.0, 0.2}, {0.3, 0.4, 0.2}, {0.3, -0.7, 0.2}, 1.5};
  CHECK(distance(stoppedTarget(stoppedAtGround(), reach), Vec3(0.3, 0.0, 0.2)) < 1e-12);
}

TEST_CASE("a limb that rests at its stop keeps its way to it, and slides freely a tenth of a second away") {
  const Rest rest{1.4, 1.6, {0.4, 0.0, 0.0}};
  const SolvedTrail resting = stoppedAtGround({Rest{0.0, 9.0, {0.0, 0.2, 0.0}}, rest});
  const SolvedTrail free = stoppedAtGround();
  for (const double originalY : {0.5, 0.0, -0.1, -0.4}) {
    const StoppedReach reach{{0.0, 1.0, 0.0}, {0.4, originalY, 0.1}, {1.6, -0.3, 0.3}, 0.0};
    const double entering = originalY > 0.0 ? originalY / (originalY + 0.3) : 0.0;
    const double share = originalY < -0.3 ? 1.0 - 0.3 / -originalY : entering;
    const Vec3 halted = reach.original + share * (reach.wanted - reach.original);
    for (const double away : {-0.2, -0.1, -0.07, -0.05, -0.01, 0.0, 0.01, 0.03, 0.05, 0.099, 0.1, 0.2}) {
      StoppedReach at = reach;
      at.timeSeconds = away < 0.0 ? rest.startSeconds + away : rest.endSeconds + away;
      const double u = std::min(1.0, std::abs(away) / 0.1);
      const Vec3 slid = stoppedTarget(free, at);
      const Vec3 told = halted + u * u * (3.0 - 2.0 * u) * (slid - halted);
      CAPTURE(originalY, away);
      CHECK(distance(stoppedTarget(resting, at), told) < 1e-9);
    }
    StoppedReach within = reach;
    within.timeSeconds = 1.5;
    CHECK(distance(stoppedTarget(resting, within), halted) < 1e-12);
  }
}

TEST_CASE("only what rests within a tenth of the limb of its stop is kept there") {
  const StoppedReach reach{{0.0, 1.0, 0.0}, {0.4, 0.3, 0.1}, {1.6, -0.3, 0.3}, 1.5};
  const Vec3 slid = stoppedTarget(stoppedAtGround(), reach);
  for (const auto& [height, isKept] : {std::pair{-0.3, true}, {0.099, true}, {0.101, false}}) {
    const Vec3 target = stoppedTarget(stoppedAtGround({Rest{1.4, 1.6, {0.0, height, 0.0}}}), reach);
    CAPTURE(height);
    CHECK((distance(target, slid) > 0.01) == isKept);
  }
}

TEST_CASE("a limb that comes to rest keeps a fifth of its height over the stop and gives way before that") {
  SolvedTrail solved = stoppedAtGround();
  solved.comesToRest = true;
  for (const double height : {0.2, 1.0}) {
    for (const double lowered : {-0.5, 0.0, 0.2, 0.31, 0.33, 0.5, 0.8, 1.0, 1.27, 1.29, 2.0, 5.0}) {
      const StoppedReach reach{
          {0.0, 2.0, 0.0}, {0.4, height, 0.1}, {1.6, height * (1.0 - lowered), -0.3}, 1.5};
      const double wanted = lowered / 0.8;
      const double share = wanted <= 0.0 ? 1.0 : givingWay(wanted) / wanted;
      const Vec3 told = reach.original + share * (reach.wanted - reach.original);
      const Vec3 target = stoppedTarget(solved, reach);
      CAPTURE(height, lowered);
      CHECK(distance(target, told) < 1e-9);
      CHECK(target.y >= 0.2 * height - 1e-12);
    }
  }
}

TEST_CASE("a limb that comes to rest and is at its stop in the clip goes away from it and no farther in") {
  SolvedTrail solved = stoppedAtGround();
  solved.comesToRest = true;
  for (const double height : {0.0, -0.2}) {
    const StoppedReach into{{0.0, 1.0, 0.0}, {0.4, height, 0.1}, {1.6, height - 0.1, 0.3}, 1.5};
    CHECK(stoppedTarget(solved, into) == into.original);
    StoppedReach out = into;
    out.wanted.y = height + 0.1;
    CHECK(stoppedTarget(solved, out) == out.wanted);
    out.wanted.y = height;
    CHECK(stoppedTarget(solved, out) == out.wanted);
  }
}

TEST_CASE("a limb comes to rest where it rests at its stop between the tip and a fifth of a second after") {
  SolvedTrail forwards = stoppedAtGround();
  SolvedTrail backwards = stoppedAtGround();
  backwards.settings.pivot = Pivot::end;
  backwards.tipSeconds = 1.0;
  const Vec3 ground(0.0);
  const auto comes = [](SolvedTrail solved, const std::vector<Rest>& rests) {
    solved.rests = rests;
    return comesToRest(solved);
  };
  for (const auto& [begins, does] :
       {std::pair{1.9, false}, {2.0, false}, {2.01, true}, {2.69, true}, {2.71, false}}) {
    CAPTURE(begins);
    CHECK(comes(forwards, {{begins, begins + 0.3, ground}}) == does);
    CHECK(comes(forwards, {{0.0, 0.5, ground}, {begins, begins + 0.3, ground}}) == does);
    // The other way round in time.
    CHECK(comes(backwards, {{3.0 - begins - 0.3, 3.0 - begins, ground}}) == does);
    CHECK(comes(backwards, {{3.0 - begins - 0.3, 3.0 - begins, ground}, {2.4, 2.5, ground}}) == does);
  }
  for (const auto& [height, does] : {std::pair{-1.0, true}, {0.099, true}, {0.101, false}}) {
    CHECK(comes(forwards, {{2.2, 2.5, {0.0, height, 0.0}}}) == does);
    CHECK(comes(backwards, {{0.5, 0.8, {0.0, height, 0.0}}}) == does);
  }
  forwards.rests.reset();
  CHECK_FALSE(comesToRest(forwards));
}

TEST_CASE("rests are the runs of short steps that last, at whatever rate and in whatever range") {
  Row row(59);
  std::size_t found = 0;
  for (int round = 0; round < 150; ++round) {
    const double rate = std::vector{2.0, 5.0, 12.0, 24.0, 25.0, 60.0}[row.below(6)];
    const double farthest = 0.25 * 2.0 / rate;
    const auto leastSteps = static_cast<std::size_t>(std::max(1L, std::lround(0.15 * rate)));
    const std::vector<double> places = restingPlaces(row, 50, farthest);
    const SteppedLimb stepped(places, rate);
    const int first = static_cast<int>(row.below(12));
    const int last = 20 + static_cast<int>(row.below(40));
    const Vec2 range((first == 0 ? -3.4 : first - 0.3) / rate, (last + 0.3) / rate);
    const auto told = quietRuns(places, first, std::min(last, 49), farthest, leastSteps);
    const std::vector<Rest> rests = stepped.rests(range);
    CAPTURE(round, rate, first, last);
    REQUIRE(rests.size() == told.size());
    for (std::size_t i = 0; i < rests.size(); ++i) {
      CHECK(rests[i].startSeconds == Approx(told[i].first / rate).margin(1e-9));
      CHECK(rests[i].endSeconds == Approx(told[i].second / rate).margin(1e-9));
      const double place = places[static_cast<std::size_t>(told[i].first) + leastSteps];
      CHECK(distance(rests[i].place, Vec3(2.0, place, 0.0)) < 1e-5);
    }
    found += rests.size();
  }
  CHECK(found > 200);
}

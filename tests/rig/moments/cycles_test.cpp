// Which limbs go round in a clip that closes.
#include "rig/moments/cycles.h"

#include <cmath>
#include <functional>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr double round360 = 2.0 * pi;

/// Where a limb is at a part of the way round, 0 to 1: to the right, up and to the front of its body.
using Course = std::function<Vec3(double)>;

Course circle(double rounds, double radius = 1.0) {
  return [=](double part) {
    const double angle = round360 * rounds * part;
    return radius * Vec3(0.6 * std::cos(angle), std::sin(angle), 0.8 * std::cos(angle));
  };
}

Course later(const Course& course, double part) {
  return [=](double at) { return course(at + part); };
}

Course inMirror(const Course& course) {
  return [=](double at) { return course(at) * Vec3(-1.0, 1.0, 1.0); };
}

Vec3 resting(double /*part*/) {
  return {0.1, 0.2, 0.3};
}

struct Going {
  LimbPlace place;
  Course course;
};

/// Half frames of a clip that goes round once.
struct Sampling {
  int period = 40;
  bool repeatsFirst = true; ///< Else the clip ends a frame before that.
  bool hasSides = true;
  std::uint32_t turnsBy = 0; ///< Seed of how the body turns about as it goes; 0: it does not.

  [[nodiscard]] int samples() const { return repeatsFirst ? period + 1 : period - 1; }
};

std::vector<bool> cyclesOf(const std::vector<Going>& going, const Sampling& sampling = {}) {
  BodyMotion motion;
  std::vector<Limb> limbs(going.size());
  motion.limbs.resize(going.size());
  Row row(sampling.turnsBy);
  for (std::size_t i = 0; i < going.size(); ++i) {
    static_cast<LimbPlace&>(limbs[i]) = going[i].place;
    limbs[i].joints = {NodeIndex(i)};
    motion.limbs[i].reach = 1.0;
  }
  for (int sample = 0; sample < sampling.samples(); ++sample) {
    const double heading = sampling.turnsBy == 0 ? 0.0 : row.around(3.0);
    const Vec3 forward(std::sin(heading), 0.0, std::cos(heading));
    const Vec3 right(-forward.z, 0.0, forward.x);
    motion.forward.push_back(sampling.hasSides ? forward : Vec3(0.0));
    for (std::size_t i = 0; i < going.size(); ++i) {
      const Vec3 place = going[i].course(static_cast<double>(sample) / sampling.period);
      motion.limbs[i].places.push_back(place.x * right + Vec3(0.0, place.y, 0.0) + place.z * forward);
    }
  }
  return limbsInCycles(motion, limbs);
}

bool goesRound(const LimbPlace& place, const Course& course, const Sampling& sampling = {}) {
  return cyclesOf({{place, course}}, sampling).front();
}

const LimbPlace chain{LimbKind::chain};
using Answers = std::vector<bool>;

} // namespace

TEST_CASE("a limb alone goes round where it does the same a half, a third or a quarter of the clip later") {
  for (const bool repeatsFirst : {true, false}) {
    for (const std::uint32_t turnsBy : {0U, 5U}) {
      Sampling sampling;
      sampling.period = 60;
      sampling.repeatsFirst = repeatsFirst;
      sampling.turnsBy = turnsBy;
      CAPTURE(repeatsFirst, turnsBy);
      for (const int rounds : {2, 3, 4, 6, 8}) {
        CAPTURE(rounds);
        CHECK(goesRound(chain, circle(rounds), sampling));
        CHECK(goesRound(biped::leftArm, circle(rounds), sampling));
      }
      for (const int rounds : {1, 5, 7}) {
        CAPTURE(rounds);
        CHECK_FALSE(goesRound(chain, circle(rounds), sampling));
        CHECK_FALSE(goesRound(biped::leftArm, circle(rounds), sampling));
      }
    }
  }
}

TEST_CASE("a clip that ends a frame before its first pose comes again goes round in one frame more") {
  CHECK(goesRound(chain, circle(10.0), {40, false}));
  CHECK(goesRound(chain, circle(10.0), {40, true}));
}

TEST_CASE("a limb goes round with its counterpart, a half later or mirrored a half or a quarter later") {
  const Course once = circle(1.0);
  for (const std::uint32_t turnsBy : {0U, 9U}) {
    Sampling sampling;
    sampling.turnsBy = turnsBy;
    const auto armsOf = [&](const Course& right) {
      return cyclesOf({{biped::leftArm, once}, {biped::rightArm, right}}, sampling);
    };
    CHECK(armsOf(later(once, 0.5)) == Answers{true, true});
    CHECK(armsOf(inMirror(later(once, 0.5))) == Answers{true, true});
    CHECK(armsOf(inMirror(later(once, -0.25))) == Answers{true, false});
    CHECK(armsOf(inMirror(later(once, 0.25))) == Answers{false, true});
    CHECK(armsOf(once) == Answers{false, false});
    CHECK(armsOf(later(once, 0.25)) == Answers{false, false});
    CHECK(armsOf(inMirror(once)) == Answers{false, false});
    CHECK(armsOf(resting) == Answers{false, false});
  }
}

TEST_CASE("without two sides, and as chains of the user's, limbs have no counterparts") {
  const Course once = circle(1.0);
  Sampling oneSided;
  oneSided.hasSides = false;
  const Course opposite = later(once, 0.5);
  CHECK(cyclesOf({{biped::leftArm, once}, {biped::rightArm, opposite}}, oneSided) == Answers{false, false});
  const LimbPlace left{LimbKind::chain, LimbSide::left};
  const LimbPlace right{LimbKind::chain, LimbSide::right};
  CHECK(cyclesOf({{left, once}, {right, opposite}}) == Answers{false, false});
  CHECK(cyclesOf({{biped::leftArm, once}, {biped::leftArm, opposite}}) == Answers{false, false});
}

TEST_CASE("a limb in the middle is its own counterpart, to and fro from side to side") {
  const Course swaying = [](double part) {
    return Vec3(std::sin(round360 * part), 0.3 * std::cos(2.0 * round360 * part), 0.0);
  };
  CHECK(goesRound(biped::spine, swaying));
  CHECK_FALSE(goesRound(chain, swaying));
  Sampling oneSided;
  oneSided.hasSides = false;
  CHECK_FALSE(goesRound(biped::spine, swaying, oneSided));
}

TEST_CASE("legs of one body go together, whichever of them it is that goes round") {
  const LimbPlace third{LimbKind::leg, LimbSide::middle};
  for (const bool isFirst : {true, false}) {
    const Course twice = circle(2.0);
    const Course first = isFirst ? twice : resting;
    const Course last = isFirst ? resting : twice;
    CHECK(cyclesOf({{biped::leftLeg, first},
                    {biped::leftArm, resting},
                    {biped::rightLeg, resting},
                    {third, last}}) == Answers{true, false, true, true});
  }
  CHECK(cyclesOf({{biped::leftArm, circle(2.0)}, {biped::leftLeg, resting}, {biped::rightArm, resting}}) ==
        Answers{true, false, false});
}

TEST_CASE("legs go round in uneven time as well, three eighths of the clip later, arms do not") {
  const Course once = circle(1.0);
  for (const double part : {3.0 / 8.0, 5.0 / 8.0}) {
    CAPTURE(part);
    const Course behind = later(once, part);
    CHECK(cyclesOf({{biped::leftLeg, once}, {biped::rightLeg, behind}}) == Answers{true, true});
    CHECK(cyclesOf({{biped::leftArm, once}, {biped::rightArm, behind}}) == Answers{false, false});
  }
  CHECK(cyclesOf({{biped::leftLeg, once}, {biped::rightLeg, later(once, 0.25)}}) == Answers{false, false});
  CHECK(cyclesOf({{biped::leftLeg, once}, {biped::rightLeg, resting}}) == Answers{false, false});
}

TEST_CASE("four legs gallop where the two of each pair go one after the other, by however much") {
  const Course once = circle(1.0);
  const auto four = [](const Course& frontLeft, const Course& frontRight, const Course& hindLeft,
                       const Course& hindRight) {
    return cyclesOf({{{LimbKind::leg, LimbSide::left, 1}, frontLeft},
                     {{LimbKind::leg, LimbSide::right, 1}, frontRight},
                     {{LimbKind::leg, LimbSide::left, 2}, hindLeft},
                     {{LimbKind::leg, LimbSide::right, 2}, hindRight}});
  };
  const Answers all(4, true);
  const Answers none(4, false);
  for (const double part : {1.0 / 8.0, 3.0 / 16.0, 1.0 / 4.0, 7.0 / 8.0}) {
    CAPTURE(part);
    const Course behind = later(once, part);
    CHECK(four(once, behind, later(once, 0.4), later(once, 0.4 + part)) == all);
    CHECK(four(once, behind, behind, once) == all);
    CHECK(four(once, behind, resting, resting) == none); // it strikes out
    CHECK(four(once, behind, once, once) == none);
    CHECK(cyclesOf({{biped::leftLeg, once}, {biped::rightLeg, behind}}) == Answers(2, false));
  }
  CHECK(four(once, once, once, once) == none); // it jumps
}

TEST_CASE("what hardly moves, or is too short to be seen twice, does not go round") {
  CHECK(goesRound(chain, circle(2.0, 0.0101)));
  CHECK_FALSE(goesRound(chain, circle(2.0, 0.0099)));
  CHECK(goesRound(biped::leftArm, circle(3.0, 1.0), {9}));
  CHECK(goesRound(biped::leftArm, circle(2.0, 1.0), {8}));
  CHECK_FALSE(goesRound(biped::leftArm, circle(2.0, 1.0), {6}));
}

TEST_CASE("a clip closes where its end is no farther from its beginning than two of its steps") {
  const auto drifting = [](double way) -> Course {
    return [=](double part) {
      const double angle = 2.0 * round360 * part;
      return Vec3(std::cos(angle), way * part, std::sin(angle));
    };
  };
  // In one frame a round of 40 half frames goes 2 sin(9 degrees) of its radius.
  const double step = 2.0 * std::sin(pi / 20.0);
  CHECK(goesRound(chain, drifting(0.0), {80}));
  CHECK(goesRound(chain, drifting(1.95 * step), {80}));
  CHECK_FALSE(goesRound(chain, drifting(2.1 * step), {80}));
}

TEST_CASE("the same is what differs by less than three tenths in the square, however large it is") {
  for (const double size : {0.2, 1.0, 30.0}) {
    const auto halves = [=](double aside) -> Course {
      return [=](double part) {
        const double angle = 2.0 * round360 * part;
        return size * Vec3(std::cos(angle) + aside * std::cos(round360 * part), std::sin(angle),
                           aside * std::sin(round360 * part));
      };
    };
    // Half a clip later what goes round once is opposite: 4 a^2 against 0.55^2 (1 + a^2).
    const double most = std::sqrt(0.3025 / (4.0 - 0.3025));
    CHECK(goesRound(chain, halves(0.97 * most)));
    CHECK_FALSE(goesRound(chain, halves(1.03 * most)));
  }
}

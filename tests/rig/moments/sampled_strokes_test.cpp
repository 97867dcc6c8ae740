// Strokes and landings of motions that are given sample by sample, against a slower way of finding them.
#include "rig/moments/strokes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/moments/landings.h"
#include "rig/moments/moments.h"
#include "tests/support/row.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr double samplesPerSecond = 60.0;

/// A limb whose velocities are given beside its places.
struct GivenLimb : LimbMotion {
  Velocities velocities;
};

std::vector<SampledStroke> strokesIn(const BodyMotion& motion, const GivenLimb& limb, bool goesRound) {
  return strokesOf(motion, limb, limb.velocities, goesRound);
}

/// A limb that goes from place to place by these velocities, in a body that faces +Z.
GivenLimb movedBy(const Vec3& from, const std::vector<Vec3>& velocities) {
  GivenLimb limb;
  limb.places.push_back(from);
  limb.velocities.ways = velocities;
  for (const Vec3& velocity : velocities) {
    limb.velocities.speeds.push_back(glm::length(velocity));
    limb.places.push_back(limb.places.back() + velocity / samplesPerSecond);
  }
  limb.places.pop_back();
  limb.ends = limb.places;
  for (const Vec3& place : limb.places) {
    limb.reach = std::max(limb.reach, glm::length(place));
  }
  return limb;
}

BodyMotion bodyOf(std::size_t samples, double reach) {
  BodyMotion motion;
  motion.samplesPerSecond = samplesPerSecond;
  motion.forward.assign(samples, Vec3(0.0, 0.0, 1.0));
  motion.reach = reach;
  return motion;
}

/// Straight along +Z at these speeds, from a place far behind the start, so that no way leads back to it.
GivenLimb straight(const std::vector<double>& speeds) {
  std::vector<Vec3> velocities;
  velocities.reserve(speeds.size());
  for (const double speed : speeds) {
    velocities.emplace_back(0.0, 0.0, speed);
  }
  return movedBy(Vec3(0.0, 0.0, 0.5), velocities);
}

double cosine(const Vec3& a, const Vec3& b) {
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0.0 ? glm::dot(a, b) / lengths : 0.0;
}

/// docs/moments.md, Strength, of a limb in a body that faces +Z.
double strengthTold(const BodyMotion& motion, const GivenLimb& limb, const SampledStroke& stroke,
                    bool goesRound) {
  const Vec3 from = limb.places[stroke.start];
  const Vec3 to = limb.places[stroke.tip];
  const Vec3 way = limb.ends[stroke.tip] - limb.ends[stroke.start];
  const double travel = glm::length(to - from);
  const double seen = std::min(1.0, std::max(0.2, glm::length(way) / travel));
  const double home = glm::length(to - limb.places[0]);
  const bool isBack = home < 0.15 * limb.reach && glm::length(from - limb.places[0]) - home > 0.8 * travel;
  return limb.velocities.speeds[stroke.peak] / motion.reach *
         std::sqrt(travel / limb.reach * seen * glm::length(to) / limb.reach) *
         std::exp(0.4 * cosine(way, Vec3(0.0, 0.0, 1.0))) * limb.weight * (isBack && !goesRound ? 0.5 : 1.0);
}

/// Whether a stroke with its peak there goes on at a sample.
bool goesOn(const GivenLimb& limb, std::size_t peak, std::size_t sample) {
  return limb.velocities.speeds[sample] > 0.25 * limb.velocities.speeds[peak] &&
         cosine(limb.velocities.ways[sample], limb.velocities.ways[peak]) > -0.2;
}

std::vector<SampledStroke> strokesTold(const BodyMotion& motion, const GivenLimb& limb, bool goesRound) {
  std::vector<SampledStroke> found;
  const std::size_t last = limb.velocities.speeds.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const double speed = limb.velocities.speeds[i];
    const bool rises = i == 0 || limb.velocities.speeds[i - 1] < speed;
    const bool falls = i == last || limb.velocities.speeds[i + 1] <= speed;
    SampledStroke stroke{i, i, i};
    for (; stroke.start > 0 && goesOn(limb, i, stroke.start); --stroke.start) {
    }
    for (; stroke.tip < last && goesOn(limb, i, stroke.tip); ++stroke.tip) {
    }
    const double travel = glm::length(limb.places[stroke.tip] - limb.places[stroke.start]);
    if (speed <= 0.0 || !rises || !falls || speed < 0.25 * motion.reach || travel < 0.15 * limb.reach) {
      continue;
    }
    stroke.strength = strengthTold(motion, limb, stroke, goesRound);
    if (stroke.strength >= 0.5) {
      found.push_back(stroke);
    }
  }
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.strength > b.strength; });
  std::vector<SampledStroke> apart;
  for (const SampledStroke& stroke : found) {
    bool overlaps = false;
    for (const SampledStroke& kept : apart) {
      overlaps = overlaps || (stroke.tip > kept.start + 1 && kept.tip > stroke.start + 1);
    }
    if (!overlaps) {
      apart.push_back(stroke);
    }
  }
  return apart;
}

void checkSame(const std::vector<SampledStroke>& found, const std::vector<SampledStroke>& told) {
  REQUIRE(found.size() == told.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    CHECK(found[i].start == told[i].start);
    CHECK(found[i].peak == told[i].peak);
    CHECK(found[i].tip == told[i].tip);
    CHECK(found[i].strength == Approx(told[i].strength));
  }
}

/// Velocities that swell and turn, slow now and then.
std::vector<Vec3> swellingVelocities(Row& row, std::size_t count, double fastest) {
  std::vector<Vec3> velocities;
  while (velocities.size() < count) {
    const Vec3 way = row.vector(1.0);
    const auto length = 1 + row.below(9);
    const double speed = row.between(0.0, fastest);
    for (std::uint32_t i = 0; i < length && velocities.size() < count; ++i) {
      const double share = row.once(6) ? 1.0 : std::sin(3.1 * (i + 0.5) / length);
      velocities.push_back(speed * share * (way + row.vector(0.3)));
    }
  }
  return velocities;
}

GivenLimb swelling(Row& row, double fastest) {
  GivenLimb limb = movedBy(row.vector(0.6), swellingVelocities(row, 2 + row.below(60), fastest));
  Vec3 carried(0.0);
  for (Vec3& end : limb.ends) {
    carried += row.vector(0.03);
    end += carried;
  }
  limb.weight = row.once(3) ? 0.35 : 1.0;
  return limb;
}

/// Places of hips and feet that fall, stand and rise.
std::vector<Vec3> fallingPlaces(Row& row, std::size_t count) {
  std::vector<Vec3> places{Vec3(0.0, 1.0, 0.0)};
  while (places.size() < count) {
    const auto length = 1 + row.below(12);
    const double step = row.once(3) ? 0.0 : row.between(-0.06, 0.04);
    for (std::uint32_t i = 0; i < length && places.size() < count; ++i) {
      places.push_back(places.back() + Vec3(0.01, row.once(5) ? 0.5 * step : step, 0.0));
    }
  }
  return places;
}

/// Feet that fall with the hips up to a sample, and stand from there on or go on slower.
std::vector<Vec3> stoppedPlaces(Row& row, const std::vector<Vec3>& hips) {
  std::vector<Vec3> places{Vec3(0.0)};
  double share = 1.0;
  for (std::size_t i = 1; i < hips.size(); ++i) {
    share = row.once(7) ? row.between(-0.1, 1.1) : share;
    places.push_back(places.back() + share * (hips[i] - hips[i - 1]));
  }
  return places;
}

double fallAt(const std::vector<Vec3>& places, std::size_t sample) {
  return sample == 0 ? 0.0 : (places[sample - 1].y - places[sample].y) * samplesPerSecond;
}

/// The slowest of the feet's falls at a sample.
double feetFallAt(const BodyMotion& motion, const std::vector<Limb>& limbs, std::size_t sample) {
  double least = 1e9;
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    if (limbs[i].kind == LimbKind::leg) {
      least = std::min(least, fallAt(motion.limbs[i].ends, sample));
    }
  }
  return least;
}

/// The landing of one fall of the hips from its top to its bottom, where it is one.
std::optional<SampledStroke> landingTold(const BodyMotion& motion, const std::vector<Limb>& limbs,
                                         std::size_t top, std::size_t bottom) {
  const std::vector<Vec3>& hips = motion.hips;
  SampledStroke landing;
  landing.peak = top;
  for (std::size_t i = top + 1; i <= bottom; ++i) {
    landing.peak = fallAt(hips, i) > fallAt(hips, landing.peak) ? i : landing.peak;
  }
  const double fastest = fallAt(hips, landing.peak);
  std::size_t carried = top;
  for (std::size_t i = top; i <= bottom; ++i) {
    carried = feetFallAt(motion, limbs, i) > 0.5 * fastest ? i : carried;
  }
  landing.start = carried;
  while (landing.start < bottom && feetFallAt(motion, limbs, landing.start) > 0.25 * fastest) {
    ++landing.start;
  }
  landing.tip = landing.start;
  while (landing.tip < bottom && fallAt(hips, landing.tip + 1) > 0.25 * fastest) {
    ++landing.tip;
  }
  const double fall = hips[top].y - hips[bottom].y;
  landing.strength = fastest / motion.reach * std::sqrt(fall / motion.reach);
  const bool flies = hips[top].y - hips[carried].y >= 0.1 * motion.reach;
  const bool isOne = flies && landing.start < landing.tip && landing.strength >= 0.5;
  return isOne ? std::optional(landing) : std::nullopt;
}

std::vector<SampledStroke> landingsTold(const BodyMotion& motion, const std::vector<Limb>& limbs) {
  std::vector<SampledStroke> landings;
  const std::vector<Vec3>& hips = motion.hips;
  for (std::size_t top = 0; top + 1 < hips.size(); ++top) {
    if (fallAt(hips, top + 1) <= 0.0 || (top > 0 && fallAt(hips, top) > 0.0)) {
      continue;
    }
    std::size_t bottom = top;
    while (bottom + 1 < hips.size() && fallAt(hips, bottom + 1) > 0.0) {
      ++bottom;
    }
    if (const auto landing = landingTold(motion, limbs, top, bottom); landing) {
      landings.push_back(*landing);
    }
  }
  std::ranges::stable_sort(landings, [](const auto& a, const auto& b) { return a.strength > b.strength; });
  return landings;
}

/// Two legs, an arm before them that does not count, and hips.
struct FallingBody {
  BodyMotion motion;
  std::vector<Limb> limbs{3};

  explicit FallingBody(Row& row) : motion(bodyOf(2 + row.below(80), row.between(0.6, 1.6))) {
    limbs[0].kind = LimbKind::arm;
    limbs[1].kind = LimbKind::leg;
    limbs[2].kind = LimbKind::leg;
    motion.hips = fallingPlaces(row, motion.forward.size());
    motion.limbs.resize(limbs.size());
    motion.limbs[0].ends = fallingPlaces(row, motion.forward.size());
    motion.limbs[1].ends = stoppedPlaces(row, motion.hips);
    motion.limbs[2].ends = stoppedPlaces(row, motion.hips);
  }
};

} // namespace

TEST_CASE("strokes are those that a slower way finds, sample by sample") {
  Row row(101);
  std::size_t found = 0;
  for (int round = 0; round < 600; ++round) {
    const GivenLimb limb = swelling(row, round % 3 == 0 ? 1.0 : 12.0);
    const BodyMotion motion = bodyOf(limb.places.size(), row.between(0.5, 1.5));
    for (const bool goesRound : {false, true}) {
      CAPTURE(round, goesRound);
      const std::vector<SampledStroke> strokes = strokesIn(motion, limb, goesRound);
      checkSame(strokes, strokesTold(motion, limb, goesRound));
      found += strokes.size();
    }
  }
  CHECK(found > 600);
}

TEST_CASE("the way straight back to the clip's beginning counts half, except in a cycle") {
  const double speed = 6.0;
  const auto strengths = [&](double back, bool goesRound) {
    std::vector<Vec3> velocities(8, Vec3(0.0, 0.0, speed));
    velocities.insert(velocities.end(), 4, Vec3(0.0));
    velocities.insert(velocities.end(), 8, Vec3(0.0, 0.0, -back * speed));
    velocities.emplace_back(0.0);
    const GivenLimb limb = movedBy(Vec3(0.0, 0.0, 0.4), velocities);
    const BodyMotion motion = bodyOf(limb.places.size(), 1.0);
    const std::vector<SampledStroke> strokes = strokesIn(motion, limb, goesRound);
    REQUIRE(strokes.size() == 2);
    return strokes[1].strength;
  };
  CHECK(strengths(0.99, false) == Approx(0.5 * strengths(0.99, true)));
  CHECK(strengths(0.5, false) == Approx(strengths(0.5, true)));
}

TEST_CASE("a stroke at the very beginning or end of a clip is one, cut there") {
  const std::vector<double> rising{0.0, 1.0, 3.0, 6.0, 9.0, 9.5};
  const std::vector<double> falling{9.5, 9.0, 6.0, 3.0, 1.0, 0.0};
  const BodyMotion motion = bodyOf(rising.size(), 1.0);
  const std::vector<SampledStroke> last = strokesIn(motion, straight(rising), false);
  REQUIRE(last.size() == 1);
  CHECK(last[0].start == 1);
  CHECK(last[0].peak == 5);
  CHECK(last[0].tip == 5);
  const std::vector<SampledStroke> first = strokesIn(motion, straight(falling), false);
  REQUIRE(first.size() == 1);
  CHECK(first[0].start == 0);
  CHECK(first[0].peak == 0);
  CHECK(first[0].tip == 4);
}

TEST_CASE("the farthest way is a stroke from a quarter of the reach each second on") {
  for (const auto& [speed, count] : {std::pair{0.26, std::size_t{1}}, std::pair{0.245, std::size_t{0}}}) {
    const auto samples = static_cast<std::size_t>(2.0 * samplesPerSecond / speed);
    std::vector<Vec3> velocities(samples, Vec3(0.0, 0.0, speed));
    velocities[samples / 2].z *= 1.001;
    const GivenLimb limb = movedBy(Vec3(0.0, 0.0, -1.0), velocities);
    CAPTURE(speed);
    CHECK(strokesIn(bodyOf(samples, 1.0), limb, false).size() == count);
  }
}

TEST_CASE("a stroke counts by what is seen of it in the world, a fifth of it at least") {
  const std::vector<double> speeds{0.0, 4.0, 8.0, 12.0, 12.0, 8.0, 4.0, 0.0};
  const GivenLimb limb = straight(speeds);
  const BodyMotion motion = bodyOf(speeds.size(), 1.0);
  const auto strength = [&](double seen) {
    GivenLimb carried = limb;
    for (std::size_t i = 0; i < carried.ends.size(); ++i) {
      carried.ends[i] = Vec3(seen * limb.places[i].z, 0.0, 0.0); // at a right angle to where the body faces
    }
    return strokesIn(motion, carried, false).at(0).strength;
  };
  for (const double seen : {0.1, 0.19, 0.21, 0.5, 0.9, 1.0, 1.7}) {
    CAPTURE(seen);
    CHECK(strength(seen) == Approx(strength(1.0) * std::sqrt(std::clamp(seen, 0.2, 1.0))));
  }
  CHECK(strength(0.0) == Approx(strength(1.0) * std::sqrt(0.2)));
}

TEST_CASE("a stroke turns where its way comes past a right angle, not at one") {
  for (const auto& [sine, last] : {std::pair{0.19, std::size_t{5}}, std::pair{0.21, std::size_t{3}}}) {
    const Vec3 aside(std::sqrt(1.0 - sine * sine), 0.0, -sine);
    std::vector<Vec3> velocities{Vec3(0.0), {0.0, 0.0, 9.0}, {0.0, 0.0, 8.0}};
    velocities.insert(velocities.end(), 2, 7.0 * aside);
    velocities.emplace_back(0.0);
    const GivenLimb limb = movedBy(Vec3(0.0, 0.0, 0.5), velocities);
    const std::vector<SampledStroke> strokes = strokesIn(bodyOf(limb.places.size(), 1.0), limb, false);
    CAPTURE(sine);
    REQUIRE_FALSE(strokes.empty());
    CHECK(strokes[0].peak == 1);
    CHECK(strokes[0].tip == last);
  }
}

namespace {

/// Steps of a leg, 0.6 forwards in a third of a second each, lifted so high, after which the foot stands.
struct Steps {
  int count = 1;
  double lift = 0.1;
  double comesDownTo = 0.0; ///< Above where it stood.
  double creeps = 0.0;      ///< How fast it goes on after it is put down.
};

GivenLimb stepping(const Steps& steps, bool isLeg = true) {
  std::vector<Vec3> velocities(10, Vec3(0.0));
  for (int i = 0; i < steps.count; ++i) {
    for (int sample = 0; sample < 20; ++sample) {
      const double part = (sample + 0.5) / 20.0;
      const double height = sample < 10 ? steps.lift : steps.comesDownTo - steps.lift;
      velocities.emplace_back(0.0, height / 10.0 * samplesPerSecond,
                              0.3 * pi * std::sin(pi * part) / 20.0 * samplesPerSecond);
    }
    velocities.insert(velocities.end(), 12, Vec3(0.0, 0.0, steps.creeps));
  }
  GivenLimb limb = movedBy(Vec3(0.0, -1.0, -0.3), velocities);
  limb.isLeg = isLeg;
  return limb;
}

double strengthOfSteps(const GivenLimb& limb, bool goesRound = false, double bodyReach = 1.0) {
  const std::vector<SampledStroke> strokes =
      strokesIn(bodyOf(limb.places.size(), bodyReach), limb, goesRound);
  return strokes.empty() ? 0.0 : strokes.front().strength;
}

/// Share of what the same way of any other limb counts.
double shareOfSteps(const Steps& steps) {
  return strengthOfSteps(stepping(steps)) / strengthOfSteps(stepping(steps, false));
}

} // namespace

TEST_CASE("a foot that skims over the ground and is put down to stand steps, which counts three tenths") {
  CHECK(shareOfSteps({.count = 1}) == Approx(0.3));
  CHECK(shareOfSteps({.count = 2}) == Approx(0.3));
  CHECK(shareOfSteps({.count = 3}) == 1.0);                       // a gait
  CHECK(shareOfSteps({.lift = 0.4}) == 1.0);                      // a stamp
  CHECK(shareOfSteps({.lift = 0.2, .comesDownTo = 0.15}) == 1.0); // a kick
  CHECK(shareOfSteps({.creeps = 0.8}) == 1.0);                    // it slides on
  CHECK(strengthOfSteps(stepping({}), true) == strengthOfSteps(stepping({}, false), true));
  const double whole = strengthOfSteps(stepping({}, false));
  CHECK(strengthOfSteps(stepping({}), false, whole) == 0.5); // Of 1: a step stays a moment.
}

TEST_CASE("a step at the end of a clip, of which nobody sees whether the foot stands, counts whole") {
  for (const auto& [left, share] : {std::pair{10, 0.3}, std::pair{2, 1.0}}) {
    GivenLimb leg = stepping({});
    for (std::vector<Vec3>* const list : {&leg.places, &leg.ends, &leg.velocities.ways}) {
      list->resize(list->size() - 12 + static_cast<std::size_t>(left));
    }
    leg.velocities.speeds.resize(leg.places.size());
    GivenLimb other = leg;
    other.isLeg = false;
    CAPTURE(left);
    CHECK(strengthOfSteps(leg) == Approx(share * strengthOfSteps(other)));
  }
}

TEST_CASE("landings are those that a slower way finds, sample by sample") {
  Row row(77);
  std::size_t found = 0;
  std::size_t several = 0;
  for (int round = 0; round < 1500; ++round) {
    CAPTURE(round);
    const FallingBody body(row);
    const std::vector<SampledStroke> landings = landingsOf(body.motion, body.limbs);
    checkSame(landings, landingsTold(body.motion, body.limbs));
    found += landings.size();
    several += landings.size() > 1 ? 1 : 0;
  }
  CHECK(found > 100);
  CHECK(several > 5);
}

TEST_CASE("a body without legs, and one of two samples, lands nowhere") {
  Row row(3);
  for (int round = 0; round < 400; ++round) {
    FallingBody body(row);
    if (landingsOf(body.motion, body.limbs).empty()) {
      continue;
    }
    body.limbs[1].kind = LimbKind::tail;
    body.limbs[2].kind = LimbKind::arm;
    CHECK(landingsOf(body.motion, body.limbs).empty());
    body.limbs[2].kind = LimbKind::leg;
    body.motion.hips = {Vec3(0.0, 9.0, 0.0), Vec3(0.0)};
    CHECK(landingsOf(body.motion, body.limbs).empty());
    body.motion.hips.clear();
    CHECK(landingsOf(body.motion, body.limbs).empty());
    return;
  }
  FAIL("no body lands");
}

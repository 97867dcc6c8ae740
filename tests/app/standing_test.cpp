#include "app/weight/standing.h"

#include <catch2/catch.hpp>

using namespace stretch;
using namespace stretch::app;

namespace {

SampledClip::OfLimb leg(const rig::LimbPlace& place, const std::vector<double>& lowest) {
  SampledClip::OfLimb one;
  static_cast<rig::LimbPlace&>(one.limb) = place;
  one.limb.id = rig::limbName(place);
  one.limb.restLength = 0.9;
  one.lowest = lowest;
  return one;
}

Standing standing(const std::vector<double>& left, const std::vector<double>& right) {
  SampledClip sampled;
  sampled.samplesPerSecond = 30.0;
  sampled.limbs = {leg(rig::biped::leftLeg, left), leg(rig::biped::rightLeg, right)};
  return standingOf(sampled, 1.0);
}

} // namespace

TEST_CASE("two legs on the ground share the body, one alone carries it") {
  std::vector<double> lifted(40, 0.0);
  for (std::size_t k = 15; k < 40; ++k) {
    lifted[k] = 0.3;
  }
  const Standing legs = standing(std::vector<double>(40, 0.0), lifted);
  const std::size_t left = legs.indexOf("left-leg");
  const std::size_t right = legs.indexOf("right-leg");
  CHECK(legs.shares[left][3] == Approx(0.5));
  CHECK(legs.shares[right][3] == Approx(0.5));
  CHECK(legs.shares[left][30] == Approx(1.0));
  CHECK(legs.planted[right][30] == 0.0);
  CHECK(legs.indexOf("left-arm") == legs.legs.size());
}

TEST_CASE("a foot that is held up all the time does not stand, however still it is") {
  const Standing legs = standing(std::vector<double>(20, 0.02), std::vector<double>(20, 0.35));
  CHECK(legs.planted[legs.indexOf("left-leg")][10] == 1.0);
  CHECK(legs.planted[legs.indexOf("right-leg")][10] == 0.0);
}

TEST_CASE("a foot keeps its place as long as it touches the ground, however short and hard that is") {
  std::vector<double> running(40, 0.4);
  running[19] = 0.02; // comes down and goes up at more than ten legs a second
  running[20] = 0.0;
  const Standing legs = standing(running, std::vector<double>(40, 0.4));
  const std::vector<double>& kept = legs.kept[legs.indexOf("left-leg")];
  CHECK(legs.planted[legs.indexOf("left-leg")][20] < 1.0);
  CHECK(kept[19] == 1.0);
  CHECK(kept[20] == 1.0);
  CHECK(kept[17] > 0.0);
  CHECK(kept[17] < 1.0);
  CHECK(kept[10] == 0.0);
  CHECK(legs.kept[legs.indexOf("right-leg")][20] == 0.0);
}

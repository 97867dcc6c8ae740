// The height at which a leg stands in a clip.
#include "rig/motion/floor.h"

#include <optional>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "rig/limb.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

/// Frame, and by how much the body is moved there.
using Moves = std::vector<std::pair<double, Vec3>>;

MovingBiped moved(const Moves& moves, double framesPerSecond) {
  MovingBiped biped = still(namedBody());
  biped.clip.framesPerSecond = framesPerSecond;
  const NodeIndex hips = biped.body.hips;
  VectorKeys keys;
  for (const auto& [frame, by] : moves) {
    keys.emplace_back(frame / framesPerSecond, biped.scene.nodes[at(hips)].rest.translation + by);
  }
  biped.clip.tracks.emplace_back(vectorTrack(hips, Channel::translation, Interpolation::linear, keys));
  setEndsFromKeys(biped.clip);
  return biped;
}

double heightAtRest(const std::string& leg) {
  const MovingBiped biped = still(namedBody());
  return endPosition(biped.limb(leg), sourceAtFrame(biped, 0)).y;
}

/// How far above its place in the bind pose the leg stands.
std::optional<double> standsAt(const Moves& moves, double framesPerSecond = 24.0,
                               const std::string& leg = "left-leg") {
  const MovingBiped biped = moved(moves, framesPerSecond);
  const std::optional<double> height = standingHeight(biped.scene, biped.clip, biped.limb(leg));
  return height ? std::optional(*height - heightAtRest(leg)) : std::nullopt;
}

Vec3 high(double by) {
  return {0.0, by, 0.0};
}

} // namespace

TEST_CASE("A leg stands at the lowest height at which it rests for a tenth of a second") {
  const Moves hop{{0, high(0.3)},  {4, high(0.3)},  {6, high(-0.2)}, {7, high(0.1)},
                  {11, high(0.1)}, {12, high(0.5)}, {20, high(0.5)}};
  for (const char* leg : {"left-leg", "right-leg"}) {
    CAPTURE(leg);
    REQUIRE(standsAt(hop, 24.0, leg));
    CHECK(*standsAt(hop, 24.0, leg) == Approx(0.1).margin(1e-5)); // at -0.2 it only passes
  }
}

TEST_CASE("A rest is two frames long at 24 and six at 60 frames per second, and one at a rate of 6") {
  const auto restsFor = [](double frames, double rate) {
    return standsAt({{0, high(0.0)}, {2, high(0.9)}, {2 + frames, high(0.9)}, {4 + frames, high(1.8)}}, rate);
  };
  CHECK_FALSE(restsFor(1, 24.0));
  REQUIRE(restsFor(2, 24.0));
  CHECK(*restsFor(2, 24.0) == Approx(0.9).margin(1e-5));
  CHECK_FALSE(restsFor(5, 60.0));
  CHECK(restsFor(6, 60.0));
  CHECK(restsFor(1, 6.0));
}

TEST_CASE("A rest may end with the clip, and one that begins the clip counts from its first frame") {
  CHECK(standsAt({{0, high(0.0)}, {2, high(0.9)}, {4, high(0.9)}}));
  CHECK_FALSE(standsAt({{0, high(0.0)}, {2, high(0.9)}, {3, high(0.9)}}));
  CHECK(standsAt({{0, high(0.0)}, {2, high(0.0)}, {4, high(0.9)}}));
  CHECK_FALSE(standsAt({{0, high(0.0)}, {1, high(0.0)}, {3, high(0.9)}}));
}

TEST_CASE("A leg rests below a quarter of its length per second, in whatever direction it moves") {
  const double length = still(namedBody()).limb("left-leg").restLength;
  for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)}) {
    CAPTURE(way.x, way.y, way.z);
    CHECK(standsAt({{0, Vec3(0.0)}, {24, 0.24 * length * way}}));
    CHECK_FALSE(standsAt({{0, Vec3(0.0)}, {24, 0.26 * length * way}}));
    CHECK(standsAt({{0, Vec3(0.0)}, {60, 0.24 * length * way}}, 60.0));
    CHECK_FALSE(standsAt({{0, Vec3(0.0)}, {60, 0.26 * length * way}}, 60.0));
  }
}

TEST_CASE("In a walk on the spot a foot that rests in the air stands where it slides, if that is far lower") {
  const double length = still(namedBody()).limb("left-leg").restLength;
  const auto standsAbove = [&](double air) {
    const Vec3 back(0.0, 0.0, -0.5 * length);
    const Vec3 top = high(air * length);
    // Rests in the air for three frames, comes down and slides back at half a length within six frames.
    return standsAt({{0, top}, {3, top}, {6, Vec3(0.0)}, {12, back}, {15, top + back}}).value_or(-1.0) /
           length;
  };
  CHECK(standsAbove(0.11) == Approx(0.0).margin(1e-5));
  CHECK(standsAbove(0.09) == Approx(0.09).margin(1e-5));
  CHECK_FALSE(standsAt({{0, Vec3(0.0)}, {12, Vec3(0.0, 0.0, -length)}})); // Nowhere at all.
}

TEST_CASE("A leg without a foot stands by its last bone's end") {
  MovingBiped biped = moved({{0, high(0.4)}, {4, high(0.4)}, {6, high(2.0)}}, 24.0);
  Limb leg = biped.limb("right-leg");
  const double withFoot = *standingHeight(biped.scene, biped.clip, leg);
  leg.endOffset = biped.scene.nodes[at(leg.endNode)].rest.translation;
  leg.endNode = NodeIndex::none;
  CHECK(*standingHeight(biped.scene, biped.clip, leg) == Approx(withFoot).margin(1e-5));
}

// Ground of a clip that is to be exaggerated: the floor under feet that stand, slide or fly.
#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/auto/clip_ground.h"
#include "tests/support/app/auto_clips.h"
#include "tests/support/app/boxer.h"
#include "tests/support/app/new_trail.h"

using namespace stretch;
using namespace stretch::app;
using namespace stretch::test;

namespace {

/// Two straight legs of length 1 below hips that sway from side to side within 24 frames, so fast that no
/// foot ever stands, at a height that the frame tells.
template <typename Height>
Document swaying(const Height& heightAt) {
  Document document = twoLeggedStepper();
  Scene scene = *document.scene;
  Primitive sole;
  sole.positions = {{-0.05F, 0.0F, 0.0F}, {0.05F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.1F}};
  sole.indices = {0, 1, 2};
  for (const char* const leg : {"left-leg", "right-leg"}) {
    scene.nodes[at(findLimb(document, leg)->endNode)].mesh = static_cast<int>(scene.meshes.size());
    scene.meshes.push_back({"sole", {sole}, {}});
  }
  document.scene = std::make_shared<const Scene>(std::move(scene));
  Track hips;
  hips.node = document.body.hips;
  hips.channel = Channel::translation;
  hips.width = 3;
  for (int frame = 0; frame <= 24; ++frame) {
    hips.times.push_back(static_cast<float>(frame / 30.0));
    for (const double value : {std::sin(2.0 * pi * frame / 12.0), heightAt(frame), 0.0}) {
      hips.values.push_back(static_cast<float>(value));
    }
  }
  return withTracks(document, {hips});
}

} // namespace

TEST_CASE(
    "Feet that never stand still slide along a floor where the lowest vertex is as high on most frames") {
  const auto floorOf = [](const auto& heightAt) { return clipGround(swaying(heightAt), 0).floor; };
  const double height = swaying([](int) { return 1.0; }).body.height;
  const auto dips = [&](double share) {
    return [=](int frame) { return frame > 14 ? 1.4 : frame == 3 ? 1.0 - share * height : 1.0; };
  };
  REQUIRE(clipGround(swaying(dips(0.0)), 0).stands.empty());
  // As low as a heel dips, but not as low as what swings far below. Hops on less than half of the frames are
  // no floor.
  for (const auto& [share, floor] : {std::pair(0.0, 0.0), {0.028, -0.028}, {0.032, 0.0}}) {
    CAPTURE(share);
    REQUIRE(floorOf(dips(share)));
    CHECK(*floorOf(dips(share)) == Approx(floor * height).margin(1e-6));
  }
  CHECK_FALSE(floorOf([](int frame) { return frame > 11 ? 1.0 + 0.1 * frame : 1.0; }));
  // Up and down by less than a hundredth of the height they still do.
  const auto bobs = [&](double share) {
    return [=](int frame) { return 1.0 + share * height * (frame % 3 - 1); };
  };
  CHECK(floorOf(bobs(0.008)));
  CHECK_FALSE(floorOf(bobs(0.012)));
  // Without legs nothing slides.
  Document legless = swaying(dips(0.0));
  std::erase_if(legless.body.limbs, [](const rig::Limb& limb) { return isLeg(limb); });
  CHECK_FALSE(clipGround(legless, 0).floor);
}

TEST_CASE(
    "A loop goes on at its start where no limb gives way in it, and where its keys begin within a frame") {
  const Document document = swinger();
  const auto groundOf = [](const Document& loop) {
    const ClipGround ground = clipGround(loop, 0);
    CHECK(ground.endsMeet);
    return ground.wraps;
  };
  CHECK(groundOf(document));
  Document weighted = document;
  WeightedLimb weight;
  weight.limb = "left-arm";
  weighted.weights.push_back(weight);
  CHECK_FALSE(groundOf(weighted));
  weighted.weights.front().on = false;
  CHECK(groundOf(weighted));
  for (const auto& [firstKey, wraps] : {std::pair(1, true), {2, false}}) {
    CAPTURE(firstKey);
    Track arm = turnsOf(document, "left-arm");
    for (const auto& [frame, angle] : {std::pair(firstKey, 0.1), {10, 1.2}, {24, 0.1}}) {
      addKey(arm, frame, glm::angleAxis(angle, Vec3(0.0, -1.0, 0.0)));
    }
    Document later = withTracks(document, {arm});
    Clip clip = later.clips->front();
    setEndsFromKeys(clip);
    later.clips = std::make_shared<const std::vector<Clip>>(std::vector<Clip>{clip});
    CHECK(groundOf(later) == wraps);
  }
}

TEST_CASE(
    "A clip's last pose is its first one again within a fiftieth of the height, or goes on to it within two "
    "and a half frames") {
  const Document boxer = test::boxer();
  const auto isLoop = [&](const std::vector<std::pair<double, double>>& keys) {
    Track arm = turnsOf(boxer, "left-arm");
    for (const auto& [frame, angle] : keys) {
      addKey(arm, frame, glm::angleAxis(angle, Vec3(0.0, -1.0, 0.0)));
    }
    return clipGround(withTracks(boxer, {arm}), 0).endsMeet;
  };
  // The hand of the arm of 0.6 ends as far from where it began as an angle says: 0.036 is a fiftieth.
  const auto endsAt = [](double angle) {
    return std::vector<std::pair<double, double>>{{0, 0.0}, {2, 0.0}, {10, 1.0}, {22, angle}, {24, angle}};
  };
  CHECK(isLoop(endsAt(0.058)));
  CHECK_FALSE(isLoop(endsAt(0.062)));
  // An arm that goes round within 24 frames, whose last frames are left out.
  const auto goesRoundTo = [](int last) {
    std::vector<std::pair<double, double>> keys;
    for (int frame = 0; frame <= last; ++frame) {
      keys.emplace_back(frame, 2.0 * pi * frame / 24.0);
    }
    return keys;
  };
  CHECK(isLoop(goesRoundTo(24)));
  CHECK(isLoop(goesRoundTo(22)));
  CHECK_FALSE(isLoop(goesRoundTo(21)));
  // A clip of one frame has no course that could go on.
  CHECK(isLoop({{0, 0.0}, {2, 0.05}}));
  CHECK_FALSE(isLoop({{0, 0.0}, {1, 0.05}}));
}

TEST_CASE(
    "A clip nearly meets its start where one limb of four is not back, by less than 0.15 of the height") {
  const auto nearlyMeets = [](const std::vector<const char*>& limbs, double angle) {
    const Document document = twoLeggedStepper();
    std::vector<Track> tracks;
    for (const char* const limb : limbs) {
      tracks.push_back(turnsOf(document, limb));
      for (const auto& [frame, turned] : {std::pair(0.0, 0.0), {24.0, angle}}) {
        addKey(tracks.back(), frame, glm::angleAxis(turned, Vec3(0.0, 0.0, 1.0)));
      }
    }
    return clipGround(withTracks(document, tracks), 0).nearlyMeets;
  };
  CHECK(nearlyMeets({"right-arm"}, 0.0));
  CHECK(nearlyMeets({"right-arm"}, 0.44)); // The hand is 0.26 away, and the body 1.8 high.
  CHECK_FALSE(nearlyMeets({"right-arm"}, 0.47));
  CHECK_FALSE(nearlyMeets({"right-arm", "left-arm"}, 0.44)); // Two of five limbs.
}

TEST_CASE(
    "Trails and weight that a clip has already are no part of the ground that new ones are measured on") {
  const Document boxer = test::boxer();
  Document worked = test::withNewTrail(boxer, {.startFrame = 0.0, .endFrame = 10.0, .scale = 2.0});
  WeightedLimb weight;
  weight.limb = "left-arm";
  worked.weights.push_back(weight);
  REQUIRE(worked.trails.size() == 1);
  const ClipGround ground = clipGround(boxer, 0);
  CHECK(clipGround(worked, 0).places == ground.places);
  CHECK(glm::length(ground.reachOf("left-arm", 10.0)) == Approx(0.6));
}

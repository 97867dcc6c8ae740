// Where a part gets keys: on a finger that is closed by as much over its whole clip, so that straight spans
// follow it and every key has a reason of its own.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "core/math/rotation.h"
#include "rig/rekey/key_times.h"
#include "tests/support/rig/adjusted_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

namespace {

constexpr double fingerRate = 24.0;

double secondsAt(double frame) {
  return asKeyTime(frame / fingerRate);
}

/// A biped whose first joint of the middle finger turns to and fro from one of these frames to the next.
MovingBiped turningFinger(const std::vector<double>& frames, double lastFrame,
                          Interpolation interpolation = Interpolation::linear,
                          const std::string& key = "finger1a.l") {
  MovingBiped moving = still(namedBody());
  RotationKeys keys;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    keys.emplace_back(secondsAt(frames[i]), axisAngle(Vec3(1, 0, 0), i % 2 == 0 ? 0.2 : -0.3));
  }
  moving.clip.tracks.emplace_back(rotationTrack(moving.node.at(key), interpolation, keys));
  moving.clip.endSeconds = lastFrame / fingerRate;
  return moving;
}

KeyedPart partOf(const MovingBiped& moving, const std::vector<Vec2>& windowFrames,
                 const std::vector<std::string>& nodes = {"finger1a.l"}) {
  KeyedPart part;
  for (const std::string& node : nodes) {
    part.nodes.push_back(moving.node.at(node));
  }
  part.boneLength = 0.04;
  for (const Vec2& window : windowFrames) {
    part.windows.push_back({secondsAt(window.x), secondsAt(window.y), false, false});
  }
  return part;
}

struct Chosen {
  std::vector<std::vector<double>> frames; ///< Of the keys, by window.
  std::vector<std::vector<double>> stretchFrames;
  std::vector<ChangedChannel> channels;
};

std::vector<std::vector<double>> inFrames(std::vector<std::vector<double>> windows) {
  for (std::vector<double>& times : windows) {
    std::ranges::transform(times, times.begin(),
                           [](double time) { return std::round(time * fingerRate * 1e4) / 1e4; });
  }
  return windows;
}

Chosen chosenFor(const MovingBiped& moving, const KeyedPart& part, KeyPlaces places = KeyPlaces::needed,
                 double curl = 0.7) {
  const MotionState motion = adjusted(moving, {valued("left-hand.curl", curl)});
  ExactMotion exact(moving.scene, moving.clip, motion);
  const std::vector<KeyedPart> parts{part};
  const ChosenKeys chosen = chooseKeys(exact, parts, {.tolerance = 1e-4, .places = places});
  REQUIRE(chosen.parts.size() == 1);
  CHECK(chosen.parts[0].part == &parts[0]);
  CHECK(chosen.largestMiss == 0.0);
  CHECK(chosen.parts[0].stretchedNodes.empty());
  return {inFrames(chosen.parts[0].times), inFrames(chosen.parts[0].stretchTimes), chosen.parts[0].channels};
}

using Frames = std::vector<std::vector<double>>;

} // namespace

TEST_CASE("a motion that straight spans follow is keyed at its window's ends and where the source is") {
  const MovingBiped moving = turningFinger({0, 5, 9.25, 17, 20, 30}, 40.0);
  CHECK(chosenFor(moving, partOf(moving, {{5, 20}})).frames == Frames{{5, 9.25, 17, 20}});
  CHECK(chosenFor(moving, partOf(moving, {{4.5, 20.75}})).frames == Frames{{4.5, 5, 9.25, 17, 20, 20.75}});
  CHECK(chosenFor(moving, partOf(moving, {{0, 6}, {18, 31}})).frames == Frames{{0, 5, 6}, {18, 20, 30, 31}});
  CHECK(chosenFor(moving, partOf(moving, {{0, 6}, {18, 31}})).stretchFrames ==
        Frames{{0, 5, 6}, {18, 20, 30, 31}});
  CHECK(chosenFor(moving, partOf(moving, {{31, 35}})).frames == Frames{{31, 35}});
}

TEST_CASE("a window without length is one key, and those after it are keyed as ever") {
  const MovingBiped moving = turningFinger({0, 5, 9, 30}, 40.0);
  CHECK(chosenFor(moving, partOf(moving, {{3, 3}, {4, 6}, {7, 7}})).frames == Frames{{3}, {4, 5, 6}, {7}});
}

TEST_CASE("keys of the source that lie at a window's ends are not made twice") {
  MovingBiped moving = turningFinger({0, 5, 20, 30}, 40.0);
  const double beside = GENERATE(-1e-5, 1e-5);
  KeyedPart part = partOf(moving, {{5, 20}});
  part.windows[0].startSeconds = asKeyTime(part.windows[0].startSeconds + beside);
  part.windows[0].endSeconds = asKeyTime(part.windows[0].endSeconds - beside);
  CHECK(chosenFor(moving, part).frames[0].size() == 2);
}

TEST_CASE("times that a part asks for are keyed inside its windows, unless a key is as good as there") {
  const MovingBiped moving = turningFinger({0, 9, 30}, 40.0);
  KeyedPart part = partOf(moving, {{5, 20}});
  part.keySeconds = {secondsAt(3), secondsAt(5), secondsAt(7.5), secondsAt(12), secondsAt(20), secondsAt(25)};
  CHECK(chosenFor(moving, part).frames == Frames{{5, 7.5, 9, 12, 20}});
  for (const double beside : {-1.5e-5, 1.5e-5}) {
    part.keySeconds = {secondsAt(9) + beside};
    CHECK(chosenFor(moving, part).frames == Frames{{5, 9, 20}});
  }
  for (const double beside : {-1e-3, 1e-3}) {
    part.keySeconds = {secondsAt(9) + beside};
    CHECK(chosenFor(moving, part).frames[0].size() == 4);
  }
}

TEST_CASE("where every frame is to be keyed all whole frames of a window are, beside what is keyed anyway") {
  const MovingBiped moving = turningFinger({0, 9.5, 30}, 40.0);
  CHECK(chosenFor(moving, partOf(moving, {{6.25, 12}}), KeyPlaces::everyFrame).frames ==
        Frames{{6.25, 7, 8, 9, 9.5, 10, 11, 12}});
  CHECK(chosenFor(moving, partOf(moving, {{7, 9.75}}), KeyPlaces::everyFrame).frames ==
        Frames{{7, 8, 9, 9.5, 9.75}});
  CHECK(chosenFor(moving, partOf(moving, {{7, 9.125}}), KeyPlaces::everyFrame).frames ==
        Frames{{7, 8, 9, 9.125}});
  CHECK(chosenFor(moving, partOf(moving, {{7, 9.75}}), KeyPlaces::wholeFrames).frames ==
        Frames{{7, 9.5, 9.75}});
}

TEST_CASE("spans of more than 500 frames are cut into equal ones on whole frames") {
  const MovingBiped moving = turningFinger({0}, 4000.0);
  CHECK(chosenFor(moving, partOf(moving, {{0, 499}})).frames == Frames{{0, 499}});
  CHECK(chosenFor(moving, partOf(moving, {{0, 501}})).frames == Frames{{0, 251, 501}});
  CHECK(chosenFor(moving, partOf(moving, {{10.5, 1210.5}})).frames == Frames{{10.5, 410, 810, 1210, 1210.5}});
  KeyedPart part = partOf(moving, {{0, 1299}});
  part.keySeconds = {secondsAt(300)}; // 999 frames are left behind it: two halves.
  CHECK(chosenFor(moving, part).frames == Frames{{0, 300, 800, 1299}});
}

TEST_CASE("a jump inside a window is keyed on both of its sides, in place of a key that is as good") {
  const MovingBiped moving = turningFinger({0, 9, 30}, 40.0);
  KeyedPart part = partOf(moving, {{5, 20}});
  const double beside = GENERATE(-1.0, 1.0);
  const JumpInside atKey{secondsAt(9), besideJump(secondsAt(9), beside)};
  const JumpInside between{secondsAt(12), besideJump(secondsAt(12), beside)};
  const JumpInside outside{secondsAt(25), besideJump(secondsAt(25), beside)};
  part.jumps = {atKey, between, outside};
  const MotionState motion = adjusted(moving, {valued("left-hand.curl", 0.7)});
  ExactMotion exact(moving.scene, moving.clip, motion);
  const std::vector<KeyedPart> parts{part};
  const ChosenKeys chosen = chooseKeys(exact, parts, {});
  std::vector<double> wanted{secondsAt(5),          atKey.insideSeconds,   atKey.besideSeconds,
                             between.insideSeconds, between.besideSeconds, secondsAt(20)};
  std::ranges::sort(wanted);
  CHECK(chosen.parts[0].times[0] == wanted);
  CHECK(chosen.parts[0].stretchTimes[0] == wanted);
}

TEST_CASE("only what a motion changes is keyed, with its source where the clip has one") {
  const MovingBiped moving = turningFinger({0, 9, 30}, 40.0);
  const KeyedPart part = partOf(moving, {{5, 20}}, {"foreArm.l", "finger1a.l", "finger1b.l", "finger1a.r"});
  const std::vector<ChangedChannel> channels = chosenFor(moving, part).channels;
  REQUIRE(channels.size() == 2);
  CHECK(channels[0].node == moving.node.at("finger1a.l"));
  CHECK(channels[0].source == &*moving.clip.tracks[0]);
  CHECK(channels[1].node == moving.node.at("finger1b.l"));
  CHECK(channels[1].source == nullptr);
  for (const ChangedChannel& channel : channels) {
    CHECK(channel.channel == Channel::rotation);
    CHECK_FALSE(channel.isCubic);
  }
  CHECK(chosenFor(moving, part, KeyPlaces::needed, 0.0).channels.empty());
  // A joint that stands where the one above it stands is not moved by that.
  MovingBiped folded = moving;
  folded.scene.nodes[at(folded.node.at("finger1a.r"))].rest.translation = Vec3(0.0);
  CHECK(chosenFor(folded, part).channels.size() == 2);
  // Of a part whose first node has no keys those of the second count all the same.
  CHECK(chosenFor(moving, partOf(moving, {{5, 20}}, {"finger1b.l", "finger1a.l"})).frames ==
        Frames{{5, 9, 20}});
}

TEST_CASE("a channel that the clip does not have gets tangents where another one of its part has them") {
  MovingBiped moving = turningFinger({0, 9, 30}, 40.0, Interpolation::cubicSpline);
  const MovingBiped linear = turningFinger({0, 12, 30}, 40.0, Interpolation::linear, "finger0a.l");
  moving.clip.tracks.push_back(linear.clip.tracks[0]);
  const auto cubic = [&](const std::vector<std::string>& nodes) {
    std::vector<bool> are;
    for (const ChangedChannel& channel : chosenFor(moving, partOf(moving, {{5, 20}}, nodes)).channels) {
      are.push_back(channel.isCubic);
    }
    return are;
  };
  CHECK(cubic({"finger1a.l", "finger0a.l", "finger2a.l"}) == std::vector{true, false, true});
  CHECK(cubic({"finger2a.l", "finger0a.l", "finger1a.l"}) == std::vector{true, false, true});
  CHECK(cubic({"finger0a.l", "finger2a.l"}) == std::vector{false, false});
}

TEST_CASE("a hand that closes and opens is keyed where straight spans would miss it, and only there") {
  MovingBiped moving = turningFinger({0}, 40.0);
  Adjustment curl = valued("left-hand.curl", 0.0, 10.0);
  curl.keys.push_back(curl.keys[0]);
  curl.keys[1].frame = 20.0;
  curl.keys[1].value = 1.0;
  const MotionState motion = adjusted(moving, {curl});
  const double tolerance = 1e-4;
  const std::vector<KeyedPart> parts{partOf(moving, {{0, 40}})};
  const NodeIndex node = parts[0].nodes[0];
  ExactMotion exact(moving.scene, moving.clip, motion);
  const ChosenKeys chosen = chooseKeys(exact, parts, {.tolerance = tolerance});
  const std::vector<double>& times = chosen.parts[0].times[0];
  REQUIRE(times.size() > 6);
  // The finger turns about one axis: a span is off by the angle, times how far what it moves reaches.
  const Vec3 hinge = positionOf(exact.at(0.0).worlds[at(node)]);
  const Vec3 tip = positionOf(exact.at(0.0).worlds[at(moving.node.at("finger1b.l"))]);
  const double reach = std::max(exact.reachOf(at(node)),
                                glm::length(tip - hinge) + exact.reachOf(at(moving.node.at("finger1b.l"))));
  const auto turnAt = [&](double time) { return exact.at(time).pose.locals[at(node)].rotation; };
  for (std::size_t i = 1; i < times.size(); ++i) {
    for (double time = times[i - 1]; time < times[i]; time += 0.5 / fingerRate) {
      const Quat span = glm::slerp(turnAt(times[i - 1]), turnAt(times[i]),
                                   (time - times[i - 1]) / (times[i] - times[i - 1]));
      CHECK(angleBetween(span, turnAt(time)) * reach < 1.02 * tolerance);
    }
    const bool stands = times[i] <= 10.0 / fingerRate || times[i - 1] >= 20.0 / fingerRate;
    CHECK((!stands || times[i] - times[i - 1] > 9.0 / fingerRate)); // Nothing moves there.
  }
}

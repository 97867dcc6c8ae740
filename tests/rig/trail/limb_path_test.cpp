#include "rig/trail/limb_path.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "rig/motion/paths.h"
#include "tests/support/rig/moving_biped.h"

using namespace stretch;
using namespace stretch::rig;
using namespace stretch::test;

TEST_CASE("sampling a few nodes answers what sampling the whole character answers") {
  for (const Interpolation interpolation :
       {Interpolation::linear, Interpolation::cubicSpline, Interpolation::step}) {
    const MovingBiped moving = punchingBiped(interpolation);
    const NodeIndex hand = moving.node.at("hand.l");
    const NodeSampler sampler(moving.scene, moving.clip, std::vector{hand});
    FrameState sampled;
    for (double frame = -2.0; frame <= 26.0; frame += 0.7) {
      sampler.sample(frame / 24.0, sampled);
      const Mat4 difference = sampled.worlds[at(hand)] - sourceAtFrame(moving, frame).worlds[at(hand)];
      for (int column = 0; column < 4; ++column) {
        CHECK(glm::length(difference[column]) < 1e-12);
      }
    }
  }
}

TEST_CASE("a range is sampled at its frames, the keys in it and both ends") {
  const std::vector<double> times = sampleTimes(0.1, 0.35, 10.0, {0.0, 0.15, 0.2, 0.2000001, 0.4});
  const std::vector<double> wanted{0.1, 0.15, 0.2, 0.3, 0.35};
  REQUIRE(times.size() == wanted.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    CHECK(times[i] == Approx(wanted[i]).margin(1e-6));
  }
  CHECK(times.front() == 0.1);
  CHECK(times.back() == 0.35);
}

TEST_CASE("a range of no length has one sample") {
  CHECK(sampleTimes(0.5, 0.5, 24.0, {0.5}) == std::vector{0.5});
}

TEST_CASE("a sparsely keyed limb has a sphere at each of its keys, ends included") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 3, 20, 2.0)});
  const std::vector<double>& frames = motion.trails.front().controlFrames;
  const std::vector<double> wanted{3, 6, 12, 18, 20};
  REQUIRE(frames.size() == wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    CHECK(frames[i] == Approx(wanted[i]));
  }
}

TEST_CASE("a densely keyed limb has few spheres: ends, extremes and what a cubic needs") {
  MovingBiped moving = punchingBiped(Interpolation::cubicSpline);
  moving.clip = keyedOnEveryFrame(moving.clip);
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 0, 24, 2.0)});
  const std::vector<double>& frames = motion.trails.front().controlFrames;
  CHECK(frames.front() == 0.0);
  CHECK(frames.back() == Approx(24.0));
  CHECK(frames.size() >= 4);
  CHECK(frames.size() <= 16);
  CHECK(std::ranges::is_sorted(frames));
  CHECK(motion.trails.front().path.samples.size() == 25);
}

TEST_CASE("spheres that the user chose stay as chosen") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 0, 24, 2.0);
  trail.controlFrames = {0.0, 7.5, 24.0};
  CHECK(solved(moving, {trail}).trails.front().controlFrames == trail.controlFrames);
}

TEST_CASE("the ratio runs from 0 at the pivot to 1 at the tip and never back") {
  const MovingBiped moving = punchingBiped();
  for (const Pivot pivot : {Pivot::start, Pivot::end}) {
    Trail trail = connectedTrail("left-arm", 0, 18, 2.0);
    trail.settings.pivot = pivot;
    const MotionState motion = solved(moving, {trail});
    const LimbPath& path = motion.trails.front().path;
    const double sign = pivot == Pivot::start ? 1.0 : -1.0;
    CHECK(path.ratioAt(0.0) == (pivot == Pivot::start ? 0.0 : 1.0));
    CHECK(path.ratioAt(0.75) == Approx(pivot == Pivot::start ? 1.0 : 0.0).margin(1e-12));
    for (double frame = 0.25; frame <= 18.0; frame += 0.25) {
      CHECK(sign * (path.ratioAt(frame / 24.0) - path.ratioAt((frame - 0.25) / 24.0)) >= -1e-12);
    }
  }
}

TEST_CASE("the trail's space is measured from the hips or the base and carried back") {
  const MovingBiped moving = punchingBiped();
  for (const TrailSpace space : {TrailSpace::world, TrailSpace::root, TrailSpace::base, TrailSpace::view}) {
    Trail trail = connectedTrail("left-arm", 0, 12, 2.0);
    trail.settings.space = space;
    trail.settings.viewAxes = Mat3(Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(-1, 0, 0));
    const MotionState motion = solved(moving, {trail});
    const LimbPath& path = motion.trails.front().path;
    for (const LimbSample& sample : path.samples) {
      const Vec3 there = path.toSpace(sample, sample.end);
      CHECK(glm::length(path.toWorld(sample, there) - sample.end) < 1e-12);
      CHECK(glm::length(there) == Approx(glm::length(sample.end - sample.reference)));
    }
    const bool fromBase = path.samples[4].reference == path.samples[4].base;
    CHECK(fromBase == (space == TrailSpace::base));
  }
}

TEST_CASE("the default range ends where the hand is farthest from where it began, seen from the base") {
  const MovingBiped moving = punchingBiped();
  const Vec2 range = defaultRange(moving.scene, moving.clip, moving.limb("left-arm"));
  CHECK(range.x == 0.0);
  CHECK(range.y == 12.0);
}

TEST_CASE("spheres set by hand stay within the range, whose ends always have one") {
  const MovingBiped moving = punchingBiped();
  Trail trail = connectedTrail("left-arm", 0, 24, 2.0);
  trail.controlFrames = {-2.0, 7.5, 90.0};
  CHECK(solved(moving, {trail}).trails.front().controlFrames == std::vector<double>{0.0, 7.5, 24.0});
}

TEST_CASE("spheres stand at the extremes of the path as the trail's space has it") {
  // The body runs so far that the hand never turns back in the world; seen from the hips it does, at
  // frame 12.
  MovingBiped moving = punchingBiped();
  std::erase_if(moving.clip.tracks, [&](const CopyOnWrite<Track>& track) {
    return track->node == moving.body.hips && track->channel == Channel::translation;
  });
  const Vec3 hips = moving.scene.nodes[at(moving.body.hips)].rest.translation;
  moving.clip.tracks.emplace_back(vectorTrack(moving.body.hips, Channel::translation, Interpolation::linear,
                                              {{0.0, hips}, {1.0, hips + Vec3(0.0, 0.0, 40.0)}}));
  moving.clip = keyedOnEveryFrame(moving.clip);
  Trail trail = connectedTrail("left-arm", 0, 24, 2.0);
  trail.settings.space = TrailSpace::root;
  const MotionState motion = solved(moving, {trail});
  const SolvedTrail& seen = motion.trails.front();
  for (int axis = 0; axis < 3; ++axis) {
    const auto place = [&](const LimbSample& sample) { return seen.path.toSpace(sample, sample.end)[axis]; };
    const LimbSample& farthest = *std::ranges::max_element(seen.path.samples, {}, place);
    const double frame = farthest.timeSeconds * moving.clip.framesPerSecond;
    CHECK(std::ranges::any_of(seen.controlFrames,
                              [&](double control) { return std::abs(control - frame) < 1e-3; }));
  }
}

TEST_CASE("a densely keyed limb whose extreme lies beside a frame has its sphere on the frame") {
  constexpr double rate = 10.0;
  LimbPath path;
  std::vector<double> keyTimes;
  const auto add = [&](double seconds, double x) {
    LimbSample sample;
    sample.timeSeconds = seconds;
    sample.end = Vec3(x, 0.0, 0.0);
    path.samples.push_back(sample);
    keyTimes.push_back(seconds);
  };
  const double start = GENERATE(0.0, 2.0, 2.04, 2.06); // on a frame, and just before and behind one's middle
  for (const double seconds : {0.0, 0.1, 0.2, 0.3, 0.4}) {
    add(start + seconds, seconds);
  }
  add(start + 0.43, 1.0);
  for (const double seconds : {0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
    add(start + seconds, 1.1 - seconds);
  }
  const std::vector<double> frames = chooseControlFrames(path, keyTimes, rate, rate, 10.0);
  CAPTURE(start);
  REQUIRE(frames.size() == 3);
  CHECK(frames[0] == Approx(rate * start).margin(1e-9)); // the ends stay where they are
  CHECK(frames[1] == Approx(std::round(rate * (start + 0.43))).margin(1e-9));
  CHECK(frames[2] == Approx(rate * (start + 1.0)).margin(1e-9));
}

TEST_CASE("what a path does between the frames that its keys are counted in makes no sphere") {
  constexpr double shown = 20.0;
  constexpr double keyed = 10.0;
  LimbPath path;
  std::vector<double> keyTimes;
  const double start = GENERATE(0.0, 2.0);
  for (int frame = 0; frame <= 20; ++frame) {
    LimbSample sample;
    sample.timeSeconds = start + frame / shown;
    sample.end = Vec3(frame / shown + (frame % 2 != 0 ? 0.2 : 0.0), 0.0, 0.0);
    path.samples.push_back(sample);
    keyTimes.push_back(sample.timeSeconds);
  }
  const std::vector<double> frames = chooseControlFrames(path, keyTimes, shown, keyed, 10.0);
  REQUIRE(frames.size() == 2);
  CHECK(frames[0] == Approx(shown * start).margin(1e-9));
  CHECK(frames[1] == Approx(shown * (start + 1.0)).margin(1e-9));
  CHECK(chooseControlFrames(path, keyTimes, shown, shown, 10.0).size() > 2);
}

TEST_CASE("a limb counts as densely keyed from more than 0.6 keys in a frame on, and from five keys on") {
  CHECK(isDenselyKeyed(11, 0.0, 1.0, 10.0));
  CHECK(isDenselyKeyed(8, 0.0, 1.0, 10.0)); // 7 keys after the first in 10 frames
  CHECK_FALSE(isDenselyKeyed(7, 0.0, 1.0, 10.0));
  CHECK_FALSE(isDenselyKeyed(4, 0.0, 0.3, 10.0));
  CHECK(isDenselyKeyed(5, 0.0, 0.4, 10.0));
  CHECK_FALSE(isDenselyKeyed(11, 0.0, 1.0, 20.0)); // the same keys at twice the rate
}

TEST_CASE("a limb is densely keyed by one of its tracks, or by all of them together, over the whole clip") {
  const auto track = [](NodeIndex node, std::vector<float> times, Channel channel = Channel::rotation) {
    Track made;
    made.node = node;
    made.channel = channel;
    made.times = std::move(times);
    return made;
  };
  const std::vector<float> each{0.0F, 0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F, 0.7F, 0.8F, 0.9F, 1.0F};
  const std::vector<float> even{0.0F, 0.2F, 0.4F, 0.6F, 0.8F, 1.0F};
  const std::vector<float> odd{0.1F, 0.3F, 0.5F, 0.7F, 0.9F};
  const std::vector<NodeIndex> limb{NodeIndex(1), NodeIndex(2)};
  const auto isDense = [&](std::vector<Track> tracks) {
    Clip clip;
    clip.framesPerSecond = 10.0;
    clip.endSeconds = 1.0;
    for (Track& one : tracks) {
      clip.tracks.emplace_back(std::move(one));
    }
    return keySpacing(clip, limb).isDense;
  };
  CHECK(isDense({track(NodeIndex(2), each)}));
  CHECK(isDense({track(NodeIndex(1), even), track(NodeIndex(2), odd)}));
  CHECK_FALSE(isDense({track(NodeIndex(1), even), track(NodeIndex(2), even)}));
  CHECK_FALSE(isDense({track(NodeIndex(1), even), track(NodeIndex(3), each)}));
  CHECK_FALSE(isDense({track(NodeIndex(1), even), track(NodeIndex(1), each, Channel::weights)}));
  std::vector<float> twice; // two keys at once are one
  for (const float time : even) {
    twice.insert(twice.end(), {time, time + 2e-7F});
  }
  CHECK_FALSE(isDense({track(NodeIndex(1), twice)}));
}

TEST_CASE(
    "a limb that is keyed at every frame of its file is densely keyed at any rate that it is shown at") {
  Clip clip;
  clip.endSeconds = 1.0;
  Track track;
  track.node = NodeIndex(1);
  track.channel = Channel::rotation;
  const int keys = GENERATE(25, 7); // one in each frame of 24, and one in four
  for (int key = 0; key < keys; ++key) {
    track.times.push_back(static_cast<float>(key) / static_cast<float>(keys - 1));
  }
  clip.tracks.emplace_back(track);
  for (const double rate : {24.0, 30.0, 48.0, 60.0}) {
    CAPTURE(keys, rate);
    clip.framesPerSecond = rate;
    const KeySpacing spacing = keySpacing(clip, {NodeIndex(1)});
    CHECK(spacing.isDense == (keys == 25));
    CHECK(spacing.keysPerSecond == (keys == 25 && rate == 30.0 ? 30.0 : 24.0));
  }
}

TEST_CASE("key times of several tracks are told once and in order, within the range alone") {
  Clip clip;
  clip.framesPerSecond = 10.0;
  clip.endSeconds = 2.0;
  for (const std::vector<float>& times : {std::vector<float>{0.0F, 0.5F, 1.0F, 2.0F},
                                          {0.25F, 1.0F, 1.75F},
                                          {0.0F, 0.5F, 1.0F, 2.0F},
                                          {1.25F}}) {
    Track track;
    track.node = NodeIndex(1);
    track.times = times;
    clip.tracks.emplace_back(std::move(track));
  }
  CHECK(keyTimesOf(clip, {NodeIndex(1)}, 0.0, 2.0) ==
        std::vector<double>{0.0, 0.25, 0.5, 1.0, 1.25, 1.75, 2.0});
  CHECK(keyTimesOf(clip, {NodeIndex(1)}, 0.5, 1.25) == std::vector<double>{0.5, 1.0, 1.25});
  CHECK(keyTimesOf(clip, {NodeIndex(2)}, 0.0, 2.0).empty());
}

TEST_CASE("the default range ends where the limb is farthest from where it began, not where it is longest") {
  MovingBiped moving = still(namedBody());
  const NodeIndex arm = moving.node.at("upperArm.l");
  const Quat rest = moving.scene.nodes[at(arm)].rest.rotation;
  const auto turned = [&](double degrees) {
    const double half = 0.5 * degrees * pi / 180.0;
    return Quat(std::cos(half), 0.0, std::sin(half), 0.0) * rest;
  };
  moving.clip.tracks.emplace_back(rotationTrack(
      arm, Interpolation::linear, {{0.0, turned(0.0)}, {10.0 / 24.0, turned(-110.0)}, {1.0, turned(20.0)}}));
  setEndsFromKeys(moving.clip);
  const Vec2 range = defaultRange(moving.scene, moving.clip, moving.limb("left-arm"));
  CHECK(range.x == 0.0);
  CHECK(range.y == 10.0);
}

TEST_CASE("halfway between two times is half a frame exactly, where it is one") {
  CHECK(timesBetween({0.0, 0.1, 0.2}, 10.0) == std::vector<double>{0.05, 0.15});
  const std::vector<double> beside = timesBetween({0.0, 0.1, 0.14}, 10.0);
  REQUIRE(beside.size() == 2);
  CHECK(beside[1] == Approx(0.12));
  CHECK(timesBetween({0.3}, 10.0).empty());
}

TEST_CASE("the keys of a limb in a range are those of its nodes that move, its ends among them") {
  const MovingBiped moving = punchingBiped();
  const NodeIndex arm = moving.node.at("upperArm.l");
  const auto frames = [&](const std::vector<NodeIndex>& nodes, double first, double last) {
    std::vector<double> found = keyTimesOf(moving.clip, nodes, first / 24.0, last / 24.0);
    std::ranges::for_each(found, [](double& time) { time = std::round(24.0 * time * 100.0) / 100.0; });
    return found;
  };
  CHECK(frames({arm}, 6, 18) == std::vector<double>{6, 12, 18});
  CHECK(frames({arm}, 6.1, 17.9) == std::vector<double>{12});
  CHECK(frames({arm, moving.node.at("foreArm.l")}, 0, 24) == std::vector<double>{0, 6, 12, 18, 24});
  CHECK(frames({moving.node.at("upperArm.r")}, 0, 24).empty());
}

TEST_CASE("how a mesh that a joint carries changes its shape neither moves nor keys the joint") {
  MovingBiped moving = punchingBiped();
  const NodeIndex arm = moving.node.at("upperArm.l");
  Track shapes;
  shapes.node = arm;
  shapes.channel = Channel::weights;
  shapes.width = 1;
  shapes.times = {0.1F, 0.4F};
  shapes.values = {0.0F, 1.0F};
  const Clip before = moving.clip;
  moving.clip.tracks.emplace_back(shapes);
  CHECK(keyTimesOf(moving.clip, {arm}, 0.0, 1.0) == keyTimesOf(before, {arm}, 0.0, 1.0));
  FrameState with;
  FrameState without;
  NodeSampler(moving.scene, moving.clip, {arm}).sample(0.3, with);
  NodeSampler(moving.scene, before, {arm}).sample(0.3, without);
  CHECK(with.worlds[at(arm)] == without.worlds[at(arm)]);
}

TEST_CASE(
    "a path is drawn at every frame, or so many times in one, from where the trail begins to where it ends") {
  const MovingBiped moving = punchingBiped();
  const MotionState motion = solved(moving, {connectedTrail("left-arm", 6, 12, 2.0)});
  const SolvedTrail& trail = motion.trails.front();
  const double first = 24.0 * trail.windowStartSeconds;
  const double last = 24.0 * std::min(trail.windowEndSeconds, moving.clip.endSeconds);
  for (const std::size_t perFrame : {std::size_t{1}, std::size_t{2}, std::size_t{5}}) {
    const std::vector<double> frames = drawnFrames(moving.clip, trail, perFrame);
    REQUIRE(frames.size() > 1);
    CHECK(frames.front() == Approx(first).margin(1e-9));
    CHECK(frames[1] - frames[0] == Approx(1.0 / static_cast<double>(perFrame)));
    CHECK(frames.back() <= last + 1e-9);
    CHECK(frames.back() > last - 1.0 / static_cast<double>(perFrame));
  }
  CHECK(drawnFrames(moving.clip, trail, 0) == drawnFrames(moving.clip, trail, 1));
}

TEST_CASE("the default range of a limb that stays where it is farthest ends where it gets there") {
  MovingBiped moving = still(namedBody());
  const NodeIndex arm = moving.node.at("upperArm.l");
  const Quat rest = moving.scene.nodes[at(arm)].rest.rotation;
  const Quat away = Quat(std::cos(0.8), 0.0, -std::sin(0.8), 0.0) * rest;
  moving.clip.tracks.emplace_back(
      rotationTrack(arm, Interpolation::linear, {{0.0, rest}, {0.25, away}, {0.75, away}, {1.0, rest}}));
  setEndsFromKeys(moving.clip);
  CHECK(defaultRange(moving.scene, moving.clip, moving.limb("left-arm")) == Vec2(0.0, 6.0));
  moving.clip.tracks.clear(); // nothing moves: the whole clip
  CHECK(defaultRange(moving.scene, moving.clip, moving.limb("left-arm")) == Vec2(0.0, 24.0));
}

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

#include "core/anim/sampling.h"
#include "core/math/rotation.h"

using namespace stretch;

namespace {

Vec3 sampledVector(const Track& track, double timeSeconds) {
  std::array<double, 3> out{};
  sampleTrack(track, timeSeconds, out.data());
  return {out[0], out[1], out[2]};
}

Quat sampledRotation(const Track& track, double timeSeconds) {
  std::array<double, 4> out{};
  sampleTrack(track, timeSeconds, out.data());
  return {out[3], out[0], out[1], out[2]};
}

Track moves(Interpolation interpolation) {
  return {NodeIndex(0), Channel::translation, interpolation, 3, {1, 2, 4}, {0, 0, 0, 10, 0, 0, 10, 8, 0}, -1};
}

Track turns(std::vector<float> values) {
  return {NodeIndex(0), Channel::rotation, Interpolation::linear, 4, {0, 1}, std::move(values), -1};
}

} // namespace

TEST_CASE("Before the first key and after the last the value is held") {
  const Interpolation interpolation = GENERATE(Interpolation::step, Interpolation::linear);
  const Track track = moves(interpolation);
  CHECK(sampledVector(track, -100.0) == Vec3(0, 0, 0));
  CHECK(sampledVector(track, 0.999) == Vec3(0, 0, 0));
  CHECK(sampledVector(track, 4.001) == Vec3(10, 8, 0));
  CHECK(sampledVector(track, 1e9) == Vec3(10, 8, 0));
}

TEST_CASE("At a key the value is the key's, to the bit") {
  const Interpolation interpolation = GENERATE(Interpolation::step, Interpolation::linear);
  const Track track = moves(interpolation);
  CHECK(sampledVector(track, 1.0) == Vec3(0, 0, 0));
  CHECK(sampledVector(track, 2.0) == Vec3(10, 0, 0));
  CHECK(sampledVector(track, 4.0) == Vec3(10, 8, 0));
}

TEST_CASE("LINEAR is a straight line between keys, STEP waits for the next") {
  CHECK(sampledVector(moves(Interpolation::linear), 1.5) == Vec3(5, 0, 0));
  CHECK(sampledVector(moves(Interpolation::linear), 3.5) == Vec3(10, 6, 0));
  CHECK(sampledVector(moves(Interpolation::step), 1.999) == Vec3(0, 0, 0));
  CHECK(sampledVector(moves(Interpolation::step), 3.999) == Vec3(10, 0, 0));
}

TEST_CASE("A track of one key has its value always") {
  const Track track{NodeIndex(0), Channel::scale, Interpolation::linear, 3, {5}, {1, 2, 3}, -1};
  for (const double time : {-1.0, 5.0, 9.0}) {
    CHECK(sampledVector(track, time) == Vec3(1, 2, 3));
  }
}

TEST_CASE("CUBICSPLINE runs through its values with its tangents") {
  // From 0 to 8 in two seconds, leaving with 4 per second, arriving with 0 per second.
  const Track track{NodeIndex(0),
                    Channel::translation,
                    Interpolation::cubicSpline,
                    3,
                    {1, 3},
                    {9, 9, 9, 0, 0, 0, 4, 0, 0, 0, 0, 0, 8, 0, 0, 7, 7, 7},
                    -1};
  CHECK(sampledVector(track, 0.0) == Vec3(0, 0, 0));
  CHECK(sampledVector(track, 1.0) == Vec3(0, 0, 0));
  CHECK(sampledVector(track, 2.0).x == Approx(5.0)); // half of 8, and an eighth of 4 per second over 2
                                                     // seconds
  CHECK(sampledVector(track, 3.0) == Vec3(8, 0, 0));
  const double slope = (sampledVector(track, 1.001).x - sampledVector(track, 1.0).x) / 0.001;
  CHECK(slope == Approx(4.0).epsilon(1e-2));
}

TEST_CASE("Rotations take the shorter arc with constant speed") {
  const float half = 0.70710678F;
  const Track quarter = turns({0, 0, 0, 1, 0, 0, half, half});
  const Track opposite = turns({0, 0, 0, 1, 0, 0, -half, -half}); // the same rotation on the other hemisphere
  for (const Track& track : {quarter, opposite}) {
    CHECK(angleBetween(sampledRotation(track, 1.0 / 3.0), glm::angleAxis(pi / 6, Vec3(0, 0, 1))) < 1e-6);
  }
}

TEST_CASE("Rotations come out with unit length whatever the file holds") {
  CHECK(glm::length(sampledRotation(turns({0, 0, 0, 2, 0, 3, 0, 0}), 0.3)) == Approx(1.0));
  CHECK(sampledRotation(turns({0, 0, 0, 0, 0, 0, 0, 0}), 0.5) == Quat(1, 0, 0, 0));
}

TEST_CASE("A clip's pose rests where no track animates it") {
  Scene scene;
  scene.nodes.resize(2);
  scene.nodes[0].rest.scale = Vec3(3.0);
  scene.nodes[1].matrix = toMatrix({Vec3(1, 2, 3), Quat(1, 0, 0, 0), Vec3(1.0)});
  scene.nodes[1].rest = toTransform(*scene.nodes[1].matrix);
  scene.nodes[1].morphWeights = {0.25F};
  Clip clip;
  clip.tracks = {CopyOnWrite<Track>(moves(Interpolation::linear))};
  const Pose pose = samplePose(scene, clip, 2.0);
  CHECK(pose.locals[0].translation == Vec3(10, 0, 0));
  CHECK(pose.locals[0].scale == Vec3(3.0));
  CHECK(pose.usesMatrix[1]);
  CHECK(localMatrix(scene, pose, NodeIndex(1)) == *scene.nodes[1].matrix);
  CHECK(pose.weights[1] == std::vector<float>{0.25F});
}

TEST_CASE("An animated node leaves its matrix") {
  Scene scene;
  scene.nodes.resize(1);
  scene.nodes[0].matrix = toMatrix({Vec3(1, 2, 3), Quat(1, 0, 0, 0), Vec3(2.0)});
  scene.nodes[0].rest = toTransform(*scene.nodes[0].matrix);
  Clip clip;
  clip.tracks = {CopyOnWrite<Track>(moves(Interpolation::step))};
  const Pose pose = samplePose(scene, clip, 2.0);
  CHECK_FALSE(pose.usesMatrix[0]);
  CHECK(Vec3(localMatrix(scene, pose, NodeIndex(0))[3]) == Vec3(10, 0, 0));
  CHECK(pose.locals[0].scale == Vec3(2.0));
}

TEST_CASE("The frame rate is guessed from the keys") {
  const auto rateOf = [](std::vector<float> times) {
    Track track = moves(Interpolation::linear);
    track.values.assign(times.size() * 3, 0.0F);
    track.times = std::move(times);
    return guessFramesPerSecond({CopyOnWrite<Track>(std::move(track))});
  };
  CHECK(rateOf({0, 1 / 24.0F, 2 / 24.0F, 5 / 24.0F}) == 24.0);
  CHECK(rateOf({1 / 30.0F, 2 / 30.0F, 7 / 30.0F}) == 30.0);
  CHECK(rateOf({0, 1 / 25.0F, 3 / 25.0F}) == 25.0);
  CHECK(rateOf({0, 1 / 60.0F, 2 / 60.0F}) == 60.0);
  CHECK(rateOf({0.5F}) == 30.0);
  // Between them the tracks are keyed on every frame, many of them at the same ones.
  std::vector<CopyOnWrite<Track>> tracks;
  for (const int first : {0, 1, 0, 2, 0, 0, 1}) {
    Track track = moves(Interpolation::linear);
    track.times.clear();
    for (int frame = first; frame < 40; frame += 3) {
      track.times.push_back(static_cast<float>(frame) / 17.0F);
    }
    track.values.assign(track.times.size() * 3, 0.0F);
    tracks.emplace_back(std::move(track));
  }
  CHECK(guessFramesPerSecond(tracks) == Approx(17.0));
  CHECK(guessFramesPerSecond({}) == 30.0);
  CHECK(rateOf({0, 0.0123F, 0.0301F, 0.0449F}) == 30.0); // no rate fits
}

TEST_CASE(
    "A rate is told up to 240 frames in each second, whose times no single precision holds, and none above") {
  const auto rateOf = [](double framesPerSecond) {
    Track track = moves(Interpolation::linear);
    track.times.clear();
    for (int frame = 0; frame <= 600; ++frame) {
      track.times.push_back(static_cast<float>(frame / framesPerSecond));
    }
    track.values.assign(track.times.size() * 3, 0.0F);
    return guessFramesPerSecond({CopyOnWrite<Track>(std::move(track))});
  };
  CHECK(rateOf(239.76) == Approx(239.76).epsilon(1e-4));
  CHECK(rateOf(240.0) == Approx(240.0).epsilon(1e-4));
  CHECK(rateOf(241.0) == 30.0);
}

TEST_CASE("Keys between the frames of some tracks do not double the frame rate") {
  const auto keyedEvery = [](double framesPerSecond, double stepFrames) {
    Track track = moves(Interpolation::linear);
    track.times.clear();
    for (double frame = 0.0; frame <= framesPerSecond; frame += stepFrames) {
      track.times.push_back(static_cast<float>(frame / framesPerSecond));
    }
    track.values.assign(track.times.size() * 3, 0.0F);
    return CopyOnWrite<Track>(std::move(track));
  };
  for (const double rate : {24.0, 25.0, 30.0, 60.0, 23.5}) {
    CAPTURE(rate);
    const CopyOnWrite<Track> onFrames = keyedEvery(rate, 1.0);
    const CopyOnWrite<Track> between = keyedEvery(rate, 0.5);
    CHECK(guessFramesPerSecond({onFrames, between, between}) == Approx(rate));
    CHECK(guessFramesPerSecond({keyedEvery(rate, 4.0), keyedEvery(rate, 2.0), between}) == Approx(rate));
    // Every track keyed at twice the rate is a clip of twice the rate, whatever holds still in it.
    const CopyOnWrite<Track> still = keyedEvery(rate, rate);
    CHECK(guessFramesPerSecond({between, still, still, still}) == Approx(2.0 * rate));
  }
}

TEST_CASE("A clip lasts from its earliest key to its latest, and never begins before 0") {
  Clip clip;
  setEndsFromKeys(clip);
  CHECK(clip.startSeconds == 0.0);
  CHECK(clip.endSeconds == 0.0);
  Track late = moves(Interpolation::linear);
  late.times = {2, 3, 5};
  clip.tracks = {moves(Interpolation::linear), late};
  setEndsFromKeys(clip);
  CHECK(clip.startSeconds == 1.0);
  CHECK(clip.endSeconds == 5.0);
  late.times = {-1e30F, 3, 5};
  clip.tracks.emplace_back(late);
  setEndsFromKeys(clip);
  CHECK(clip.startSeconds == 0.0);
  late.times = {-3, -2, -1};
  clip.tracks = {late};
  setEndsFromKeys(clip);
  CHECK(clip.startSeconds == 0.0);
  CHECK(clip.endSeconds == 0.0);
}

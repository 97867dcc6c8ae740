#include "core/anim/clip.h"

#include <catch2/catch.hpp>

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/patch/new_clips.h"
#include "core/gltf/source/fields.h"
#include "tests/support/core/glb_builder.h"

using namespace stretch;

namespace {

Track keyed(int node, Channel channel, const std::vector<float>& times) {
  Track track;
  track.node = NodeIndex(node);
  track.channel = channel;
  track.times = times;
  track.values.assign(times.size() * 3, 0.0F);
  return track;
}

Track keyedAt(const std::vector<float>& times) {
  return keyed(0, Channel::translation, times);
}

/// `count` keys from frame `first` on, `step` frames apart, at a rate.
std::vector<float> onFrames(double rate, int count, double step = 1.0, double first = 0.0) {
  std::vector<float> times;
  times.reserve(static_cast<std::size_t>(count));
  for (int key = 0; key < count; ++key) {
    times.push_back(static_cast<float>((first + step * key) / rate));
  }
  return times;
}

double guessed(const std::vector<std::vector<float>>& tracks) {
  std::vector<CopyOnWrite<Track>> made;
  made.reserve(tracks.size());
  for (const std::vector<float>& times : tracks) {
    made.emplace_back(keyedAt(times));
  }
  return guessFramesPerSecond(made);
}

} // namespace

TEST_CASE("A track is found by its node and by what it moves, both") {
  Clip clip;
  clip.tracks = {keyed(3, Channel::translation, {0}), keyed(3, Channel::rotation, {0}),
                 keyed(5, Channel::rotation, {0}), keyed(3, Channel::scale, {0})};
  CHECK(findTrack(clip, NodeIndex(3), Channel::translation) == 0);
  CHECK(findTrack(clip, NodeIndex(3), Channel::rotation) == 1);
  CHECK(findTrack(clip, NodeIndex(5), Channel::rotation) == 2);
  CHECK(findTrack(clip, NodeIndex(3), Channel::scale) == 3);
  CHECK(findTrack(clip, NodeIndex(5), Channel::translation) == -1);
  CHECK(findTrack(clip, NodeIndex(4), Channel::rotation) == -1);
  CHECK(findTrack(Clip{}, NodeIndex(0), Channel::translation) == -1);
}

TEST_CASE("A clip has the keys of all its tracks together") {
  CHECK(keyCount(Clip{}) == 0);
  Clip clip;
  clip.tracks = {keyedAt({0, 1, 2}), keyedAt({0}), keyedAt({0, 5})};
  CHECK(keyCount(clip) == 6);
}

TEST_CASE("A clip lasts from the earliest to the latest key of any track, and never from before 0") {
  const auto endsOf = [](const std::vector<std::vector<float>>& tracks) {
    Clip clip;
    clip.startSeconds = clip.endSeconds = 9.0;
    for (const std::vector<float>& times : tracks) {
      clip.tracks.emplace_back(keyedAt(times));
    }
    setEndsFromKeys(clip);
    return std::pair(clip.startSeconds, clip.endSeconds);
  };
  CHECK(endsOf({}) == std::pair(0.0, 0.0));
  CHECK(endsOf({{0.5F, 2.0F}}) == std::pair(0.5, 2.0));
  CHECK(endsOf({{0.5F, 2.0F}, {0.25F, 1.0F}, {0.75F, 3.0F}}) == std::pair(0.25, 3.0));
  CHECK(endsOf({{-0.5F, 2.0F}, {0.25F, 1.0F}}) == std::pair(0.0, 2.0));
  CHECK(endsOf({{0.25F, 1.0F}, {-0.5F, 2.0F}}) == std::pair(0.0, 2.0));
  CHECK(endsOf({{-2.0F, -1.0F}}) == std::pair(0.0, 0.0));
}

TEST_CASE("A clip has a frame for each whole one up to its end, and one more") {
  const auto framesOf = [](double seconds, double rate) {
    Clip clip;
    clip.endSeconds = seconds;
    clip.framesPerSecond = rate;
    return frameCount(clip);
  };
  CHECK(framesOf(0.0, 30.0) == 1);
  CHECK(framesOf(1.0, 30.0) == 31);
  CHECK(framesOf(0.49 / 24.0, 24.0) == 1);
  CHECK(framesOf(0.51 / 24.0, 24.0) == 2);
  CHECK(framesOf(1e30, 30.0) == 1000000000000001); // beyond counting
}

TEST_CASE("The rate of a clip is the first usual one on whose frames its keys lie") {
  CHECK(guessed({}) == 30.0);
  CHECK(guessed({{0.0F}}) == 30.0);
  CHECK(guessed({{0.0F, 1.0F}}) == 24.0); // every rate holds: the first
  for (const double rate : {24.0, 30.0, 25.0, 60.0, 50.0, 120.0, 100.0}) {
    INFO(rate);
    CHECK(guessed({onFrames(rate, 13)}) == rate);
  }
  // Each second frame of 24, 30, 50 and so on are frames of those, too.
  CHECK(guessed({onFrames(12.0, 13)}) == 24.0);
  CHECK(guessed({onFrames(15.0, 13)}) == 30.0);
  CHECK(guessed({onFrames(10.0, 13)}) == 30.0);
  CHECK(guessed({onFrames(8.0, 13)}) == 24.0);
  // None of the usual: by the spacing of the keys.
  CHECK(guessed({onFrames(17.0, 13)}) == Approx(17.0));
  CHECK(guessed({onFrames(230.0, 13)}) == Approx(230.0));
  CHECK(guessed({onFrames(250.0, 13)}) == 30.0);                                 // more than cameras take
  CHECK(guessed({{0.0F, 0.3714F, 0.9127F, 1.1362F, 1.7191F, 2.0377F}}) == 30.0); // no rhythm
}

TEST_CASE("One key in ten may lie off the frames, by more than 2 hundredths of one") {
  const auto withOdd = [](std::size_t odd, double off) {
    std::vector<float> times = onFrames(24.0, 20);
    for (std::size_t key = 0; key < odd; ++key) {
      const std::size_t at = 3 + 4 * key;
      times[at] = static_cast<float>((static_cast<double>(at) + off) / 24.0);
    }
    return guessed({times});
  };
  CHECK(withOdd(2, 0.3) == 24.0);
  CHECK(withOdd(4, 0.019) == 24.0);
  CHECK(withOdd(4, 0.3) != 24.0);
  CHECK(withOdd(4, 0.021) != 24.0);
}

TEST_CASE("Keys name a rate where they are within a fiftieth of a frame of its frames, and none below one "
          "per second") {
  const auto offBy = [](float share) {
    std::vector<float> times(13);
    for (std::size_t frame = 0; frame < times.size(); ++frame) {
      times[frame] = (static_cast<float>(frame) + (frame % 2 == 0 ? share : -share)) / 24.0F;
    }
    return times;
  };
  CHECK(guessed({offBy(0.015F)}) == 24.0);
  CHECK(guessed({offBy(0.03F)}) == 30.0);
  CHECK(guessed({onFrames(1.0 / 1.737, 13)}) == 30.0);
}

TEST_CASE("Keys that lie between frames on some tracks do not double the rate") {
  const std::vector<float> plain = onFrames(30.0, 11);
  const std::vector<float> rekeyed = onFrames(60.0, 21);
  CHECK(guessed({rekeyed}) == 60.0);
  CHECK(guessed({rekeyed, plain}) == 30.0);
  CHECK(guessed({plain, rekeyed}) == 30.0);
  // Three tracks of ten are a good part, two are not.
  std::vector<std::vector<float>> tracks(7, rekeyed);
  tracks.insert(tracks.end(), 3, plain);
  CHECK(guessed(tracks) == 30.0);
  tracks.back() = rekeyed;
  CHECK(guessed(tracks) == 60.0);
  // A track of three keys tells nothing, one of four does.
  CHECK(guessed({rekeyed, onFrames(30.0, 3)}) == 60.0);
  CHECK(guessed({rekeyed, onFrames(30.0, 4)}) == 30.0);
  // Half a rate below 40 is none.
  CHECK(guessed({onFrames(24.0, 21), onFrames(12.0, 11)}) == 24.0);
  CHECK(guessed({onFrames(50.0, 21), onFrames(25.0, 11)}) == 25.0);
}

TEST_CASE("A file with new clips is the old one with them behind its own, and their rates where keys tell "
          "another") {
  const gltf::Loaded file = test::loaded(test::armBuilder());
  Clip named;
  named.name = "nod";
  named.framesPerSecond = 24.0;
  Track turn = keyed(1, Channel::rotation, onFrames(24.0, 3));
  turn.width = 4;
  turn.values = {0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1};
  named.tracks = {turn, keyed(2, Channel::translation, onFrames(24.0, 3))};
  Clip nameless;
  nameless.framesPerSecond = 50.0;
  nameless.tracks = {keyed(2, Channel::scale, {0.0F, 1.0F})};
  const Result<gltf::Source> grown = gltf::withNewClips(*file.source, {named, nameless});
  REQUIRE(grown);
  const gltf::Json& animations = (*grown->json)["animations"];
  REQUIRE(animations.size() == 4);
  CHECK(animations[0] == (*file.source->json)["animations"][0]);
  CHECK(animations[2]["name"] == "nod");
  CHECK_FALSE(animations[3].contains("name"));
  const test::TemporaryFolder folder;
  REQUIRE(gltf::save(*grown, folder.path() / "grown.glb"));
  const Result<gltf::Loaded> back = gltf::load(folder.path() / "grown.glb");
  REQUIRE(back);
  REQUIRE(back->clips.size() == 4);
  CHECK(back->clips[2].name == "nod");
  REQUIRE(back->clips[2].tracks.size() == 2);
  CHECK(back->clips[2].tracks[0]->node == NodeIndex(1));
  CHECK(back->clips[2].tracks[0]->values == turn.values);
  CHECK(back->clips[2].tracks[1]->times == turn.times);
  CHECK(back->clips[2].framesPerSecond == 24.0);
  CHECK(back->clips[3].framesPerSecond == 50.0);
  // Only what keys do not tell is noted.
  CHECK_FALSE(animations[2].contains("extras"));
  CHECK(animations[3].contains("extras"));
}

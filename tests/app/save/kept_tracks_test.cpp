// Which numbers of edited tracks a file keeps, and which of those it does not take back.
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "app/edits/keys/track_edits.h"
#include "app/files/kept_tracks.h"
#include "core/gltf/json/json.h"
#include "tests/support/app/things_of_clip.h"
#include "tests/support/refusal.h"

using namespace stretch;
using namespace stretch::app;
using gltf::Json;

namespace {

// The one track of each clip: rotations of the left arm at frames 0, 5, 10 and 20.
Track punchTrack(const Document& document, int clip = 1) {
  return *clipOf(document, clip).tracks.at(0);
}

Json keptOf(const Document& start, const Track& track, int clip = 1) {
  return keptTracks(setTracks(start, clip, {track}));
}

void setTrackKey(Track& track, std::size_t key, const std::vector<float>& value) {
  std::copy(value.begin(), value.end(), track.values.begin() + static_cast<std::ptrdiff_t>(4 * key));
}

const std::vector<float> halfTurn{0.0F, 1.0F, 0.0F, 0.0F};

Track newTrack(Channel channel) {
  Track track;
  track.node = NodeIndex(2);
  track.channel = channel;
  track.times = {0.0F, 0.5F};
  track.values = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F};
  return track;
}

std::string restored(const Json& entries, Document document = test::twoPunches()) {
  return test::refusal(restoreKeptTracks(entries, document));
}

std::string restoredFollowing(const Json& entries, Document& document) {
  return test::refusal(restoreFollowingKeys(entries, document));
}

} // namespace

TEST_CASE("Of a track of which few values changed the file keeps these keys alone", "[keys]") {
  const Document start = test::twoPunches();
  CHECK(keptTracks(start) == Json::array());
  Track track = punchTrack(start);
  setTrackKey(track, 2, halfTurn);
  const Json one = keptOf(start, track);
  const Json wanted = {{{"clip", 1},
                        {"node", track.node.value},
                        {"path", "rotation"},
                        {"interpolation", "LINEAR"},
                        {"changed", {{2, halfTurn}}}}};
  CHECK(one == wanted);
  setTrackKey(track, 0, halfTurn); // Half of the keys: all of their values are as short.
  const Json two = keptOf(start, track);
  CHECK_FALSE(two[0].contains("changed"));
  CHECK(two[0]["values"] == Json(track.values));
  CHECK_FALSE(two[0].contains("times"));
}

TEST_CASE("Times are kept where they differ, and values that do not are left out", "[keys]") {
  const Document start = test::twoPunches();
  Track track = punchTrack(start);
  track.times[3] += 0.25F;
  const Json later = keptOf(start, track);
  CHECK(later[0]["times"] == Json(track.times));
  CHECK_FALSE(later[0].contains("values"));
  CHECK_FALSE(later[0].contains("changed"));
  track.times.pop_back(); // Another number of keys.
  track.values.resize(12);
  const Json fewer = keptOf(start, track);
  CHECK(fewer[0]["times"] == Json(track.times));
  CHECK(fewer[0]["values"] == Json(track.values));
  Track stepped = punchTrack(start);
  stepped.interpolation = Interpolation::step;
  const Json steps = keptOf(start, stepped);
  CHECK(steps[0]["interpolation"] == "STEP");
  CHECK(steps[0]["values"] == Json(stepped.values));
  CHECK_FALSE(steps[0].contains("times"));
}

TEST_CASE("A track that the source does not have is kept whole", "[keys]") {
  const Document start = test::twoPunches();
  const Channel channel = GENERATE(Channel::translation, Channel::scale);
  const Track track = newTrack(channel);
  const Json kept = keptOf(start, track, 0);
  REQUIRE(kept.size() == 1);
  CHECK(kept[0]["clip"] == 0);
  CHECK(kept[0]["node"] == 2);
  CHECK(kept[0]["times"] == Json(track.times));
  CHECK(kept[0]["values"] == Json(track.values));
}

TEST_CASE("Whatever tracks are edited to, in whichever clips, they come back", "[keys]") {
  const Document start = test::twoPunches();
  std::vector<Track> edited(5, punchTrack(start));
  setTrackKey(edited[0], 3, halfTurn);
  setTrackKey(edited[1], 0, halfTurn);
  setTrackKey(edited[1], 1, halfTurn);
  edited[2].times[1] = 0.2F;
  setTrackKey(edited[2], 1, halfTurn);
  edited[3].times = {0.1F};
  edited[3].values.resize(4);
  edited[4].interpolation = Interpolation::cubicSpline;
  edited[4].values.resize(48, 0.25F);
  for (const Track& track : edited) {
    for (const Channel channel : {Channel::translation, Channel::scale}) {
      Document both = setTracks(setTracks(start, 1, {newTrack(channel), track}), 0, {newTrack(channel)});
      Document back = start;
      REQUIRE(restoreKeptTracks(keptTracks(both), back));
      CHECK(*back.clips == *both.clips);
    }
  }
}

TEST_CASE("Kept tracks are taken up to the edges of what is sound, and not beyond", "[keys]") {
  const Document start = test::twoPunches();
  Track changed = punchTrack(start);
  setTrackKey(changed, 2, halfTurn);
  const Json kept = keptOf(start, changed);
  const auto with = [&](const char* key, const Json& value) {
    Json entries = kept;
    entries[0][key] = value;
    return restored(entries);
  };
  const std::string sound = "accepted";
  const std::string refused = restored({{{"clip", 2}}});
  CHECK_THAT(refused, Catch::Contains("clip_keys") && Catch::Contains("is not what this program writes"));
  CHECK(restored(kept) == sound);
  CHECK(with("clip", 0) == sound);
  CHECK(with("clip", 2) == refused);
  CHECK(with("clip", -1) == refused);
  const int nodes = static_cast<int>(start.scene->nodes.size());
  CHECK(with("node", nodes) == refused);
  CHECK(with("node", -1) == refused);
  CHECK(with("path", "weights") == refused);
  CHECK(with("path", "scale") == refused); // The source has no such track, and times and values are not told.
  CHECK(with("times", {0.0, 0.5, 1.0, 1e6}) == sound);
  CHECK(with("times", {0.0, 0.5, 1.0, 1.1e6}) == refused);
  CHECK(with("times", {0.1, 0.5, 1.0, 2.0}) == sound);
  CHECK(with("times", {-0.1, 0.5, 1.0, 2.0}) == refused);
  CHECK(with("times", {0.0, 0.5, 0.5, 2.0}) == refused);
  CHECK(with("times", {0.0, 0.5, 2.0}) == refused); // Fewer than the source has values.
  CHECK(with("times", Json::array()) == refused);
  CHECK(with("interpolation", "CUBICSPLINE") == refused); // Three times as many values would be needed.
  CHECK(with("changed", {{3, halfTurn}}) == sound);
  CHECK(with("changed", {{4, halfTurn}}) == refused);
  CHECK(with("changed", {{3, {1.0, 0.0, 0.0}}}) == refused);
  CHECK(with("changed", {{3, {1.0, 0.0, 0.0, 0.0, 0.0}}}) == refused);
  CHECK(with("changed", {{3, {1.0, 0.0, 0.0, 1e300}}}) == refused);
  CHECK(with("values", std::vector<float>(16, 0.5F)) == sound);
  CHECK(with("values", std::vector<float>(15, 0.5F)) == refused);
}

TEST_CASE("A new track needs both times and values, and none stands twice", "[keys]") {
  const Document start = test::twoPunches();
  const Json kept = keptOf(start, newTrack(Channel::scale));
  CHECK(restored(kept) == "accepted");
  for (const char* missing : {"times", "values"}) {
    Json entries = kept;
    entries[0].erase(missing);
    CHECK_THAT(restored(entries), Catch::Contains("clip_keys"));
  }
  const auto nodes = static_cast<int>(start.scene->nodes.size());
  for (const auto& [node, isThere] : {std::pair(nodes - 1, true), {nodes, false}}) {
    Json entries = kept;
    entries[0]["node"] = node;
    CHECK((restored(entries) == "accepted") == isThere);
  }
  Json twice = kept;
  twice.push_back(kept[0]);
  CHECK_THAT(restored(twice), Catch::Contains("clip_keys"));
  for (const auto& [key, value] :
       std::vector<std::pair<const char*, Json>>{{"clip", 0}, {"node", 1}, {"path", "translation"}}) {
    Json two = kept;
    two.push_back(kept[0]);
    two[1][key] = value; // Of another clip, node or part they are two.
    CHECK(restored(two) == "accepted");
  }
}

TEST_CASE("Keys that follow are kept by clip, node and part, and come back where the track has them",
          "[keys]") {
  Document document = test::twoPunches();
  const Track track = punchTrack(document);
  CHECK(keptFollowingKeys(document) == Json::array());
  document.followingKeys = {{1, track.node, Channel::rotation, {{track.times[1], 5U}, {track.times[3], 2U}}}};
  const Json kept = keptFollowingKeys(document);
  const Json wanted = {{{"clip", 1},
                        {"node", track.node.value},
                        {"path", "rotation"},
                        {"keys", {{track.times[1], 5}, {track.times[3], 2}}}}};
  CHECK(kept == wanted);
  Document back = test::twoPunches();
  CHECK(restoredFollowing(kept, back) == "accepted");
  CHECK(back.followingKeys == document.followingKeys);

  const auto keysOf = [&](const Json& keys) {
    Json entries = kept;
    entries[0]["keys"] = keys;
    Document other = test::twoPunches();
    CHECK(restoredFollowing(entries, other) == "accepted");
    return other.followingKeys.empty() ? std::size_t{0} : other.followingKeys[0].keys.size();
  };
  const float first = track.times[0];
  const float third = track.times[2];
  CHECK(keysOf({{first, 1}, {third, 1}}) == 2);
  CHECK(keysOf({{third, 1}, {first, 1}}) == 1); // Not in order.
  CHECK(keysOf({{third, 1}, {third, 1}}) == 1);
  CHECK(keysOf({{0.01, 1}, {third, 1}}) == 1); // No key stands there.
  CHECK(keysOf({{0.01, 1}}) == 0);
  CHECK(keysOf(Json::array()) == 0);
}

TEST_CASE("Keys that follow of a clip or a part that there is not are refused, of a node left out",
          "[keys]") {
  Document document = test::twoPunches();
  const Track track = punchTrack(document);
  document.followingKeys = {{1, track.node, Channel::rotation, {{track.times[1], 5U}}}};
  const Json kept = keptFollowingKeys(document);
  const auto with = [&](const char* key, const Json& value) {
    Json entries = kept;
    entries[0][key] = value;
    Document other = test::twoPunches();
    const std::string told = restoredFollowing(entries, other);
    return told == "accepted" ? std::to_string(other.followingKeys.size()) : told;
  };
  CHECK(with("clip", 0) == "1");
  CHECK_THAT(with("clip", 2), Catch::Contains("auto_keys"));
  CHECK_THAT(with("clip", -1), Catch::Contains("auto_keys"));
  CHECK_THAT(with("path", "weights"), Catch::Contains("auto_keys"));
  CHECK(with("path", "scale") == "0");
  CHECK(with("node", 1) == "0");
}

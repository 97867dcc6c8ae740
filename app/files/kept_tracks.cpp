#include "app/files/kept_tracks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/edits/keys/track_edits.h"
#include "core/anim/track_names.h"
#include "core/gltf/json/json.h"
#include "core/gltf/json/json_integers.h"

namespace stretch::app {

namespace {

using gltf::Json;

std::size_t numbersOfKey(const Track& track) {
  return static_cast<std::size_t>(track.width) *
         (track.interpolation == Interpolation::cubicSpline ? 3U : 1U);
}

std::vector<float> valuesOfKey(const Track& track, std::size_t key) {
  const std::size_t count = numbersOfKey(track);
  const auto first = track.values.begin() + static_cast<std::ptrdiff_t>(key * count);
  return {first, first + static_cast<std::ptrdiff_t>(count)};
}

// The keys that differ, as [key, numbers]; nothing where another number of keys, or most of them, do.
std::optional<Json> changedValues(const Track& track, const Track& source) {
  if (track.times.size() != source.times.size() || track.interpolation != source.interpolation) {
    return std::nullopt;
  }
  Json changed = Json::array();
  for (std::size_t key = 0; key < track.times.size(); ++key) {
    if (valuesOfKey(track, key) != valuesOfKey(source, key)) {
      changed.push_back({key, valuesOfKey(track, key)});
    }
  }
  return changed.size() * 2 < track.times.size() ? std::optional(changed) : std::nullopt;
}

const Track* sourceTrack(const Document& document, int clip, NodeIndex node, Channel channel) {
  const Clip& source = sourceClipOf(document, clip);
  const int index = findTrack(source, node, channel);
  return index < 0 ? nullptr : &*source.tracks[at(index)];
}

Json keptTrack(int clip, const Track& track, const Track* source) {
  Json json = {{"clip", clip},
               {"node", track.node.value},
               {"path", nameOf(track.channel)},
               {"interpolation", nameOf(track.interpolation)}};
  if (source == nullptr || track.times != source->times) {
    json["times"] = track.times;
  }
  std::optional<Json> changed = source == nullptr ? std::nullopt : changedValues(track, *source);
  if (!changed) {
    json["values"] = track.values;
  } else if (!changed->empty()) {
    json["changed"] = std::move(*changed);
  }
  return json;
}

Error malformedKeys(const char* where) {
  return {"is not what this program writes", where, "open the file and edit its keys again"};
}

Error malformedTrack() {
  return malformedKeys("clip_keys");
}

// Of the parts of a node that keys are edited of: morph weights are none.
std::optional<Channel> editedChannel(const Json& json) {
  const std::optional<Channel> channel = channelNamed(json.at("path").get<std::string>());
  return channel == Channel::weights ? std::nullopt : channel;
}

bool takeChanged(const Json& changed, Track& track) {
  const std::size_t count = numbersOfKey(track);
  for (const Json& entry : changed) {
    const auto key = static_cast<std::size_t>(gltf::integerOf(entry.at(0)));
    const auto numbers = entry.at(1).get<std::vector<float>>();
    if (key >= track.times.size() || numbers.size() != count) {
      return false;
    }
    std::copy(numbers.begin(), numbers.end(),
              track.values.begin() + static_cast<std::ptrdiff_t>(key * count));
  }
  return true;
}

bool isSound(const Track& track) {
  constexpr float longestSeconds = 1e6F;
  const bool ordered = std::adjacent_find(track.times.begin(), track.times.end(),
                                          [](float a, float b) { return !(a < b); }) == track.times.end();
  return !track.times.empty() && ordered && track.times.front() >= 0.0F &&
         track.times.back() <= longestSeconds &&
         track.values.size() == track.times.size() * numbersOfKey(track) &&
         std::ranges::all_of(track.values, [](float v) { return std::isfinite(v); });
}

Result<Track> trackFromJson(const Json& json, int clip, const Document& document) {
  const NodeIndex node(gltf::integerOf(json.at("node")));
  const auto channel = editedChannel(json);
  const auto interpolation = interpolationNamed(json.at("interpolation").get<std::string>());
  if (!node.exists() || at(node) >= document.scene->nodes.size() || !channel || !interpolation) {
    return malformedTrack();
  }
  const Track* const source = sourceTrack(document, clip, node, *channel);
  if (source == nullptr && !(json.contains("times") && json.contains("values"))) {
    return malformedTrack();
  }
  Track track = source != nullptr ? *source : Track{};
  track.node = node;
  track.channel = *channel;
  track.width = track.channel == Channel::rotation ? 4 : 3;
  track.interpolation = *interpolation;
  track.times = json.contains("times") ? json.at("times").get<std::vector<float>>() : track.times;
  track.values = json.contains("values") ? json.at("values").get<std::vector<float>>() : track.values;
  if (!isSound(track) || !takeChanged(json.value("changed", Json::array()), track) || !isSound(track)) {
    return malformedTrack();
  }
  return track;
}

} // namespace

Json keptTracks(const Document& document) {
  Json list = Json::array();
  for (int clip = 0; hasEditedKeys(document) && clip < static_cast<int>(document.clips->size()); ++clip) {
    for (const Track& track : editedTracks(document, clip)) {
      list.push_back(keptTrack(clip, track, sourceTrack(document, clip, track.node, track.channel)));
    }
  }
  return list;
}

Json keptFollowingKeys(const Document& document) {
  Json list = Json::array();
  for (const FollowingKeys& following : document.followingKeys) {
    Json keys = Json::array();
    for (const FollowingKeys::Key& key : following.keys) {
      keys.push_back({key.seconds, key.components});
    }
    list.push_back({{"clip", following.clip},
                    {"node", following.node.value},
                    {"path", nameOf(following.channel)},
                    {"keys", std::move(keys)}});
  }
  return list;
}

Status restoreFollowingKeys(const Json& entries, Document& document) {
  for (const Json& json : entries) {
    const int clip = gltf::integerOf(json.at("clip"));
    const auto channel = editedChannel(json);
    if (clip < 0 || at(clip) >= document.clips->size() || !channel) {
      return malformedKeys("auto_keys");
    }
    FollowingKeys following{clip, NodeIndex(gltf::integerOf(json.at("node"))), *channel, {}};
    const int track = findTrack(clipOf(document, clip), following.node, following.channel);
    const std::vector<float> times =
        track < 0 ? std::vector<float>{} : clipOf(document, clip).tracks[at(track)]->times;
    for (const Json& entry : json.at("keys")) {
      const FollowingKeys::Key key{entry.at(0).get<float>(), entry.at(1).get<unsigned>()};
      const bool isNext = following.keys.empty() || key.seconds > following.keys.back().seconds;
      if (isNext && std::binary_search(times.begin(), times.end(), key.seconds)) {
        following.keys.push_back(key);
      }
    }
    if (!following.keys.empty()) {
      document.followingKeys.push_back(std::move(following));
    }
  }
  return Success{};
}

Status restoreKeptTracks(const Json& entries, Document& document) {
  std::vector<std::vector<Track>> tracks(document.clips->size());
  std::set<std::tuple<int, int, Channel>> known;
  for (const Json& json : entries) {
    const int clip = gltf::integerOf(json.at("clip"));
    if (clip < 0 || at(clip) >= tracks.size()) {
      return malformedTrack();
    }
    Result<Track> track = trackFromJson(json, clip, document);
    if (!track) {
      return track.error();
    }
    if (!known.emplace(clip, track->node.value, track->channel).second) {
      return malformedTrack();
    }
    tracks[at(clip)].push_back(std::move(*track));
  }
  for (std::size_t clip = 0; clip < tracks.size(); ++clip) {
    if (!tracks[clip].empty()) {
      document = setTracks(document, static_cast<int>(clip), tracks[clip]);
    }
  }
  return Success{};
}

} // namespace stretch::app

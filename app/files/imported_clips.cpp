#include "app/files/imported_clips.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "app/edits/keys/import_clip.h"
#include "core/anim/track_names.h"
#include "core/gltf/json/json.h"
#include "core/gltf/json/json_integers.h"

namespace stretch::app {

namespace {

using gltf::Json;

Error malformedClip() {
  return {"is not what this program writes", "imported_clips", "import the clip again"};
}

Json trackJson(const Track& track) {
  return {{"node", track.node.value},
          {"path", nameOf(track.channel)},
          {"interpolation", nameOf(track.interpolation)},
          {"width", track.width},
          {"times", track.times},
          {"values", track.values}};
}

Result<Track> trackOfJson(const Json& json, std::size_t nodes) {
  Track track;
  track.node = NodeIndex(gltf::integerOf(json.at("node")));
  const auto channel = channelNamed(json.at("path").get<std::string>());
  const auto interpolation = interpolationNamed(json.at("interpolation").get<std::string>());
  if (!track.node.exists() || at(track.node) >= nodes || !channel || !interpolation) {
    return malformedClip();
  }
  track.channel = *channel;
  track.interpolation = *interpolation;
  track.width = gltf::integerOf(json.at("width"));
  track.times = json.at("times").get<std::vector<float>>();
  track.values = json.at("values").get<std::vector<float>>();
  return track.times.empty() ? Result<Track>(malformedClip()) : Result<Track>(std::move(track));
}

Result<Clip> clipOfJson(const Json& json, std::size_t nodes) {
  Clip clip;
  clip.name = json.at("name").get<std::string>();
  clip.framesPerSecond = json.at("fps").get<double>();
  for (const Json& entry : json.at("tracks")) {
    Result<Track> track = trackOfJson(entry, nodes);
    if (!track) {
      return track.error();
    }
    clip.tracks.emplace_back(std::move(track).value());
  }
  return clip.tracks.empty() || !(clip.framesPerSecond > 0.0) ? Result<Clip>(malformedClip())
                                                              : Result<Clip>(std::move(clip));
}

} // namespace

Json importedClipsToJson(const Document& document) {
  Json list = Json::array();
  if (document.importedClips == 0) {
    return list;
  }
  const std::vector<Clip>& clips = *sourceClipsOf(document);
  for (std::size_t i = clips.size() - document.importedClips; i < clips.size(); ++i) {
    Json tracks = Json::array();
    for (const CopyOnWrite<Track>& track : clips[i].tracks) {
      tracks.push_back(trackJson(*track));
    }
    list.push_back({{"clip", i},
                    {"name", clips[i].name},
                    {"fps", clips[i].framesPerSecond},
                    {"tracks", std::move(tracks)}});
  }
  return list;
}

Result<Document> withImportedClips(const Document& document, const Json& list) {
  std::vector<Clip> lacking;
  try {
    for (const Json& entry : list) {
      Result<Clip> clip = clipOfJson(entry, document.scene->nodes.size());
      if (!clip) {
        return clip.error();
      }
      const auto place = static_cast<std::size_t>(gltf::integerOf(entry.at("clip")));
      const bool isThere = place < document.clips->size() && (*document.clips)[place].name == clip->name;
      if (!isThere && place != document.clips->size() + lacking.size()) {
        return malformedClip();
      }
      if (!isThere) {
        lacking.push_back(std::move(clip).value());
      }
    }
  } catch (const Json::exception&) {
    return malformedClip();
  }
  return lacking.empty() ? Result<Document>(document) : withNewClips(document, lacking);
}

} // namespace stretch::app

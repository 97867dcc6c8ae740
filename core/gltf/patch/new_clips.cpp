#include "core/gltf/patch/new_clips.h"

#include "core/gltf/json/json.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/patch/journal.h"
#include "core/gltf/source/fields.h"

namespace stretch::gltf {

Result<Source> withNewClips(const Source& source, const std::vector<Clip>& clips) {
  Journal journal(source.json);
  Edits edits;
  for (const Clip& clip : clips) {
    Json animation = {{"channels", Json::array()}, {"samplers", Json::array()}};
    if (!clip.name.empty()) {
      animation["name"] = clip.name;
    }
    const std::size_t index = journal.append(Json::json_pointer("/animations"), std::move(animation));
    ClipTracks added{static_cast<int>(index), {}};
    for (const CopyOnWrite<Track>& track : clip.tracks) {
      added.tracks.push_back(*track);
    }
    added.framesPerSecond =
        guessFramesPerSecond(clip.tracks) == clip.framesPerSecond ? 0.0 : clip.framesPerSecond;
    edits.clips.push_back(std::move(added));
  }
  Source grown = source;
  grown.json = journal.json();
  return patched(grown, edits);
}

} // namespace stretch::gltf

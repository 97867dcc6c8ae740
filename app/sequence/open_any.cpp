#include "app/sequence/open_any.h"
#include "app/files/save.h"

#include <algorithm>
#include <system_error>

#include "skinning/sequence/mesh_file.h"

namespace stretch::app {

namespace {

bool movesMorphTargetsOnly(const Document& document) {
  const auto onlyWeights = [](const Clip& clip) {
    return !clip.tracks.empty() && std::ranges::all_of(clip.tracks, [](const CopyOnWrite<Track>& track) {
      return track->channel == Channel::weights;
    });
  };
  const std::vector<Clip>& clips = *document.clips;
  return document.scene->skins.empty() && !clips.empty() &&
         std::all_of(clips.begin(), clips.end(), onlyWeights);
}

Result<Opened> asOpened(Result<SequenceDocument> sequence) {
  return sequence ? Result<Opened>(std::move(sequence).value()) : Result<Opened>(sequence.error());
}

} // namespace

bool namesSequence(const std::vector<std::filesystem::path>& paths) {
  std::error_code ignored;
  return paths.size() > 1 || std::any_of(paths.begin(), paths.end(), [&](const auto& path) {
           return std::filesystem::is_directory(path, ignored) || skinning::isMeshFile(path) ||
                  skinning::isPointCache(path);
         });
}

bool holdsSequence(const std::filesystem::path& folder) {
  std::error_code problem;
  if (std::filesystem::exists(folder / "membranes_buffer.txt", problem)) {
    return true;
  }
  int meshes = 0;
  for (std::filesystem::directory_iterator entry(folder, problem), end;
       !problem && meshes < 2 && entry != end; entry.increment(problem)) {
    meshes += skinning::isMeshFile(entry->path()) ? 1 : 0;
  }
  return meshes > 1;
}

Result<Opened> openAny(const std::vector<std::filesystem::path>& paths, const skinning::Progress& progress) {
  if (namesSequence(paths)) {
    return asOpened(openSequence(paths, progress));
  }
  Result<Document> document = openDocument(paths.front(), gltf::Tolerance::warn);
  if (!document) {
    return document.error();
  }
  if (movesMorphTargetsOnly(*document)) {
    return asOpened(openSequence(paths, progress));
  }
  return Opened(std::move(document).value());
}

} // namespace stretch::app

#include "skinning/sequence/read_sequence.h"

#include <system_error>

#include <fmt/format.h>

#include "skinning/sequence/frame_names.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/topology.h"

namespace stretch::skinning {
namespace {

/// Files of a glTF split vertices along seams: the sequence moves each place once.
void joinSplit(MeshSequence& sequence) {
  if (const std::size_t joined = joinDuplicates(sequence); joined > 0) {
    sequence.warnings.push_back(std::to_string(joined) +
                                " vertices that lie on another one in every frame were joined with it");
  }
}

/// What is missing where a single file was named.
Error aloneError(const std::filesystem::path& path) {
  if (!isPointCache(path)) {
    return Error{
        "a single file is no mesh sequence", path.string(),
        "give a folder of frames, a .pc2 or .mdd cache with the mesh it was made of, or a glTF with a "
        "morph-target clip"};
  }
  const auto points = pointsOfCache(path);
  return points ? Error{"no OBJ or PLY beside the cache has its " + std::to_string(*points) + " points",
                        path.string(), "name the mesh that it was made of with it: BASE.obj CACHE.pc2"}
                : points.error();
}

Result<MeshSequence> readTwo(const std::filesystem::path& base, const std::filesystem::path& cache,
                             const Progress& progress, double framesPerSecond) {
  if (!isPointCache(cache)) {
    return Error{"is not a point cache", cache.string(), "name a base mesh and its .pc2 or .mdd cache"};
  }
  auto sequence = readPointCache(base, cache, progress, framesPerSecond);
  if (sequence && isGltfFile(base)) {
    joinSplit(*sequence);
  }
  return sequence;
}

Result<MeshSequence> readOne(const std::filesystem::path& path, const std::string& clip,
                             const Progress& progress, double framesPerSecond) {
  std::error_code problem;
  if (std::filesystem::is_directory(path, problem)) {
    const bool simulated = std::filesystem::exists(path / "membranes_buffer.txt", problem);
    return simulated ? readSibernetic(path, progress) : readFrames(path, progress);
  }
  if (!std::filesystem::exists(path, problem)) {
    return Error{"there is no such file or folder", path.string(), "check the path"};
  }
  if (isMeshFile(path) && seriesOf(path).size() > 1) {
    return readFrames(path, progress);
  }
  if (!isGltfFile(path)) {
    return aloneError(path);
  }
  auto sequence = readAnimatedGltf(path, clip, progress, framesPerSecond);
  if (sequence) {
    joinSplit(*sequence);
  }
  return sequence;
}

} // namespace

Result<MeshSequence> readSequence(const std::vector<std::filesystem::path>& named, const Progress& progress,
                                  const std::string& clip, double framesPerSecond) {
  const std::vector<std::filesystem::path> paths = sequencePaths(named);
  if (paths.empty() || paths.size() > 2) {
    return Error{"a sequence is one folder or file, or a base mesh and its cache", "",
                 "name one or two paths"};
  }
  if (!clip.empty() && (paths.size() != 1 || !isGltfFile(paths[0]))) {
    return Error{"only a glTF has clips to choose from", fmt::format("clip '{}'", clip), "leave it out"};
  }
  auto sequence = paths.size() == 1 ? readOne(paths[0], clip, progress, framesPerSecond)
                                    : readTwo(paths[0], paths[1], progress, framesPerSecond);
  if (!sequence) {
    return sequence;
  }
  if (framesPerSecond > 0.0) {
    sequence->framesPerSecond = framesPerSecond;
  }
  const TopologyReport report = inspectTopology(sequence->frame(0), sequence->triangles);
  for (std::string& warning : report.warnings()) {
    sequence.value().warnings.push_back(std::move(warning));
  }
  return sequence;
}

} // namespace stretch::skinning

#include "skinning/sequence/read_sequence.h"

#include <system_error>

#include "skinning/sequence/topology.h"

namespace stretch::skinning {
namespace {

Result<MeshSequence> readOne(const std::filesystem::path& path, const Progress& progress) {
  std::error_code problem;
  if (std::filesystem::is_directory(path, problem)) {
    const bool simulated = std::filesystem::exists(path / "membranes_buffer.txt", problem);
    return simulated ? readSibernetic(path, progress) : readFrameFolder(path, progress);
  }
  if (!std::filesystem::exists(path, problem)) {
    return Error{"there is no such file or folder", path.string(), "check the path"};
  }
  const std::string extension = path.extension().string();
  if (extension != ".glb" && extension != ".gltf" && extension != ".vrm") {
    return Error{
        "a single file is no mesh sequence", path.string(),
        "give a folder of frames, a .pc2 cache with the mesh it was made of, or a glTF with a morph-target "
        "clip"};
  }
  auto sequence = readAnimatedGltf(path, {}, progress);
  if (sequence) {
    const std::size_t joined = joinDuplicates(sequence.value());
    if (joined > 0) {
      sequence.value().warnings.push_back(
          std::to_string(joined) + " vertices that lie on another one in every frame were joined with it");
    }
  }
  return sequence;
}

} // namespace

Result<MeshSequence> readSequence(const std::vector<std::filesystem::path>& named, const Progress& progress) {
  const std::vector<std::filesystem::path> paths = sequencePaths(named);
  if (paths.empty() || paths.size() > 2) {
    return Error{"a sequence is one folder or file, or a base mesh and its cache", "",
                 "name one or two paths"};
  }
  auto sequence =
      paths.size() == 1 ? readOne(paths[0], progress) : readPointCache(paths[0], paths[1], progress);
  if (!sequence) {
    return sequence;
  }
  const TopologyReport report = inspectTopology(sequence->frame(0), sequence->triangles);
  for (std::string& warning : report.warnings()) {
    sequence.value().warnings.push_back(std::move(warning));
  }
  return sequence;
}

} // namespace stretch::skinning

#include "skinning/sequence/read_sequence.h"

#include <algorithm>
#include <system_error>

#include "core/base/file.h"
#include "skinning/sequence/frame_names.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/text.h"

namespace stretch::skinning {
namespace {

/// The frames in a folder, or those that one of them stands for.
Result<FrameFiles> frameFiles(const std::filesystem::path& path, bool isFolder) {
  if (!isFolder) {
    return framesInOrder(seriesOf(path));
  }
  const auto files = filesIn(path, isMeshFile);
  if (!files) {
    return files.error();
  }
  if (files->empty()) {
    return Error{"the folder holds no .obj or .ply frames", path.string(), "give the folder of the frames"};
  }
  const auto isPly = [](const std::filesystem::path& file) { return lowerExtension(file) == ".ply"; };
  if (std::ranges::any_of(*files, isPly) && !std::ranges::all_of(*files, isPly)) {
    return Error{"the folder holds OBJ and PLY frames", path.string(), "keep one kind"};
  }
  return framesInOrder(*files);
}

/// `first`: the polygons of the first frame. Those of a later one may be cut otherwise, for it has other
/// places.
Status addFrame(MeshSequence& sequence, const MeshFile& mesh, const Polygons& first,
                const std::string& file) {
  if (sequence.vertexCount == 0) {
    sequence.vertexCount = mesh.positions.size();
    sequence.triangles = mesh.triangles;
  }
  if (mesh.positions.size() != sequence.vertexCount) {
    return Error{"the frame has " + std::to_string(mesh.positions.size()) + " vertices where the first has " +
                     std::to_string(sequence.vertexCount),
                 file, "every frame needs the same topology"};
  }
  if (mesh.triangles != sequence.triangles && mesh.polygons != first) {
    return Error{"the faces differ from those of the first frame", file,
                 "every frame needs the same topology"};
  }
  sequence.positions.insert(sequence.positions.end(), mesh.positions.begin(), mesh.positions.end());
  sequence.frameNames.push_back(file);
  return Success{};
}

} // namespace

bool isMeshFile(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  return extension == ".obj" || extension == ".ply";
}

Result<MeshFile> readMeshFile(const std::filesystem::path& path) {
  const auto content = readText(path);
  if (!content) {
    return content.error();
  }
  const std::string name = path.filename().string();
  return lowerExtension(path) == ".ply" ? parsePly(*content, name) : parseObj(*content, name);
}

Result<MeshSequence> readFrames(const std::filesystem::path& named, const Progress& progress) {
  std::error_code problem;
  const bool isFolder = !isMeshFile(named) || std::filesystem::is_directory(named, problem);
  const auto frames = frameFiles(named, isFolder);
  if (!frames) {
    return frames.error();
  }
  const std::vector<std::filesystem::path>& files = frames->files;
  MeshSequence sequence;
  sequence.name = (isFolder ? named : folderOf(named)).filename().string();
  sequence.warnings = frames->warnings;
  Polygons first;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::filesystem::path& path = files[i];
    const auto mesh = readMeshFile(path);
    if (!mesh) {
      return mesh.error();
    }
    if (i == 0) {
      sequence.surface = surfaceOfMeshFile(path, *mesh, sequence.warnings);
      sequence.positions.reserve(mesh->positions.size() * files.size());
      first = mesh->polygons;
    }
    const auto added = addFrame(sequence, *mesh, first, path.filename().string());
    if (!added) {
      return added.error();
    }
    if (progress) {
      progress(static_cast<double>(i + 1) / static_cast<double>(files.size()));
    }
  }
  return sequence;
}

} // namespace stretch::skinning

#include <algorithm>

#include "skinning/sequence/frame_names.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/read_sequence.h"

namespace stretch::skinning {
namespace {

namespace fs = std::filesystem;

std::size_t sharedStart(const std::string& a, const std::string& b) {
  const auto [end, ignored] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(end - a.begin());
}

/// The mesh beside a cache that has as many vertices as the cache has points; of several the one whose name
/// begins most like the cache's.
fs::path baseMeshOf(const fs::path& cache) {
  constexpr std::size_t mostTried = 16;
  const std::string stem = cache.stem().string();
  const auto beside = filesIn(folderOf(cache), isBaseMesh);
  std::vector<fs::path> files = beside ? *beside : std::vector<fs::path>();
  std::sort(files.begin(), files.end(), [&](const fs::path& a, const fs::path& b) {
    const std::size_t likeA = sharedStart(stem, a.stem().string());
    const std::size_t likeB = sharedStart(stem, b.stem().string());
    return likeA != likeB ? likeA > likeB : a < b;
  });
  files.resize(std::min(files.size(), mostTried));
  const auto points = pointsOfCache(cache);
  for (const fs::path& file : points ? files : std::vector<fs::path>{}) {
    const auto vertices = verticesOfBase(file);
    if (vertices && *vertices == *points) {
      return file;
    }
  }
  return {};
}

} // namespace

std::vector<fs::path> sequencePaths(const std::vector<fs::path>& named) {
  if (named.size() == 2 && isPointCache(named[0])) {
    return {named[1], named[0]};
  }
  if (named.size() != 1) {
    return named;
  }
  if (isPointCache(named[0])) {
    const fs::path base = baseMeshOf(named[0]);
    return base.empty() ? named : std::vector<fs::path>{base, named[0]};
  }
  const std::size_t series = isMeshFile(named[0]) ? seriesOf(named[0]).size() : 1;
  const auto meshes = filesIn(folderOf(named[0]), isMeshFile);
  return series > 1 && meshes && meshes->size() == series ? std::vector<fs::path>{folderOf(named[0])} : named;
}

} // namespace stretch::skinning

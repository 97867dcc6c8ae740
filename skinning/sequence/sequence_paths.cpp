#include <algorithm>
#include <system_error>

#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/read_sequence.h"

namespace stretch::skinning {
namespace {

namespace fs = std::filesystem;

/// The name up to the number at its end: "wolf-" of "wolf-12.obj".
std::string withoutNumber(const fs::path& path) {
  const std::string stem = path.stem().string();
  return stem.substr(0, stem.find_last_not_of("0123456789") + 1);
}

std::vector<fs::path> filesIn(const fs::path& folder, bool (*wanted)(const fs::path&)) {
  std::vector<fs::path> files;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    if (wanted(entry->path())) {
      files.push_back(entry->path());
    }
  }
  return files;
}

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

bool isOneOfSeveralFrames(const fs::path& path) {
  const std::string name = withoutNumber(path);
  const std::vector<fs::path> files = filesIn(folderOf(path), isMeshFile);
  return name != path.stem().string() &&
         std::count_if(files.begin(), files.end(), [&](const fs::path& other) {
           return withoutNumber(other) == name && other.extension() == path.extension();
         }) > 1;
}

std::size_t sharedStart(const std::string& a, const std::string& b) {
  const auto [end, ignored] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(end - a.begin());
}

/// The mesh beside a cache that has as many vertices as the cache has points; of several the one whose name
/// begins most like the cache's.
fs::path baseMeshOf(const fs::path& cache) {
  constexpr std::size_t mostTried = 16;
  const std::string stem = cache.stem().string();
  std::vector<fs::path> files = filesIn(folderOf(cache), isBaseMesh);
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
  if (isMeshFile(named[0]) && isOneOfSeveralFrames(named[0])) {
    return {folderOf(named[0])};
  }
  return named;
}

} // namespace stretch::skinning

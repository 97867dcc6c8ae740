#include "skinning/sequence/read_sequence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/anim/frame_state.h"
#include "core/gltf/import/mesh_surface.h"
#include "core/gltf/load/load_as_it_stands.h"
#include "skinning/linear_blend_skinning.h"
#include "skinning/sequence/gltf_surface.h"
#include "skinning/sequence/mesh_file.h"

namespace stretch::skinning {
namespace {

const Clip* findClip(const std::vector<Clip>& clips, const std::string& name) {
  const auto found = std::find_if(clips.begin(), clips.end(), [&](const Clip& clip) {
    return name.empty() || clip.name == name || fmt::format("#{}", clip.sourceIndex) == name;
  });
  return found == clips.end() ? nullptr : &*found;
}

// "'walk', 'run', #2 and 4 more"; a clip without a name by its place.
std::string listOf(const std::vector<Clip>& clips) {
  constexpr std::size_t most = 8;
  std::string list;
  for (std::size_t i = 0; i < std::min(clips.size(), most); ++i) {
    list +=
        (i == 0 ? "" : ", ") + (clips[i].name.empty() ? fmt::format("#{}", i) : "'" + clips[i].name + "'");
  }
  return clips.size() > most ? fmt::format("{} and {} more", list, clips.size() - most) : list;
}

Error noClip(const std::vector<Clip>& clips, const std::string& name, const std::filesystem::path& path) {
  return clips.empty() ? Error{"the file holds no clip", path.string(), "give an animated file"}
                       : Error{fmt::format("there is no clip '{}'", name), path.string(),
                               "clips of this file: " + listOf(clips)};
}

constexpr std::size_t nameOfFrame = 4; // A frame's name takes as much as so many positions.

// A clip of two keys can last for years: what it is played to is bounded by the size of its file.
std::size_t mostPositions(const gltf::Source& source) {
  constexpr std::size_t ofAnyFile = 400'000'000; // Some 5 GB.
  constexpr std::size_t ofOneByte = 64;
  std::size_t most = std::size_t{1} << 25U;
  for (const gltf::Bytes& buffer : source.buffers) {
    most = std::min(ofAnyFile, most + ofOneByte * buffer.size());
  }
  return most;
}

Status checkPlaces(const MeshSequence& sequence, const std::filesystem::path& path) {
  if (std::ranges::all_of(sequence.positions, isUsablePlace)) {
    return Success{};
  }
  return Error{fmt::format("the clip moves a vertex to no finite place, or beyond {:g}", largestCoordinate),
               path.string(), "export the file again"};
}

} // namespace

Result<MeshSequence> readAnimatedGltf(const std::filesystem::path& path, const std::string& clipName,
                                      const Progress& progress, double framesPerSecond) {
  const auto loaded = gltf::loadAsItStands(path);
  if (!loaded) {
    return loaded.error();
  }
  const Clip* found = findClip(loaded->clips, clipName);
  if (found == nullptr) {
    return noClip(loaded->clips, clipName, path);
  }
  Clip atRate = *found;
  atRate.framesPerSecond = framesPerSecond > 0.0 ? framesPerSecond : found->framesPerSecond;
  const Clip* const clip = &atRate;
  const Scene& scene = *loaded->scene;
  MeshSequence sequence;
  sequence.name = path.stem().string();
  sequence.clipName = clip->name;
  if (clipName.empty() && loaded->clips.size() > 1) {
    sequence.warnings.push_back(fmt::format("the first of {} clips was taken, {}", loaded->clips.size(),
                                            listOf({loaded->clips.front()})));
  }
  sequence.framesPerSecond = clip->framesPerSecond;
  const auto stateAt = [&](std::int64_t frame) {
    const double seconds = static_cast<double>(frame) / clip->framesPerSecond;
    return frameOf(scene, samplePose(scene, *clip, seconds), seconds);
  };
  const std::int64_t last = std::max<std::int64_t>(frameCount(*clip), 1);
  const std::int64_t first =
      std::clamp<std::int64_t>(std::llround(clip->startSeconds * clip->framesPerSecond), 0, last - 1);
  gltf::MeshSurface surface = surfaceOf(*loaded, stateAt(first), sequence.warnings);
  sequence.triangles = surface.triangles;
  sequence.vertexCount = surface.places.size();
  if (sequence.triangles.empty()) {
    return Error{"the file shows no mesh", path.string(), "give a file with an animated mesh"};
  }
  sequence.surface = std::make_shared<const gltf::MeshSurface>(std::move(surface));
  if (sequence.vertexCount + nameOfFrame >
      mostPositions(*loaded->source) / static_cast<std::size_t>(last - first)) {
    return Error{fmt::format("{} vertices in {} frames are too many", sequence.vertexCount, last - first),
                 path.string(), "give a shorter clip"};
  }
  sequence.positions.resize(sequence.vertexCount * static_cast<std::size_t>(last - first));
  for (std::int64_t frame = first; frame < last; ++frame) {
    const std::vector<Vec3> posed = skinnedPositions(scene, stateAt(frame));
    std::copy(posed.begin(), posed.end(), sequence.frame(static_cast<std::size_t>(frame - first)).begin());
    sequence.frameNames.push_back(fmt::format("frame {}", frame));
    if (progress) {
      progress(static_cast<double>(frame - first + 1) / static_cast<double>(last - first));
    }
  }
  if (const Status usable = checkPlaces(sequence, path); !usable) {
    return usable.error();
  }
  return sequence;
}

std::size_t joinDuplicates(MeshSequence& sequence) {
  const std::size_t count = sequence.vertexCount;
  const std::size_t frames = sequence.frameCount();
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  const auto compare = [&](std::uint32_t a, std::uint32_t b) {
    for (std::size_t k = 0; k < frames; ++k) {
      const glm::vec3& p = sequence.frame(k)[a];
      const glm::vec3& q = sequence.frame(k)[b];
      if (p != q) {
        return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z) ? -1 : 1;
      }
    }
    return 0;
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const int sign = compare(a, b);
    return sign < 0 || (sign == 0 && a < b);
  });
  std::vector<std::uint32_t> stays(count); // The first vertex at the same place.
  for (std::size_t i = 0; i < count; ++i) {
    const bool same = i > 0 && compare(order[i - 1], order[i]) == 0;
    stays[order[i]] = same ? stays[order[i - 1]] : order[i];
  }
  std::vector<std::uint32_t> renumbered(count);
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < count; ++v) {
    renumbered[v] = stays[v] == v ? kept++ : renumbered[stays[v]];
  }
  for (std::size_t k = 0; k < frames; ++k) {
    for (std::uint32_t v = 0; v < count; ++v) {
      if (stays[v] == v) {
        sequence.positions[k * kept + renumbered[v]] = sequence.positions[k * count + v];
      }
    }
  }
  sequence.positions.resize(frames * kept);
  sequence.vertexCount = kept;
  for (Triangle& triangle : sequence.triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = renumbered[corner];
    }
  }
  if (sequence.surface != nullptr) {
    gltf::MeshSurface surface = *sequence.surface;
    for (std::uint32_t& place : surface.places) {
      place = renumbered[place];
    }
    sequence.surface = std::make_shared<const gltf::MeshSurface>(std::move(surface));
  }
  return count - kept;
}

void joinUntilAlike(MeshSequence& a, MeshSequence& b) {
  if (a.vertexCount == b.vertexCount) {
    return;
  }
  MeshSequence joinedA = a;
  MeshSequence joinedB = b;
  joinDuplicates(joinedA);
  joinDuplicates(joinedB);
  if (joinedA.vertexCount == joinedB.vertexCount) {
    a = std::move(joinedA);
    b = std::move(joinedB);
  }
}

} // namespace stretch::skinning

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "core/gltf/load/load_as_it_stands.h"
#include "skinning/linear_blend_skinning.h"
#include "skinning/sequence/cache_header.h"
#include "skinning/sequence/gltf_surface.h"
#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/read_sequence.h"
#include "skinning/sequence/text.h"

namespace stretch::skinning {
namespace {

/// A sequence without frames: what the base mesh of a cache says.
Result<MeshSequence> sequenceOfGltf(const std::filesystem::path& base) {
  const auto loaded = gltf::loadAsItStands(base);
  if (!loaded) {
    return loaded.error();
  }
  MeshSequence sequence;
  const Scene& scene = *loaded->scene;
  gltf::MeshSurface surface = surfaceOf(*loaded, frameOf(scene, restPose(scene), 0.0), sequence.warnings);
  sequence.vertexCount = surface.places.size();
  sequence.triangles = surface.triangles;
  if (sequence.triangles.empty()) {
    return Error{"the file shows no mesh", base.string(), "give the mesh that the cache was made of"};
  }
  sequence.surface = std::make_shared<const gltf::MeshSurface>(std::move(surface));
  return sequence;
}

Result<MeshSequence> sequenceOfBase(const std::filesystem::path& base) {
  if (isGltfFile(base)) {
    return sequenceOfGltf(base);
  }
  auto mesh = readMeshFile(base);
  if (!mesh) {
    return mesh.error();
  }
  MeshSequence sequence;
  sequence.vertexCount = mesh->positions.size();
  sequence.surface = surfaceOfMeshFile(base, *mesh, sequence.warnings);
  sequence.triangles = std::move(mesh->triangles);
  return sequence;
}

/// Puts a sample of the file into a frame.
void takeSample(std::vector<char>& bytes, bool bigEndian, std::span<glm::vec3> frame) {
  if (bigEndian) {
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
      std::swap(bytes[i], bytes[i + 3]);
      std::swap(bytes[i + 1], bytes[i + 2]);
    }
  }
  static_assert(sizeof(glm::vec3) == 12);
  std::memcpy(static_cast<void*>(frame.data()), bytes.data(), bytes.size());
}

Status readSamples(std::ifstream& stream, const std::string& place, const CacheHeader& header,
                   MeshSequence& sequence, const Progress& progress) {
  const auto samples = static_cast<std::size_t>(header.samples);
  sequence.positions.resize(sequence.vertexCount * samples);
  std::vector<char> bytes(header.sampleBytes());
  for (std::size_t s = 0; s < samples; ++s) {
    const std::span<glm::vec3> frame = sequence.frame(s);
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    takeSample(bytes, header.bigEndian, frame);
    for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
      if (!isUsablePlace(frame[v])) {
        return Error{fmt::format("vertex {} is at no finite place, or beyond {:g}", v, largestCoordinate),
                     fmt::format("{}, sample {}", place, s), "export the cache again"};
      }
    }
    sequence.frameNames.push_back(fmt::format("sample {}", s));
    if (progress) {
      progress(static_cast<double>(s + 1) / static_cast<double>(samples));
    }
  }
  return Success{};
}

/// Tells where a PC2 does not hold every frame of the program that wrote it: it names no rate itself.
void tellSparse(const CacheHeader& header, MeshSequence& sequence) {
  if (header.framesBetween != 1.0) {
    sequence.warnings.push_back(
        fmt::format("the cache was sampled every {:g} frames of the program that wrote it, and plays them at "
                    "{:g} frames per second: give --fps, that program's rate over {:g}",
                    header.framesBetween, sequence.framesPerSecond, header.framesBetween));
  }
}

/// The rate that the times of the samples make; a clip plays them evenly. Answers whether they make one.
bool takeRate(const std::vector<double>& times, MeshSequence& sequence) {
  if (times.size() < 2) {
    return false;
  }
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  constexpr double fastest = 10000.0; // frames per second
  if (!(step > 1.0 / fastest)) {
    sequence.warnings.emplace_back("the times of the cache do not move on: 30 frames per second are taken");
    return false;
  }
  double worst = 0.0;
  for (std::size_t s = 0; s < times.size(); ++s) {
    worst = std::max(worst, std::abs(times[s] - times.front() - static_cast<double>(s) * step));
  }
  sequence.framesPerSecond = 1.0 / step;
  // Times in single precision: a rate that is meant to be whole is.
  if (const double whole = std::round(sequence.framesPerSecond);
      std::abs(sequence.framesPerSecond - whole) < 1e-3 * whole) {
    sequence.framesPerSecond = whole;
  }
  if (worst > 0.1 * step) {
    sequence.warnings.push_back(
        fmt::format("the times of the cache are uneven: it plays at {:.4g} frames per "
                    "second, its mean",
                    sequence.framesPerSecond));
  }
  return true;
}

/// The rate that was asked for in place of the one of the times.
void takeOtherRate(double framesPerSecond, bool hasOwn, MeshSequence& sequence) {
  constexpr double alike = 1e-3;
  const double share = framesPerSecond / sequence.framesPerSecond;
  if (hasOwn && std::abs(share - 1.0) > alike) {
    sequence.warnings.push_back(fmt::format(
        "by the times of the cache it has {:g} frames per second: at {:g} it plays {:.4g} times as "
        "fast as it was made",
        sequence.framesPerSecond, framesPerSecond, share));
  }
  sequence.framesPerSecond = framesPerSecond;
}

} // namespace

bool isGltfFile(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  return extension == ".glb" || extension == ".gltf" || extension == ".vrm";
}

bool isBaseMesh(const std::filesystem::path& path) {
  return isMeshFile(path) || isGltfFile(path);
}

Result<std::size_t> verticesOfBase(const std::filesystem::path& path) {
  if (isMeshFile(path)) {
    const Result<MeshFile> mesh = readMeshFile(path);
    return mesh ? Result<std::size_t>(mesh->positions.size()) : Result<std::size_t>(mesh.error());
  }
  const Result<MeshSequence> base = sequenceOfGltf(path);
  return base ? Result<std::size_t>(base->vertexCount) : Result<std::size_t>(base.error());
}

Result<MeshSequence> readPointCache(const std::filesystem::path& base, const std::filesystem::path& cache,
                                    const Progress& progress, double framesPerSecond) {
  if (!isBaseMesh(base)) {
    return Error{"is not a mesh that a cache could move", base.string(), "give an OBJ, PLY or glTF file"};
  }
  Result<MeshSequence> sequence = sequenceOfBase(base);
  if (!sequence) {
    return sequence;
  }
  const std::string place = cache.filename().string();
  std::ifstream stream;
  const auto header = readCacheHeader(stream, cache);
  if (!header) {
    return header.error();
  }
  if (header->points != sequence->vertexCount) {
    return Error{fmt::format("the cache has {} points where {} has {} vertices", header->points,
                             base.filename().string(), sequence->vertexCount),
                 place, "give the mesh that the cache was made of"};
  }
  sequence->name = cache.stem().string();
  const bool hasOwnRate = takeRate(header->timeSeconds, *sequence);
  if (framesPerSecond > 0.0) {
    takeOtherRate(framesPerSecond, hasOwnRate, *sequence);
  } else {
    tellSparse(*header, *sequence);
  }
  if (const Status read = readSamples(stream, place, *header, *sequence, progress); !read) {
    return read.error();
  }
  return sequence;
}

} // namespace stretch::skinning

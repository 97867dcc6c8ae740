#include "skinning/sequence/mesh_file.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <span>
#include <system_error>

#include "skinning/sequence/read_sequence.h"
#include "skinning/sequence/text.h"

namespace stretch::skinning {
namespace {

static_assert(std::endian::native == std::endian::little, "point caches are read as they lie in the file");

struct CacheHeader {
  std::uint64_t points = 0;
  std::uint64_t samples = 0;
};

constexpr std::size_t headerBytes = 32;

template <typename T>
T readAt(const std::array<char, headerBytes>& bytes, std::size_t offset) {
  T value{};
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

Result<CacheHeader> readHeader(std::ifstream& stream, const std::string& place) {
  constexpr std::array<char, 12> magic{'P', 'O', 'I', 'N', 'T', 'C', 'A', 'C', 'H', 'E', '2', '\0'};
  std::array<char, headerBytes> bytes{};
  stream.read(bytes.data(), headerBytes);
  if (stream.gcount() != headerBytes || std::memcmp(bytes.data(), magic.data(), magic.size()) != 0) {
    return Error{"the file is no PC2 point cache", place, "export the cache as PC2"};
  }
  const auto version = readAt<std::int32_t>(bytes, 12);
  const auto points = readAt<std::int32_t>(bytes, 16);
  const auto samples = readAt<std::int32_t>(bytes, 28);
  if (version != 1 || points <= 0 || samples <= 0) {
    return Error{"the header of the point cache makes no sense (version " + std::to_string(version) + ", " +
                     std::to_string(points) + " points, " + std::to_string(samples) + " samples)",
                 place, "export the cache again"};
  }
  return CacheHeader{static_cast<std::uint64_t>(points), static_cast<std::uint64_t>(samples)};
}

Status readSamples(std::ifstream& stream, const std::string& place, MeshSequence& sequence,
                   std::size_t samples, const Progress& progress) {
  static_assert(sizeof(glm::vec3) == 12);
  sequence.positions.resize(sequence.vertexCount * samples);
  for (std::size_t s = 0; s < samples; ++s) {
    const std::span<glm::vec3> frame = sequence.frame(s);
    std::vector<char> bytes(sequence.vertexCount * sizeof(glm::vec3));
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    std::memcpy(static_cast<void*>(frame.data()), bytes.data(), bytes.size());
    for (std::size_t v = 0; v < sequence.vertexCount; ++v) {
      if (!std::isfinite(frame[v].x + frame[v].y + frame[v].z)) {
        return Error{"vertex " + std::to_string(v) + " is no finite position",
                     place + ", sample " + std::to_string(s), "export the cache again"};
      }
    }
    sequence.frameNames.push_back("sample " + std::to_string(s));
    if (progress) {
      progress(static_cast<double>(s + 1) / static_cast<double>(samples));
    }
  }
  return Success{};
}

} // namespace

bool isPointCache(const std::filesystem::path& path) {
  return lowerExtension(path) == ".pc2";
}

Result<std::uint64_t> pointsOfCache(const std::filesystem::path& cache) {
  std::ifstream stream(cache, std::ios::binary);
  const auto header = readHeader(stream, cache.filename().string());
  if (!header) {
    return header.error();
  }
  return header->points;
}

Result<MeshSequence> readPointCache(const std::filesystem::path& base, const std::filesystem::path& cache,
                                    const Progress& progress) {
  auto mesh = readMeshFile(base);
  if (!mesh) {
    return mesh.error();
  }
  const std::string place = cache.filename().string();
  std::error_code problem;
  const auto fileBytes = std::filesystem::file_size(cache, problem);
  std::ifstream stream(cache, std::ios::binary);
  if (problem || !stream) {
    return Error{"the file cannot be read", cache.string(), "check that it exists and may be read"};
  }
  const auto header = readHeader(stream, place);
  if (!header) {
    return header.error();
  }
  if (header->points != mesh->positions.size()) {
    return Error{"the cache has " + std::to_string(header->points) + " points where " +
                     base.filename().string() + " has " + std::to_string(mesh->positions.size()) +
                     " vertices",
                 place, "give the mesh that the cache was made of"};
  }
  const std::uint64_t expected = headerBytes + header->points * header->samples * sizeof(glm::vec3);
  if (fileBytes < expected) {
    return Error{"the cache is cut short: " + std::to_string(fileBytes) + " bytes of " +
                     std::to_string(expected),
                 place, "copy or export it again"};
  }
  MeshSequence sequence;
  sequence.name = cache.stem().string();
  sequence.vertexCount = mesh->positions.size();
  sequence.surface = surfaceOfMeshFile(base, *mesh, sequence.warnings);
  sequence.triangles = std::move(mesh->triangles);
  const auto read = readSamples(stream, place, sequence, static_cast<std::size_t>(header->samples), progress);
  if (!read) {
    return read.error();
  }
  return sequence;
}

} // namespace stretch::skinning

#include "skinning/sequence/cache_header.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <system_error>

#include <fmt/core.h>

#include "skinning/sequence/mesh_file.h"
#include "skinning/sequence/text.h"

namespace stretch::skinning {
namespace {

static_assert(std::endian::native == std::endian::little, "PC2 caches are read as they lie in the file");

template <typename T, std::size_t size>
T numberAt(const std::array<char, size>& bytes, std::size_t offset, bool bigEndian) {
  std::array<char, sizeof(T)> raw{};
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), raw.begin());
  if (bigEndian) {
    std::reverse(raw.begin(), raw.end());
  }
  return std::bit_cast<T>(raw);
}

Error senseless(const std::string& place, const std::string& what) {
  return Error{"the header of the point cache makes no sense (" + what + ")", place,
               "export the cache again"};
}

Error cutShort(const std::string& place, std::uint64_t fileBytes, const CacheHeader& header) {
  return Error{fmt::format("the cache is cut short: {} bytes for {} points in {} samples", fileBytes,
                           header.points, header.samples),
               place, "copy or export it again"};
}

/// "POINTCACHE2\0", version 1, points, start frame, frames between samples, samples; little endian.
Result<CacheHeader> readPc2(std::ifstream& stream, const std::string& place) {
  constexpr std::array<char, 12> magic{'P', 'O', 'I', 'N', 'T', 'C', 'A', 'C', 'H', 'E', '2', '\0'};
  std::array<char, 32> bytes{};
  stream.read(bytes.data(), bytes.size());
  if (stream.gcount() != static_cast<std::streamsize>(bytes.size()) ||
      std::memcmp(bytes.data(), magic.data(), magic.size()) != 0) {
    return Error{"the file is no PC2 point cache", place, "export the cache as PC2"};
  }
  const auto version = numberAt<std::int32_t>(bytes, 12, false);
  const auto points = numberAt<std::int32_t>(bytes, 16, false);
  const auto framesBetween = static_cast<double>(numberAt<float>(bytes, 24, false));
  const auto samples = numberAt<std::int32_t>(bytes, 28, false);
  if (version != 1 || points <= 0 || samples <= 0) {
    return senseless(place, fmt::format("version {}, {} points, {} samples", version, points, samples));
  }
  CacheHeader header{static_cast<std::uint64_t>(points), static_cast<std::uint64_t>(samples), bytes.size()};
  // Some writers leave it out.
  header.framesBetween = std::isfinite(framesBetween) && framesBetween > 0.0 ? framesBetween : 1.0;
  return header;
}

/// Samples, points, and the time of each sample in seconds; big endian.
Result<CacheHeader> readMdd(std::ifstream& stream, const std::string& place, std::uint64_t fileBytes) {
  std::array<char, 8> bytes{};
  stream.read(bytes.data(), bytes.size());
  if (stream.gcount() != static_cast<std::streamsize>(bytes.size())) {
    return Error{"the file is no MDD point cache", place, "export the cache as MDD"};
  }
  const auto samples = numberAt<std::int32_t>(bytes, 0, true);
  const auto points = numberAt<std::int32_t>(bytes, 4, true);
  if (points <= 0 || samples <= 0) {
    return senseless(place, fmt::format("{} points, {} samples", points, samples));
  }
  CacheHeader header{static_cast<std::uint64_t>(points), static_cast<std::uint64_t>(samples), bytes.size(),
                     true};
  header.bytes += static_cast<std::size_t>(samples) * sizeof(float);
  if (fileBytes < header.bytes) {
    return cutShort(place, fileBytes, header);
  }
  for (std::int32_t s = 0; s < samples; ++s) {
    std::array<char, 4> raw{};
    stream.read(raw.data(), raw.size());
    const auto time = static_cast<double>(numberAt<float>(raw, 0, true));
    if (!std::isfinite(time) || (s > 0 && time < header.timeSeconds.back())) {
      return senseless(place, fmt::format("the time of sample {} does not follow the one before", s));
    }
    header.timeSeconds.push_back(time);
  }
  return header;
}

} // namespace

Result<CacheHeader> readCacheHeader(std::ifstream& stream, const std::filesystem::path& cache) {
  std::error_code problem;
  const std::uint64_t fileBytes = std::filesystem::file_size(cache, problem);
  stream.open(cache, std::ios::binary);
  if (problem || !stream) {
    return Error{"the file cannot be read", cache.string(), "check that it exists and may be read"};
  }
  const std::string place = cache.filename().string();
  Result<CacheHeader> header =
      lowerExtension(cache) == ".mdd" ? readMdd(stream, place, fileBytes) : readPc2(stream, place);
  if (header && (fileBytes - header->bytes) / header->sampleBytes() < header->samples) {
    return cutShort(place, fileBytes, *header);
  }
  return header;
}

bool isPointCache(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  return extension == ".pc2" || extension == ".mdd";
}

Result<std::uint64_t> pointsOfCache(const std::filesystem::path& cache) {
  std::ifstream stream;
  const auto header = readCacheHeader(stream, cache);
  if (!header) {
    return header.error();
  }
  return header->points;
}

} // namespace stretch::skinning

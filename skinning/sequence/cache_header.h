#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

#include "core/base/result.h"

namespace stretch::skinning {

/// How the samples of a point cache lie in its file: three numbers of single precision for each point, sample
/// after sample, behind the header.
struct CacheHeader {
  std::uint64_t points = 0;
  std::uint64_t samples = 0;
  std::size_t bytes = 0; ///< Bytes of the header.
  bool bigEndian = false;
  double framesBetween = 1.0;           ///< Frames of the writing program from sample to sample (PC2).
  std::vector<double> timeSeconds = {}; ///< Times of the samples, ascending; empty where the file gives none.

  [[nodiscard]] std::size_t sampleBytes() const { return static_cast<std::size_t>(points) * 12; }
};

/// Reads the header of a PC2 or MDD cache, by the extension, and leaves the stream behind it. An error for a
/// header that makes no sense, and for a file that is shorter than its header says: nothing is taken into
/// memory before that is known.
[[nodiscard]] Result<CacheHeader> readCacheHeader(std::ifstream& stream, const std::filesystem::path& cache);

} // namespace stretch::skinning

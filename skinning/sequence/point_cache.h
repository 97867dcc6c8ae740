#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/result.h"

namespace stretch::skinning {

/// Whether the extension is .pc2.
[[nodiscard]] bool isPointCache(const std::filesystem::path& path);

/// Number of points that the header of a cache promises. An error for bytes that are not a point cache.
[[nodiscard]] Result<std::uint64_t> pointsOfCache(const std::filesystem::path& cache);

} // namespace stretch::skinning

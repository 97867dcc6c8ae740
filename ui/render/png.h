#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace stretch::ui {

/// The picture as a PNG file's bytes (RGBA). Empty pictures are an error.
[[nodiscard]] Result<std::vector<std::uint8_t>> encodePng(const Image& image);

/// Writes a PNG; an existing file is replaced at once or, on an error, left as it is.
[[nodiscard]] Status writePng(const std::filesystem::path& path, const Image& image);

} // namespace stretch::ui

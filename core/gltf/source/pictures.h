#pragma once

#include <filesystem>

#include "core/gltf/source/source.h"

namespace stretch::gltf {

/// Images of a file: decoded, or, where nothing is drawn, only looked at as far as their headers go. Those of
/// the scene are empty then, and an image that is broken behind its header is not told of.
enum class Pictures { decoded, headers };

/// Reads a file as load(path, tolerance) does, which decodes its images.
[[nodiscard]] Result<Loaded> load(const std::filesystem::path& path, Tolerance tolerance, Pictures pictures);

} // namespace stretch::gltf

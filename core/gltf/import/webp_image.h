#pragma once

#include <cstdint>
#include <span>

#include "core/scene/scene.h"

namespace stretch::gltf {

/// Pixels that a WebP picture says it has; 0 for what is none.
[[nodiscard]] std::size_t webpPixels(std::span<const std::uint8_t> bytes);

/// Empty when it cannot be decoded (animations are not).
[[nodiscard]] Image decodeWebp(std::span<const std::uint8_t> bytes);

} // namespace stretch::gltf

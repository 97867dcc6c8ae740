#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/gltf/source.h"

namespace stretch::gltf {

/// The materials of a file with the textures, samplers and images that they name, and nothing else: a source
/// of its own, whose images lie in its one buffer. Materials keep their indices. A texture whose image cannot
/// be read is left out, with a line in `warnings`.
[[nodiscard]] Source materialsOf(const Source& source, std::vector<std::string>& warnings);

/// Adds an encoded image (PNG, JPEG, WebP) and a texture that shows it, repeated; answers the texture's
/// index.
std::size_t addTexture(Source& materials, const Bytes& image, const std::string& name);

/// Writes materials into a file that has none yet. `addView` stores the bytes of an image and answers the
/// index of its buffer view.
void putMaterials(const Source& materials, Json& json,
                  const std::function<std::size_t(std::span<const std::uint8_t>)>& addView);

} // namespace stretch::gltf

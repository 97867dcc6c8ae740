#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/gltf/source/source.h"
#include "core/scene/scene.h"

namespace stretch::gltf {

/// The materials of a file with the textures, samplers and images that they name, and nothing else: a source
/// of its own, whose images lie in its one buffer. Materials keep their indices. A texture whose image cannot
/// be read is left out, with a line in `warnings`.
[[nodiscard]] Source materialsOf(const Source& source, std::vector<std::string>& warnings);

/// Media type of an encoded image by how it begins: PNG, JPEG or WebP; nothing for any other.
[[nodiscard]] std::optional<std::string> mediaTypeOf(std::span<const std::uint8_t> image);

/// A material as the viewport draws it, with the sets of texture coordinates that its textures use.
struct ShownMaterial {
  Material material;
  std::size_t baseColorSet = 0;
  std::size_t emissiveSet = 0;
};

/// Materials as the viewport draws them: as Scene holds them, images decoded.
struct ShownMaterials {
  std::vector<ShownMaterial> materials;
  std::vector<Image> images;
};

/// Materials of a source that materialsOf made. Textures that cannot be shown are left out.
[[nodiscard]] ShownMaterials shownMaterials(const Source& materials);

} // namespace stretch::gltf

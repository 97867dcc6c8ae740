#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "core/gltf/source/source.h"
#include "core/scene/scene.h"

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

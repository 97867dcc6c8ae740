#pragma once

#include <filesystem>

#include "core/gltf/source/pictures.h"

namespace stretch::gltf {

/// Reads a file as any viewer does: a file of ours with its stretched limbs, instead of the source that it
/// can be restored to. savedWork stays null. For comparing what files show. Errors name the
/// file before the place in it.
[[nodiscard]] Result<Loaded> loadAsItStands(const std::filesystem::path& path,
                                            Pictures pictures = Pictures::decoded);

} // namespace stretch::gltf

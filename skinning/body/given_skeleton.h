#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/scene/mesh_sequence.h"
#include "skinning/skinned_sequence.h"

namespace stretch::skinning {

/// The bones of a file's skin with their names, places in the bind pose and parents (the nearest joint above
/// in the scene); of several skins the one with the most joints. A bone reaches to the middle of those that
/// hang on it; one that ends there goes on as its parent does. Errors: the file cannot be read, holds no
/// skin, or a bind matrix that cannot be inverted.
[[nodiscard]] Result<std::vector<SkinBone>> readSkeleton(const std::filesystem::path& path);

/// An error where the bones cannot be meant for the mesh: they span less than a quarter or more
/// than four times of what its first frame spans, or most of them lie outside of its box.
[[nodiscard]] Status checkSkeleton(const std::vector<SkinBone>& bones, const MeshSequence& sequence);

} // namespace stretch::skinning

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/gltf/source/source.h"

namespace stretch::assets {

/// Of a committed file, by its name in bundledFiles().
[[nodiscard]] std::filesystem::path bundledPath(const std::string& name);
[[nodiscard]] std::vector<std::uint8_t> bundledBytes(const std::string& name);

/// The committed character, read as the program reads any other.
[[nodiscard]] gltf::Loaded loadedDummy();

/// Index of the node of that name; a failed test when there is none.
[[nodiscard]] NodeIndex nodeNamed(const Scene& scene, const std::string& name);

/// Vertices with one joint turned about the axis of its own bend in the bind pose, by the smallest turn that
/// bends the limb further. `joint` has a parent and a first child.
[[nodiscard]] std::vector<Vec3> bent(const Scene& scene, const Primitive& body, NodeIndex joint,
                                     double degrees);

} // namespace stretch::assets

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/gltf/source/source.h"
#include "core/math/transform.h"

namespace stretch::gltf {

/// Contents of a file that can be added to another one.
struct Thing {
  std::shared_ptr<const Source> source; ///< In one buffer.
  std::vector<std::string> warnings;    ///< One line each.
};

/// Reads the nodes of a file's scene with their meshes, materials and images. Animations and cameras stay
/// behind, compressed parts are opened; extensions of nodes, as instances, and textures whose picture cannot
/// be read are left out with a warning. An error, which names the file, for one that cannot be read, holds no
/// mesh or a skinned one.
[[nodiscard]] Result<Thing> readThing(const std::filesystem::path& path);

/// Whether the file holds meshes and none of them is skinned, without reading more than has to be: what
/// readThing may still refuse.
[[nodiscard]] bool looksLikeThing(const std::filesystem::path& path);

/// Whether a file of the user can be what readThing answers: for what comes out of a saved file.
[[nodiscard]] bool isThing(const Source& thing);

/// The source with the files behind its own nodes, in their order; nothing of its own is renumbered.
[[nodiscard]] Result<Source> withAddedFiles(const Source& source, const std::vector<AddedFile>& files);

/// The scene of a source with files added.
[[nodiscard]] Result<std::shared_ptr<const Scene>> sceneWith(const Source& source,
                                                             const std::vector<AddedFile>& files);

/// The files with all their bytes, as JSON of its own, and back; what is damaged is left out.
[[nodiscard]] Json addedToJson(const std::vector<AddedFile>& files);
[[nodiscard]] std::vector<AddedFile> addedFromJson(const Json& json);

/// How many nodes a file adds: the one that carries it comes last.
[[nodiscard]] std::size_t addedNodeCount(const AddedFile& file);

} // namespace stretch::gltf

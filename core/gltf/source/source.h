#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/anim/clip.h"
#include "core/base/result.h"
#include "core/gltf/json/json_document.h"
#include "core/gltf/source/glb.h"
#include "core/math/transform.h"
#include "core/scene/scene.h"

namespace stretch::gltf {

/// A glTF file as it was read: what saving starts from, so that whatever we do not edit comes back the same.
struct Source {
  std::filesystem::path path; ///< File that it was read from: relative URIs start in its folder.
  JsonDocument json;
  /// Bytes of each entry of json["buffers"]; empty for a buffer that could not be read and that nothing
  /// needs.
  std::vector<std::vector<std::uint8_t>> buffers;
  bool hasBinaryChunk = false; ///< buffers[0] is the GLB's BIN chunk (json gives it no uri).
  /// Further chunks of the GLB, in their order; a BIN chunk that no buffer refers to is one of them.
  std::vector<GlbChunk> otherChunks;
};

/// A thing of another file that was added to a source (core/gltf/source/added_file.h).
struct AddedFile {
  std::string file; ///< Name of the file that it came from.
  std::string name; ///< Name of the node that carries it; no other node of the source has this name.
  Transform place;  ///< Place of that node.
  std::shared_ptr<const Source> thing;

  friend bool operator==(const AddedFile&, const AddedFile&) = default;
};

/// A file opened: the source and what was understood of it.
struct Loaded {
  std::shared_ptr<const Source> source; ///< A file of ours is restored first: this is the source it was made
                                        ///< from.
  std::vector<AddedFile> added; ///< Files that were added to the source in a file of ours; the scene holds
                                ///< it.
  std::shared_ptr<const Scene> scene;
  std::vector<Clip> clips;
  std::vector<std::string> warnings; ///< One line each: what in the file is odd and what was made of it.
  JsonDocument savedWork;            ///< Content of `Edits::work` when the file was saved; null without one.
};

/// Treatment of a file that breaks the specification but can be read all the same. What files in use are
/// known for (strided samplers, weights that do not sum to 1, missing textures, ...) is a warning either way.
enum class Tolerance { refuse, warn };

/// Reads .glb, .gltf, .vrm or .vrma (told by content, not by name). Bad input gives an Error that names the
/// place.
[[nodiscard]] Result<Loaded> load(const std::filesystem::path& path, Tolerance tolerance = Tolerance::refuse);

} // namespace stretch::gltf

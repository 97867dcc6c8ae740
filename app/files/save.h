#pragma once

#include <filesystem>

#include "app/document.h"
#include "core/gltf/patch/edits.h"

namespace stretch::app {

struct SaveOptions {
  bool clean = false;         ///< Leave the program's own data out.
  bool keyEveryFrame = false; ///< A key on every frame of range and release, as the thesis does.
  bool keepSkeleton = false;  ///< Stretch through translations only: the joint list stays as it is.
};

/// Edits that saving makes in the file: the clips re-keyed with the connected trails and the weight of limbs,
/// bind leaves, skin slots, and the work.
[[nodiscard]] Result<gltf::Edits> editsOf(const Document& document, const SaveOptions& options);

/// Writes the document atomically; the source file itself is left alone unless it is `path`.
[[nodiscard]] Status saveDocument(const Document& document, const std::filesystem::path& path,
                                  const SaveOptions& options);

/// Opens a file, finds its limbs, and takes up the work that a file of ours carries.
[[nodiscard]] Result<Document> openDocument(const std::filesystem::path& path,
                                            gltf::Tolerance tolerance = gltf::Tolerance::refuse);

} // namespace stretch::app

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/schema/saved_form.h"
#include "core/gltf/patch/edits.h"
#include "core/gltf/source/pictures.h"
#include "rig/corners/bind_corners.h"

namespace stretch::app {

class EvaluationCache;

struct SaveOptions {
  bool clean = false; ///< Leave the program's own data out.
  SavedForm form = {};
};

/// Result of saving a document.
struct SavedEdits {
  gltf::Edits edits;
  rig::CornerFit fit;        ///< All 0 where no corners carry a stretch.
  double missOfHeight = 0.0; ///< See rig::RekeyedClip::largestMiss; of the body's height.
};

/// Edits that saving makes in the file: the clips re-keyed with the connected trails and the weight of limbs,
/// bind leaves or corners, skin slots, and the work. A joint that a file of ours stretches already keeps the
/// form that it has there.
[[nodiscard]] SavedEdits editsOf(const Document& document, const SaveOptions& options);
/// Likewise; what `cache` remembers of the document's motion is not worked out again.
[[nodiscard]] SavedEdits editsOf(const Document& document, const SaveOptions& options,
                                 EvaluationCache& cache);

/// Writes the document atomically; the source file itself is left alone unless it is `path`.
[[nodiscard]] Status saveDocument(const Document& document, const std::filesystem::path& path,
                                  const SaveOptions& options);

/// Saves likewise, from edits that were made before.
[[nodiscard]] Status saveEdits(const Document& document, const gltf::Edits& edits,
                               const std::filesystem::path& path);

/// A line that names the files which were written beside the output, since it needs them; none where it
/// stands alone, or in the folder of its source.
[[nodiscard]] std::vector<std::string> besideLines(const gltf::Source& source,
                                                   const std::filesystem::path& output);

/// Opens a file, finds its limbs, and takes up the work that a file of ours carries.
[[nodiscard]] Result<Document> openDocument(const std::filesystem::path& path,
                                            gltf::Tolerance tolerance = gltf::Tolerance::refuse,
                                            gltf::Pictures pictures = gltf::Pictures::decoded);

} // namespace stretch::app

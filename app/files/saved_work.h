#pragma once

#include "app/document.h"

namespace stretch::app {

/// The user's work as JSON, for the root extras of a saved file (docs/file-format.md, The work): edited keys
/// of the clips, adjustments, trails with all settings, the weight of limbs, limbs corrected by hand, chains,
/// loops. Null when there is none.
[[nodiscard]] gltf::Json workOf(const Document& document);

/// The document as its file alone has it: nothing that workOf would keep, limbs as they are found.
[[nodiscard]] Document withoutWork(Document document);

/// Takes the work up again, in place of what the document has. An error names the entry that cannot be
/// understood; the document is then unchanged.
[[nodiscard]] Status restoreWork(const gltf::Json& work, Document& document);

} // namespace stretch::app

#pragma once

#include "app/document.h"

namespace stretch::app {

/// The user's work as JSON, for the root extras of a saved file (spec/editor.md, Files): trails with all
/// settings, the weight of limbs, limbs corrected by hand, chains, loops. Null when there is none.
[[nodiscard]] gltf::Json workOf(const Document& document);

/// Takes the work up again. An error names the entry that cannot be understood; the document is then
/// unchanged.
[[nodiscard]] Status restoreWork(const gltf::Json& work, Document& document);

} // namespace stretch::app

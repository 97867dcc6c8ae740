#pragma once

#include "app/document.h"
#include "core/base/result.h"

namespace stretch::app {

/// The clips that came from other files since the document was opened, whole, for an autosave: the file that
/// it is about may not have them. An empty list without any.
[[nodiscard]] gltf::Json importedClipsToJson(const Document& document);

/// The document, as its file has it, with the clips of an autosave that the file lacks. An error names what
/// cannot be understood.
[[nodiscard]] Result<Document> withImportedClips(const Document& document, const gltf::Json& list);

} // namespace stretch::app

#pragma once

#include "app/document.h"

namespace stretch::app {

/// The edited tracks of all clips, for the work of a saved file (docs/file-format.md, The work: clip_keys):
/// what is as in the source's track is left out. An empty list where nothing was edited.
[[nodiscard]] gltf::Json keptTracks(const Document& document);

/// The keys with auto tangents (docs/file-format.md, The work: auto_keys).
[[nodiscard]] gltf::Json keptFollowingKeys(const Document& document);
/// The document has its tracks. Keys that they do not have are left out.
[[nodiscard]] Status restoreFollowingKeys(const gltf::Json& entries, Document& document);

/// Puts kept tracks into the clips of a document that has none. An error names what cannot be understood.
[[nodiscard]] Status restoreKeptTracks(const gltf::Json& entries, Document& document);

} // namespace stretch::app

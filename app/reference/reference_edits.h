#pragma once

#include "app/document.h"
#include "core/gltf/json/json_document.h"

namespace stretch::app {

/// The reference of a clip; without images and sound where it has none.
[[nodiscard]] Reference referenceOf(const Document& document, int clip);

/// Puts it in the place of what its clip had; one without images and sound takes that away.
[[nodiscard]] Document withReference(Document document, const Reference& reference);

/// Reads the object "references" of a recipe, or writes it: an object of "images" and "sound", each as its
/// schema says. A file is looked for in `folder` where its path is no full one. Errors name the key.
[[nodiscard]] gltf::Json referenceToJson(const Reference& reference);
[[nodiscard]] Result<Reference> referenceFromJson(const gltf::Json& json, int clip,
                                                  const std::string& folder);

/// The references of all clips for the user's settings of the file: by number and name of the clip, frames
/// counted in the clip's own rate. Reading takes what it understands and leaves out the rest; a clip that has
/// another number now is found by its name, where one clip alone has that.
[[nodiscard]] gltf::Json referencesToJson(const Document& document);
[[nodiscard]] std::vector<Reference> referencesFromJson(const gltf::Json& json, const Document& document);

} // namespace stretch::app

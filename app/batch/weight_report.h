#pragma once

#include "app/document.h"
#include "core/gltf/source.h"

namespace stretch::app {

/// What the weight of each limb of a clip comes to, as `elastic` and `exaggerate` report it.
[[nodiscard]] gltf::Json weightJson(const Document& document, int clip);

/// The same as lines of text; warnings on standard error.
void printWeight(const gltf::Json& limbs);

} // namespace stretch::app

#pragma once

#include <vector>

#include "app/document.h"
#include "rig/moments/moments.h"

namespace stretch::app {

/// The moments of a clip of the document (rig/moments/moments.h), of the body's limbs and the user's chains,
/// without what trails and offsets make of it.
[[nodiscard]] std::vector<rig::Moment> momentsOf(const Document& document, int clip);

} // namespace stretch::app

#pragma once

#include <vector>

#include "app/document.h"
#include "rig/moments/moments.h"

namespace stretch::app {

/// The moments of a clip of the document (rig/moments/moments.h), of the body's limbs and the user's chains,
/// without what trails and offsets make of it.
[[nodiscard]] std::vector<rig::Moment> momentsOf(const Document& document, int clip);

/// The range that a limb's trail takes where none is given: the limb's strongest moment in the clip. One that
/// makes no stroke is told so by a warning of the document, and goes from the first frame to the one at which
/// its end, seen from its base, is farthest from where it began (rig::defaultRange).
[[nodiscard]] Vec2 defaultRange(Document& document, int clip, const rig::Limb& limb);

} // namespace stretch::app
